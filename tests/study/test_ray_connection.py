"""Connection to Ray: its variables, and what is done if a cluster does not start. Ray itself is replaced."""

from __future__ import annotations

import os
from contextlib import nullcontext
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from aftdeck.errors import InputError
from aftdeck.study import ray_connection
from aftdeck.study.ray_access import MODE, TOKEN, TOKEN_PATH, token_at_hand
from aftdeck.study.ray_connection import AUTO, LOCAL, connected


class FakeRay:
    """Ray whose first starts fail."""

    @staticmethod
    def _none(_: str) -> str:
        raise ConnectionError("Could not find any running Ray instance.")

    _private = SimpleNamespace(services=SimpleNamespace(canonicalize_bootstrap_address_or_die=_none))
    _raylet = SimpleNamespace(Config=SimpleNamespace(initialize=lambda _: None))

    def __init__(self, failures: int, text: str = "it timed out during startup:\n\nTraceback\n  the cause") -> None:
        self.failures, self.text, self.calls = failures, text, 0

    def init(self, **_: Any) -> None:
        self.calls += 1
        os.environ["RAY_OWN"] = "set by Ray"
        if self.calls <= self.failures:
            raise Exception(self.text)

    def shutdown(self) -> None:
        pass


@pytest.fixture
def ray(monkeypatch: pytest.MonkeyPatch, request: pytest.FixtureRequest) -> FakeRay:
    made = FakeRay(getattr(request, "param", 0))
    monkeypatch.setattr(ray_connection, "needed", lambda *_: made)
    return made


@pytest.mark.parametrize("ray", [1], indirect=True)
def test_local_cluster_that_does_not_start_is_started_once_more(ray: FakeRay) -> None:
    with connected(LOCAL, 1):
        assert ray.calls == 2


@pytest.mark.parametrize("ray", [2], indirect=True)
def test_local_cluster_that_never_starts_is_one_sentence(ray: FakeRay) -> None:
    with pytest.raises(InputError, match=r"^--ray local: it timed out during startup: the cause$"), connected(LOCAL, 1):
        pass
    assert ray.calls == 2


@pytest.mark.usefixtures("ray")
@pytest.mark.parametrize(
    ("text", "calls"), [("Initialization failure from server: a process ended", 2), ("the cluster has gone", 1)]
)
def test_client_connects_once_more_if_the_head_could_not_serve_it(
    text: str, calls: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    ray = FakeRay(1, text)
    monkeypatch.setattr(ray_connection, "needed", lambda *_: ray)
    monkeypatch.setattr(ray_connection, "mode_for", lambda _: None)
    with nullcontext() if calls > 1 else pytest.raises(InputError, match=text), connected("ray://head:10001", 2):
        pass
    assert ray.calls == calls


@pytest.mark.parametrize("address", ["garbage", "127.0.0.1", "ray://head", "http://127.0.0.1:8265", "ray://:10001/"])
def test_what_is_no_address_is_rejected(address: str) -> None:
    with pytest.raises(InputError, match=rf"got '{address}', expected auto, local, HOST:PORT or ray"):
        connected(address, 1).__enter__()


@pytest.mark.usefixtures("ray")
def test_machine_without_a_cluster_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("RAY_ADDRESS", raising=False)
    with pytest.raises(InputError, match=r"--ray auto: no Ray cluster runs on this machine"):
        connected(AUTO, 1).__enter__()


@pytest.mark.usefixtures("ray")
def test_variables_of_ray_are_restored(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RAY_USAGE_STATS_ENABLED", "1")
    monkeypatch.delenv("RAY_OWN", raising=False)
    before = dict(os.environ)
    with connected(LOCAL, 1):
        assert os.environ["RAY_USAGE_STATS_ENABLED"] == "1"
        assert MODE not in os.environ or MODE in before
    assert dict(os.environ) == before


def test_token_is_looked_for_where_ray_does(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("HOME", str(tmp_path))
    for name in (TOKEN, TOKEN_PATH):
        monkeypatch.delenv(name, raising=False)
    assert token_at_hand() is None
    (tmp_path / ".ray").mkdir()
    for number, path in enumerate((tmp_path / ".ray" / "auth_token", tmp_path / "other")):
        path.write_text(f"{number}\n", encoding="utf-8")
    found = [token_at_hand()]
    monkeypatch.setenv(TOKEN_PATH, str(tmp_path / "other"))
    found.append(token_at_hand())
    monkeypatch.setenv(TOKEN, "2")
    found.append(token_at_hand())
    assert [token.value for token in found if token] == ["0", "1", "2"]
    monkeypatch.delenv(TOKEN)
    monkeypatch.setenv(TOKEN_PATH, str(tmp_path))
    with pytest.raises(InputError, match=r"RAY_AUTH_TOKEN_PATH is .* not a file with a token"):
        token_at_hand()

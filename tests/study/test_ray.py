"""Real Ray: the same table as one process, with and without a token; one sentence where a cluster cannot be used.

A cluster of two nodes asks for a token, a cluster of one node does not. Both are on this machine.
"""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

import platformdirs
import pytest

from aftdeck.study.ray_access import MODE, TOKEN, TOKEN_PATH
from benchmarks.ray_nodes import nodes
from tests.ray_lines import LEAN, free_port
from tests.study.studies import written
from tests.waits import WAIT_S

pytestmark = pytest.mark.slow

SECRET = "5ea1" * 16
ONE_AFTER_THE_OTHER = """
import sys
from aftdeck.study.ray_connection import connected

for address in sys.argv[1:]:
    with connected(address, 1) as ray:
        print(sum(node["Alive"] for node in ray.nodes()), end=" ")
        assert ray.get(ray.remote(lambda: 7).remote()) == 7
"""
"""Program that connects to clusters one after the other, counts their nodes, and runs a task on each."""


class Cluster(NamedTuple):
    """Addresses of a cluster, and the options of a study that runs there."""

    head: str
    client: str


@contextmanager
def cluster(count: int, variables: dict[str, str]) -> Iterator[Cluster]:
    """Start a cluster on free ports."""
    head, client = free_port(), free_port()
    variables = variables | LEAN
    made = TemporaryDirectory(prefix="ray", ignore_cleanup_errors=True)  # the last processes of a node may still write
    with made as folder, nodes(count, head, Path(folder), client, variables) as address:
        yield Cluster(address, f"ray://127.0.0.1:{client}")


@pytest.fixture(scope="module")
def with_token() -> Iterator[Cluster]:
    with cluster(2, {MODE: "token", TOKEN: SECRET}) as made:
        yield made


@pytest.fixture(scope="module")
def without_token() -> Iterator[Cluster]:
    with cluster(1, {MODE: "disabled"}) as made:
        yield made


class Home:
    """A user's home folder, with or without a token, and a study."""

    def __init__(self, folder: Path) -> None:
        self.folder, self.file = folder, written(folder)

    def token(self, text: str) -> None:
        """Write the token as Ray does."""
        (self.folder / ".ray").mkdir()
        (self.folder / ".ray" / "auth_token").write_text(f"{text}\n", encoding="utf-8")

    def study(self, *options: str, **variables: str) -> subprocess.CompletedProcess[str]:
        """Run the study in this home folder."""
        return self.python(
            "-m", "aftdeck", "study", str(self.file), "-o", str(self.folder / "out"), *options, **variables
        )

    def python(self, *arguments: str, **variables: str) -> subprocess.CompletedProcess[str]:
        """Run Python in this home folder."""
        ray = {name: value for name, value in os.environ.items() if not name.startswith("RAY_")}
        own = LEAN | {"HOME": str(self.folder), "XDG_CACHE_HOME": str(platformdirs.user_cache_path())}
        command = [sys.executable, *arguments]
        return subprocess.run(
            command, env=ray | own | variables, capture_output=True, text=True, timeout=WAIT_S, check=False
        )

    def table(self, *options: str, **variables: str) -> bytes:
        """Return the table of the study; its run reports no error."""
        done = self.study(*options, **variables)
        assert (done.returncode, done.stderr) == (0, ""), done.stderr
        return (self.folder / "out" / "results.parquet").read_bytes()

    def sentence(self, address: str, **variables: str) -> str:
        """Return the sentence with which the command ends: it is all that is printed."""
        done = self.study("--ray", address, **variables)
        assert (done.returncode, done.stdout) == (2, "")
        line, end, rest = done.stderr.partition("\n")
        assert (end, rest) == ("\n", ""), done.stderr
        return line


@pytest.fixture
def home(tmp_path: Path) -> Home:
    return Home(tmp_path)


@pytest.fixture(scope="module")
def table(tmp_path_factory: pytest.TempPathFactory) -> bytes:
    """Table of the study, from one process."""
    return Home(tmp_path_factory.mktemp("one")).table("--jobs", "1")


def test_cluster_that_asks_for_a_token_gets_the_one_at_hand(with_token: Cluster, home: Home, table: bytes) -> None:
    home.token(SECRET)
    assert home.table("--ray", with_token.head, "--jobs", "2") == table


def test_client_of_a_cluster_elsewhere_sends_its_token(with_token: Cluster, home: Home, table: bytes) -> None:
    assert home.table("--ray", with_token.client, "--jobs", "1", **{TOKEN: SECRET}) == table


def test_cluster_without_authentication_works_without_a_token(without_token: Cluster, home: Home, table: bytes) -> None:
    assert home.table("--ray", without_token.client, "--jobs", "1") == table


def test_cluster_without_authentication_works_with_a_token(without_token: Cluster, home: Home, table: bytes) -> None:
    home.token(SECRET)
    assert home.table("--ray", "auto", "--jobs", "1", RAY_ADDRESS=without_token.head) == table


def test_new_local_cluster_gives_the_same_table(home: Home, table: bytes) -> None:
    home.token(SECRET)
    assert home.table("--ray", "local", "--jobs", "1") == table


def test_one_process_uses_clusters_of_both_kinds(with_token: Cluster, without_token: Cluster, home: Home) -> None:
    home.token(SECRET)
    done = home.python("-c", ONE_AFTER_THE_OTHER, with_token.head, without_token.head, with_token.head)
    assert (done.returncode, done.stdout) == (0, "2 1 2 "), done.stderr


@pytest.mark.parametrize("kind", ["head", "client"])
def test_missing_token_is_one_sentence(with_token: Cluster, home: Home, kind: str) -> None:
    address = getattr(with_token, kind)
    expected = f"--ray {address}: this cluster asks for a token, and none is at hand; copy ~/.ray/auth_token"
    assert expected in home.sentence(address)


def test_wrong_token_is_one_sentence(with_token: Cluster, home: Home) -> None:
    home.token("f001" * 16)
    assert f"does not accept the token in {home.folder}/.ray/auth_token" in home.sentence(with_token.head)
    assert f"the token in {TOKEN};" in home.sentence(with_token.client, **{TOKEN: "f001"})


def test_mode_that_the_user_has_set_is_left_and_named(with_token: Cluster, without_token: Cluster, home: Home) -> None:
    home.token(SECRET)
    assert "RAY_AUTH_MODE is 'disabled'; unset it" in home.sentence(with_token.head, **{MODE: "disabled"})
    assert "RAY_AUTH_MODE is 'token'; unset it" in home.sentence(without_token.head, **{MODE: "token"})


def test_token_path_that_is_no_file_is_one_sentence(with_token: Cluster, home: Home) -> None:
    home.token(SECRET)
    assert "RAY_AUTH_TOKEN_PATH is '/none'" in home.sentence(with_token.head, **{TOKEN_PATH: "/none"})


def test_address_without_a_cluster_is_one_sentence(with_token: Cluster, home: Home) -> None:
    address = f"127.0.0.1:{free_port()}"
    for each in (address, f"ray://{address}"):
        assert f"--ray {each}: no Ray cluster answers at this address" in home.sentence(each)
    port = with_token.client.rpartition(":")[2]
    assert "is no Ray cluster (UNIMPLEMENTED)" in home.sentence(f"127.0.0.1:{port}")

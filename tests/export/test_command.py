"""Command ``export``: its errors, before anything is written."""

from __future__ import annotations

import importlib
from pathlib import Path
from types import ModuleType

import pytest

from tests.commands import Run
from tests.export.runs import by_hand

WITHOUT = importlib.import_module


@pytest.fixture
def recorded(tmp_path: Path) -> str:
    return str(by_hand(tmp_path / "run.mcap"))


@pytest.fixture
def no_library(monkeypatch: pytest.MonkeyPatch) -> None:
    """Hide the libraries, whether they are installed or not."""

    def found(name: str, package: str | None = None) -> ModuleType:
        library = name.partition(".")[0]
        if library in ("lerobot", "minari"):
            raise ModuleNotFoundError(f"No module named {library!r}", name=library)
        return WITHOUT(name, package)

    monkeypatch.setattr("aftdeck.extra.importlib.import_module", found)


@pytest.mark.parametrize(
    ("options", "part"),
    [
        ([], "either --lerobot DIR or --minari DIR"),
        (["--lerobot", "{}/a", "--minari", "{}/a-v0"], "either --lerobot DIR or --minari DIR"),
        (["--lerobot", "{}"], "exists already"),
        (["--lerobot", "{}/no/a"], "does not exist"),
        (["--minari", "{}/flights"], "has to end in -v and a number"),
        (["--minari", "{}/a-v0", "--fps", "7"], "the control rate, divided by a whole number"),
        (["--minari", "{}/a-v0", "--fps", "1e-320"], "at least 0.1"),
        (["--minari", "{}/a-v0", "--fps", "1e-6"], "at least 0.1"),
        (["--minari", "{}/a-v0", "--size", "64x48"], "--size needs --camera"),
        (["--minari", "{}/" + "a" * 300 + "-v0"], "cannot be the name of a folder"),
        (["--minari", "{}/a-v0", "--columns", "thc_x,stick"], "got 'stick'"),
        (["--minari", "{}/a-v0", "--camera", "Q", "--size", "64x48"], "no camera 'Q'"),
        (["--minari", "{}/a-v0", "--camera", "WR", "--size", "8x8"], "size: got 8x8"),
        (["--minari", "{}/a-v0", "--camera", "WR", "--size", "big"], "--size: got 'big'"),
        (["--minari", "{}/a-v0", "{}/none.mcap"], "none.mcap: cannot be read"),
        (["--minari", "{}/a-v0", "--no-pictures", "--camera", "WR"], "--no-pictures cannot be combined"),
    ],
)
def test_error_states_what_is_allowed(options: list[str], part: str, recorded: str, tmp_path: Path, run: Run) -> None:
    if "--minari" in options:
        pytest.importorskip("minari")
    code, out, err = run("export", recorded, *(option.format(tmp_path) for option in options))
    assert (code, out) == (2, "")
    assert part in err
    assert sorted(path.name for path in tmp_path.iterdir()) == ["run.mcap"]


@pytest.mark.usefixtures("no_library")
@pytest.mark.parametrize(("option", "extra"), [("--lerobot", "lerobot"), ("--minari", "minari")])
def test_missing_library_is_named_with_its_extra(
    option: str, extra: str, recorded: str, tmp_path: Path, run: Run
) -> None:
    code, _, err = run("export", recorded, option, str(tmp_path / "set-v0"))
    assert code == 2
    assert f"pip install 'aftdeck[{extra}]'" in err
    assert not (tmp_path / "set-v0").exists()


def test_help_has_an_example_and_fits_80_columns(run: Run) -> None:
    code, out, _ = run("export", "--help")
    assert code == 0
    assert "aftdeck export" in out.partition("Example")[2]
    assert max(len(line) for line in out.splitlines()) <= 80

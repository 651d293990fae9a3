"""What all tests share.

The browser tests run where a Chromium is found, and say so where none is. Hypothesis looks for new examples at every
run, for as long as it takes; with ``--hypothesis-profile=ci``, as `.ci/run` has it, for the same ones each time.
"""

import os
import shutil
from collections.abc import Iterator
from pathlib import Path

import platformdirs
import pytest
from hypothesis import HealthCheck, settings

from tests.commands import Run

CHROMIUM_NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
CHROMIUM_PLACES = (
    Path("/Applications/Chromium.app/Contents/MacOS/Chromium"),
    Path("/Applications/Google Chrome.app/Contents/MacOS/Google Chrome"),
)
HOW_TO_GET_ONE = "install chromium, or name one in AFTDECK_CHROMIUM"

not_run = pytest.StashKey[int]()

# A slow machine fails nothing: no example has a time to keep.
settings.register_profile("default", deadline=None, suppress_health_check=[HealthCheck.too_slow])


def find_chromium() -> Path | None:
    """Returns the Chromium to test with: AFTDECK_CHROMIUM, else one on PATH, else one in its usual place.

    Raises:
        pytest.UsageError: where AFTDECK_CHROMIUM names no file.
    """
    if named := os.environ.get("AFTDECK_CHROMIUM"):
        if not Path(named).is_file():
            raise pytest.UsageError(f"AFTDECK_CHROMIUM is {named!r}, which is no file.")
        return Path(named)
    on_path = (Path(found) for name in CHROMIUM_NAMES if (found := shutil.which(name)))
    in_place = (place for place in CHROMIUM_PLACES if place.is_file())
    return next(on_path, None) or next(in_place, None)


@pytest.hookimpl(trylast=True)  # after `-m` and `-k` have chosen
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Leaves out the browser tests where there is no Chromium, or refuses if one is required."""
    browser = [item for item in items if item.get_closest_marker("browser")]
    if not browser or find_chromium():
        return
    if os.environ.get("AFTDECK_REQUIRE_BROWSER") == "1":
        raise pytest.UsageError(f"{len(browser)} browser tests need a Chromium, and none was found: {HOW_TO_GET_ONE}.")
    config.stash[not_run] = len(browser)
    config.hook.pytest_deselected(items=browser)
    items[:] = [item for item in items if not item.get_closest_marker("browser")]


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter, config: pytest.Config) -> None:
    """Says at the end which tests were left out for want of a Chromium."""
    if count := config.stash.get(not_run, 0):
        terminalreporter.section("no Chromium found", yellow=True)
        terminalreporter.line(f"{count} browser tests were not run: {HOW_TO_GET_ONE}.")


@pytest.fixture(scope="session", autouse=True)
def data_folder(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """The user's data folder of all tests and of the programs that they start: an empty one, not the user's own."""
    folder = tmp_path_factory.mktemp("data")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_DATA_HOME", str(folder))
        if platformdirs.user_data_path() != folder:  # where no variable says where it is
            patch.setattr(platformdirs, "user_data_dir", lambda name, **_: str(folder / name))
        yield folder


@pytest.fixture(scope="session")
def chromium() -> Path:
    """The Chromium that the browser tests drive."""
    found = find_chromium()
    assert found is not None, "tests that use this fixture carry the marker `browser`"
    return found


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> Run:
    """The command line, in this process."""
    return Run(capsys, monkeypatch)

"""Fixtures and hooks of all tests.

Browser tests run if a Chromium is found; otherwise the summary reports how many were not run. Hypothesis tries new
examples in every run. With ``--hypothesis-profile=ci``, as in `.ci/run`, it tries the same examples in every run.

A module of tests may load no arm while the tests are collected: every process would load it, whatever it runs.
`tests/loaded.py` has arms and scenarios.
"""

import os
import shutil
import sys
import threading
from collections.abc import Callable, Generator, Iterator
from pathlib import Path
from traceback import walk_stack
from types import FrameType

import platformdirs
import pytest
from hypothesis import HealthCheck, settings

from aftdeck.arms import load as arms
from aftdeck.files import Text
from tests.commands import Run
from tests.durations import Durations
from tests.order import Order

pytest_plugins = ["tests.skips"]

CHROMIUM_NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
CHROMIUM_PLACES = (
    Path("/Applications/Chromium.app/Contents/MacOS/Chromium"),
    Path("/Applications/Google Chrome.app/Contents/MacOS/Google Chrome"),
)
HOW_TO_GET_ONE = "install chromium, or name one in AFTDECK_CHROMIUM"

LEFT_S = 20.0
"""Longest time until a thread of Aftdeck has ended after the tests of a module [s]."""

not_run = pytest.StashKey[int]()

# no time limit for examples, so that a slow machine fails no test
settings.register_profile("default", deadline=None, suppress_health_check=[HealthCheck.too_slow])


def find_chromium() -> Path | None:
    """Return the Chromium for the tests: AFTDECK_CHROMIUM if set, else the first one on PATH or in a usual folder.

    Raises:
        pytest.UsageError: AFTDECK_CHROMIUM is not a file.
    """
    if named := os.environ.get("AFTDECK_CHROMIUM"):
        if not Path(named).is_file():
            raise pytest.UsageError(f"AFTDECK_CHROMIUM is {named!r}, which is not a file.")
        return Path(named)
    on_path = (Path(found) for name in CHROMIUM_NAMES if (found := shutil.which(name)))
    in_place = (place for place in CHROMIUM_PLACES if place.is_file())
    return next(on_path, None) or next(in_place, None)


def pytest_xdist_auto_num_workers() -> int:
    """Return the number of processes: one more than processors, since the tests of the page mostly wait."""
    return (os.cpu_count() or 1) + 1


def pytest_configure(config: pytest.Config) -> None:
    """Order the tests; measure them in the process that collects the results of all processes."""
    config.pluginmanager.register(Order())
    if not hasattr(config, "workerinput"):
        config.pluginmanager.register(Durations())


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Generator[None, object, object]:
    """Raise an error in each module that loads an arm, which every scenario has, while the tests are collected."""
    model_of, collecting = arms.model_of, True

    def refused_at_import(source: Text, shapes: Callable[[str], Text]) -> arms.ArmModel:
        assert not collecting, "an arm is loaded at import; load it in a test or a fixture, from tests/loaded.py"
        return model_of(source, shapes)

    arms.model_of = refused_at_import  # modules that are imported meanwhile keep this function
    try:
        return (yield)
    finally:
        collecting = False


@pytest.hookimpl(trylast=True)  # after the selection by `-m` and `-k`
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Deselect the browser tests if no Chromium is found; raise an error if one is required."""
    browser = [item for item in items if item.get_closest_marker("browser")]
    if not browser or find_chromium():
        return
    if os.environ.get("AFTDECK_REQUIRE_BROWSER") == "1":
        raise pytest.UsageError(f"{len(browser)} browser tests need a Chromium, and none was found: {HOW_TO_GET_ONE}.")
    config.stash[not_run] = len(browser)
    config.hook.pytest_deselected(items=browser)
    items[:] = [item for item in items if not item.get_closest_marker("browser")]


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter, config: pytest.Config) -> None:
    """Report the number of browser tests that were deselected."""
    if count := config.stash.get(not_run, 0):
        terminalreporter.section("no Chromium found", yellow=True)
        terminalreporter.line(f"{count} browser tests were not run: {HOW_TO_GET_ONE}.")


def _of_aftdeck(frame: FrameType) -> bool:
    return str(frame.f_globals.get("__name__")).startswith("aftdeck.")


@pytest.fixture(scope="module", autouse=True)
def no_thread_is_left() -> Iterator[None]:
    """Fail if a module leaves a thread that runs code of Aftdeck: it may print a line during another test."""
    yield
    frames, present = sys._current_frames(), threading.current_thread()
    left = [
        thread
        for thread in threading.enumerate()
        if thread is not present and thread.ident in frames
        if any(_of_aftdeck(frame) for frame, _ in walk_stack(frames[thread.ident]))
    ]
    for thread in left:
        thread.join(LEFT_S)
    assert [thread.name for thread in left if thread.is_alive()] == []


@pytest.fixture(scope="session", autouse=True)
def data_folder(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """Replace the user's data folder by an empty folder, for the tests and the programs that they start."""
    folder = tmp_path_factory.mktemp("data")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_DATA_HOME", str(folder))
        if platformdirs.user_data_path() != folder:  # on systems where XDG_DATA_HOME has no effect
            patch.setattr(platformdirs, "user_data_dir", lambda name, **_: str(folder / name))
        yield folder


@pytest.fixture(scope="session")
def chromium() -> Path:
    """Path of the Chromium for the browser tests."""
    found = find_chromium()
    assert found is not None, "tests that use this fixture carry the marker `browser`"
    return found


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> Run:
    """Command line in this process."""
    return Run(capsys, monkeypatch)

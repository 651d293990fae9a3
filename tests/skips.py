"""Plugin of pytest: with AFTDECK_REQUIRE_ALL=1, a skipped test that is not listed here fails the run.

`.ci/run` sets that variable, because everything that the tests need is installed there. It also makes the browsers
required, so that no test is deselected for the lack of one.
"""

from __future__ import annotations

import os
from fnmatch import fnmatchcase
from typing import Any, NamedTuple

import pytest

VARIABLE, BROWSER_VARIABLE = "AFTDECK_REQUIRE_ALL", "AFTDECK_REQUIRE_BROWSER"
MAY_SKIP = {
    "tests/test_exact_flights.py::test_every_flight_is_equal_to_the_last_bit_on_a_generic_processor": (
        "this processor computes like the generic one, so that nothing would be compared"
    ),
    "tests/export/test_lerobot_dataset.py::test_*": "LeRobot is not installed; scripts/test-lerobot runs this",
    "tests/recording/test_bombs.py::test_bombs_are_rejected_quickly_and_in_little_memory": (
        "the test reads its memory in Linux's /proc"
    ),
}
"""Tests that may be skipped, as patterns of their ids, with the reason that the skip has to give."""


class Skip(NamedTuple):
    """A skipped test or file."""

    id: str
    reason: str


found = pytest.StashKey[set[Skip]]()


def unlisted(skips: set[Skip]) -> list[Skip]:
    """Return the skips that the list does not allow, sorted."""
    return sorted(
        skip
        for skip in skips
        if not any(fnmatchcase(skip.id, id) and skip.reason == why for id, why in MAY_SKIP.items())
    )


def _skip(report: pytest.TestReport | pytest.CollectReport) -> Skip:
    text = report.longrepr[2] if isinstance(report.longrepr, tuple) else str(report.longrepr)
    return Skip(report.nodeid, text.removeprefix("Skipped: "))


def pytest_configure(config: pytest.Config) -> None:
    """Watch the skips, if all tests are required."""
    if os.environ.get(VARIABLE) == "1":
        os.environ.setdefault(BROWSER_VARIABLE, "1")
        config.stash[found] = set()
        config.pluginmanager.register(Watch(config), "aftdeck-skips")


class Watch:
    """Hooks that collect the skips of this process, and of the processes of xdist."""

    def __init__(self, config: pytest.Config) -> None:
        self._skips = config.stash[found]
        self._output: dict[str, Any] | None = getattr(config, "workeroutput", None)

    def pytest_collectreport(self, report: pytest.CollectReport) -> None:
        """Note a file that was skipped."""
        if report.skipped:
            self._skips.add(_skip(report))

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Note a test that was skipped; a test that is expected to fail does not count."""
        if report.skipped and not hasattr(report, "wasxfail"):
            self._skips.add(_skip(report))

    @pytest.hookimpl(optionalhook=True)
    def pytest_testnodedown(self, node: Any) -> None:
        """Take over the skips of a process of xdist, which forwards those of tests, but not those of files."""
        self._skips.update(Skip(*each) for each in getattr(node, "workeroutput", {}).get("skips", ()))

    @pytest.hookimpl(tryfirst=True)
    def pytest_sessionfinish(self, session: pytest.Session) -> None:
        """Hand over the skips of a process of xdist; fail the run in the main process."""
        if self._output is not None:
            self._output["skips"] = [tuple(skip) for skip in self._skips]
        elif unlisted(self._skips) and session.exitstatus == pytest.ExitCode.OK:
            session.exitstatus = pytest.ExitCode.TESTS_FAILED

    def pytest_terminal_summary(self, terminalreporter: pytest.TerminalReporter) -> None:
        """List the skips that fail the run."""
        if skips := unlisted(self._skips):
            terminalreporter.section(f"skipped, and not listed in {__name__}", red=True)
            for skip in skips:
                terminalreporter.line(f"{skip.id}: {skip.reason}")

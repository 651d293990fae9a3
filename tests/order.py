"""Order of the tests: in groups, each in one process, and those that take longest first."""

from __future__ import annotations

from collections import Counter
from fnmatch import fnmatchcase

import pytest
from xdist.scheduler import LoadScopeScheduling

from tests.durations import function_of, kept

GROUPS = {
    "tests/browser/*": "browser",  # the tests share a browser, and only one page draws at a time
    "tests/study/test_ray.py::*": "ray",  # only one cluster runs at a time
    "tests/test_shell_lines.py::*[[]studies.md]": "ray",
    "tests/test_benchmarks.py::*[[]ray]": "ray",
}
"""Groups of tests, by patterns of their ids. Any other module is a group, so that its fixtures are made once."""


def group_of(nodeid: str) -> str:
    """Return the name of a test's group."""
    module = nodeid.partition("::")[0]
    return next((group for pattern, group in GROUPS.items() if fnmatchcase(nodeid, pattern)), module)


class Groups(LoadScopeScheduling):  # type: ignore[misc]  # xdist has no types
    """Scheduler of xdist that gives each group to one process."""

    def _split_scope(self, nodeid: str) -> str:
        return group_of(nodeid)


class Order:
    """Plugin of pytest that sorts the tests, and gives each group to one process."""

    @pytest.hookimpl(tryfirst=True)
    def pytest_collection_modifyitems(self, items: list[pytest.Item]) -> None:
        """Sort the groups by their kept times. Inside a group the tests keep their order."""
        times = kept()
        names = [function_of(item.nodeid) for item in items]
        counts = Counter(names)
        seconds: dict[str, float] = {}
        for item, name in zip(items, names, strict=True):
            group = group_of(item.nodeid)
            seconds[group] = seconds.get(group, 0.0) + times.get(name, 0.0) / counts[name]
        items.sort(key=lambda item: -seconds[group_of(item.nodeid)])

    @pytest.hookimpl(optionalhook=True)
    def pytest_xdist_make_scheduler(self, config: pytest.Config, log: object) -> Groups:
        """Return the scheduler."""
        return Groups(config, log)

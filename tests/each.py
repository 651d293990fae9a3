"""Properties that hold for many cases: one test, with few random cases in CI and many in ``make test-all``."""

from __future__ import annotations

import functools
import inspect
import os
from collections.abc import Callable, Iterable
from typing import Any

MANY = "AFTDECK_MANY"
"""Environment variable that selects the larger number of random cases, if it is 1."""

Test = Callable[..., None]


def number(few: int, many: int) -> int:
    """Return how many random cases or steps a test tries: `few` in CI, `many` in ``make test-all``."""
    return many if os.environ.get(MANY) == "1" else few


def seeds(few: int, many: int, first: int = 0) -> range:
    """Return the seeds of a property's random cases.

    Args:
        few: their number in CI.
        many: their number in ``make test-all``.
        first: the first seed.
    """
    return range(first, first + number(few, many))


def each(name: str, cases: Iterable[Any] | Callable[[], Iterable[Any]]) -> Callable[[Test], Test]:
    """Call a test for each case, as one test; the error of a failed case names the case.

    Args:
        name: name of the test's argument.
        cases: values of the argument, or a function that returns them when the test runs.
    """

    def over_all(test: Test) -> Test:
        signature = inspect.signature(test)

        @functools.wraps(test)
        def run(*args: Any, **given: Any) -> None:
            count = 0
            for case in cases() if callable(cases) else cases:
                count += 1
                try:
                    test(*args, **given, **{name: case})
                except BaseException as error:
                    error.add_note(f"case: {name} = {case!r}")
                    raise
            assert count, f"no case of {name}"

        others = [one for one in signature.parameters.values() if one.name != name]
        run.__signature__ = signature.replace(parameters=others)  # type: ignore[attr-defined]
        return run

    return over_all

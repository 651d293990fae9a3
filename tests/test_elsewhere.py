"""The simulation needs no threads, no files once loaded, and none of the server's or recording's libraries."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

STEPS = 12


@pytest.mark.parametrize("name", ["first-flight", "concept-1972-script", "srms-berth"])
def test_a_scenario_flies_where_nothing_is_there_but_the_simulation(name: str) -> None:
    """Uncompiled, as in a Python without a compiler: compiled laws are read from files when they are first called."""
    done = subprocess.run(
        [sys.executable, "-m", "tests.elsewhere", name, str(STEPS)],
        cwd=Path(__file__).parents[1],
        env={**os.environ, "NUMBA_DISABLE_JIT": "1"},
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert float(done.stdout) > 0.0

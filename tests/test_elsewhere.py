"""After loading, the simulation starts no threads and opens no files; it needs no server or recording libraries."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

STEPS = 12


@pytest.mark.parametrize("name", ["first-flight", "concept-1972-script", "srms-berth"])
def test_scenario_runs_without_threads_files_and_libraries(name: str) -> None:
    """The laws run as plain Python, because the first call of a compiled law would read a file."""
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

"""A study that is killed continues without loss and without doubling."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from aftdeck.study.case import Runner
from aftdeck.study.design import cases
from aftdeck.study.plan import plan_of
from aftdeck.study.run import run_study
from aftdeck.study.store import LINES
from aftdeck.study.table import RESULTS, write_tables
from tests.study.studies import FOUR, loaded, written

MANY = FOUR.replace("repeats = 2", "repeats = 12")


@pytest.mark.slow
def test_killed_study_continues_and_ends_with_the_same_table(tmp_path: Path) -> None:
    file, folder = written(tmp_path, MANY), tmp_path / "killed"
    command = [sys.executable, "-m", "aftdeck", "study", str(file), "-o", str(folder), "--jobs", "2"]
    with subprocess.Popen(command, start_new_session=True) as process:
        lines = folder / LINES
        while not lines.exists() or lines.read_bytes().count(b"\n") < 3:
            assert process.poll() is None
            time.sleep(0.02)
        workers = children(process.pid)
        process.send_signal(signal.SIGKILL)
    assert len(workers) >= 2
    wait_for_end(workers)
    before = lines.read_bytes()
    assert 3 <= before.count(b"\n") < 24

    study = loaded(tmp_path, MANY)
    run_study(study, folder, jobs=2)
    assert lines.read_bytes().startswith(before[: before.rfind(b"\n") + 1])
    assert lines.read_bytes().count(b"\n") == 24
    runner, whole = Runner(plan_of(study)), tmp_path / "whole"
    whole.mkdir()
    write_tables(study, [runner.run(case) for case in cases(study)], whole)
    assert (folder / RESULTS).read_bytes() == (whole / RESULTS).read_bytes()


def children(pid: int) -> list[int]:
    """Return the process ids of the children of a process."""
    found = subprocess.run(["ps", "-A", "-o", "pid=,ppid="], capture_output=True, text=True, check=True)
    pairs = (line.split() for line in found.stdout.splitlines())
    return [int(child) for child, parent in pairs if int(parent) == pid]


def wait_for_end(pids: list[int], longest_s: float = 20.0) -> None:
    """Wait until processes have ended."""
    until = time.monotonic() + longest_s
    for pid in pids:
        while time.monotonic() < until:
            try:
                os.kill(pid, 0)
            except ProcessLookupError:
                break
            time.sleep(0.05)
        else:
            raise AssertionError(f"process {pid} has not ended")

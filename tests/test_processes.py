"""Processes that work for another one: they end with it, whatever they are doing."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from multiprocessing.connection import Connection
from pathlib import Path
from select import select

import pytest

import aftdeck
from aftdeck.processes import ONE_THREAD, Child
from tests.waits import WAIT_S

SOURCE = Path(aftdeck.__file__).parent

PARENT = """
import signal, sys
signal.signal(signal.SIGINT, signal.default_int_handler)  # ignored in a job in the background
from aftdeck.processes import Child
import stuck
child = Child(getattr(stuck, sys.argv[1]))
if sys.argv[1] == "work":
    child.pipe.recv()
print(child.process.pid, flush=True)
sys.stdin.read()
"""
STUCK = """
import os, sys, time
if sys.argv[0].endswith("processes.py") and os.environ["STUCK"] == "import":
    time.sleep(10000)

def work(pipe):
    pipe.send("at work")
    while True:
        pass

def wait(pipe):
    pass
"""
"""Module of a target. Its import, or its work, never ends in the process that is started."""


def echo(pipe: Connection, *given: object) -> None:
    """Send the arguments, and whether Ctrl-C and several threads are off."""
    threads = {os.environ.get(name) for name in ONE_THREAD}
    pipe.send((given, signal.getsignal(signal.SIGINT) == signal.SIG_IGN, threads))


def test_child_calls_the_function_and_leaves_ctrl_c_to_its_parent() -> None:
    child = Child(echo, 1, "two", nice=3)
    assert os.getpriority(os.PRIO_PROCESS, child.process.pid) == os.getpriority(os.PRIO_PROCESS, 0) + 3
    assert os.getpgid(child.process.pid) != os.getpgid(0)
    assert child.pipe.recv() == ((1, "two"), True, {"1"})
    assert child.process.wait(WAIT_S) == 0
    child.kill()


@pytest.mark.parametrize(("target", "stuck"), [("wait", "import"), ("work", "")], ids=["importing", "working"])
@pytest.mark.parametrize("end", [signal.SIGKILL, signal.SIGTERM, signal.SIGINT])
def test_child_ends_with_its_parent(tmp_path: Path, target: str, stuck: str, end: signal.Signals) -> None:
    (tmp_path / "stuck.py").write_text(STUCK, encoding="utf-8")
    environment = os.environ | {"STUCK": stuck, "PYTHONPATH": str(tmp_path)}
    command = [sys.executable, "-c", PARENT, target]
    with subprocess.Popen(
        command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, env=environment
    ) as parent:
        assert parent.stdout is not None
        child = os.pidfd_open(int(parent.stdout.readline()))
        parent.send_signal(end)
        parent.wait(WAIT_S)
    with os.fdopen(child):
        assert select([child], [], [], WAIT_S)[0], "the process has not ended"


def test_every_process_is_a_child() -> None:
    starting = ("subprocess", "create_subprocess", "multiprocessing.get_context", "os.fork", "ProcessPoolExecutor")
    found = {
        str(path.relative_to(SOURCE))
        for path in SOURCE.rglob("*.py")
        if any(name in path.read_text(encoding="utf-8") for name in starting)
    }
    assert found == {"processes.py", "study/pool.py"}  # the pool catches an error of subprocess

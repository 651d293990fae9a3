"""Shell lines about a Ray cluster, run on this machine with ports, and a home folder, of their own."""

from __future__ import annotations

import os
import shutil
import socket
import subprocess
import sys
from contextlib import ExitStack
from pathlib import Path
from tempfile import mkdtemp

import platformdirs
import pytest

from aftdeck.study.ray_connection import NEW_CLUSTER
from benchmarks.ray_nodes import node
from tests.pages import ROOT, Line
from tests.waits import WAIT_S

HEAD, CLIENT, FIRST = "6379", "ray://head:10001", "FIRST"
"""Port, address and machine of the cluster in the documents."""


LEAN = {"PYTHONPATH": str(ROOT / "tests" / "study" / "lean"), "PYTHONDONTWRITEBYTECODE": ""}
"""Variables with which a process of Ray starts faster: without a package that it does not need, and with bytecode."""


def free_port() -> int:
    """Return a port on which nothing listens."""
    with socket.socket() as found:
        found.bind(("127.0.0.1", 0))
        return int(found.getsockname()[1])


class Nodes:
    """Nodes that the lines of a page start; a context manager, which ends them."""

    def __init__(self, patch: pytest.MonkeyPatch) -> None:
        self._folder = Path(mkdtemp(prefix="ray"))  # short, because it becomes part of the paths of sockets
        self._ports = {"head": free_port(), "client": free_port()}
        self._nodes = ExitStack()
        patch.setenv("XDG_CACHE_HOME", str(platformdirs.user_cache_path()))  # the laws' machine code
        patch.setenv("HOME", str(self._folder))
        patch.setenv("RAY_TMPDIR", str(self._folder))
        for name in ("RAY_ADDRESS", "RAY_AUTH_MODE", "RAY_AUTH_TOKEN", "RAY_AUTH_TOKEN_PATH"):
            patch.delenv(name, raising=False)
        for name, value in (NEW_CLUSTER | LEAN).items():
            patch.setenv(name, value)

    def __enter__(self) -> Nodes:
        return self

    def __exit__(self, *_: object) -> None:
        self._nodes.close()
        shutil.rmtree(self._folder, ignore_errors=True)  # the last processes of a node may still write

    @staticmethod
    def takes(line: Line) -> bool:
        """Return whether a line is about the cluster."""
        return line.words[0] == "ray" or "--ray" in line.words

    def run(self, line: Line) -> None:
        """Run a line: start a node and wait for it, run a study of its own, or call another command of Ray."""
        program, *words = (self._here(word) for word in line.words)
        environment = os.environ | line.variables
        if words[0] == "start":
            if "--head" in words:
                words += ["--include-dashboard=false", f"--ray-client-server-port={self._ports['client']}"]
            log = self._folder / f"node-{line.place.partition(':')[2]}.log"
            self._nodes.enter_context(node(words[1:], environment, log))
            return
        module = "aftdeck" if program == "aftdeck" else "ray.scripts.scripts"
        shutil.rmtree("mine", ignore_errors=True)
        command = [sys.executable, "-m", module, *words]
        done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=WAIT_S, check=False)
        assert done.returncode == 0, f"{line.place}: {done.stdout}{done.stderr}"
        assert module != "aftdeck" or "4 successful" in done.stdout, done.stdout

    def _here(self, word: str) -> str:
        word = word.replace(CLIENT, f"ray://127.0.0.1:{self._ports['client']}").replace(FIRST, "127.0.0.1")
        return "study.toml" if word == "mine.toml" else word.replace(HEAD, str(self._ports["head"]))

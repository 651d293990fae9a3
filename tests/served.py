"""`aftdeck fly` and `aftdeck replay --open` in a process: asked once, and ended."""

from __future__ import annotations

import subprocess
import sys
from urllib.request import urlopen

from tests.waits import WAIT_S


def ask_and_end(*arguments: str) -> None:
    """Start a server on a free port without a browser, ask for its page, and end it."""
    command = [sys.executable, "-m", "aftdeck", *arguments, "--no-browser", "--port", "0"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        try:
            assert process.stdout is not None and process.stderr is not None
            first = process.stdout.readline()
            assert "http://127.0.0.1:" in first, first + process.stderr.read()
            address = "http://127.0.0.1:" + first.partition("http://127.0.0.1:")[2].split()[0]
            with urlopen(address, timeout=WAIT_S) as answer:
                assert answer.status == 200 and b"<html" in answer.read()
        finally:
            process.terminate()
        said = process.stderr.read()
        assert said == "", said
        process.wait(WAIT_S)

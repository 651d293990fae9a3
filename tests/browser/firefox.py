"""A stock Firefox, driven by WebDriver BiDi over its websocket. It draws in software.

https://w3c.github.io/webdriver-bidi/ lists the commands. On Linux, Firefox has WebGL only with a screen,
for example Xvfb.
"""

from __future__ import annotations

import itertools
import json
import os
import shutil
import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NamedTuple

from websockets.sync.client import ClientConnection, connect

from tests.browser.programs import running
from tests.waits import WAIT_S

NAMES = ("firefox-esr", "firefox")
PREFERENCES = {
    "webgl.force-enabled": True,  # by default, Firefox does not use software WebGL
    "remote.active-protocols": 1,
    "browser.shell.checkDefaultBrowser": False,
    "datareporting.policy.dataSubmissionEnabled": False,
    "app.update.auto": False,
}
ESCAPE = "\ue00c"


class Programs(NamedTuple):
    """Paths of Firefox and of the program that provides its screen."""

    firefox: str
    screen: str


def find_programs() -> Programs | None:
    """Return the Firefox and the Xvfb on PATH, or None if one of them is missing."""
    found = next((path for name in NAMES if (path := shutil.which(name))), None)
    screen = shutil.which("Xvfb")
    return Programs(found, screen) if found and screen else None


class Firefox:
    """A tab of a running Firefox."""

    def __init__(self, socket: ClientConnection) -> None:
        self._socket = socket
        self._numbers = itertools.count(1)
        self.errors: list[str] = []
        """Errors and warnings in the console of the pages."""
        self.command("session.new", capabilities={})
        self.command("session.subscribe", events=["log.entryAdded"])
        self._tab = self.command("browsingContext.getTree")["contexts"][0]["context"]

    def command(self, method: str, **params: Any) -> Any:  # the standard defines a result for each method
        """Send a command and return its result."""
        number = next(self._numbers)
        self._socket.send(json.dumps({"id": number, "method": method, "params": params}))
        while True:
            message = json.loads(self._socket.recv(timeout=WAIT_S))
            if message.get("method") == "log.entryAdded" and message["params"]["level"] in ("error", "warn"):
                self.errors.append(message["params"]["text"])
            if message.get("id") == number:
                assert message["type"] == "success", message
                return message["result"]

    def resize(self, width: int, height: int) -> None:
        """Set the size of the page [px]."""
        self.command("browsingContext.setViewport", context=self._tab, viewport={"width": width, "height": height})
        self.until(f"innerWidth === {width} && innerHeight === {height}")

    def go(self, address: str) -> None:
        """Open an address."""
        self.command("browsingContext.navigate", context=self._tab, url=address, wait="complete")

    def script(self, text: str) -> Any:  # a result of JavaScript has no type
        """Evaluate an expression in the page; if its value is a function, call it."""
        wrapped = f"(async () => {{ const made = ({text}); "
        wrapped += "return JSON.stringify(await (typeof made === 'function' ? made() : made)) ?? 'null'; })()"
        answer = self.command("script.evaluate", expression=wrapped, target={"context": self._tab}, awaitPromise=True)
        assert answer["type"] == "success", answer["exceptionDetails"]["text"]
        return json.loads(answer["result"]["value"])

    def until(self, condition: str) -> None:
        """Wait for a JavaScript condition, in which `frame` is the last frame shown."""
        ends = time.monotonic() + WAIT_S
        held = f"(() => {{ const frame = window.__aftdeck?.lastFrame; return Boolean({condition}); }})()"
        while not self.script(held):
            assert time.monotonic() < ends, f"not within {WAIT_S:g} s: {condition}"
            time.sleep(0.1)

    def press(self, *keys: str) -> None:
        """Press and release keys one after the other."""
        for key in keys:
            self._act("key", *({"type": kind, "value": key} for kind in ("keyDown", "keyUp")))

    def hold(self, key: str) -> None:
        """Press a key and hold it."""
        self._act("key", {"type": "keyDown", "value": key})

    def release(self, key: str) -> None:
        """Release a key."""
        self._act("key", {"type": "keyUp", "value": key})

    def point(self, *actions: dict[str, Any]) -> None:
        """Move the mouse and press or release its buttons."""
        self._act("pointer", *actions)

    def _act(self, kind: str, *actions: dict[str, Any]) -> None:
        source = {"type": kind, "id": kind, "actions": list(actions)}
        self.command("input.performActions", context=self._tab, actions=[source])


@contextmanager
def started(programs: Programs, folder: Path) -> Iterator[Firefox]:
    """Run a Firefox with a new profile in `folder` inside the `with` block."""
    lines = [f"user_pref({json.dumps(name)}, {json.dumps(value)});" for name, value in PREFERENCES.items()]
    (folder / "user.js").write_text("\n".join(lines), encoding="utf-8")
    port_file = folder / "WebDriverBiDiServer.json"
    with _screen(programs.screen) as display:
        command = [programs.firefox, "--remote-debugging-port", "0", "--profile", str(folder), "--no-remote"]
        environment = {**os.environ, "HOME": str(folder), "DISPLAY": display}
        with running(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=environment) as process:
            ends = time.monotonic() + WAIT_S
            while not (port_file.exists() and (text := port_file.read_text(encoding="utf-8"))):
                assert process.poll() is None and time.monotonic() < ends, "Firefox did not start"
                time.sleep(0.2)
            port = json.loads(text)["ws_port"]
            with connect(f"ws://127.0.0.1:{port}/session", max_size=None, open_timeout=WAIT_S) as socket:
                yield Firefox(socket)


@contextmanager
def _screen(program: str) -> Iterator[str]:
    """Run an invisible screen inside the `with` block; yield the name of its display."""
    command = [program, "-displayfd", "1", "-screen", "0", "1920x1200x24", "-nolisten", "tcp"]
    with running(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as process:
        assert process.stdout is not None
        yield f":{process.stdout.readline().decode().strip()}"

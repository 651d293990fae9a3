"""A stock Firefox, driven by WebDriver BiDi over its own websocket; it draws with the processor.

https://w3c.github.io/webdriver-bidi/ names the commands. Without a screen, as Xvfb is one, Firefox offers no WebGL on
Linux.
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

NAMES = ("firefox-esr", "firefox")
WAIT_S = 120.0
"""The longest wait for anything that Firefox, or a page in it, shall do [s]."""
PREFERENCES = {
    "webgl.force-enabled": True,  # it shuns drawing with the processor
    "remote.active-protocols": 1,
    "browser.shell.checkDefaultBrowser": False,
    "datareporting.policy.dataSubmissionEnabled": False,
    "app.update.auto": False,
}
ESCAPE = "\ue00c"


class Programs(NamedTuple):
    """What is needed: a Firefox, and a screen for it."""

    firefox: str
    screen: str


def find_programs() -> Programs | None:
    """The Firefox and the Xvfb on PATH; None where one of them is not there."""
    found = next((path for name in NAMES if (path := shutil.which(name))), None)
    screen = shutil.which("Xvfb")
    return Programs(found, screen) if found and screen else None


class Firefox:
    """One tab."""

    def __init__(self, socket: ClientConnection) -> None:
        self._socket = socket
        self._numbers = itertools.count(1)
        self.errors: list[str] = []
        """What pages have written to the console as errors and warnings."""
        self.command("session.new", capabilities={})
        self.command("session.subscribe", events=["log.entryAdded"])
        self._tab = self.command("browsingContext.getTree")["contexts"][0]["context"]

    def command(self, method: str, **params: Any) -> Any:  # what it answers is as the standard has it
        """Sends a command and waits for its answer."""
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
        """Gives the page a size [px]."""
        self.command("browsingContext.setViewport", context=self._tab, viewport={"width": width, "height": height})
        self.until(f"innerWidth === {width} && innerHeight === {height}")

    def go(self, address: str) -> None:
        """Opens an address."""
        self.command("browsingContext.navigate", context=self._tab, url=address, wait="complete")

    def script(self, text: str) -> Any:  # what a page returns has no type
        """Evaluates an expression in the page, or calls the function that it is."""
        wrapped = f"(async () => {{ const made = ({text}); "
        wrapped += "return JSON.stringify(await (typeof made === 'function' ? made() : made)) ?? 'null'; })()"
        answer = self.command("script.evaluate", expression=wrapped, target={"context": self._tab}, awaitPromise=True)
        assert answer["type"] == "success", answer["exceptionDetails"]["text"]
        return json.loads(answer["result"]["value"])

    def until(self, condition: str) -> None:
        """Waits for a condition of the page, in which `frame` is the last frame shown."""
        ends = time.monotonic() + WAIT_S
        held = f"(() => {{ const frame = window.__aftdeck?.lastFrame; return Boolean({condition}); }})()"
        while not self.script(held):
            assert time.monotonic() < ends, f"not within {WAIT_S:g} s: {condition}"
            time.sleep(0.1)

    def press(self, *keys: str) -> None:
        """Presses and lets go of keys, one after the other."""
        for key in keys:
            self._act("key", *({"type": kind, "value": key} for kind in ("keyDown", "keyUp")))

    def hold(self, key: str) -> None:
        """Presses a key and keeps it down."""
        self._act("key", {"type": "keyDown", "value": key})

    def release(self, key: str) -> None:
        """Lets go of a key."""
        self._act("key", {"type": "keyUp", "value": key})

    def point(self, *actions: dict[str, Any]) -> None:
        """Moves the mouse and its buttons."""
        self._act("pointer", *actions)

    def _act(self, kind: str, *actions: dict[str, Any]) -> None:
        source = {"type": kind, "id": kind, "actions": list(actions)}
        self.command("input.performActions", context=self._tab, actions=[source])


@contextmanager
def started(programs: Programs, folder: Path) -> Iterator[Firefox]:
    """A Firefox with a new profile in a folder, until this is left."""
    lines = [f"user_pref({json.dumps(name)}, {json.dumps(value)});" for name, value in PREFERENCES.items()]
    (folder / "user.js").write_text("\n".join(lines), encoding="utf-8")
    listens = folder / "WebDriverBiDiServer.json"
    with _screen(programs.screen) as display:
        command = [programs.firefox, "--remote-debugging-port", "0", "--profile", str(folder), "--no-remote"]
        environment = {**os.environ, "HOME": str(folder), "DISPLAY": display}
        with running(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=environment) as process:
            ends = time.monotonic() + WAIT_S
            while not (listens.exists() and (told := listens.read_text(encoding="utf-8"))):
                assert process.poll() is None and time.monotonic() < ends, "Firefox did not start"
                time.sleep(0.2)
            port = json.loads(told)["ws_port"]
            with connect(f"ws://127.0.0.1:{port}/session", max_size=None, open_timeout=WAIT_S) as socket:
                yield Firefox(socket)


@contextmanager
def _screen(program: str) -> Iterator[str]:
    """A screen that nobody sees, by the name of its display."""
    command = [program, "-displayfd", "1", "-screen", "0", "1920x1200x24", "-nolisten", "tcp"]
    with running(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as process:
        assert process.stdout is not None
        yield f":{process.stdout.readline().decode().strip()}"

"""Benchmarks of the program in separate processes: its help, its start, and its response to a stick."""

from __future__ import annotations

import os
import random
import subprocess
import sys
import time
import urllib.request
from collections.abc import Iterator
from contextlib import contextmanager
from typing import NamedTuple

import msgspec
from websockets.sync.client import ClientConnection, connect

from aftdeck.station.messages import from_page, kinds, to_page
from aftdeck.station.messages.frame import Frame
from aftdeck.station.messages.welcome import Welcome
from benchmarks.measure import Figure, percentile

AFTDECK = (sys.executable, "-m", "aftdeck")
WAIT = 60.0
"""Longest wait [s]."""


class Size(NamedTuple):
    """Extent of the measurement.

    Attributes:
        helps: number of times that the help is printed.
        processes: number of processes that import the package; the first one fills the caches.
        starts: number of times that the station is started; the first one fills the caches.
        messages: number of messages whose latency is measured.
    """

    helps: int
    processes: int
    starts: int
    messages: int


FULL, TINY = Size(8, 6, 4, 500), Size(1, 1, 1, 5)

_messages: msgspec.json.Decoder[to_page.FromServer] = msgspec.json.Decoder(to_page.FromServer)


def help_page(size: Size) -> list[Figure]:
    """Measure ``aftdeck --help``, from its start to its end."""
    took = []
    for _ in range(size.helps):
        start = time.perf_counter()
        subprocess.run([*AFTDECK, "--help"], check=True, capture_output=True, timeout=WAIT)
        took.append(time.perf_counter() - start)
    return [
        Figure("aftdeck --help", min(took), "s", 0.3, f"best of {len(took)}"),
        Figure("aftdeck --help, median", percentile(took, 50), "s"),
    ]


def first_use(size: Size) -> list[Figure]:
    """Measure loading an arm and the first step of a simulation, each in a new process with its imports."""
    arm, step = (_new(one, size.processes) for one in ("load_arm('srms')", "Simulation('first-flight').step()"))
    best = f"best of {max(1, size.processes - 1)} processes"
    return [
        Figure("load_arm", arm, "s", 0.3, f"with its imports, {best}"),
        Figure("first step of a simulation", step, "s", 2.0, f"with its imports, warm cache, {best}"),
    ]


def _new(call: str, processes: int) -> float:
    """Return the shortest time in which a new process imports the package and calls one of its functions [s]."""
    code = f"import time; t = time.perf_counter(); import aftdeck; aftdeck.{call}; print(time.perf_counter() - t)"
    command = [sys.executable, "-c", code]
    took = [
        float(subprocess.run(command, check=True, capture_output=True, text=True, timeout=WAIT).stdout)
        for _ in range(processes)
    ]
    return min(took[1:] or took)  # the first process fills the caches


def start(size: Size) -> list[Figure]:
    """Measure the time from the start of ``aftdeck fly --no-browser`` to the page, and to the page's first frame."""
    pages, frames = [], []
    for _ in range(size.starts):
        begun = time.perf_counter()
        with flying() as address:
            with urllib.request.urlopen(f"http://{address}/", timeout=WAIT) as answer:
                answer.read()
            with _greeting(address) as socket:
                next_message(socket)
                page = time.perf_counter() - begun
                _frame(socket)
            pages.append(page)
            frames.append(time.perf_counter() - begun)
    pages, frames = pages[1:] or pages, frames[1:] or frames  # the first run fills the caches
    best = f"warm cache, best of {len(pages)}"
    return [
        Figure("aftdeck fly to a page", min(pages), "s", 1.5, f"to a line of progress, {best}"),
        Figure("aftdeck fly to a first frame", min(frames), "s", 4.0, f"over the WebSocket, {best}"),
    ]


def latency(size: Size) -> list[Figure]:
    """Measure the time from the sending of a `Sticks` message to the arrival of the first frame that used it."""
    took, pause = [], random.Random(1)
    with flying() as address, page_of(address) as socket:
        for seq in range(size.messages):
            time.sleep(pause.uniform(0.0, 0.02))  # messages arrive at random times within a control period
            sent = time.perf_counter()
            socket.send(
                msgspec.json.encode(from_page.Sticks(seq, (0.01 * (seq % 2), 0.0, 0.0), (0.0, 0.0, 0.0), 0.0)).decode()
            )
            while True:
                message = next_message(socket)
                if isinstance(message, Frame) and message.display.stick_seq >= seq:
                    break
            took.append(1e3 * (time.perf_counter() - sent))
    return [
        Figure("stick to frame, p50", percentile(took, 50), "ms", None, f"{len(took)} messages, loopback"),
        Figure("stick to frame, p99", percentile(took, 99), "ms", 22.0, "control period 20 ms + 2 ms"),
        Figure("stick to frame, worst", max(took), "ms"),
    ]


@contextmanager
def flying(scenario: str = "first-flight", **variables: str) -> Iterator[str]:
    """Run ``aftdeck fly`` with further environment variables during the `with` block; yield its host and port."""
    command = [*AFTDECK, "fly", scenario, "--no-browser", "--port", "0"]
    environment = {**os.environ, **variables}
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=environment) as process:
        assert process.stdout is not None
        try:
            yield process.stdout.readline().partition("http://")[2].strip().rstrip("/")
        finally:
            process.terminate()
            process.wait(10)


@contextmanager
def _greeting(address: str) -> Iterator[ClientConnection]:
    """Connect as a page and send `hello`."""
    with connect(f"ws://{address}/ws", compression=None, open_timeout=WAIT) as socket:
        socket.send(msgspec.json.encode(from_page.Hello(kinds.PROTOCOL)).decode())
        yield socket


@contextmanager
def page_of(address: str) -> Iterator[ClientConnection]:
    """Connect as a page and wait for `welcome`."""
    with _greeting(address) as socket:
        while not isinstance(next_message(socket), Welcome):
            pass
        yield socket


def next_message(socket: ClientConnection) -> to_page.FromServer:
    """Return the next message of the station."""
    return _messages.decode(socket.recv(timeout=WAIT))


def _frame(socket: ClientConnection) -> Frame:
    while not isinstance(message := next_message(socket), Frame):
        pass
    return message

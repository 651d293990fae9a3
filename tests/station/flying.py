"""A session in flight without a server, of which no frame is lost."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from queue import Empty, SimpleQueue

import msgspec
import pytest

from aftdeck.recording.trial import NO_TRIAL, Trial
from aftdeck.scenario.model import Scenario
from aftdeck.station.messages.frame import Frame
from aftdeck.station.session.session import Session
from tests.station.pages import WAIT_S, scenario

_frames = msgspec.json.Decoder(Frame)


class Flown(Session):
    """A session that keeps every frame until `comes` has looked at it, so that a slow test passes none over."""

    def start(self, told: Callable[[], None]) -> None:
        """Begin to fly."""
        self.frames: SimpleQueue[bytes] = SimpleQueue()

        def keep() -> None:
            self.frames.put(self.newest)
            told()

        super().start(keep)


@contextmanager
def flying(
    *,
    demo: bool = False,
    name: str = "first-flight",
    made: Scenario | None = None,
    record: Path | None = None,
    trial: Trial = NO_TRIAL,
) -> Iterator[Flown]:
    """A session in flight that has shown its first frame."""
    session = Flown(made or scenario(name), demo=demo, record=record, trial=trial)
    session.start(lambda: None)
    try:
        comes(session, lambda frame: frame.tick == 1, "the first frame")
        yield session
    finally:
        session.close()


def shown(session: Session) -> Frame:
    """The newest frame."""
    return _frames.decode(session.newest)


def comes(session: Flown, met: Callable[[Frame], bool], what: str) -> Frame:
    """The first frame that is as wanted after the one that this returned last."""
    end = time.monotonic() + WAIT_S
    try:
        while True:
            frame = _frames.decode(session.frames.get(timeout=max(end - time.monotonic(), 0.0)))
            if met(frame):
                return frame
    except Empty:
        pytest.fail(f"waited {WAIT_S:g} s in vain: {what}")


def goes_on(session: Flown, steps: int = 10) -> Frame:
    """The frame so many steps after the newest one."""
    tick = shown(session).tick
    return comes(session, lambda frame: frame.tick >= tick + steps, f"{steps} steps more")

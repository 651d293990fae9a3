"""A session without a server: stepped by its test, or by its driver."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import msgspec
import pytest

from aftdeck.recording.trial import NO_TRIAL, Trial
from aftdeck.scenario.model import Scenario
from aftdeck.station.messages.frame import Frame
from aftdeck.station.session.driver import Driver
from aftdeck.station.session.session import Session
from tests.station.pages import scenario, until

MOST_STEPS = 5000
"""Largest number of steps in which something comes about: a hundred seconds of a run."""

_frames = msgspec.json.Decoder(Frame)


class Flown(Session):
    """A session whose time stands still until the test moves it on: `now` is what its clock shows [s]."""

    def __init__(
        self,
        scenario: Scenario,
        *,
        demo: bool = False,
        record: Path | None = None,
        trial: Trial = NO_TRIAL,
    ) -> None:
        self.now = 100.0
        super().__init__(scenario, demo=demo, record=record, trial=trial, clock=lambda: self.now)


@contextmanager
def flying(
    *,
    demo: bool = False,
    name: str = "first-flight",
    made: Scenario | None = None,
    record: Path | None = None,
    trial: Trial = NO_TRIAL,
) -> Iterator[Flown]:
    """A session that has shown its first frame."""
    session = Flown(made or scenario(name), demo=demo, record=record, trial=trial)
    session.begin()
    try:
        assert steps(session, 1).tick == 1
        yield session
    finally:
        session.close()


def shown(session: Session) -> Frame:
    """The newest frame."""
    return _frames.decode(session.newest)


def comes(session: Session, met: Callable[[Frame], bool], what: str) -> Frame:
    """The frame of the first step from now on that is as wanted."""
    for _ in range(MOST_STEPS):
        if met(frame := steps(session, 1)):
            return frame
    pytest.fail(f"{MOST_STEPS} steps in vain: {what}")


def steps(session: Session, number: int = 10) -> Frame:
    """The frame after so many steps."""
    for _ in range(number):
        session.step()
    return shown(session)


@contextmanager
def driven(*, record: Path | None = None) -> Iterator[Driver]:
    """A session that its driver steps in real time, and that has shown its first frame."""
    driver = Driver(Session(scenario(), record=record))
    driver.start(lambda: None)
    try:
        until(lambda: driver.session.newest != b"", "the first frame")
        yield driver
    finally:
        driver.close()

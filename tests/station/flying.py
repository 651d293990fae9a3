"""Sessions without a server, stepped by the test or by a driver."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import msgspec
import pytest

from aftdeck.recording.trial import NO_TRIAL, Trial
from aftdeck.scenario.model import Scenario
from aftdeck.station.core.autopilot import Autopilots
from aftdeck.station.messages.frame import Frame
from aftdeck.station.session.driver import Driver
from aftdeck.station.session.session import Session
from tests.loaded import scenario
from tests.station.pages import until

MAX_STEPS = 5000
"""Maximum number of steps to wait for a condition: a hundred seconds of a run."""

_frames = msgspec.json.Decoder(Frame)


class Flown(Session):
    """Session whose clock shows `now` [s], which only the test changes."""

    def __init__(
        self,
        scenario: Scenario,
        *,
        demo: bool = False,
        autopilots: Autopilots | None = None,
        record: Path | None = None,
        trial: Trial = NO_TRIAL,
    ) -> None:
        self.now = 100.0
        super().__init__(scenario, demo=demo, autopilots=autopilots, record=record, trial=trial, clock=lambda: self.now)


@contextmanager
def flying(
    *,
    demo: bool = False,
    autopilots: Autopilots | None = None,
    name: str = "first-flight",
    made: Scenario | None = None,
    record: Path | None = None,
    trial: Trial = NO_TRIAL,
) -> Iterator[Flown]:
    """Yield a session after its first step."""
    session = Flown(made or scenario(name), demo=demo, autopilots=autopilots, record=record, trial=trial)
    session.begin()
    try:
        assert steps(session, 1).tick == 1
        yield session
    finally:
        session.close()


def shown(session: Session) -> Frame:
    """Return the newest frame."""
    return _frames.decode(session.newest)


def step_until(session: Session, condition: Callable[[Frame], bool], what: str) -> Frame:
    """Step until `condition` accepts the frame, and return that frame; `what` names the condition."""
    for _ in range(MAX_STEPS):
        if condition(frame := steps(session, 1)):
            return frame
    pytest.fail(f"not within {MAX_STEPS} steps: {what}")


def steps(session: Session, number: int = 10) -> Frame:
    """Do `number` steps, and return the last frame."""
    for _ in range(number):
        session.step()
    return shown(session)


@contextmanager
def driven(*, record: Path | None = None) -> Iterator[Driver]:
    """Yield the driver of a session that runs in real time, after its first step."""
    driver = Driver(Session(scenario(), record=record))
    driver.start(lambda: None)
    try:
        until(lambda: driver.session.newest != b"", "the first frame")
        yield driver
    finally:
        driver.close()

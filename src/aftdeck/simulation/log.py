"""Lines that a step adds to the log, with the time at the end of the step."""

from __future__ import annotations

from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.frame import Event, Level
from aftdeck.simulation.state import State


def log(flight: Flight, state: State, kind: str, level: Level, text: str) -> None:
    """Add a line to the log, with the time at the end of the present step."""
    time = state.tick * flight.scenario.control_period
    state.events.append(Event(round(time, 9), kind, level, text))


def log_rejection(flight: Flight, state: State, text: str) -> None:
    """Log a rejected command and the reason."""
    log(flight, state, "refused", "caution", text)


def joint_label(joint: str) -> str:
    """Return a joint's name in words: ``elbow pitch`` for ``elbow_pitch``."""
    return joint.replace("_", " ")

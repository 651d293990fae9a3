"""The log: lines of a step, stamped with its end."""

from __future__ import annotations

from aftdeck.simulation.flight import Flight
from aftdeck.simulation.frame import Event, Level
from aftdeck.simulation.state import State


def log(flight: Flight, state: State, kind: str, level: Level, text: str) -> None:
    """Write a line of the log, at the end of the step under way."""
    time = state.tick * flight.scenario.control_period
    state.events.append(Event(round(time, 9), kind, level, text))


def refuse(flight: Flight, state: State, text: str) -> None:
    """Tell the operator of a command that was not taken, and why."""
    log(flight, state, "refused", "caution", text)


def spoken(joint: str) -> str:
    """``elbow pitch`` for ``elbow_pitch``."""
    return joint.replace("_", " ")

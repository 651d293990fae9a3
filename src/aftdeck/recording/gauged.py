"""Readings of gauges in a recorded run: a recording has none, and a re-simulation with gauges gives them."""

from __future__ import annotations

from collections.abc import Iterator

from aftdeck.compiled_first import compiled_first
from aftdeck.errors import RecordingError
from aftdeck.plant.readings import Readings
from aftdeck.recording.apart import further, within_tolerance
from aftdeck.recording.bundle import scenario_of
from aftdeck.recording.convert import DIGITS, as_recorded, inputs_of
from aftdeck.recording.message import Message
from aftdeck.recording.reader import Recording
from aftdeck.recording.records import FrameRecord, Input
from aftdeck.simulation.run import Simulation
from aftdeck.simulation.state import State
from aftdeck.simulation.warm import warm_up
from aftdeck.state_part import declaration


def messages_of(recording: Recording, *, gauged: bool) -> Iterator[tuple[Message, Readings | None]]:
    """Yield the messages of a recording, and with each frame its step's readings, if there are any.

    If `gauged` is true and the run has masses, a re-simulation gives the readings.

    Raises:
        RecordingError: as for `Recording.messages`; or a step of the re-simulation differs from the recorded one by
            more than the tolerance for another environment (`recording.apart`).
    """
    opening = recording.opening
    scenario = scenario_of(opening) if gauged else None
    if scenario is None or scenario.plant == "kinematic":
        yield from ((message, None) for message in recording.messages_on_demand())
        return
    compiled_first(warm_up, scenario)
    digests = opening.digests == declaration(State)
    sim = Simulation(scenario, opening.seed, gauged=True)
    for entry in recording.entries_with_inputs():
        message, readings = entry.message, None
        if isinstance(message, Input):
            sim.advance(inputs_of(message))
        elif isinstance(message, FrameRecord):
            if not (digests and sim.seal().hex()[:DIGITS] == message.sha256):
                _check(recording, message, sim)
            readings = sim.readings
        if message is not None:
            yield message, readings


def _check(recording: Recording, recorded: FrameRecord, sim: Simulation) -> None:
    """Check a step whose digests differ or cannot be compared.

    Raises:
        RecordingError: lengths or angles differ by more than the tolerance.
    """
    if not within_tolerance(further(None, recorded, as_recorded(sim.look()))):
        raise RecordingError(
            f"{recording.path}: its re-simulation differs from it at {recorded.time_s:.2f} s, so that there are no "
            "readings of gauges; `aftdeck replay` shows the difference"
        )

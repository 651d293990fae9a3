"""Steps of a session, made by a core or from a frame."""

from __future__ import annotations

from aftdeck.recording.delays import Delays
from aftdeck.report.lamps import Lamp
from aftdeck.scenario.light import Lighting, conditions
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.inputs import Inputs
from aftdeck.station.core.asked import Asked
from aftdeck.station.core.core import Core, Recording
from aftdeck.station.core.page_inputs import PageInputs
from aftdeck.station.core.step import Step
from aftdeck.station.messages.frame import LinkSteps


def one_step(recording: Recording, made: Scenario) -> None:
    """Begin a run of a scenario with this recording, and make one step."""
    core = Core(made, clock=lambda: 0.0, recording=recording)
    core.begin()
    core.advance(core.take())


def step_of(frame: Frame, lamps: tuple[Lamp, ...], monitors: tuple[tuple[str, ...], ...]) -> Step:
    """Return a step with this frame."""
    lighting = Lighting(conditions()[0].name, (), ())
    asked = Asked(PageInputs(0).take(0.0, rate_held=False), None, monitors, lighting, "", {})
    return Step(
        frame.tick,
        0.0,
        0.0,
        None,
        Delays(),
        False,
        [],
        asked=asked,
        inputs=Inputs(),
        frame=frame,
        lamps=lamps,
        autopilot=None,
        link=LinkSteps(frame.tick, frame.tick, frame.tick, ()),
    )

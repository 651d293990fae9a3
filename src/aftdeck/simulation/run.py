"""A simulation that callers step, and a run without a screen from first frame to summary."""

from __future__ import annotations

import hashlib
import math
from collections.abc import Callable
from pathlib import Path
from typing import Literal

import msgspec

from aftdeck.errors import InputError, SimulationError
from aftdeck.scenario.load import load_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.begin import first_state
from aftdeck.simulation.flight import prepare
from aftdeck.simulation.frame import Event, Frame
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.look import look
from aftdeck.simulation.look_ahead import Ahead, Axis, look_ahead
from aftdeck.simulation.look_work import all_near
from aftdeck.simulation.plain import plain_inputs, whole
from aftdeck.simulation.resume import resume
from aftdeck.simulation.step import step
from aftdeck.simulation.summary import Summary, Tally
from aftdeck.state_part import digest, encoded
from aftdeck.worksite.report import Near


class SavedSimulation(msgspec.Struct, frozen=True):
    """A simulation's state at an instant, with the scenario and seed that it belongs to."""

    scenario: str
    """SHA-256 of the scenario's text and the arm's constants."""
    seed: int
    state: bytes
    """`aftdeck.state_part.encoded` makes them."""


class Simulation:
    """One flight of a scenario, stepped by its caller.

    Attributes:
        scenario: what is flown.
        seed: of everything random (nothing is, on the kinematic plant).
    """

    def __init__(self, scenario: Scenario | str | Path, seed: int | None = None) -> None:
        self.scenario = scenario if isinstance(scenario, Scenario) else load_scenario(scenario)
        self.seed = self.scenario.seed if seed is None else whole(seed, "seed")
        self._frame: Frame | None = None
        self._seal = b""
        self._given: Inputs | None = None
        self._flown = Inputs()
        self._flight = prepare(self.scenario)
        self._state = first_state(self._flight)
        constants = f"{self.scenario.text}\n{self.scenario.arm.model.source}"
        self._stepped = False
        self._digest = hashlib.sha256(constants.encode()).hexdigest()

    @property
    def ended(self) -> Literal["", "completed", "time", "fault"]:
        """How the scenario's script ended; empty while it has not. Flying by hand never ends it."""
        return self._state.script.ended

    @property
    def frame(self) -> Frame | None:
        """The last step's frame; None before the first, and after `restore` till the next."""
        return self.look() if self._stepped else None

    @property
    def cameras(self) -> tuple[str, ...]:
        """Names of the cameras that can be turned."""
        return self._flight.cameras.names

    @property
    def given(self) -> Inputs | None:
        """The inputs of the last step as they were given; None where the script flew it, or none was made."""
        return self._given

    def step(self, inputs: Inputs | None = None) -> Frame:
        """Advance by one control period and look: `advance`, whose arguments and errors these are, and `look`."""
        self.advance(inputs)
        return self.look()

    def advance(self, inputs: Inputs | None = None) -> None:
        """Advance by one control period.

        Args:
            inputs: sticks and switches; None lets the scenario's script fly.

        Raises:
            InputError: inputs that no hand controller can give, a target that is none or contradicts itself, a
                camera that cannot be turned; nothing has changed.
            SimulationError: the state is no longer finite.
        """
        if inputs is not None:
            inputs.check(self._state.arm)
            if inputs.camera is not None:
                self._flight.cameras.check(inputs.camera)
            inputs = plain_inputs(inputs)
        state = self._state
        self._flown = step(self._flight, state, inputs)
        self._given = inputs
        self._stepped, self._frame, self._seal = True, None, b""
        angles = state.plant.angles.tolist()
        if not math.isfinite(sum(angles)):
            time = state.tick * self.scenario.control_period
            raise SimulationError(f"the arm's state is no longer finite at {time:g} s: {angles}")

    def seal(self) -> bytes:
        """SHA-256 of the state after the last step, to the last digit: `Frame.sha256` shows it."""
        if not self._seal:
            self._seal = digest(self._state)
        return self._seal

    def look(self) -> Frame:
        """All that may be known of the last step. To look changes nothing, and costs about as much as a step."""
        if self._frame is None:
            self._frame = look(self._flight, self._state, self.seal())
        return self._frame

    def ahead(self, seconds: float = 5.0, last: Axis | None = None) -> Ahead:
        """What the sticks as they stand would do in some seconds.

        Args:
            seconds: how far to look, 2 to 20 [s].
            last: the axis that is shown at full deflection where the sticks rest, and its sign; None: none.

        Raises:
            InputError: seconds or an axis that are none of these.
        """
        return look_ahead(self._flight, self._state, seconds, last)

    def watched(self) -> tuple[Near, ...]:
        """Every pair of parts that is watched now, nearest first: clearance, closest points, plane, closing speed."""
        return all_near(self._flight, self._state)

    def save(self) -> SavedSimulation:
        """Everything that the next step depends on; plain values, msgspec encodes them."""
        return SavedSimulation(self._digest, self.seed, encoded(self._state))

    def restore(self, saved: SavedSimulation) -> None:
        """Go on from what `save` gave, in this or in another simulation of the same scenario.

        Raises:
            InputError: it was saved from another scenario, or is no saved state; nothing has changed.
        """
        if saved.scenario != self._digest:
            raise InputError(
                f"the saved state belongs to a scenario with digest {saved.scenario[:12]}, this one is "
                f"{self.scenario.name!r} with {self._digest[:12]}"
            )
        self._state = resume(self._flight, saved.state)
        self.seed = saved.seed
        self._stepped, self._frame, self._given, self._seal = False, None, None, b""


class Run(msgspec.Struct, frozen=True):
    """A run from its first frame to its end."""

    scenario: Scenario
    frames: tuple[Frame, ...]
    events: tuple[Event, ...]
    summary: Summary


def run(
    scenario: Scenario | str | Path,
    seed: int | None = None,
    *,
    inputs: Callable[[Simulation], Inputs | None] | None = None,
    keep_frames: bool = True,
    progress: Callable[[float], None] | None = None,
    seen: Callable[[Frame], None] | None = None,
    stepped: Callable[[Simulation], None] | None = None,
) -> Run:
    """Fly a scenario's script, or given inputs, to the end without a screen.

    Args:
        scenario: a scenario, a built-in name or a path.
        seed: in place of the scenario's.
        inputs: asked before every step for a person's inputs, which fly in place of the script; None ends the run.
        keep_frames: False keeps only the last frame, for long runs.
        progress: told now and then how much of the longest duration has gone, 0 to 1.
        seen: told of every frame.
        stepped: called after every step with the simulation.

    Raises:
        InputError: `inputs` gives none for the first step, or some that no hand controller can give.
    """
    sim = Simulation(scenario, seed)
    frames: list[Frame] = []
    tally = Tally()
    while not sim.ended:
        given = None if inputs is None else inputs(sim)
        if given is None and inputs is not None:
            break
        sim.advance(given)
        tally.take(sim._state, sim.seal())
        if keep_frames or seen is not None:
            frame = sim.look()
            if keep_frames:
                frames.append(frame)
            if seen is not None:
                seen(frame)
        if stepped is not None:
            stepped(sim)
        if progress is not None and tally.ticks % 256 == 0:
            progress(tally.ticks / sim.scenario.ticks)
    if tally.ticks == 0:
        raise InputError("there are no inputs to fly: none is given for the first step")
    last = sim.look()
    summary = tally.summary(sim.scenario, sim.seed, sim.ended or "completed", last)
    return Run(sim.scenario, tuple(frames) if keep_frames else (last,), tuple(tally.events), summary)

"""A synthetic operator of one run: it reads frames, follows the steps of the task, and moves sticks and switches."""

from __future__ import annotations

import msgspec

from aftdeck.arms.load import PorLimits
from aftdeck.errors import InputError
from aftdeck.operators.approach import Speeds
from aftdeck.operators.decide import decide
from aftdeck.operators.hand import Hand
from aftdeck.operators.spec import OperatorSpec
from aftdeck.scenario.limits import por_with
from aftdeck.scenario.load import in_force
from aftdeck.scenario.model import Scenario
from aftdeck.scene.stick_axes import StickAxes
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.task.progress import Progress

PATIENCE_S = 600.0
"""Time without a completed step after which an operator gives up [s]."""
PERFECT_GAIN = 1.0
"""Gain of the perfect operator [1/s]."""
AGAIN_S = 2.0
"""Time after which an operator presses the same switch again [s]."""
_SWITCHES = ("mode", "rate", "effector", "latch", "proceed")
_NOTHING = tuple(getattr(Inputs(), name) for name in _SWITCHES)
BEYOND_DEADBAND = 1.6
"""Least deflection of a human operator, as a multiple of the deadband; assumed."""


class Pilot:
    """A synthetic operator; `aftdeck.run` calls it before each step.

    Attributes:
        progress: progress through the task.
    """

    def __init__(self, scenario: Scenario, spec: OperatorSpec, seed: int) -> None:
        self.progress = Progress(scenario)
        self._scenario, self._axes = scenario, StickAxes(scenario)
        human = spec.kind == "human"
        self._gain = float(spec.gain) if human else PERFECT_GAIN
        self._least = BEYOND_DEADBAND * spec.deadband if human else 0.0
        self._hand = Hand(spec, seed, scenario.control_period) if human else None
        self._thinking = float(spec.thinking) if human else 0.0
        self._limits: dict[tuple[tuple[str, ...], float], PorLimits] = {}
        rule = scenario.worksite.translation
        self._orbiter: Speeds | None = None
        if rule is not None:
            both = (rule.speed, rule.speed)
            por = PorLimits(both, both, rule.speed / rule.reached_in, rule.speed / rule.reached_in)
            self._orbiter = Speeds(rule.speed, rule.speed, self._gain, por, self._least)
        self._read: set[tuple[int, int]] = set()
        self._until = self._since = self._pressed_at = 0.0
        self._pressed = _NOTHING

    def __call__(self, sim: Simulation) -> Inputs | None:
        """Return the inputs of the next step; None if the task is complete, or if the operator gives up."""
        frame = sim.frame
        if frame is None:
            return Inputs()
        if self.progress.see(frame):
            self._since = frame.time_s
        if self.progress.present is None or frame.time_s > self._since + PATIENCE_S:
            return None
        wanted = self._pressed_once(self._wanted(frame), frame.time_s)
        return wanted if self._hand is None else self._hand.moved(wanted)

    def _wanted(self, frame: Frame) -> Inputs:
        text = (self.progress.at, self.progress.hint())
        if text not in self._read:
            self._read.add(text)
            self._until = frame.time_s + self._thinking
        if frame.time_s < self._until:
            return Inputs()
        speeds = Speeds(*frame.por_limits, self._gain, self._por(frame), self._least)
        return decide(frame, self.progress, self._axes.in_l(frame), speeds, self._orbiter)

    def _pressed_once(self, wanted: Inputs, time_s: float) -> Inputs:
        """Return the inputs without a switch that was pressed in the same way less than `AGAIN_S` ago."""
        pressed = tuple(getattr(wanted, name) for name in _SWITCHES)
        if pressed == _NOTHING or pressed != self._pressed or time_s >= self._pressed_at + AGAIN_S:
            if pressed != _NOTHING:
                self._pressed, self._pressed_at = pressed, time_s
            return wanted
        return msgspec.structs.replace(wanted, **dict(zip(_SWITCHES, _NOTHING, strict=True)))

    def _por(self, frame: Frame) -> PorLimits:
        """Return the limits of the point of resolution for the mass that the end effector holds."""
        scenario, mass = in_force(self._scenario, frame.changes), 0.0
        if frame.attached:
            mass = scenario.own_payloads[frame.attached - 1].mass
        else:
            held = (own.mass for own, now in zip(scenario.payloads, frame.work.cargo, strict=True) if now.held)
            mass = next(held, 0.0)
        key = frame.changes, mass
        if key not in self._limits:
            self._limits[key] = por_with(scenario.arm.model, mass, scenario.por)
        return self._limits[key]


def pilot(scenario: Scenario, spec: OperatorSpec, seed: int) -> Pilot:
    """Return a synthetic operator for one run, as the argument `inputs` of `aftdeck.run`.

    Args:
        scenario: the scenario.
        spec: parameters of the operator, of the kind ``perfect`` or ``human``.
        seed: seed of the operator's noise.

    Raises:
        InputError: the scenario has no steps, or the kind is ``script``.
    """
    if spec.kind == "script":
        raise InputError("operator: kind 'script' is the scenario's script, which needs no pilot")
    if not scenario.steps:
        raise InputError(f"operator: {scenario.name} has no steps ([[step]]) that an operator could follow")
    return Pilot(scenario, spec, seed)

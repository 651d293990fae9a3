"""Pilot that flies a scenario with a policy of Capture, Extract or Dock, and with a synthetic operator up to there."""

from __future__ import annotations

from aftdeck.errors import InputError
from aftdeck.gym.mission.actions import Rate, inputs_of, repeats_of
from aftdeck.gym.mission.definition import MISSIONS, observations
from aftdeck.gym.mission.observation import Observer
from aftdeck.gym.mission.starts import step_of
from aftdeck.gym.policy import Policy
from aftdeck.operators.pilot import Pilot
from aftdeck.operators.spec import OperatorSpec
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.task.remaining import Aims


class MissionPilot:
    """A policy in one run of a scenario.

    The perfect synthetic operator flies the earlier steps of the task. Where the episodes of the environment start, the
    policy takes over, and flies until the environment's step is done; then the pilot ends.

    Attributes:
        flying: whether the policy flies now.
    """

    def __init__(self, scenario: Scenario, policy: Policy) -> None:
        self._mission, joints = MISSIONS[policy.environment], len(scenario.arm.joints)
        expected = sum(group.size for group in observations(joints))
        if len(policy.mean) != expected:
            raise InputError(
                f"policy: takes {len(policy.mean)} observations; {policy.environment} has {expected} for the {joints} "
                f"joints of {scenario.arm.name!r}"
            )
        self._step = step_of(self._mission, scenario)
        self._last = scenario.steps.index(self._step)
        self._scenario, self._policy = scenario, policy
        self._operator = Pilot(scenario, OperatorSpec("perfect"), scenario.seed)
        self._aims, self._repeats = Aims(scenario), repeats_of(scenario)
        self._observer: Observer | None = None
        self._inputs, self._until = Inputs(), 0
        self._rate: Rate = "coarse"
        self.flying = False

    def __call__(self, sim: Simulation) -> Inputs | None:
        """Return the inputs of the next step; None if the policy's step is done, or if the operator gives up."""
        frame = sim.frame
        by_operator = self._operator(sim)
        if frame is None:
            return by_operator
        if by_operator is None or self._operator.progress.at > self._last:
            return None
        if not self.flying:
            if not self._is_near(frame):
                return by_operator
            self.flying, self._until = True, frame.tick + 1
            self._inputs = Inputs(mode=self._step.mode, rate="coarse")
            return self._inputs
        if self._observer is None:
            self._observer = Observer(self._scenario, self._step, frame)
        if frame.tick >= self._until:
            action = self._policy.act(self._observer.of(sim)[0]).tolist()
            self._inputs, self._until = inputs_of(self._mission, action, self._rate), frame.tick + self._repeats
            self._rate = self._inputs.rate or self._rate
        return self._inputs

    def _is_near(self, frame: Frame) -> bool:
        """Return whether the tip, or the held payload, is as near to the step's place as at the start of an episode."""
        left = self._aims.remaining(frame, self._step)
        return left is not None and left.distance <= self._mission.spread.greatest

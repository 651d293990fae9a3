"""What the environments of one scenario share: the step that they fly, its random starts, and its observer."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.pose import rows, vec3
from aftdeck.errors import ScenarioError
from aftdeck.files import Where
from aftdeck.gym.batch_step import NoStartError
from aftdeck.gym.choices import PLANTS, one_of
from aftdeck.gym.mission.actions import repeats_of
from aftdeck.gym.mission.definition import Mission
from aftdeck.gym.mission.observation import Observer
from aftdeck.gym.mission.score import CONTACT, is_decided, limits_of, may_be_done, may_hold
from aftdeck.gym.mission.starts import Starts, base_of, step_of
from aftdeck.gym.terms import Floats32
from aftdeck.scenario.load import load_scenario
from aftdeck.scenario.model import Scenario, Start
from aftdeck.scenario.schema import Plant
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.task.reached import Since, reached
from aftdeck.task.remaining import Aims

_TRIES = 100
"""Greatest number of random starts that are tried until one has no contact."""


class MissionTask:
    """One step of a scenario's task, for any number of simulations.

    Args:
        mission: the environment.
        scenario: name of a built-in scenario, or path of a scenario file; None for the usual one.
        plant: ``kinematic``, ``rigid`` or ``flexible``.

    Attributes:
        scenario: the scenario.
        step: the step of its task that is flown.
        repeats: number of control periods in a step of the environment.
        first: inputs of the first control period: sticks centred, mode of the task's step, rate setting coarse.
        aims: finder of the remaining motion from frames.
        observer: the observer.
        limits: what a complete task needs (`score.limits_of`).

    Raises:
        InputError: an argument is not allowed, or the scenario has no such step; the message states what is allowed.
        ScenarioError: there is no such scenario, or its file has errors.
    """

    def __init__(self, mission: Mission, scenario: str | Path | None, plant: Plant) -> None:
        one_of("plant", plant, PLANTS)
        self.mission = mission
        self.scenario = _built_in(mission.scenario, plant) if scenario is None else _loaded(scenario, plant)
        self.repeats, self.step = repeats_of(self.scenario), step_of(mission, self.scenario)
        self.first, self.aims = Inputs(mode=self.step.mode, rate="coarse"), Aims(self.scenario)
        base = base_of(self.scenario, self.step)
        sim = self.simulation()
        sim.restart(base)
        frame = sim.step(self.first)
        self._starts = Starts(self.scenario, self.step, base, mission.spread, frame)
        self.observer, self.limits = Observer(self.scenario, self.step, frame), limits_of(self.step.done)
        self._decided = is_decided(self.step.done)

    def simulation(self) -> Simulation:
        """Return a new simulation of the scenario."""
        return Simulation(self.scenario, digests=False)

    def begin(self, sim: Simulation, random: np.random.Generator) -> tuple[Start, Since, Floats32, Array]:
        """Restart a simulation at a random start without a contact, and make its first control period.

        Returns:
            The start, what has to be remembered of it, the observation, and what its score needs.

        Raises:
            NoStartError: no random start is free of contacts.
        """
        for _ in range(_TRIES):
            start = self._starts.draw(random)
            if start is None:
                continue
            try:
                sim.restart(start, in_place=True)
            except ScenarioError:
                continue
            sim.advance(self.first)
            observation, scored = self.observer.of(sim)
            if scored[CONTACT] == 0.0:
                seen = sim.parts[1].observed
                return start, Since(vec3(seen, 0), rows(seen, 3)), observation, scored
        raise NoStartError(
            f"scenario: {self.scenario.name!r} has no start without a contact in {_TRIES} random starts near the "
            f"place of step {self.step.title!r}"
        )

    def may_be_complete(self, sim: Simulation, scored: Array) -> bool:
        """Return False if the task is certainly not complete; `scored` (6,): what is observed of the simulation."""
        return may_be_done(self.limits, scored) and may_hold(self.step.done, sim.parts[1].worksite)

    def is_complete(self, sim: Simulation, since: Since, scored: Array) -> bool:
        """Return whether a task that may be complete is, without a contact that ends the episode.

        The arguments are those that `begin` returns.
        """
        if self.mission.contact_ends and scored[CONTACT] != 0.0:
            return False
        return self._decided or reached(self.aims, self.step, self.step.done, sim.look(), since)


def _loaded(scenario: str | Path, plant: Plant) -> Scenario:
    changes: dict[Where, object] = {("plant",): plant}
    return load_scenario(scenario, changes)


@lru_cache(maxsize=4)
def _built_in(name: str, plant: Plant) -> Scenario:
    """Return a built-in scenario, the same for all environments of a process: its picture takes seconds to prepare."""
    return _loaded(name, plant)

"""``python -m benchmarks.spread``: by how much motions with masses differ from their rehearsals without masses.

Random motions of the Shuttle's arm in empty space, with a fixed orbiter, in modes 1, 2 and 3, without and with
payloads whose centres are at the tip; and built-in scenarios. For each plant, mode, and with or without a payload, the
command prints the values of `plant.spread`: the least ones that hold for all these motions.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Literal, NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.kinematics.arm import load_arm
from aftdeck.scenario.load import load_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.run import Simulation
from aftdeck.steering.mode import LawChoice
from benchmarks.empty_space import in_space, move_to
from benchmarks.plants import LAWS

TURN, TURN_LOADED = math.radians(40.0), math.radians(8.0)
"""Greatest change of a joint angle without and with a payload [rad]."""
BUILT_IN: dict[LawChoice, tuple[str, ...]] = {
    "position": ("sts-400-position",),
    "closed loop": ("sts-400-closed", "first-flight"),
    "open loop": ("sts-400-open",),
}
"""Scenarios whose first motion is measured, too."""
SETTLING = 3.0
"""Time by which a motion with masses may end later, however short it is [s]."""


class Size(NamedTuple):
    """Extent of the table.

    Attributes:
        loads: masses of the payload [lb].
        motions: number of random motions for each mass.
        laws: steering laws.
        plants: plants with masses.
        built_in: True if built-in scenarios are measured too.
    """

    loads: tuple[int, ...]
    motions: int
    laws: tuple[LawChoice, ...]
    plants: tuple[Literal["rigid", "flexible"], ...]
    built_in: bool


FULL = Size((0, 5_000, 32_000, 65_000), 10, tuple(LAWS.values()), ("rigid", "flexible"), True)
TINY = Size((0,), 1, ("position",), ("rigid",), False)
_MIDDLE = np.radians([-30.0, 70.0, -80.0, -40.0, 10.0, -60.0])


class Motion(NamedTuple):
    """Motion in OPR CMD.

    Attributes:
        start: (6,) joint angles at the start [rad].
        end: (6,) joint angles at the target, as mode 1 may reach it [rad].
        pounds: mass of the payload [lb]; 0 for none.
    """

    start: Array
    end: Array
    pounds: int


class Result(NamedTuple):
    """Time of a motion [s], and distance of the true tip from the target at its end [m]."""

    seconds: float
    miss: float


def motions(loads: tuple[int, ...], count: int) -> Iterator[Motion]:
    """Yield the motions, in every call the same."""
    for pounds in loads:
        rng = np.random.default_rng(pounds)
        most = TURN_LOADED if pounds else TURN
        for _ in range(count):
            start = _MIDDLE + rng.uniform(-0.4, 0.4, 6)
            yield Motion(start, start + rng.uniform(-most, most, 6), pounds)


def scenario(motion: Motion, law: LawChoice, plant: str) -> Scenario:
    """Return the scenario of a motion."""
    phases = move_to(load_arm("srms").forward(motion.end), law)
    return in_space(plant, motion.start.tolist(), pounds=motion.pounds, phases=phases)


def flown(given: Scenario) -> Result | None:
    """Fly the first motion of a scenario; None if CMD CK rejects it or it does not end."""
    sim, began = Simulation(given), math.nan
    while not sim.ended:
        sim.advance()
        state = sim._state
        if math.isnan(began) and state.panel.sequence == "in progress":
            began = state.tick
        if any(event.kind == "arrived" for event in state.events):
            frame = sim.look()
            assert frame.goal is not None
            miss = frame.goal.distance
            if frame.dynamics is not None and frame.dynamics.miss is not None:
                miss, _ = frame.dynamics.miss
            return Result((state.tick - began) * sim.scenario.control_period, miss)
    return None


def flights(law: LawChoice, plant: str, size: Size, *, loaded: bool) -> list[Result | None]:
    """Fly all motions and, without a payload, the built-in scenarios of a steering law."""
    moves = motions(size.loads, size.motions)
    found = [flown(scenario(motion, law, plant)) for motion in moves if bool(motion.pounds) == loaded]
    if not loaded and size.built_in:
        found += [flown(load_scenario(name, {("plant",): plant})) for name in BUILT_IN[law]]
    return found


def table(size: Size) -> Iterator[str]:
    """Yield the lines of the table of `plant.spread`."""
    for law in size.laws:
        for loaded in sorted({pounds > 0 for pounds in size.loads}):
            rehearsed = flights(law, "kinematic", size, loaded=loaded)
            for plant in size.plants:
                both = zip(rehearsed, flights(law, plant, size, loaded=loaded), strict=True)
                pairs = [(before, after) for before, after in both if before is not None and after is not None]
                latest = max(after.seconds - before.seconds for before, after in pairs)
                later = SETTLING if latest > 0.1 else 0.0
                longer = max(max(after.seconds - later, 0.0) / before.seconds - 1.0 for before, after in pairs)
                miss = max(after.miss for _, after in pairs)
                share = math.ceil(100.0 * longer) / 100.0 if longer > 0.01 else 0.0  # a control step counts as nothing
                values = f"{share}, {later}, {math.ceil(1000.0 * miss) / 1000.0}"
                yield f'    ("{plant}", "{law}", {loaded}): Spread({values}),  # {len(pairs)} motions'


if __name__ == "__main__":
    for line in table(FULL):
        print(line, flush=True)

"""``python -m benchmarks.jets``: the orbiter's primary jets against a parked arm, as a table in Markdown.

Two jets are on for a time, about or along one of the orbiter's axes, and the orbiter is free. The table has the swing
of the tip in L from peak to peak; with a payload, also the time until the tip is at rest, as `tip_rest` defines it.

Source: Smithsonian Institution, NASM.2014.0025, box 8, folder 10, page 89 (notes of a crew member, 1981): multiple jets
move a horizontal arm by 4 in from peak to peak at most; inputs of 3 s, by either hand controller, move a vertical arm
by about 6 in at most, in roll.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path
from typing import Literal, NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.scenario.disturbance import Disturbance
from aftdeck.scenario.load import parse_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.motion.tip_rest import AT_REST, WINDOW, WINDOW_LOADED
from aftdeck.simulation.run import Simulation
from aftdeck.tuples import plain_vector

PRIMARY, VERNIER = 3870.0, 107.0
"""Thrust of a primary and of a vernier jet [N]: 870 and 24 lbf (assumed: recalled, without a document)."""
POSES = {
    "horizontal, aft": (0, 5, -5, 0, 0, 0),
    "horizontal, to port": (-90, 5, -5, 0, 0, 0),
    "vertical": (0, 90, -5, 0, 0, 0),
}
"""Joint angles [deg]."""
AXES = ("roll", "pitch", "yaw", "forward", "starboard", "down")
"""Columns of the table: torques and forces of the jets."""
Holder = Literal["brakes", "servos"]


class Case(NamedTuple):
    """Row of the table.

    Attributes:
        pose: name in `POSES`.
        pounds: mass of the payload [lb], whose centre is 2.3 m ahead of the tip; 0 for none.
        held: what holds the joints.
        seconds: time for which the jets are on [s].
    """

    pose: str
    pounds: int
    held: Holder
    seconds: float


class Swing(NamedTuple):
    """Motion of the tip in L.

    Attributes:
        farthest: greatest distance from its first place [m].
        extent: greatest extent from peak to peak, along the direction in which it moves most [m].
        rest: time after the jets' end at which the tip comes to rest [s]; infinite if it is not at rest at the end.
    """

    farthest: float
    extent: float
    rest: float


FULL = tuple(
    [Case(pose, 0, "brakes", seconds) for pose in POSES for seconds in (0.08, 1.0, 3.0)]
    + [Case(pose, 31_000, held, 0.08) for pose in POSES for held in ("brakes", "servos")]
)
TINY = (Case("vertical", 0, "brakes", 0.08),)


def swing(case: Case, axis: int, *, after: float) -> Swing:
    """Return the tip's motion while two primary jets act on one of `AXES`, and `after` this [s]."""
    sim = Simulation(parked(case))
    period = sim.scenario.control_period
    push, braked, tips = _push(sim.scenario, axis), case.held == "brakes", []
    on = round(case.seconds / period)
    for k in range(on + round(after / period)):
        frame = sim.step(Inputs(brakes=braked, disturbances=(push,) if k < on else ()))
        assert frame.dynamics is not None
        tips.append(frame.dynamics.position)
    moved = np.array(tips) - tips[0]
    away = moved - moved.mean(axis=0)
    along = away @ np.linalg.svd(away, full_matrices=False)[2][0]
    window = round((WINDOW_LOADED if case.pounds else WINDOW) / period)
    return Swing(float(np.linalg.norm(moved, axis=1).max()), float(np.ptp(along)), _rest(moved[on:], window) * period)


def parked(case: Case) -> Scenario:
    """Return the scenario of an arm that stands still over an empty bay."""
    payload = f"[payload]\nmass = '{case.pounds} lb'\nposition = [2.3, 0.0, 0.0]\n" if case.pounds else ""
    text = f"""
title = "jets against a parked arm"
worksite = "orbiter"
plant = "flexible"
duration = "900 s"
[initial]
joints = {np.radians(POSES[case.pose]).tolist()}
{payload}"""
    return parse_scenario(text, "jets", "jets.toml", Path())


def _push(scenario: Scenario, axis: int) -> Disturbance:
    """Return the force or torque of two primary jets; their levers are those of the vernier jets."""
    assert scenario.worksite.orbiter is not None and scenario.worksite.orbiter.jets is not None
    along, torques = np.eye(3)[axis % 3], np.array(scenario.worksite.orbiter.jets.torque)
    if axis < 3:
        return Disturbance("orbiter", torque=plain_vector(PRIMARY / VERNIER * torques * along))
    return Disturbance("orbiter", force=plain_vector(2.0 * PRIMARY * along))


def _rest(tips: Array, window: int) -> float:
    """Return the first step from which all positions (n, 3) of a window [steps] are in a small box; else infinity."""
    seen = np.lib.stride_tricks.sliding_window_view(tips, window, axis=0)
    found = np.flatnonzero(np.linalg.norm(np.ptp(seen, axis=2), axis=1) < AT_REST)
    return float(found[0]) if len(found) else math.inf


def table(cases: tuple[Case, ...]) -> Iterator[str]:
    """Yield the lines of the table."""
    yield f"| arm | payload, lb | held by | jets on, s | {' | '.join(f'{axis}, mm' for axis in AXES)} |"
    yield f"|---|---|---|---{'|---' * len(AXES)}|"
    for case in cases:
        load = f"{case.pounds:,}" if case.pounds else "none"
        cells = []
        for axis in range(len(AXES)):
            found = swing(case, axis, after=140.0 if case.pounds else 10.0)
            rest = f"{found.rest:.0f} s" if math.isfinite(found.rest) else "over 120 s"
            cells.append(f"{1e3 * found.extent:.0f}" + (f" ({rest})" if case.pounds else ""))
        yield f"| {case.pose} | {load} | {case.held} | {case.seconds:g} | {' | '.join(cells)} |"


if __name__ == "__main__":
    for line in table(FULL):
        print(line, flush=True)

"""CLEARANCE and objectives at a berth: the payload may come as close to the berth as it has to, and no closer."""

from __future__ import annotations

import math
from functools import lru_cache
from itertools import pairwise

import numpy as np
import pytest

import aftdeck
from aftdeck import Inputs
from aftdeck.arrays import Array
from aftdeck.simulation.constants.site import all_solids
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.payloads.alignment import ASIDE, TILTED, alarm_pairs
from aftdeck.simulation.row.on_way import STEP, clearances_on_way
from aftdeck.simulation.run import SavedSimulation, Simulation
from aftdeck.tuples import Vec3
from aftdeck.worksite.watch.clearance_monitor import ClearanceMonitor
from aftdeck.worksite.watch.found import CLEARANCE
from tests.each import number
from tests.loaded import scenario


@lru_cache
def flown(name: str) -> tuple[Frame, ...]:
    """Return the frames of a scripted run."""
    sim, frames = Simulation(name), []
    while not sim.ended:
        frames.append(sim.step(None))
    return tuple(frames)


MISSIONS = [
    "free-flyer",
    *(pytest.param(name, marks=pytest.mark.slow) for name in ("srms-berth", "srms-deploy", "concept-1972-script")),
]


@pytest.mark.parametrize("name", MISSIONS)
def test_mission_raises_no_alarm(name: str) -> None:
    assert not {frame.phase for frame in flown(name) if frame.work.clearance_level != "info"}


@pytest.mark.parametrize(
    "name",
    ["free-flyer", *(pytest.param(name, marks=pytest.mark.slow) for name in ("srms-deploy", "concept-1972-script"))],
)
def test_berth_that_has_just_released_a_payload_is_no_objective(name: str) -> None:
    """The conditions of the berth still hold at first; an objective with these conditions would be green at once."""
    freed = 0
    for before, now in pairwise(flown(name)):
        objective = now.work.objective
        if any(
            new.held and new.seat == "" != old.seat for old, new in zip(before.work.cargo, now.work.cargo, strict=True)
        ):
            freed += 1
            assert objective is None
        if before.work.objective is None and objective is not None and objective.action in ("berth", "insert", "dock"):
            assert not all(condition.holds for condition in now.work.conditions)
    assert freed > 0


@lru_cache
def above_the_berth() -> Simulation:
    """Return a run of srms-berth in which the payload is on its way into the berth."""
    sim = Simulation("srms-berth")
    for _ in range(4500):
        sim.advance()
    return sim


def counted(side: float = 0.0, tilt: float = 0.0) -> tuple[Array, Array, Array]:
    """Return which pairs of payload and berth count, which do not, and all their clearances, for a displaced payload.

    Args:
        side: displacement across the bay [m].
        tilt: rotation about the axis along the bay [rad].
    """
    sim = above_the_berth()
    site, worksite = sim._flight.site, sim._state.worksite
    row = site.payload_rows[0]
    [fit] = site.fits[0]
    frames = worksite.frames.copy()
    off = fit.offset(frames, row)
    frames[row, :3] -= frames[row, 3:].reshape(3, 3) @ off[:3]  # into the berth
    frames[row, 3:] = (frames[row, 3:].reshape(3, 3) @ off[3:].reshape(3, 3).T).ravel()
    rotation = frames[row, 3:].reshape(3, 3)
    c, s = np.cos(tilt), np.sin(tilt)
    along = float(off[:3] @ fit.way_out)
    across = np.cross(fit.way_out, [1.0, 0.0, 0.0])
    frames[row, :3] += rotation @ (along * fit.way_out + side * across)
    frames[row, 3:] = (rotation @ np.array([[1, 0, 0], [0, c, -s], [0, s, c]])).ravel()
    watch = ClearanceMonitor(site.layout)
    watch.update(frames)
    worksite.nearest, worksite.aligned_with = -1, None
    counts, _ = alarm_pairs(sim._flight, sim._state, watch, frames, worksite.permitted)
    pairs = site.seated[0, fit.berth.name] != 0
    return pairs & (counts != 0), pairs & (counts == 0), watch.found[:, CLEARANCE]


def test_no_pair_counts_on_the_straight_way_in() -> None:
    count, excepted, clearances = counted()
    assert not count.any()
    assert clearances[excepted].min() < 0.5  # a pair below the caution is among them


@pytest.mark.parametrize("side", [-0.2, 0.2])
def test_pairs_that_are_too_near_count(side: float) -> None:
    """Beside the way, one side of the payload is nearer than on it by up to the displacement, and counts."""
    count, excepted, _ = counted(side)
    assert count.any()
    assert excepted.any()


@pytest.mark.parametrize(("side", "tilt"), [(1.1 * ASIDE, 0.0), (-1.1 * ASIDE, 0.0), (0.0, 1.1 * TILTED)])
def test_every_pair_counts_away_from_the_way_in(side: float, tilt: float) -> None:
    count, excepted, _ = counted(side, tilt=tilt)
    site = above_the_berth()._flight.site
    aligned = set(np.flatnonzero(excepted).tolist())
    assert aligned <= set(site.meeting_groups.tolist())  # trunnions over their guides do not count in any case
    assert count.any()


@pytest.mark.parametrize("step", [0, 7, 20])
def test_clearances_on_the_way_are_those_of_the_solids(step: int) -> None:
    sim = above_the_berth()
    site, solids = sim._flight.site, all_solids(sim.scenario)
    [fit] = site.fits[0]
    turn = fit.place[3:].reshape(3, 3)
    place = fit.place[:3] + step * STEP * turn @ fit.way_out
    found, layout = clearances_on_way(site, 0, 0)[step], site.layout
    for group in np.argsort(found)[:4].tolist():
        pairs = layout.pairs[layout.begins[group] : layout.begins[group + 1]].tolist()
        placed = [
            [
                solids[k].vertices @ turn.T + place if solids[k].frame == site.payloads[0].name else solids[k].vertices
                for k in pair
            ]
            for pair in pairs
        ]
        assert min(aftdeck.separation(a, b).clearance for a, b in placed) == pytest.approx(found[group], abs=1e-9)


@lru_cache
def state_after(steps: int) -> SavedSimulation:
    """Return the state of `srms-berth` after a number of steps of its script."""
    sim = Simulation(scenario("srms-berth"))
    for _ in range(steps):
        sim.advance()
    return sim.save()


@pytest.mark.parametrize("steps", [4500, pytest.param(6000, marks=pytest.mark.slow)])
@pytest.mark.parametrize("way", [(0.0, 1.0, 0.0), (0.0, -1.0, 0.0), (1.0, 0.0, 0.0)])
def test_a_payload_that_leaves_the_way_sideways_is_warned_before_it_touches(steps: int, way: Vec3) -> None:
    """Steps of a run measure few pairs; in CI, every fifth alarm is compared with the clearances of all pairs."""
    sim = Simulation(scenario("srms-berth"))
    sim.restore(state_after(steps))
    flight, state = sim._flight, sim._state
    site = flight.site
    closest, level = math.inf, ""
    for step in range(600):
        frame = sim.step(Inputs(mode="ORB LD", translation=way))
        if any(not contact.essential for contact in frame.work.contacts):
            assert level != "info"
            break
        level = frame.work.clearance_level
        if step % number(5, 1):
            continue
        watch = ClearanceMonitor(site.layout)
        watch.active = state.worksite.watch.active.copy()
        watch.update(state.worksite.frames)
        pairs = (site.seated[0, site.fits[0][0].berth.name] != 0) & (site.detrimental != 0)
        least = float(watch.found[pairs, CLEARANCE].min())
        offset = site.fits[0][0].offset(state.worksite.frames, site.payload_rows[0])[:3]
        along = max(0, int(float(offset @ site.fits[0][0].way_out) / STEP))
        on_way = float(clearances_on_way(site, 0, 0)[along : along + 2][:, pairs].min())
        closest = min(closest, least)
        if least < 0.5 * on_way - 1e-3 and least < flight.scenario.caution:
            assert level != "info", f"{least:.3f} m, on the way {on_way:.3f} m"
    assert closest < 0.4

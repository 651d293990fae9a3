"""DIRECT and TEST, and the steering law that each panel position selects."""

from __future__ import annotations

import math

import numpy as np
import pytest

import aftdeck
from aftdeck.steering.mode import MODES
from tests.reference.tables import table
from tests.steering.flying import BAY, PAYLOAD, fly, kinds, scenario

LIMITS = table("srms-limits")
POINTS = "\n".join(
    f"[[sequence]]\nslot = {slot}\n[[sequence.point]]\ntarget = {{ joints = {[f'{q} deg' for q in BAY]} }}"
    for slot in (1, 2, 3, 4)
)


@pytest.mark.parametrize("joint", range(6))
@pytest.mark.parametrize("rate", ["coarse", "vernier"])
def test_direct_starts_and_stops_a_joint_at_once(joint: int, rate: str) -> None:
    sim = aftdeck.Simulation(scenario((0, 60, -80, 30, 10, 0)))
    switch = aftdeck.Inputs(mode="DIRECT", joint=joint, rate="coarse" if rate == "coarse" else "vernier", drive=-0.5)
    frames = fly(sim, 1.0, switch)
    wanted = np.zeros(6)
    wanted[joint] = -0.5 * math.radians(LIMITS[rate][joint])
    for frame in frames:
        assert frame.rates_commanded == pytest.approx(wanted, abs=1e-15) and frame.law == 9
    assert sim.step(aftdeck.Inputs()).rates_commanded == (0.0,) * 6


def test_joint_rotary_changes_the_moving_joint_at_once() -> None:
    sim = aftdeck.Simulation(scenario())
    fly(sim, 1.0, aftdeck.Inputs(mode="DIRECT", joint=0, drive=1.0))
    frame = sim.step(aftdeck.Inputs(joint=5, drive=1.0))
    assert np.degrees(frame.rates_commanded) == pytest.approx([0, 0, 0, 0, 0, 2.64])


def test_entering_direct_at_speed_stops_every_joint_at_once() -> None:
    sim = aftdeck.Simulation(scenario())
    fly(sim, 4.0, aftdeck.Inputs(translation=(1.0, 0.0, 0.0)))
    assert sim.step(aftdeck.Inputs(mode="DIRECT")).rates_commanded == (0.0,) * 6


@pytest.mark.parametrize("joint", range(6))
@pytest.mark.parametrize("way", [1.0, -1.0])
@pytest.mark.parametrize("soft_stops", ["mended", "as-flown"])
def test_direct_ignores_soft_stops_and_keeps_hard_stops(joint: int, way: float, soft_stops: str) -> None:
    low, high = LIMITS["hard"][joint]
    start = [0.0, 70.0, -80.0, 10.0, 0.0, 0.0]
    start[joint] = high - 6.5 if way > 0 else low + 6.5
    sim = aftdeck.Simulation(scenario(start, f'soft_stops = "{soft_stops}"'))
    frames = fly(sim, 8.0, aftdeck.Inputs(mode="DIRECT", joint=joint, drive=way))
    angles = np.degrees([f.angles[joint] for f in frames])
    assert low - 1e-9 <= angles.min() and angles.max() <= high + 1e-9
    assert angles[-1] == pytest.approx(high if way > 0 else low, abs=1e-9)
    assert frames[-1].zones[joint] == 3 and kinds(frames[-1]) == {"hard stop"}
    assert frames[-1].limits[0].joint == joint
    at = [abs(math.degrees(f.rates_commanded[joint])) for f in frames if f.zones[joint] == 2]
    assert at[0] == pytest.approx(LIMITS["coarse"][joint])  # at full rate past the soft stop
    assert abs(fly(sim, 1.0, aftdeck.Inputs(drive=-way))[-1].angles[joint] - frames[-1].angles[joint]) > 0.01


def test_test_mode_ignores_all_sticks() -> None:
    sim = aftdeck.Simulation(scenario())
    frames = fly(sim, 2.0, aftdeck.Inputs((1.0, 1.0, 1.0), (1.0, 1.0, 1.0), 1.0, mode="TEST"))
    assert {f.angles for f in frames} == {tuple(sim.scenario.initial_angles.tolist())}
    assert {f.law for f in frames} == {0} and not any(kinds(f) for f in frames)


def test_entering_test_mode_at_speed_ramps_to_rest() -> None:
    sim = aftdeck.Simulation(scenario())
    before = fly(sim, 5.0, aftdeck.Inputs(translation=(0.0, 0.0, -1.0)))[-1]
    frames = fly(sim, 5.0, aftdeck.Inputs(translation=(0.0, 0.0, -1.0), mode="TEST"))
    for frame in frames:
        change = np.array(frame.twist_commanded[3:]) - before.twist_commanded[3:]
        assert np.linalg.norm(change) <= 2 * 0.3048 / 4 * 0.02 * (1 + 1e-6)
        before = frame
    assert frames[-1].rates_commanded == (0.0,) * 6


def test_panel_positions_select_the_documented_laws() -> None:
    wanted = {"OPR CMD": {1, 2, 3}, "ORB UNL": {4}, "END EFF": {5}, "ORB LD": {4, 7}, "PL": {6}, "SINGLE": {8}}
    wanted |= {f"AUTO {n}": {1, 2, 3} for n in (1, 2, 3, 4)} | {"DIRECT": {9}, "TEST": {0}, "MASTER": {10}}
    assert set(MODES) == set(wanted)
    sim = aftdeck.Simulation(scenario(BAY, f"{PAYLOAD.format(mass='1 lb')}\n{POINTS}"))
    for position, laws in wanted.items():
        flown = set()
        for law in ("position", "closed loop", "open loop"):
            for payload_axes in (False, True):
                frame = sim.step(aftdeck.Inputs(mode=position, law=law, payload_axes=payload_axes))
                assert frame.mode == position
                flown.add(frame.law)
        assert flown == laws, position


@pytest.mark.parametrize(
    ("number", "position", "law"),
    [(1, "OPR CMD", 1), (2, "OPR CMD", 2), (3, "OPR CMD", 3), (4, "ORB UNL", 4), (5, "END EFF", 5), (8, "SINGLE", 8)],
)
def test_scenario_may_name_its_mode_by_number(number: int, position: str, law: int) -> None:
    frame = aftdeck.Simulation(scenario(BAY, f"mode = {number}")).step(aftdeck.Inputs())
    assert (frame.mode, frame.law) == (position, law)


def test_automatic_modes_use_closed_loop_by_default() -> None:
    sim = aftdeck.Simulation(scenario(BAY, POINTS))
    for position in ("OPR CMD", "AUTO 1"):
        assert sim.step(aftdeck.Inputs(mode=position)).law == 2

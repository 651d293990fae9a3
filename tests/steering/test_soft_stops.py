"""Soft stops: computed modes slow before them and lead back from them; as flown, only SINGLE leads back."""

from __future__ import annotations

import math

import numpy as np
import pytest

import aftdeck
from tests.reference.tables import table
from tests.steering.flying import fly, kinds, scenario

SOFT = np.radians(table("srms-limits")["soft"])
PAST = (0.0, 60.0, -80.0, 117.5, 10.0, 0.0)
"""Wrist pitch 1.1 deg past its soft stop [deg]."""
STICKS = [
    aftdeck.Inputs(translation=t, rotation=r, mode=mode)
    for mode in ("ORB UNL", "END EFF")
    for t, r in (
        ((1.0, 0.0, 0.0), (0.0, 0.0, 0.0)),
        ((-1.0, 0.0, 0.0), (0.0, 0.0, 0.0)),
        ((0.0, 0.0, 0.0), (0.0, 1.0, 0.0)),
        ((0.0, 0.0, 0.0), (0.0, -1.0, 0.0)),
        ((0.3, -0.2, 0.7), (0.4, 0.4, -0.5)),
    )
]


@pytest.mark.parametrize("inputs", STICKS)
def test_joint_past_soft_stop_moves_only_inwards(inputs: aftdeck.Inputs) -> None:
    frames = fly(aftdeck.Simulation(scenario(PAST)), 4.0, inputs)
    angles = [math.radians(PAST[3])] + [f.angles[3] for f in frames]
    outside = [a for a in angles if a > SOFT[3, 1]]
    assert (np.diff(outside) <= 0.0).all()


def test_outward_rotation_past_soft_stop_is_blocked() -> None:
    ends = {}
    for way in (1.0, -1.0):
        frames = fly(aftdeck.Simulation(scenario(PAST)), 4.0, aftdeck.Inputs(rotation=(0, way, 0), mode="END EFF"))
        ends[way] = frames[-1].angles[3]
        if ends[way] == math.radians(PAST[3]):
            stuck = frames[-1]
    assert sorted(round(math.degrees(e), 1) for e in ends.values())[1] == PAST[3]
    assert min(ends.values()) < SOFT[3, 1]
    assert [(limit.kind, limit.joint) for limit in stuck.limits] == [("soft stop", 3)]
    assert stuck.angles == pytest.approx(np.radians(PAST), abs=0.0) and stuck.ratio == 0.0


@pytest.mark.parametrize("inputs", STICKS)
def test_as_flown_arm_past_soft_stop_does_not_move(inputs: aftdeck.Inputs) -> None:
    flight = aftdeck.Simulation(scenario(PAST, 'soft_stops = "as-flown"'))
    for frame in fly(flight, 2.0, inputs):
        assert frame.angles == tuple(math.radians(a) for a in PAST)
        assert "soft stop" in kinds(frame)


def test_as_flown_single_leads_back_inside_soft_stops() -> None:
    flight = aftdeck.Simulation(scenario(PAST, 'soft_stops = "as-flown"'))
    back = fly(flight, 4.0, aftdeck.Inputs(mode="SINGLE", joint=3, drive=-1.0))
    assert back[-1].angles[3] < SOFT[3, 1]
    fly(flight, 4.0, aftdeck.Inputs())
    frames = fly(flight, 2.0, aftdeck.Inputs(mode="ORB UNL", translation=(0.0, 0.0, -1.0)))
    assert math.dist(frames[-1].position, back[-1].position) > 0.1


def test_as_flown_arm_stops_within_a_step_past_soft_stop() -> None:
    flight = aftdeck.Simulation(scenario((0.0, 60.0, -80.0, 115.0, 10.0, 0.0), 'soft_stops = "as-flown"'))
    frames = []
    for way in (1.0, -1.0):
        frames = fly(flight, 6.0, aftdeck.Inputs(rotation=(0.0, way, 0.0), mode="END EFF"))
        if frames[-1].zones[3] == 2:
            break
    step = math.radians(4.76) * 0.02
    assert SOFT[3, 1] < frames[-1].angles[3] <= SOFT[3, 1] + step
    assert frames[-1].rates_commanded == (0.0,) * 6


def test_computed_modes_at_cradle_do_not_move_joints_outwards() -> None:
    rng = np.random.default_rng(60)
    sim = aftdeck.Simulation(scenario((0,) * 6))
    for _ in range(30):
        t, r = rng.uniform(-1, 1, 3).tolist(), rng.uniform(-1, 1, 3).tolist()
        before = sim.frame.angles if sim.frame else (0.0,) * 6
        for frame in fly(sim, 1.0, aftdeck.Inputs(tuple(t), tuple(r))):
            for joint in (1, 2):
                low, high = SOFT[joint]
                was, now = (max(low - q, q - high, 0.0) for q in (before[joint], frame.angles[joint]))
                assert now <= was + 1e-12
            before = frame.angles

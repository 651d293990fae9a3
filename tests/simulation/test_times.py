"""TP, ETA, ETAP and T_B5 of a frame, against the run itself and an independent linkage."""

from __future__ import annotations

import numpy as np
import pytest

import aftdeck
from aftdeck.arrays import Array
from aftdeck.simulation.frame import Frame, Times
from tests.each import each, seeds
from tests.steering.flying import BAY, checked, scenario, target

THERE = (-25.0, 70.0, -95.0, -70.0, 10.0, -120.0)
PERIOD = 0.08


def motion(law: str, strict: bool = False) -> list[Frame]:
    """Return the frames of an automatic motion, from the step in which it starts to the step in which it ends."""
    sim = aftdeck.Simulation(scenario(BAY, f"control_period = {PERIOD}\nstrict = {str(strict).lower()}\n"))
    sim.step(aftdeck.Inputs(mode="OPR CMD", law=law))  # type: ignore[arg-type]
    checked(sim, aftdeck.Inputs(target=target(sim.scenario.arm, THERE)))
    frames = [sim.step(aftdeck.Inputs(proceed=True))]
    while frames[-1].sequence == "in progress":
        frames.append(sim.step(aftdeck.Inputs()))
        assert len(frames) < 5000
    return frames[:-1]


@pytest.mark.parametrize("strict", [False, True])
@pytest.mark.parametrize("law", ["position", "closed loop", "open loop"])
def test_motion_ends_at_eta(law: str, strict: bool) -> None:
    frames = motion(law, strict)
    assert frames[0].times.tp_s == pytest.approx(PERIOD)
    assert [f.times.tp_s for f in frames] == pytest.approx([PERIOD * (k + 1) for k in range(len(frames))])
    etas = np.array([f.times.eta_s for f in frames], dtype=np.float64)
    assert abs(etas[-1] - frames[-1].times.tp_s) <= 2.0 * PERIOD
    if law == "open loop" and strict:  # the clock of the plan does not depend on the joints
        np.testing.assert_allclose(etas[:-1], etas[0], atol=1e-9)
    tail = etas[len(etas) // 2 :]
    assert np.abs(tail - tail[-1]).max() <= max(2.0, 0.1 * len(etas) * PERIOD)


@pytest.mark.parametrize("law", ["closed loop", "open loop"])
def test_etap_is_at_most_eta(law: str) -> None:
    frames = motion(law)
    for frame in frames:
        assert frame.times.eta_s is not None and frame.times.etap_s is not None
        assert frame.times.tp_s - 2.0 * PERIOD <= frame.times.etap_s <= frame.times.eta_s + 1e-9
    first, w = frames[0], 4.76 * np.pi / 180.0
    assert first.goal is not None and first.times.etap_s is not None
    assert first.times.etap_s == pytest.approx(first.goal.angle / w + (4.0 if law == "open loop" else 2.0), abs=PERIOD)


def test_mode_1_has_no_etap_and_timed_phase_has_eta() -> None:
    assert {f.times.etap_s for f in motion("position")} == {None}
    turn = 'mode = "SINGLE"\njoint = "wrist_yaw"\njoint_at = "10 deg"'
    phases = f'[[phase]]\nmode = "ORB UNL"\nduration = 3.2\n[[phase]]\n{turn}'
    sim = aftdeck.Simulation(scenario(BAY, f"control_period = {PERIOD}\n{phases}"))
    frames = [sim.step() for _ in range(60)]
    assert [f.times.eta_s for f in frames[:40]] == [3.2] * 40 and frames[39].times.tp_s == pytest.approx(3.2)
    assert frames[40].times.tp_s == pytest.approx(PERIOD) and frames[40].times.eta_s is None


def test_entry_of_a_mode_begins_a_phase() -> None:
    sim = aftdeck.Simulation(scenario(BAY, f"control_period = {PERIOD}\n"))
    for _ in range(10):
        sim.step(aftdeck.Inputs())
    frame = sim.step(aftdeck.Inputs(mode="END EFF"))
    assert frame.times == Times(PERIOD, None, None)


def turned(axis: int, angle: float) -> Array:
    """Return the matrix of an active rotation about an axis."""
    c, s = np.cos(angle), np.sin(angle)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    matrix = np.eye(3)
    matrix[i, i] = matrix[j, j] = c
    matrix[j, i], matrix[i, j] = s, -s
    return matrix


@each("seed", seeds(20, 200))
def test_t_b5_equals_lnkage(seed: int) -> None:
    low, high = aftdeck.load_arm("srms").limits.soft.T
    q = np.random.default_rng([305, seed]).uniform(np.maximum(low, -3.0), np.minimum(high, 3.0))
    made = scenario(np.degrees(q).tolist())
    frame = aftdeck.Simulation(made).step(aftdeck.Inputs())
    from_l = made.arm.model.mount.rotation  # T_LB transposed
    wanted = from_l @ turned(2, q[0]) @ turned(1, q[1]) @ turned(1, q[2]) @ turned(1, q[3])
    np.testing.assert_allclose(np.array(frame.wrist_pitch), wanted, atol=1e-9)

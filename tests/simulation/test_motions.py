"""Mechanisms in motion: their remaining time runs down with the simulated time, and ends when they arrive."""

from __future__ import annotations

from itertools import pairwise

import pytest

from aftdeck import Inputs
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.run import Simulation

MISSION = ("latches open", "snares close", "carriage retracts", "rigidizing", "derigidizing", "carriage extends")


def remaining(frame: Frame, text: str) -> float | None:
    return next((motion.remaining_s for motion in frame.motions if motion.text == text), None)


def check(frames: list[Frame], period: float) -> set[str]:
    """Check that each motion's remaining time falls by the control period in each step; return the texts."""
    texts = {motion.text for frame in frames for motion in frame.motions}
    for text in texts:
        for before, now in pairwise(frames):
            old, new = remaining(before, text), remaining(now, text)
            if old is not None and new is not None:
                assert new == pytest.approx(old - period, abs=1e-6)
            if old is not None and new is None and now.by == "script":
                assert old <= period + 1e-6, f"{text} ends {old} s before its time"
    return texts


@pytest.mark.slow
def test_mission_shows_each_mechanism() -> None:
    sim, frames = Simulation("srms-deploy"), []
    while not sim.ended:
        frames.append(sim.step(None))
    assert check(frames, sim.scenario.control_period) == {*MISSION, "snares open"}


def test_prong_and_telescope_move_to_their_ends() -> None:
    sim = Simulation("concept-1972")
    period = sim.scenario.control_period
    frames = [sim.step(Inputs(effector="close")), *(sim.step(Inputs()) for _ in range(200))]
    assert check(frames, period) == {"prong closes"}
    assert frames[0].motions[0].remaining_s == pytest.approx(3.5, abs=2 * period)
    assert frames[-1].motions == ()
    pulled = [sim.step(Inputs(telescope=1.0)) for _ in range(50)]
    assert check(pulled, period) == {"telescope extends"}
    assert sim.step(Inputs()).motions == ()


def test_snares_move_to_their_ends() -> None:
    sim = Simulation("srms-deploy")
    period = sim.scenario.control_period
    for inputs, texts in ((Inputs(effector="close"), {"snares close"}), (Inputs(effector="open"), {"snares open"})):
        frames = [sim.step(inputs), *(sim.step(Inputs()) for _ in range(300))]
        assert check(frames, period) == texts
        lasts = sum(frame.motions != () for frame in frames)
        assert remaining(frames[0], *texts) == pytest.approx(lasts * period, abs=2 * period)
        assert frames[-1].motions == ()


def test_nothing_moves_at_rest() -> None:
    for name in ("srms-berth", "concept-1972", "loaded"):
        assert Simulation(name).step(Inputs()).motions == ()

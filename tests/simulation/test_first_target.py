"""Target that is keyed in at the start of a run that begins in OPR CMD: PROCEED flies to it."""

from __future__ import annotations

import pytest

from aftdeck import Inputs
from aftdeck.simulation.run import Simulation


def test_sts_400_begins_with_its_target_and_proceed_flies_it() -> None:
    sim = Simulation("sts-400-closed")
    frame = sim.step(Inputs())
    assert frame.goal is not None
    assert frame.goal.distance == pytest.approx(19.0, abs=0.1)
    while frame.check is None:
        frame = sim.step(Inputs())
    assert frame.check.good
    frame = sim.step(Inputs(proceed=True))
    while frame.goal is not None and frame.goal.distance > 0.1 and frame.time_s < 140.0:
        frame = sim.step(Inputs())
    assert frame.time_s < 140.0


def test_other_runs_begin_without_a_target() -> None:
    for name in ("first-flight", "sequence", "srms-berth"):
        assert Simulation(name)._state.panel.keyed is None

"""Decisions of an operator."""

from __future__ import annotations

from typing import Literal

import pytest

from aftdeck.operators.decide import leave
from aftdeck.simulation.frame import WayOut
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize(("stick", "axis"), [("translation", 1), ("rotation", 2), ("joint", 3), ("telescope", 0)])
def test_operator_leaves_a_contact_in_the_direction_of_the_way_out(
    stick: Literal["translation", "rotation", "joint", "telescope"], axis: int, sign: int
) -> None:
    frame = Simulation("concept-1972").look()
    wanted = leave(frame, (WayOut("contact", "", stick, axis, sign),))
    sticks = [*wanted.translation, *wanted.rotation, wanted.drive, wanted.telescope]
    moved = {"translation": axis, "rotation": 3 + axis, "joint": 6, "telescope": 7}[stick]
    assert [(k, value * sign > 0.0) for k, value in enumerate(sticks) if value] == [(moved, True)]
    assert wanted.joint == (axis if stick == "joint" else None)


def test_operator_first_selects_the_mode_of_the_way_out() -> None:
    frame = Simulation("concept-1972").look()
    way = WayOut("contact", "", "joint", 2, -1, "SINGLE")
    assert frame.mode != "SINGLE"
    assert leave(frame, (way,)) == Inputs(mode="SINGLE")
    assert leave(frame, ()) == Inputs()

"""Decisions of an operator."""

from __future__ import annotations

from typing import Literal

import msgspec
import pytest

from aftdeck.operators.decide import STILL_M_S, leave, operated
from aftdeck.scenario.task_step import TaskStep
from aftdeck.simulation.frame import Frame, WayOut
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from tests.loaded import scenario


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


def _ready(title: str, held: bool) -> tuple[Frame, TaskStep]:
    """Return a frame of concept-1972 in which all conditions hold, and a step of its task."""
    loaded = scenario("concept-1972")
    frame = Simulation(loaded).look()
    step = next(step for step in loaded.steps if step.title == title)
    work = msgspec.structs.replace(
        frame.work,
        conditions=tuple(msgspec.structs.replace(c, holds=True) for c in frame.work.conditions),
        cargo=tuple(msgspec.structs.replace(cargo, held=held, seat="") for cargo in frame.work.cargo),
    )
    return msgspec.structs.replace(frame, mode=step.mode or frame.mode, work=work), step


@pytest.mark.parametrize("axis", [0, 1, 2])
@pytest.mark.parametrize(
    ("title", "held", "command"),
    [
        ("Acquire it", False, Inputs(effector="close")),
        ("Release it", True, Inputs(effector="open")),
        ("Dock it", True, Inputs(latch="latch")),
    ],
)
def test_operator_works_with_end_effector_and_latches_only_while_the_tip_is_still(
    title: str, held: bool, command: Inputs, axis: int
) -> None:
    frame, step = _ready(title, held)
    for share in (-1.01, -0.99, 0.0, 0.99, 1.01):
        twist = [0.0] * 6
        twist[3 + axis] = share * STILL_M_S
        wanted = operated(msgspec.structs.replace(frame, twist=tuple(twist)), step, None)
        assert (wanted == command) == (abs(share) < 1.0)

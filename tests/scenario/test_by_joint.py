"""Start, targets and limits of a scenario for an arm with any number of joints."""

from __future__ import annotations

import re

import numpy as np
import pytest

from aftdeck.errors import InputError
from aftdeck.historical.words_file import check_arm
from aftdeck.scenario.limits import phase_limits
from aftdeck.scenario.places import TargetReferences
from aftdeck.scenario.poses import joint_angles
from aftdeck.scenario.problems import Problems
from aftdeck.scenario.schema import Initial, PorOverride, RatesOverride
from aftdeck.scenario.starts import start
from aftdeck.units import Coordinate, CoordinateRate
from tests import loaded
from tests.joints import NUMBERS, scenario_with_joints, with_joints

EACH = pytest.mark.parametrize("joints", NUMBERS)
NOWHERE = TargetReferences((), None)


@EACH
def test_start_has_an_angle_and_a_rate_for_each_joint(joints: int) -> None:
    arm, found = with_joints(loaded.arm(), joints), Problems()
    middle = arm.limits.reach.mean(axis=1)
    angles, rates = tuple(map(Coordinate, middle)), tuple(map(CoordinateRate, 0.5 * arm.rates.servo))
    made = start(found, arm, Initial(joints=angles, rates=rates), NOWHERE, ("initial",))
    assert not found and made is not None
    assert made.angles.tolist() == middle.tolist() and made.rates.tolist() == (0.5 * arm.rates.servo).tolist()
    still = start(found, arm, Initial(joints=angles), NOWHERE, ("initial",))
    assert still is not None and still.rates.tolist() == [0.0] * joints


@EACH
def test_another_number_of_values_is_a_problem_at_its_place(joints: int) -> None:
    arm = with_joints(loaded.arm(), joints)
    for given in {*NUMBERS, 0, 6} - {joints}:
        found, wrong = Problems(), (Coordinate(0.0),) * given
        assert joint_angles(found, arm, wrong, ("here",)) is None
        start(found, arm, Initial(rates=(CoordinateRate(0.0),) * given, near=wrong), NOWHERE, ("initial",))
        phase_limits(
            found, arm.model, 0.0, PorOverride(), RatesOverride(servo=(CoordinateRate(0.01),) * given), ("limits",)
        )
        text = "\n".join(found.sentences("a.toml", ""))
        for place in ("here", "initial.rates", "initial.near", "limits.servo"):
            assert re.search(rf"{place}: expected {joints} values, .*; got {given}$", text, re.MULTILINE), text


@EACH
def test_limits_of_a_phase_have_a_rate_for_each_joint(joints: int) -> None:
    arm, found = with_joints(loaded.arm(), joints), Problems()
    given = tuple(map(CoordinateRate, 0.5 * arm.rates.vernier))
    limits = phase_limits(found, arm.model, 0.0, PorOverride(), RatesOverride(vernier=given), ("limits",))
    assert limits is not None and not found
    assert np.array_equal(limits.joints.vernier, 0.5 * arm.rates.vernier)


@EACH
def test_channels_of_1972_are_rejected_for_another_number_of_joints(joints: int) -> None:
    made = loaded.scenario("concept-1972")
    check_arm(made)
    with pytest.raises(InputError, match=f"6 joints.*{joints} joints"):
        check_arm(scenario_with_joints(made, joints))

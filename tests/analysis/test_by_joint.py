"""Values of the coordinates of an arm with any number of joints."""

from __future__ import annotations

import numpy as np
import pytest

from aftdeck.analysis.coordinates import check_stops, of_all
from aftdeck.analysis.given import smooth
from aftdeck.errors import InputError, LimitError
from tests import loaded
from tests.joints import NUMBERS, with_joints

EACH = pytest.mark.parametrize("joints", NUMBERS)


@EACH
def test_values_of_the_joints_are_those_of_their_motors(joints: int) -> None:
    number = 2 * joints + 3
    motors, others = np.arange(1, 2 * joints, 2), np.arange(100.0, 100.0 + number)
    given = np.arange(3.0 * joints).reshape(3, joints)
    found = of_all(given, motors, others, "positions")
    assert found[:, motors].tolist() == given.tolist()
    rest = np.setdiff1d(np.arange(number), motors)
    assert (found[:, rest] == others[rest]).all()
    assert (
        of_all(found, motors, others, "positions") is not given and (of_all(found, motors, others, "x") == found).all()
    )
    with pytest.raises(InputError, match=rf"\(\.\.\., {joints}\) or \(\.\.\., {number}\)"):
        of_all(np.zeros(joints + 1), motors, others, "positions")


@EACH
def test_joint_beyond_its_hard_stops_is_named(joints: int) -> None:
    model = with_joints(loaded.arm(), joints).model
    angles = model.limits.hard.mean(axis=1)
    check_stops(model, angles)
    angles[-1] = model.limits.hard[-1, 1] + 0.1
    with pytest.raises(LimitError, match=f"joint_{joints - 1} "):
        check_stops(model, angles)
    check_stops(smooth(model), angles)

"""The two-frame rule: flags and inhibits of contacts."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from aftdeck.bodies.solid import Solid
from aftdeck.state_part import Cache, decoded, encoded
from aftdeck.worksite.watch.contacts import Contacts
from aftdeck.worksite.watch.found import CLEARANCE, FOUND
from aftdeck.worksite.watch.groups import layout_of
from aftdeck.worksite.watch.pairs import among
from tests.bodies.shapes import CUBE

HOME = {"palm": "arm.hand", "prong": "arm.prong", "bar": "can", "can": "can", "wall": "orbiter"}
PAIRS = [("palm", "bar"), ("palm", "can"), ("prong", "bar"), ("prong", "can"), ("can", "wall")]
PALM_BAR, PALM_CAN, PRONG_BAR, PRONG_CAN, CAN_WALL = range(5)


LAYOUT = layout_of(tuple(dict.fromkeys(HOME.values())), [Solid(p, f, CUBE) for p, f in HOME.items()], PAIRS)
PRONG = LAYOUT.carried(["arm.prong"])


def contacts(*, holding: bool = False) -> Contacts:
    arm = LAYOUT.carried(["arm.hand", "arm.prong", *(["can"] if holding else [])])
    return Contacts(among(LAYOUT, [("prong", "bar")]), arm, np.zeros(len(PAIRS), np.uint8))


def frame(*colliding: int, clearance: float = -0.02) -> np.ndarray:
    found = np.full((len(PAIRS), FOUND), 0.5)
    found[list(colliding), CLEARANCE] = clearance
    return found


def near(found: np.ndarray) -> np.ndarray:
    return np.asarray(np.isfinite(found[:, CLEARANCE]), np.uint8)


def after(watched: Contacts, mode: int, *frames: np.ndarray) -> tuple[bool, bool]:
    """Return whether arm and finger are inhibited after these steps."""
    for found in frames:
        watched.update(found, near(found), PRONG, mode)
    return watched.inhibit.arm, watched.inhibit.finger


def test_contact_inhibits_from_the_second_control_step() -> None:
    watched = contacts()
    assert after(watched, 1, frame(PALM_CAN)) == (False, False)
    assert [c.inhibits for c in watched.standing(LAYOUT, frame(PALM_CAN), "SI")] == [False]
    assert after(watched, 1, frame(PALM_CAN)) == (True, False)
    assert [c.inhibits for c in watched.standing(LAYOUT, frame(PALM_CAN), "SI")] == [True]
    assert after(watched, 1, frame()) == (False, False)
    assert watched.standing(LAYOUT, frame(), "SI") == ()


@pytest.mark.parametrize(
    ("mode", "holding", "group", "arm", "finger"),
    [
        pytest.param(1, False, PALM_CAN, True, False, id="acquisition: the palm stops the arm"),
        pytest.param(1, False, PALM_BAR, True, False, id="acquisition: the palm on the bar too"),
        pytest.param(1, False, PRONG_CAN, True, True, id="acquisition: the prong stops the arm and itself"),
        pytest.param(1, False, PRONG_BAR, False, False, id="the prong on the bar is essential"),
        pytest.param(1, False, CAN_WALL, False, False, id="a payload that is not held does not inhibit"),
        pytest.param(1, True, CAN_WALL, True, False, id="a held payload counts as the arm"),
        pytest.param(2, True, CAN_WALL, True, True, id="extraction: both"),
        pytest.param(3, True, PRONG_CAN, True, True, id="manoeuvring: both"),
        pytest.param(3, True, PRONG_BAR, False, False, id="essential in every mode"),
    ],
)
def test_task_phase_determines_what_a_contact_inhibits(
    mode: int, holding: bool, group: int, arm: bool, finger: bool
) -> None:
    assert after(contacts(holding=holding), mode, *[frame(group)] * 2) == (arm, finger)


def test_contacts_of_palm_and_prong_inhibit_arm_and_finger() -> None:
    assert after(contacts(), 1, *[frame(PALM_CAN, PRONG_CAN)] * 2) == (True, True)


def test_contact_is_a_clearance_of_at_most_1_nm() -> None:
    assert after(contacts(), 1, *[frame(PALM_CAN, clearance=1e-9)] * 2) == (True, False)
    assert after(contacts(), 1, *[frame(PALM_CAN, clearance=1.01e-9)] * 2) == (False, False)


hits = st.lists(st.booleans(), min_size=5, max_size=5)


@settings(deadline=None)
@given(st.lists(hits, min_size=1, max_size=12), st.integers(1, 4), st.booleans(), st.integers(0, 11))
def test_inhibit_requires_a_detrimental_arm_contact_in_two_steps(
    frames: list[list[bool]], mode: int, holding: bool, cut: int
) -> None:
    watched, before = contacts(holding=holding), [False] * 5
    for k, now in enumerate(frames):
        if k == cut:
            watched = decoded(contacts(holding=holding), encoded(watched), lambda _: Cache())
        found = frame(*np.flatnonzero(now).tolist())
        inhibit = watched.update(found, near(found), PRONG, mode)
        both = [a and b for a, b in zip(before, now, strict=True)]
        palm = both[PALM_BAR] or both[PALM_CAN] or (holding and both[CAN_WALL])
        prong = both[PRONG_CAN]
        expected = (palm or prong, prong) if mode == 1 else (palm or prong,) * 2
        assert (inhibit.arm, inhibit.finger) == expected
        assert {c.group for c in watched.standing(LAYOUT, frame(), "SI")} == set(np.flatnonzero(now).tolist())
        before = now


def test_contact_change_is_reported_in_its_own_step() -> None:
    watched = contacts()
    frames = [frame(), frame(PALM_CAN), frame(PALM_CAN), frame(PALM_CAN), frame(), frame()]
    assert [watched.update(found, near(found), PRONG, 1).changed for found in frames] == [
        False,
        True,
        True,
        False,
        True,
        False,
    ]


def test_contacts_are_sorted_by_depth_with_their_kind() -> None:
    watched, found = contacts(holding=True), frame(PRONG_BAR, clearance=0.0)
    found[CAN_WALL, CLEARANCE], found[PALM_CAN, CLEARANCE] = -0.3, -0.0213
    after(watched, 2, found, found)
    standing_contacts = watched.standing(LAYOUT, found, "SI")
    assert [c.text for c in standing_contacts] == [
        "contact of can and wall: 300 mm deep",
        "contact of palm and can: 21.3 mm deep",
        "contact of prong and bar, part of the task",
    ]
    assert [(c.a, c.b, c.depth, c.essential, c.inhibits) for c in standing_contacts] == [
        ("can", "wall", 0.3, False, True),
        ("palm", "can", 0.0213, False, True),
        ("prong", "bar", 0.0, True, False),
    ]

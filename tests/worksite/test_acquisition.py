"""Acquisition: the six conditions against half-space arithmetic, and the capture envelope in closed form."""

from __future__ import annotations

from math import asin, atan, atan2, hypot, radians

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from aftdeck.arrays import Array
from aftdeck.frames import rotation_x, rotation_y, rotation_z
from aftdeck.units import FOOT
from aftdeck.worksite.capture.acquisition import (
    ALONG,
    AWAY,
    FIXED,
    HEIGHT,
    PALM,
    PITCH,
    PRONG,
    ROLL,
    SIDE,
    SPACING,
    YAW,
    acquisition,
    grasp,
)
from aftdeck.worksite.conditions import all_hold, failing, rejection_text
from tests.bodies.shapes import rotations, skewed
from tests.worksite.grips import BAR, TOLERANCES, bar, found_at, over, over_face

SEEDS = st.integers(0, 2**32 - 1)
A, B, C, D, E, F = (1, 2, 5, 6), (1, 2, 3, 4), (1, 3, 5, 7), (2, 4, 6, 8), (5, 6, 7, 8), (3, 4, 7, 8)


def anywhere(seed: int, bodies: list[Array]) -> list[Array]:
    """Return the bodies after one random rigid motion."""
    rng = np.random.default_rng(seed)
    turn, shift = rotations(rng, 1)[0], rng.uniform(-20.0, 20.0, 3)
    return [body @ turn.T + shift for body in bodies]


def names(bodies: list[Array]) -> set[str]:
    """Return the names of the failed conditions."""
    _, found = found_at(bodies)
    return {condition.name for condition in failing(acquisition(found, TOLERANCES.packed()))}


@settings(max_examples=60, deadline=None)
@given(SEEDS)
def test_conditions_agree_with_half_space_arithmetic(seed: int) -> None:
    rng = np.random.default_rng(seed)
    along, across, height, pitch, roll, yaw = (rng.normal(size=6) * [0.5, 0.1, 0.05, 0.03, 0.1, 0.1]).tolist()
    end_effector = over(
        along, across, height, pitch, roll, yaw, spacing=rng.uniform(0.7, 0.9), side=int(rng.choice([-1, 1]))
    )
    palm, fixed, prong, held = bodies = anywhere(seed, [*end_effector, bar()])
    taken, found = found_at(bodies)
    centre, face = palm[[1, 3, 5, 7]].mean(axis=0), prong[4:].mean(axis=0)
    axis = held[[2, 3, 6, 7]].mean(axis=0) - held[[0, 1, 4, 5]].mean(axis=0)
    length = np.linalg.norm(axis)
    middle = (centre - held.mean(axis=0)) @ axis / length
    expected = {
        PALM: over_face(palm, D, held).min(),
        FIXED: over_face(fixed, B, held).min(),
        PRONG: over_face(prong, E, held).min(),
        SPACING: over_face(fixed, B, face[None])[0],
        HEIGHT: over_face(held, C, centre[None])[0],
        ALONG: middle,
        AWAY: np.linalg.norm(centre - held[[0, 2, 4, 6]].mean(axis=0)),
    }
    for k, value in expected.items():
        assert found[k] == pytest.approx(value, abs=1e-12)
    conditions = acquisition(found, TOLERANCES.packed())
    assert taken == all_hold(conditions)
    held_by = [
        expected[PALM] >= 0.0,
        expected[FIXED] >= 0.0,
        expected[PRONG] >= 0.0,
        expected[SPACING] <= TOLERANCES.spacing,
        0.0 <= expected[HEIGHT] <= TOLERANCES.window,
        0.5 * FOOT - length / 2.0 <= middle <= length / 2.0 - 0.5 * FOOT,
    ]
    assert [condition.holds for condition in conditions] == held_by


@settings(max_examples=40, deadline=None)
@given(SEEDS)
def test_skewed_bodies_are_measured_from_the_same_faces(seed: int) -> None:
    rng = np.random.default_rng(seed)
    bodies = [body + rng.normal(size=3) for body in skewed(rng, 4)]
    _, found = found_at(bodies)
    palm, fixed, prong, held = bodies
    for k, body, rim in ((PALM, palm, D), (FIXED, fixed, B), (PRONG, prong, E)):
        assert found[k] == pytest.approx(over_face(body, rim, held).min(), abs=1e-9)


FINGERS = {"fixed finger beside bar", "prong beside bar"}
ENVELOPE = [  # failed condition, axis, and limit along or about the axis [ft, rad]; the palm is 0.03 ft over the bar
    ("palm along bar", "along", 1.0),
    ("palm along bar", "along", -1.0),
    ("fixed finger beside bar", "across", -0.125),
    ("prong beside bar", "across", 0.125),
    ("palm height", "height", 1.0 / 16.0),
    ("palm height", "height", 0.0),
    ("palm over bar", "roll", atan(0.03 / 0.25)),  # 6.84 deg
    ("palm over bar", "roll", -atan(0.03 / 0.25)),
    ("palm over bar", "pitch", atan(0.03 / 1.5)),  # 1.146 deg
    ("palm over bar", "pitch", -atan(0.03 / 1.5)),
    ("prong closed", "spacing", 0.8),
]


@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize(("name", "axis", "limit"), ENVELOPE)
def test_acquisition_envelope_ends_at_its_closed_form_limits(name: str, axis: str, limit: float, side: int) -> None:
    middle = {"height": 0.03, "spacing": 0.75}.get(axis, 0.0)
    inside, outside = limit + 1e-7 * np.sign(middle - limit), limit - 1e-7 * np.sign(middle - limit)
    taken, _ = found_at(anywhere(5, [*over(**{axis: inside}, side=side), bar()]))
    assert taken
    failed = names(anywhere(5, [*over(**{axis: outside}, side=side), bar()]))
    if side < 0 and name in FINGERS:  # the fingers have changed sides
        name = next(iter(FINGERS - {name}))
    # A palm below the top of the bar overlaps the bar, so a second condition fails.
    assert failed == ({name, "palm over bar"} if (axis, limit) == ("height", 0.0) else {name})


@pytest.mark.parametrize("sense", [1.0, -1.0])
def test_both_fingers_limit_yaw(sense: float) -> None:
    # Two opposite corners of the bar reach the planes of the two fingers' inner faces at the same angle t:
    # 1.5 sin t + 0.25 cos t = 0.375.
    limit = asin(0.375 / hypot(1.5, 0.25)) - atan2(0.25, 1.5)
    assert limit == pytest.approx(radians(4.8), abs=radians(0.05))
    assert found_at([*over(yaw=sense * (limit - 1e-7)), bar()])[0]
    assert names([*over(yaw=sense * (limit + 1e-7)), bar()]) == FINGERS


def test_longer_bar_allows_less_pitch() -> None:
    for half, figure in ((1.0, 1.72), (1.5, 1.146), (2.0, 0.859)):
        longer = bar() * [half * 2.0 * FOOT / BAR[0], 1.0, 1.0]
        _, found = found_at([*over(), longer])
        assert found[PITCH] == pytest.approx(atan(0.03 / half), abs=1e-12)
        assert np.degrees(found[PITCH]) == pytest.approx(figure, abs=5e-3)
        _, aside = found_at([*over(along=0.3), longer])
        assert aside[PITCH] == pytest.approx(atan(0.03 / (half + 0.3)), abs=1e-12)


@settings(max_examples=60, deadline=None)
@given(SEEDS, st.sampled_from([(PITCH, "pitch"), (ROLL, "roll"), (YAW, "yaw")]))
def test_reported_rotation_margin_is_exact(seed: int, axis: tuple[int, str]) -> None:
    rng = np.random.default_rng(seed)
    k, name = axis
    along, across, height, pitch, roll, yaw = (rng.normal(size=6) * [0.3, 0.03, 0.01, 0.004, 0.02, 0.02]).tolist()
    end_effector = over(along, across, 0.03 + height, pitch, roll, yaw)
    _, found = found_at([*end_effector, bar()])
    left = found[k]
    if found[PALM] < 0.0 or found[FIXED] < 0.0 or found[PRONG] < 0.0:
        return
    # Rotations are about the end effector's axes through the palm's centre: X2 out of the palm, Y2 to the fixed finger.
    palm = end_effector[0]
    centre = palm[[1, 3, 5, 7]].mean(axis=0)
    x2, y2 = palm[1] - palm[0], palm[4] - palm[0]
    own = np.array([x2 / np.linalg.norm(x2), y2 / np.linalg.norm(y2), np.zeros(3)])
    own[2] = np.cross(own[0], own[1])
    make = {"pitch": rotation_y, "roll": rotation_z, "yaw": rotation_x}[name]
    least = []
    for angle in (left * (1.0 - 1e-6), left * (1.0 + 1e-6)):
        both = []
        for sense in (1.0, -1.0):
            turn = own.T @ make(sense * angle) @ own
            _, turned = found_at([*((body - centre) @ turn.T + centre for body in end_effector), bar()])
            both.append(min(turned[PALM], turned[FIXED], turned[PRONG]))
        least.append(min(both))
    assert least[0] > 0.0 > least[1]


@pytest.mark.parametrize("pitch", [radians(2.0), radians(-2.0)])
def test_excess_pitch_is_reported_as_a_negative_margin(pitch: float) -> None:
    _, found = found_at([*over(pitch=pitch), bar()])
    back = found[PITCH]
    assert back < 0.0
    _, turned = found_at([*over(pitch=pitch + np.sign(pitch) * back), bar()])
    assert turned[PALM] == pytest.approx(0.0, abs=1e-12)


@settings(max_examples=30, deadline=None)
@given(SEEDS)
def test_prong_side_does_not_depend_on_the_coordinate_frame(seed: int) -> None:
    for side, face in ((1, "b"), (-1, "e")):
        bodies = anywhere(seed, [*over(side=side), bar()])
        _, found = found_at(bodies)
        assert found[SIDE] == pytest.approx(-side, abs=1e-12)
        assert grasp(found).prong_at == face
        prong, held = bodies[2], bodies[3]
        near = {rim: abs(over_face(held, rim, prong).mean()) for rim in (B, E)}
        assert min(near, key=lambda rim: near[rim]) == {"b": B, "e": E}[face]


def test_fingers_are_not_tested_beyond_their_distance() -> None:
    taken, found = found_at([*over(height=8.5), bar()])
    assert not taken
    conditions = {condition.name: condition for condition in acquisition(found, TOLERANCES.packed())}
    assert conditions["palm over bar"].holds
    prong = conditions["prong beside bar"]
    assert not prong.holds and (prong.value, prong.limit) == pytest.approx((8.5 * FOOT, 8.0 * FOOT))
    near = acquisition(found_at([*over(height=7.9), bar()])[1], TOLERANCES.packed())
    assert {condition.name for condition in failing(near)} == {"palm height"}


def test_rejected_capture_lists_the_failed_conditions() -> None:
    _, found = found_at([*over(height=2.5 / 12.0, along=1.3, spacing=1.6), bar()])
    conditions = acquisition(found, TOLERANCES.packed())
    assert {c.name: (c.value, c.limit) for c in failing(conditions)} == {
        "prong closed": pytest.approx((1.6 * FOOT, 0.8 * FOOT)),
        "palm height": pytest.approx((2.5 / 12.0 * FOOT, FOOT / 16.0)),
        "palm along bar": pytest.approx((1.3 * FOOT, FOOT)),
    }
    text = rejection_text("CAPTURE", conditions, "ft-in")
    assert text.startswith("CAPTURE ") and text.endswith(
        "palm 15.6 in from the bar's middle to its rear, at most 12 in allowed"
    )


def test_closing_the_prong_over_the_bar_acquires_it() -> None:
    # The palm moves from 4 ft to 0.03 ft above the bar at 0.5 ft/s; then the prong closes at 0.25 ft/s.
    held: dict[str, float] = {}
    down = (4.0 - 0.03) / 0.5
    for tick in range(600):
        time = tick * 0.02
        height, spacing = max(0.03, 4.0 - 0.5 * time), 1.625 - 0.25 * max(0.0, time - down)
        taken, found = found_at([*over(0.3, 0.06, height, spacing=spacing), bar()])
        for condition in acquisition(found, TOLERANCES.packed()):
            if condition.holds:
                held.setdefault(condition.name, time)
            else:
                assert condition.name not in held
        if taken:
            break
    assert time == pytest.approx(down + (1.625 - 0.8) / 0.25, abs=0.021)  # 11.24 s
    assert held.pop("palm height") == pytest.approx((4.0 - 1.0 / 16.0) / 0.5, abs=0.021)
    assert held.pop("prong closed") == time
    assert set(held.values()) == {0.0}

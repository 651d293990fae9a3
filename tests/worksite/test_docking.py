"""Docking: the envelope's figures in closed form, and the results of `approach` against plain arithmetic."""

from __future__ import annotations

from math import acos, inf, pi, radians, tan

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from aftdeck.arrays import Array
from aftdeck.errors import InputError
from aftdeck.frames import rotation_x, rotation_y, rotation_z
from aftdeck.units import FOOT
from aftdeck.worksite.berths.docking import (
    BEFORE,
    DISTANCE,
    FOUND,
    INSIDE,
    TURNED,
    DockingTolerances,
    approach,
    docking,
    envelope,
)
from aftdeck.worksite.conditions import all_hold, condition_text, failing
from tests.bodies.shapes import rotations

SEEDS = st.integers(0, 2**32 - 1)
TOLERANCES = DockingTolerances(0.25 * FOOT, radians(2.0 + 32.0 / 60.0))
APOTHEM, LENGTH = 7.5, 15.0
"""Apothem and length of the CAE [ft]."""


def probe() -> tuple[Array, Array]:
    """Return the vertices and the centre of the tip [m] of a hexagonal probe, 1 ft across corners and 1 ft long."""
    around = np.arange(6) * pi / 3.0
    rim = np.stack([np.zeros(6), 0.5 * np.cos(around), 0.5 * np.sin(around)], axis=1)
    vertices = np.concatenate([rim - [end, 0.0, 0.0] for end in (16.0, 15.0)])
    return vertices * FOOT, np.array([-16.0, 0.0, 0.0]) * FOOT


def pose(position: Array, rotation: Array) -> Array:
    return np.concatenate([position, rotation.ravel()])


def found_at(out: float, across: float = 0.0, turn: Array | None = None, sides: int = 6, seed: int = 1) -> Array:
    """Return the result of `approach` at a random port; `out` and `across` are the probe tip's position there [ft]."""
    rng = np.random.default_rng(seed)
    base, shift = rotations(rng, 1)[0], rng.uniform(-20.0, 20.0, 3)
    vertices, face = probe()
    rotation = np.eye(3) if turn is None else turn
    position = np.array([out, across, 0.0]) * FOOT - rotation @ face
    found = np.full(FOUND, np.nan)
    planes = envelope(APOTHEM * FOOT, LENGTH * FOOT, sides=sides)
    approach(vertices, face, pose(base @ position + shift, base @ rotation), pose(shift, base), planes, found)
    return found


@settings(deadline=None, max_examples=60)
@given(SEEDS, st.sampled_from([4, 6, 8, 12]), st.booleans())
def test_docking_envelope_consists_of_the_extended_prism_planes(seed: int, sides: int, turned: bool) -> None:
    rng = np.random.default_rng(seed)
    apothem, length = rng.uniform(1.0, 5.0, 2)
    offset = rng.uniform(-0.3, 0.3, 2)
    outward, axis = ((0.0, -1.0, 0.0), (1.0, 0.0, 0.0)) if turned else ((1.0, 0.0, 0.0), (0.0, 0.0, 1.0))
    planes = envelope(apothem, length, sides=sides, outward=outward, axis=axis, offset=(offset[0], offset[1]))
    out, up = np.array(outward), np.array(axis)
    across = np.cross(up, out)
    # Each corner of face c is in the plane of face c and in the planes of two neighbouring faces.
    middle = -(apothem * out + offset[0] * across + offset[1] * up)
    half = apothem * tan(pi / sides)
    for side in (-1.0, 1.0):
        for end in (-0.5, 0.5):
            corner = middle + apothem * out + side * half * across + end * length * up
            over = planes[:, :3] @ corner - planes[:, 3]
            assert np.count_nonzero(np.abs(over) < 1e-12) == 3
            assert np.all(over < 1e-12)
    # A regular prism: all sides have the same distance from its axis.
    heights = planes[:, 3] - planes[:, :3] @ middle
    assert heights == pytest.approx([-apothem, apothem, apothem, length / 2.0, length / 2.0], abs=1e-12)


@pytest.mark.parametrize(("sides", "closes"), [(6, 1.0), (8, tan(pi / 8.0))])
def test_docking_envelope_closes_where_the_sides_meet(sides: int, closes: float) -> None:
    planes = envelope(APOTHEM, LENGTH, sides=sides)
    for out, inside in ((closes - 1e-9, True), (closes + 1e-9, False)):
        point = np.array([out * APOTHEM, 0.0, 0.0])
        assert bool(np.all(planes[:, :3] @ point <= planes[:, 3])) is inside


def test_square_docking_envelope_never_closes() -> None:
    planes = envelope(APOTHEM, LENGTH, sides=4)
    assert np.all(planes[:, :3] @ np.array([1e6, 0.999 * APOTHEM, 0.0]) < planes[:, 3])


@pytest.mark.parametrize(
    ("out", "sides", "room"),
    [(4.0, 6, 2.5 * tan(pi / 6.0) - 0.5), (0.0, 6, 6.5 * tan(pi / 6.0) - 0.5), (1.5, 8, None)],
)
def test_probe_fits_within_the_lateral_limits_of_the_dimension_table(
    out: float, sides: int, room: float | None
) -> None:
    # The probe has ±0.9 ft of lateral room at a distance of 4 ft, and ±3.2 ft at contact.
    # With an octagonal envelope it has room only up to about 1.5 ft from the port.
    if room is None:
        assert found_at(out, sides=sides)[INSIDE] > 0.0 > found_at(out + 0.15, sides=sides)[INSIDE]
        return
    for sense in (1.0, -1.0):
        assert found_at(out, sense * (room - 1e-6))[INSIDE] > 0.0 > found_at(out, sense * (room + 1e-6))[INSIDE]


@settings(deadline=None, max_examples=60)
@given(SEEDS)
def test_approach_agrees_with_plain_arithmetic(seed: int) -> None:
    rng = np.random.default_rng(seed)
    turn, port_turn = rotations(rng, 2)
    position, port_position = rng.uniform(-10.0, 10.0, (2, 3))
    vertices, face = rng.normal(size=(12, 3)), rng.normal(size=3)
    planes = envelope(2.0, 4.0, sides=8)
    found = np.full(FOUND, np.nan)
    approach(vertices, face, pose(position, turn), pose(port_position, port_turn), planes, found)
    local = (vertices @ turn.T + position - port_position) @ port_turn
    inside = planes[:, 3] - local @ planes[:, :3].T
    assert found[BEFORE] == pytest.approx(inside[:, 0].min(), abs=1e-12)
    assert found[INSIDE] == pytest.approx(inside[:, 1:].min(), abs=1e-12)
    assert found[DISTANCE] == pytest.approx(np.linalg.norm(turn @ face + position - port_position), abs=1e-12)
    cosines = np.clip((turn * port_turn).sum(axis=0), -1.0, 1.0)
    assert found[TURNED:] == pytest.approx([acos(cosine) for cosine in cosines], abs=1e-7)


@pytest.mark.parametrize(("make", "moved"), [(rotation_x, "yz"), (rotation_y, "xz"), (rotation_z, "xy")])
def test_docking_compares_all_axes_by_default_and_only_y_as_published(make: object, moved: str) -> None:
    assert callable(make)
    for angle in (TOLERANCES.angle - 1e-9, TOLERANCES.angle + 1e-9):
        found = found_at(0.1, turn=make(angle))
        conditions = docking(found, TOLERANCES)
        assert all_hold(conditions) == (angle < TOLERANCES.angle)
        report = docking(found, DockingTolerances(TOLERANCES.distance, TOLERANCES.angle, "y"))
        assert all_hold(report) == (angle < TOLERANCES.angle or "y" not in moved)


def test_docking_tolerances_apply_at_their_limits() -> None:
    assert all_hold(docking(found_at(0.25 - 1e-9), TOLERANCES))
    failed = failing(docking(found_at(0.26), TOLERANCES))
    assert [condition.name for condition in failed] == ["probe at port"]
    assert (failed[0].value, failed[0].limit) == pytest.approx((0.26 * FOOT, 0.25 * FOOT))
    assert {condition.name for condition in failing(docking(found_at(-0.1), TOLERANCES))} == {"probe before port"}
    turned = docking(found_at(0.2, turn=rotation_z(radians(-3.0))), TOLERANCES)
    (attitude,) = failing(turned)
    assert (attitude.value, attitude.limit) == pytest.approx((radians(3.0), TOLERANCES.angle))
    assert condition_text(attitude, "SI") == "payload's y axis turned 3° from the port's, at most 2.53° allowed"


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"apothem": 0.0}, "apothem is 0 m"),
        ({"length": inf}, "length inf m"),
        ({"sides": 5}, "5 sides"),
        ({"outward": (1.0, 0.1, 0.0)}, r"\(1.0, 0.1, 0.0\)"),
        ({"axis": (1.0, 0.0, 0.0)}, r"along \(1.0, 0.0, 0.0\);"),
    ],
)
def test_invalid_envelope_argument_is_rejected(arguments: dict[str, object], message: str) -> None:
    given_ = {"apothem": 1.0, "length": 2.0} | arguments
    with pytest.raises(InputError, match=message):
        envelope(**given_)  # type: ignore[arg-type]

"""The orbiter's solids against its shapes, and against the space that a payload needs."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest

import aftdeck
from aftdeck import separation
from aftdeck.arms.solids import solids_of
from aftdeck.arrays import Array
from aftdeck.bodies.cameras import setting
from aftdeck.bodies.hexahedron import NX, D, pack
from aftdeck.bodies.solid import Solid
from aftdeck.errors import ScenarioError
from aftdeck.frames import SCENE_FROM_PANEL_AXES, SCENE_ORIGIN, Pose, rotation_x
from aftdeck.scene.mesh import moved
from aftdeck.scene.placed import Leaf, placed
from aftdeck.scene.solids import solid
from aftdeck.shapes import Light, Ring
from aftdeck.worksite import Worksite, load_worksite, worksites
from aftdeck.worksite.berths.bay import BayBerth
from aftdeck.worksite.file.check import distance

INCH = 0.0254
ENVELOPE = 90.0 * INCH
"""Radius of the payload envelope in the bay [m]."""
PIN = 0.03
"""Radius about the fixture's axis that contains the pin and the ball on its end [m]."""
TIP = 56.0 * INCH
"""Distance from the wrist yaw joint to the rim of the end effector [m]."""


@pytest.fixture(scope="module")
def orbiter() -> Worksite:
    return load_worksite("orbiter")


def heights(solids: Sequence[Solid], points: Array) -> Array:
    """Return the height (n, s) of each point over the nearest face of each solid; negative inside [m]."""
    packed = np.array([pack(solid.vertices) for solid in solids])
    normals = packed[:, NX:D].reshape(-1, 3, 6).transpose(0, 2, 1)
    return np.asarray((np.einsum("sfk,vk->vsf", normals, points) - packed[:, D:]).max(axis=2))


def outside(shape: Leaf, pose: Pose, solids: Sequence[Solid], allowed: float) -> Array:
    """Return the corners (n, 3) of a shape that are at least a distance `allowed` [m] away from every solid."""
    points = np.unique(moved(solid(shape, 24), pose).vertices, axis=0)
    order = heights(solids, points).argsort(axis=1)
    out = [
        point
        for point, nearest in zip(points, order, strict=True)
        if not any(distance(point, solids[k].vertices) < allowed for k in nearest)
    ]
    return np.array(out).reshape(-1, 3)


def test_orbiter_shapes_lie_inside_its_solids(orbiter: Worksite) -> None:
    """Exceptions: the bay's frames project 2 cm into the tube; lamps have no solid."""
    for shape, pose in placed(orbiter.bodies[0].shapes):
        if not isinstance(shape, Light):
            assert not len(outside(shape, pose, orbiter.solids, 0.02 if isinstance(shape, Ring) else 0.001)), shape


@pytest.mark.parametrize("name", worksites())
def test_payload_shapes_except_the_pin_lie_inside_its_solids(name: str) -> None:
    """The pin enters the end effector.

    Bright and dark boxes project from the solids by up to 2 cm, shapes of foil or structure by up to 7 mm.
    """
    allowed = {
        (kind, of): 0.0071 for kind, of in [("Cylinder", "foil"), ("Cylinder", "structure"), ("Box", "structure")]
    }
    allowed |= {("Box", "bright"): 0.0201, ("Box", "dark"): 0.0201}
    for cargo in load_worksite(name).payloads:
        for shape, pose in placed(cargo.shapes):
            if isinstance(shape, Light):
                continue
            out = outside(shape, pose, cargo.solids, allowed.get((type(shape).__name__, shape.material), 0.001))
            if cargo.grapple is not None:
                off_axis = ((out - cargo.grapple.position) @ cargo.grapple.rotation)[:, 1:]
                out = out[np.linalg.norm(off_axis, axis=1) > PIN]
            assert not len(out), (cargo.name, shape)


def test_perfect_capture_leaves_clearance_to_the_target_rod(orbiter: Worksite) -> None:
    """The clearance is the distance between the axes of end effector and rod, minus the radii: 0.286 - 0.2 - 0.013 m.

    Wrist camera and wrist light are more than 0.4 m away from the rod.
    """
    (cargo,) = orbiter.payloads
    assert cargo.grapple is not None
    model = aftdeck.load_arm("srms").model
    *_, target = (body.vertices for body in cargo.solids if body.part == "payload grapple fixture")
    rod = (target - cargo.grapple.position) @ cargo.grapple.rotation
    assert rod[:, 0].min() == pytest.approx(-0.123), "the ball on its end"
    rooms: dict[str, float] = {}
    for part, frame, vertices in solids_of(model):
        if frame == "arm.wrist_roll":
            own = (vertices - [TIP, 0.0, 0.0]) @ rotation_x(model.end_effector_roll)
            rooms[part] = min(rooms.get(part, math.inf), separation(own, rod).clearance)
    assert rooms["end effector"] == pytest.approx(0.073, abs=0.001)
    assert min(rooms["wrist camera"], rooms["wrist light"]) > 0.4


def test_target_shape_without_a_cover_is_rejected(orbiter: Worksite, tmp_path: Path) -> None:
    ring = 'kind = "ring", material = "padding"'
    assert orbiter.text.count(ring) == 1
    file = tmp_path / "turned.toml"
    file.write_text(orbiter.text.replace(ring, f'{ring}, axis = "y"'), encoding="utf-8")
    with pytest.raises(ScenarioError, match="cargo payload: grapple: this ring "):
        load_worksite(file)


def test_payload_envelope_of_90_in_radius_is_clear_in_the_bay(orbiter: Worksite) -> None:
    """Exception: the bay cameras on the bulkheads are inside the envelope, at its two ends."""
    assert orbiter.bay is not None
    x = np.linspace(orbiter.bay.low[0] + 0.6, orbiter.bay.high[0] - 0.6, 40)
    t = np.linspace(0.0, math.tau, 361)
    points = np.array([(a, ENVELOPE * math.cos(b), ENVELOPE * math.sin(b)) for a in x for b in t])
    assert heights(orbiter.solids, points).min() > 0.0


def test_latched_payload_contacts_only_the_latches(orbiter: Worksite) -> None:
    (cargo,) = orbiter.payloads
    pose = cargo.start.pose
    for own in cargo.solids:
        vertices = own.vertices @ pose.rotation.T + pose.position
        for other in orbiter.solids:
            gap = separation(vertices, other.vertices).clearance
            if own.part == "payload trunnions" and other.part.startswith("latches"):
                assert gap > -1e-3, "they rest in the latches"
            else:
                assert gap > 0.015, (own.part, other.part)


def test_trunnions_are_at_their_published_positions_over_the_latches(orbiter: Worksite) -> None:
    """Longeron: Yo 93.925, Zo 414.05, an attach point every 3.933 from Xo 608.80 on; keel: Yo 0, Zo 305.025 [in]."""
    (cargo,) = orbiter.payloads
    pose = cargo.start.pose
    places = (cargo.trunnions @ pose.rotation.T + pose.position) / INCH + [942.0, 0.0, 400.0]
    *pairs, keel = places
    assert cargo.trunnion_names == ("forward port", "forward starboard", "aft port", "aft starboard", "keel")
    for x, y, z in pairs:
        assert (abs(y), z) == pytest.approx((93.925, 414.05))
        steps = (x - 608.80) / 3.933
        assert steps == pytest.approx(round(steps), abs=0.01)
        latch = next(
            other.vertices
            for other in orbiter.solids
            if other.part == f"latches {'port' if y < 0.0 else 'starboard'}"
            and abs(other.vertices[:, 0].mean() / INCH + 942.0 - x) < 0.1
        )
        assert latch[:, 2].max() / INCH + 400.0 == pytest.approx(z - 1.625, abs=0.01)
    assert keel[1:] == pytest.approx([0.0, 305.025])


def test_arm_reaches_the_grapple_fixture_in_the_bay(orbiter: Worksite) -> None:
    (cargo,) = orbiter.payloads
    assert cargo.grapple is not None
    arm = aftdeck.load_arm("srms")
    pose, grapple = cargo.start.pose, cargo.grapple
    position = pose.rotation @ grapple.position + pose.position + SCENE_ORIGIN
    axes = SCENE_FROM_PANEL_AXES.T @ pose.rotation @ grapple.rotation
    tip = arm.model.mount.from_("panel", Pose(SCENE_FROM_PANEL_AXES.T @ position, axes))
    found = arm.inverse(Pose(tip.position, tip.rotation @ rotation_x(arm.model.end_effector_roll)))
    assert len(found) > 0
    assert grapple.rotation @ [1.0, 0.0, 0.0] == pytest.approx([0.0, 0.0, -1.0]), (
        "the end effector points into the payload"
    )


def test_bay_cameras_have_the_published_pan_and_zoom_ranges(orbiter: Worksite) -> None:
    for camera in orbiter.cameras[:4]:
        assert camera.drive is not None
        pan, zoom = camera.drive.pan, camera.drive.zoom
        assert pan is not None
        assert zoom is not None
        assert pan.slow is not None
        assert np.degrees([pan.least, pan.greatest, pan.rate, pan.slow]) == pytest.approx([-170.0, 170.0, 12.0, 1.2])
        assert np.degrees([zoom.least, zoom.greatest]) == pytest.approx([9.0, 77.0])
        assert abs(setting(camera).pan) < math.radians(30.0), "close to the direction of its base"


def test_orbiter_origin_equals_the_scene_origin(orbiter: Worksite) -> None:
    assert orbiter.origin == pytest.approx(SCENE_ORIGIN)


def test_berth_guides_match_the_latch_solids(orbiter: Worksite) -> None:
    """Low and high in the V, a trunnion has the same clearance to the latch solids as to the berth's guides."""
    (berth,) = orbiter.berths
    assert isinstance(berth, BayBerth)
    (cargo,) = orbiter.payloads
    assert berth.guides is not None
    x, y, z = cargo.trunnions[0] + cargo.start.pose.position
    latches = [body.vertices for body in orbiter.solids if body.part == "latches port"]
    blades = [body for body in latches if abs(body[:, 0].mean() - x) < 0.3]
    top = min(blade[:, 2].max() for blade in blades if blade[:, 2].max() > z)
    assert top - z == pytest.approx(berth.guides.height, abs=0.02)
    for height in (0.1, 0.4):
        free = berth.guides.throat + 1.625 * INCH + height * math.tan(berth.guides.half_angle)
        room = min(distance(np.array([x, y, z + height]), blade) for blade in blades)
        assert room / math.cos(berth.guides.half_angle) == pytest.approx(free, abs=0.02)


def test_trunnion_contacts_with_both_latch_rows_are_essential(orbiter: Worksite) -> None:
    assert {essential.parts for essential in orbiter.essential} == {
        ("payload trunnions", "latches port"),
        ("payload trunnions", "latches starboard"),
        ("end effector", "payload grapple fixture"),
    }

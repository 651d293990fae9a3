"""The concept arm's worksite against the report's text, and the arm's reach in this worksite."""

from __future__ import annotations

import math
from itertools import combinations, product

import numpy as np
import pytest

import aftdeck
from aftdeck import separation
from aftdeck.arms.solids import solids_of
from aftdeck.arrays import Array
from aftdeck.bodies.cameras import setting
from aftdeck.bodies.hexahedron import NX, D
from aftdeck.bodies.hexahedron_check import hexahedron
from aftdeck.bodies.solid import Solid
from aftdeck.frames import Pose
from aftdeck.kinematics.frames import frames_of, place_frames
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.constants.site import site_of
from aftdeck.worksite import Payload, Worksite, load_worksite
from aftdeck.worksite.berths.port import Port
from aftdeck.worksite.capture.bar import BarFile

FOOT = 0.3048
REPORT = np.diag([1.0, -1.0, -1.0])
"""Conversion between the report's R (x aft, y port, z down) and the scene."""
DOWN = np.array([[0.0, 0.0, -1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]])
"""Axes of the end effector in R, with X2 pointing down."""


@pytest.fixture(scope="module")
def concept() -> Worksite:
    return load_worksite("concept-1972")


def extent(vertices: list[Array]) -> Array:
    """Return the minimum and maximum coordinates (2, 3) [ft]."""
    points = np.concatenate(vertices) / FOOT
    return np.array([points.min(axis=0), points.max(axis=0)])


def of_part(worksite: Worksite, part: str) -> Array:
    return extent([solid.vertices for solid in worksite.solids if solid.part == part])


def test_bay_measures_60_by_15_ft_inside(concept: Worksite) -> None:
    assert of_part(concept, "aft body")[0, 0] - of_part(concept, "cabin")[1, 0] == pytest.approx(60.0)
    assert of_part(concept, "bay wall starboard")[0, 1] - of_part(concept, "bay wall port")[1, 1] == pytest.approx(15.0)
    assert concept.bay is not None
    inside = np.array([concept.bay.low, concept.bay.high]) / FOOT
    assert inside[:, 0].tolist() == pytest.approx([of_part(concept, "cabin")[1, 0], of_part(concept, "aft body")[0, 0]])
    walls = [of_part(concept, "bay wall port")[1, 1], of_part(concept, "bay wall starboard")[0, 1]]
    assert inside[:, 1].tolist() == pytest.approx(walls)
    assert inside[:, 2].tolist() == pytest.approx(
        [of_part(concept, "bay floor")[1, 2], of_part(concept, "bay wall port")[1, 2]]
    )


def test_worksite_bodies_do_not_overlap(concept: Worksite) -> None:
    for a, b in combinations(concept.solids, 2):
        assert separation(a.vertices, b.vertices).clearance > -1e-9, (a.part, b.part)


def test_shapes_of_a_body_have_the_vertices_of_its_solids(concept: Worksite) -> None:
    for body in concept.bodies:
        shapes = [np.array(shape.vertices) for shape in body.shapes if hasattr(shape, "vertices")]
        placed = [shape @ body.pose.rotation.T + body.pose.position for shape in shapes]
        corners = {tuple(v.round(9)) for v in np.concatenate(placed)}
        frame = body.fixed_to
        housings = {camera.housing for camera in concept.cameras if not camera.inside}
        solids = [solid.vertices for solid in concept.solids if solid.frame == frame and solid.part not in housings]
        assert corners == {tuple(v.round(9)) for v in np.concatenate(solids)}


def test_payload_has_its_expected_clearances_in_the_bay(concept: Worksite) -> None:
    payload = concept.payloads[0]
    pose = payload.start.pose
    gaps = {
        solid.part: min(
            separation(own.vertices @ pose.rotation.T + pose.position, solid.vertices).clearance
            for own in payload.solids
        )
        for solid in concept.solids
    }
    assert gaps["bay floor"] / FOOT == pytest.approx(0.75, abs=0.005)
    assert gaps["bay wall port"] / FOOT == pytest.approx(1.0)
    assert min(gaps.values()) == gaps["bay floor"]


def test_payload_is_a_hexagonal_prism_with_a_flat_on_top(concept: Worksite) -> None:
    own = [solid.vertices for solid in concept.payloads[0].solids if solid.part == "payload"]
    apothem = 6.5 * math.cos(math.radians(30.0))
    assert len(own) == 2
    assert extent(own) == pytest.approx(np.array([[-15.0, -6.5, -apothem], [15.0, 6.5, apothem]]))


def test_receptacle_is_numbered_as_in_the_report(concept: Worksite) -> None:
    """Face c is on top, b and e are the sides towards -Y and +Y (port), a and f the ends; 3 by 0.5 by 0.75 ft."""
    cargo = concept.payloads[0]
    bar = cargo.receptacle
    assert bar is not None
    body = hexahedron(bar)
    normals = body[NX:D].reshape(3, 6).T @ REPORT
    expected = [[-1, 0, 0], [0, -1, 0], [0, 0, -1], [0, 0, 1], [0, 1, 0], [1, 0, 0]]
    assert normals == pytest.approx(np.array(expected, dtype=float), abs=1e-12)
    top = 6.5 * math.cos(math.radians(30.0))
    assert extent([bar]) == pytest.approx(np.array([[-1.5, -0.25, top], [1.5, 0.25, top + 0.75]]))
    assert any((solid.vertices == bar).all() for solid in cargo.solids if solid.part == "payload receptacle")


def test_docked_payload_has_its_probe_tip_at_the_port_centre(concept: Worksite) -> None:
    port = concept.berths[0]
    assert port.pose.position / FOOT == pytest.approx([-4.0, -16.0, 22.0])
    for cargo in concept.payloads:
        assert cargo.probe is not None
        seated = port.seated(cargo.probe)
        tip = seated.rotation @ cargo.probe.position + seated.position
        assert tip == pytest.approx(port.pose.position)
        for own, solid in product(cargo.solids, concept.solids):
            placed = own.vertices @ seated.rotation.T + seated.position
            gap = separation(placed, solid.vertices).clearance
            docked = own.part.endswith("probe") and solid.part == "CAE"
            least = -1e-9 if docked else 0.1 if own.part.startswith("camera") else 0.3
            assert gap > least, (own.part, solid.part)


def test_docking_envelope_is_a_wedge_that_closes_one_apothem_out(concept: Worksite) -> None:
    port = concept.berths[0]
    assert isinstance(port, Port)

    def inside(x: float, y: float, z: float) -> bool:
        planes = port.envelope
        return bool((planes[:, :3] @ np.array([x, y, z]) * FOOT <= planes[:, 3]).all())

    half_side = 7.5 / math.sqrt(3.0)
    for share in (0.01, 0.3, 0.99):
        edge = half_side * (1.0 - share)
        assert inside(7.5 * share, 0.99 * edge, 7.4)
        assert inside(7.5 * share, -0.99 * edge, -7.4)
        assert not inside(7.5 * share, edge + 0.01, 0.0)
        assert not inside(7.5 * share, 0.0, 7.6)
    assert not inside(-0.01, 0.0, 0.0)
    assert not inside(7.51, 0.0, 0.0)


@pytest.mark.parametrize(("name", "stand"), [("payload", 16.0), ("free flyer", 12.0)])
def test_arm_reaches_each_bar_at_the_start_in_the_bay_and_docked(concept: Worksite, name: str, stand: float) -> None:
    arm = aftdeck.load_arm("concept-1972").at(stand=stand * FOOT)
    cargo = next(cargo for cargo in concept.payloads if cargo.name == name)
    assert cargo.receptacle is not None
    top = float(cargo.receptacle[:, 2].max())
    for pose in (cargo.start.pose, *(seat.seated(cargo.probe) for seat in concept.berths)):
        bar = pose.rotation @ [0.0, 0.0, top + 0.03 * FOOT] + pose.position
        assert len(arm.inverse(Pose(REPORT @ bar, DOWN))) > 0


def test_tolerances_are_those_of_the_report(concept: Worksite) -> None:
    rules = concept.acquisition
    assert isinstance(rules, BarFile)
    assert (rules.window / FOOT, rules.front / FOOT, rules.rear / FOOT) == pytest.approx((1 / 16, 0.5, 0.5))
    assert rules.fingers_within / FOOT == pytest.approx(8.0)
    port = concept.berths[0]
    assert (port.distance / FOOT, math.degrees(port.angle)) == pytest.approx((0.25, 2.0 + 32.0 / 60.0))


def test_station_points_have_cameras_that_zoom_from_25_to_60_deg(concept: Worksite) -> None:
    cameras = [camera for camera in concept.cameras if camera.kind == "camera"]
    assert [camera.name for camera in cameras] == [*"ABCDEFGHI", "P1", "P2", "P3", "P4", "CAE2", "W"]
    for camera in cameras:
        assert camera.drive is not None
        assert camera.drive.zoom is not None
        zoom = (camera.drive.zoom.least, camera.drive.zoom.greatest)
        assert np.degrees(zoom) == pytest.approx([25.0, 60.0])


def seen(worksite: Worksite, name: str, point: Array, pose: Pose) -> bool:
    """Return whether a camera in its initial direction has a point of the scene in its 5:3 picture.

    `pose` is the pose of the body that carries the camera.
    """
    camera = next(camera for camera in worksite.cameras if camera.name == name)
    towards = pose.rotation.T @ (point - pose.position) - np.array(camera.position)
    ahead = np.array(camera.boresight) / math.hypot(*camera.boresight)
    right = np.cross(ahead, camera.up)
    right /= np.linalg.norm(right)
    along, half = towards @ ahead, math.tan(camera.field_of_view / 2)
    across, up = towards @ right / along / half, towards @ np.cross(right, ahead) / along / half / 0.6
    return bool(along > 0.0 and abs(across) < 0.95 and abs(up) < 0.95)


@pytest.mark.parametrize(
    ("name", "at"),
    [("A", "bay"), ("B", "bay"), ("C", "bay"), ("D", "bay"), ("H", "port"), ("I", "port"), ("P2", "bar")],
)
def test_camera_sees_the_bar_or_the_port_at_the_start(concept: Worksite, name: str, at: str) -> None:
    """Cameras A to D and the payload's own camera P2 see the payload's bar in the bay; H and I see the port."""
    payload: Payload = concept.payloads[0]
    still = Pose(np.zeros(3), np.eye(3))
    body = next(camera for camera in concept.cameras if camera.name == name).body
    pose = next((b.pose for b in concept.bodies if b.name == body), payload.start.pose if body == "payload" else still)
    start = payload.start.pose
    bar = start.position + start.rotation @ [0.0, 0.0, 6.2 * FOOT]
    if at == "port":
        docked = concept.berths[0].seated(payload.probe)
        assert seen(concept, name, docked.position, pose)
    else:
        assert seen(concept, name, bar, pose)


def test_every_payload_carries_two_cameras_that_see_its_probe_and_its_bar(concept: Worksite) -> None:
    """RMS-VS, section VII.5."""
    still = Pose(np.zeros(3), np.eye(3))
    for cargo in concept.payloads:
        to_probe, to_bar = (camera.name for camera in concept.cameras if camera.body == cargo.name)
        assert cargo.probe is not None and cargo.receptacle is not None
        assert seen(concept, to_probe, cargo.probe.position, still)
        assert seen(concept, to_bar, cargo.receptacle.mean(axis=0), still)


def test_essential_pairs_include_the_fittings_of_each_payload(concept: Worksite) -> None:
    found = {essential.parts: essential.relation for essential in concept.essential}
    assert found["prong", "payload receptacle"] == "acquisition"
    assert found["free flyer probe", "CAE"] == "docking"


def test_cameras_start_with_a_tilt_below_80_deg(concept: Worksite) -> None:
    for camera in concept.cameras:
        assert abs(setting(camera).tilt) < math.radians(80.0)


def test_wrist_motion_keeps_the_end_effector_clear_of_boom_and_wrist() -> None:
    """These pairs are not monitored: the wrist axes intersect in one point, and the end effector is clear of it."""
    model = aftdeck.load_arm("concept-1972").model
    frames = frames_of(model)
    rows, angles = frames.rows(), np.zeros(6)
    own = solids_of(model)
    inner = [solid for solid in own if solid.part in ("lower boom", "wrist")]
    outer = [solid for solid in own if solid.part in ("stub", "palm", "fixed finger", "prong")]
    assert len(inner) == 2 and len(outer) == 4
    layout = site_of(load_scenario("concept-1972")).layout
    assert not layout.between({solid.part for solid in inner}, {solid.part for solid in outer}).any()
    for bend in product(*(np.linspace(low, high, 7) for low, high in model.limits.hard[3:].tolist())):
        angles[3:] = bend
        place_frames(frames.joints, angles, 4.0, -0.2, rows)
        for a, b in product(inner, outer):
            apart = separation(_in_l(a, frames.names, rows), _in_l(b, frames.names, rows)).clearance
            assert apart > (0.2 * FOOT if a.part == "lower boom" else 0.0)


def _in_l(solid: Solid, names: tuple[str, ...], rows: Array) -> Array:
    row = rows[names.index(solid.frame)]
    return np.asarray(solid.vertices @ row[3:].reshape(3, 3).T + row[:3])

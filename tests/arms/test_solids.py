"""Solids of an arm: they are valid, belong to frames of the arm, and enclose the shapes of the arm."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

import aftdeck
from aftdeck.arms.load import HERE, ArmModel, load_model
from aftdeck.arms.shapes import shapes_of
from aftdeck.arms.solids import solids_of
from aftdeck.arrays import Array
from aftdeck.bodies.hexahedron import FACES, pack
from aftdeck.bodies.hexahedron_check import hexahedron
from aftdeck.bodies.solid import Solid
from aftdeck.errors import ScenarioError
from aftdeck.kinematics.frames import frames_of, place_frames
from aftdeck.kinematics.linkage import L5
from aftdeck.scene.mesh import moved
from aftdeck.scene.placed import placed
from aftdeck.scene.solids import solid as surface_of

FOOT = 0.3048
MAX_PROJECTION = 1e-3
"""Distance by which a shape may project from the solids [m]. It is not 0, because positions in the arm file are
rounded before they are rotated."""
ARMS = pytest.mark.parametrize("name", ["srms", "concept-1972"])


@pytest.fixture(scope="module")
def concept() -> ArmModel:
    return load_model("concept-1972")


def depth(points: Array, solids: list[Solid]) -> Array:
    """Return the distance (n,) from each point to the nearest solid [m]; negative if the point is inside a solid."""
    out = []
    for solid in solids:
        body = pack(solid.vertices)
        out.append((points @ body[24:42].reshape(3, 6) - body[42:]).max(axis=1))
    return np.asarray(np.min(out, axis=0))


def solid_of(model: ArmModel, part: str) -> Solid:
    (found,) = [solid for solid in solids_of(model) if solid.part == part]
    return found


def face(solid: Solid, letter: str) -> tuple[Array, Array]:
    """Return a face's outward normal (3,) and its corners (4, 3), in the solid's frame."""
    body = pack(solid.vertices)
    k = list(FACES).index(letter)
    return body[[24 + k, 30 + k, 36 + k]], solid.vertices[[v - 1 for v in FACES[letter]]]


@ARMS
def test_every_solid_is_a_read_only_hexahedron_in_an_arm_frame(name: str) -> None:
    model = load_model(name)
    for solid in solids_of(model):
        hexahedron(solid.vertices, solid.part)
        assert solid.frame in model.frames
        with pytest.raises(ValueError, match="read-only"):
            solid.vertices[0, 0] = 1.0


@ARMS
def test_shapes_lie_inside_the_solids_of_their_frame(name: str) -> None:
    model = load_model(name)
    rng = np.random.default_rng(71)
    for frame, shapes in shapes_of(model).bodies.items():
        solids = [solid for solid in solids_of(model) if solid.frame == frame]
        for shape, pose in placed(shapes):
            surface = moved(surface_of(shape, 64), pose)
            corners = surface.vertices[surface.faces]
            inside = np.einsum("nkv,nvc->nkc", rng.dirichlet(np.ones(3), (len(corners), 4)), corners).reshape(-1, 3)
            assert depth(surface.vertices, solids).max() <= MAX_PROJECTION, (frame, shape)
            assert depth(inside, solids).max() <= MAX_PROJECTION, (frame, shape)


def test_parts_have_the_names_that_the_operator_reads() -> None:
    def parts(name: str) -> list[str]:
        return list(dict.fromkeys(solid.part for solid in solids_of(load_model(name))))

    assert parts("concept-1972") == [
        "stand", "telescope", "shoulder", "upper boom", "elbow", "lower boom", "wrist", "stub", "palm", "fixed finger",
        "prong",
    ]  # fmt: skip
    assert parts("srms") == [
        "shoulder base", "shoulder yaw", "shoulder pitch", "upper boom", "elbow", "elbow camera", "lower boom",
        "wrist pitch", "wrist yaw", "end effector", "wrist camera", "wrist light",
    ]  # fmt: skip


def test_palm_face_d_points_outward_with_the_tip_at_its_centre(concept: ArmModel) -> None:
    normal, corners = face(solid_of(concept, "palm"), "d")
    assert normal == pytest.approx([1.0, 0.0, 0.0])
    assert corners.mean(axis=0) == pytest.approx([concept.links[L5], 0.0, 0.0])
    assert face(solid_of(concept, "palm"), "c")[0] == pytest.approx([-1.0, 0.0, 0.0])


def test_finger_faces_b_and_e_face_each_other(concept: ArmModel) -> None:
    normal, corners = face(solid_of(concept, "fixed finger"), "b")
    assert normal == pytest.approx([0.0, -1.0, 0.0])
    assert concept.prong is not None
    assert corners[:, 1] == pytest.approx(np.full(4, concept.prong.facing))
    prong = solid_of(concept, "prong")
    normal, corners = face(prong, "e")
    assert prong.frame == "arm.prong" and normal == pytest.approx([0.0, 1.0, 0.0])
    assert corners[:, 1] == pytest.approx(np.zeros(4))  # the frame of the prong is at this face


def test_first_vertices_of_the_palm_are_those_of_the_report(concept: ArmModel) -> None:
    # v1 = -W Y2 + H Z2 at the palm's inner end; v2 = v1 + L X2
    v1, v2 = solid_of(concept, "palm").vertices[:2]
    assert v1 == pytest.approx([1.5 * FOOT, -1.75 * FOOT, 0.5 * FOOT])
    assert v2 - v1 == pytest.approx([0.5 * FOOT, 0.0, 0.0])


@pytest.mark.parametrize("share", np.linspace(0.0, 1.0, 9))
def test_telescope_is_covered_from_its_foot_to_below_the_shoulder(concept: ArmModel, share: float) -> None:
    assert concept.telescope is not None
    least, greatest = concept.telescope.least, concept.telescope.greatest
    height = least + share * (greatest - least)
    rows = rows_of(concept, np.zeros(6), height)
    solids = [in_base(solid, rows) for solid in solids_of(concept) if solid.part in ("stand", "telescope")]
    assert len(solids) == 2
    half, top = 0.5 * FOOT, height - 0.8 * FOOT
    for up in np.linspace(0.0, top, 200):
        ring = np.array([[x, y, -up] for x in (-half, half) for y in (-half, half)])
        assert depth(ring, solids).max() <= 1e-12
    above = depth(np.array([[0.0, 0.0, -top - 1e-6]]), solids)
    assert above[0] > 0.0


def rows_of(model: ArmModel, q: Array, stand: float) -> dict[str, Array]:
    frames = frames_of(model)
    rows = frames.rows()
    place_frames(frames.joints, q, stand, -0.4, rows)
    return dict(zip(frames.names, rows, strict=True))


def in_base(solid: Solid, rows: dict[str, Array]) -> Solid:
    row = rows[solid.frame]
    return solid._replace(vertices=solid.vertices @ row[3:].reshape(3, 3).T + row[:3])


def test_arm_parts_do_not_overlap_inside_the_soft_limits(concept: ArmModel) -> None:
    soft = concept.limits.soft
    rng = np.random.default_rng(72)
    apart = (
        ("stand", "upper boom"), ("stand", "shoulder"), ("telescope", "upper boom"), ("telescope", "shoulder"),
        ("shoulder", "upper boom"), ("upper boom", "elbow"), ("upper boom", "lower boom"), ("elbow", "lower boom"),
        ("lower boom", "wrist"), ("lower boom", "stub"), ("wrist", "stub"),
    )  # fmt: skip
    for k in range(200):
        q = rng.uniform(soft[:, 0], soft[:, 1]) if k > 20 else np.where(rng.random(6) < 0.5, soft[:, 0], soft[:, 1])
        rows = rows_of(concept, q, 3.0)
        bodies = [in_base(solid, rows) for solid in solids_of(concept)]
        for a, b in apart:
            for one in (body for body in bodies if body.part == a):
                for other in (body for body in bodies if body.part == b):
                    assert aftdeck.separation(one.vertices, other.vertices).clearance > -1e-9, (a, b, np.degrees(q))


@pytest.mark.parametrize(
    ("old", "new", "pattern"),
    [
        ('frame = "arm.base"', 'frame = "arm.foot"', r"bodies\[0\]\.frame: 'arm\.foot'"),
        ("radius = 0.27", "radius = 0.0", r"bodies\[0\]: .*radius.* 0; .*above 0"),
        ("sides = 6", "sides = 7", r"bodies\[0\]: .*7 sides.* even .* 4"),
        ("size = [0.7, 0.34, 0.12]", "size = [0.7, 0.0, 0.12]", r"bodies\[1\]: shoulder base: "),
        ("size = [0.7, 0.34, 0.12]", "size = [0.7, 0.34, -0.12]", r"bodies\[1\]: shoulder base: "),
        ('kind = "box"', 'kind = "ball"', r"bodies\[1\]"),
    ],
)
def test_invalid_body_is_rejected_with_its_location(tmp_path: Path, old: str, new: str, pattern: str) -> None:
    text = (HERE / "srms.toml").read_text(encoding="utf-8").replace('shapes = "srms.shapes.toml"\n', "")
    assert old in text
    bad = tmp_path / "bad.toml"
    bad.write_text(text.replace(old, new, 1), encoding="utf-8")
    with pytest.raises(ScenarioError) as caught:
        load_model(bad)
    assert any(re.search(pattern, problem) for problem in caught.value.problems), caught.value.problems

"""Shapes: rejection of invalid shapes, and the arm's shapes against its surveyed dimensions."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from math import cos, hypot, pi, radians, sin
from pathlib import Path
from typing import get_args

import msgspec
import pytest

import aftdeck.arms.shapes as arm_shapes
from aftdeck.arms.load import load_model
from aftdeck.arms.shapes import ArmShapes, shapes_of
from aftdeck.details.details_of import details_of
from aftdeck.errors import ScenarioError
from aftdeck.files import read
from aftdeck.scenario.load import built_in, load_scenario
from aftdeck.shapes import Cylinder, Group, Light, Material, Shape
from aftdeck.worksite import load_worksite
from tests import loaded

SRMS = Path(arm_shapes.__file__).with_name("srms.shapes.toml")
LEAN = radians(19.48)
INCH = 0.0254
SECTION = "x = 0, half_width = 1, top = 1, middle = 0, bottom = -1"


@pytest.fixture(scope="module")
def srms() -> ArmShapes:
    return shapes_of(load_model("srms"))


def leaves(shapes: tuple[Shape, ...]) -> Iterator[Shape]:
    """Yield all shapes except groups, once each."""
    for shape in shapes:
        if isinstance(shape, Group):
            yield from leaves(shape.shapes)
        else:
            yield shape


@pytest.mark.parametrize(
    ("text", "pattern"),
    [
        (
            'kind = "loft", material = "metal", sections = [{ ' + SECTION + " }]",
            "loft has 1 .* 2",
        ),
        (
            'kind = "loft", material = "metal", sections = [{ ' + SECTION + " }, { " + SECTION + " }]",
            "loft.* order .* x",
        ),
        (
            'kind = "loft", material = "metal", sections = [{ ' + SECTION.replace("width = 1", "width = 0") + " }]",
            r"\.sections\[0\]: .*half_width is 0; .*above 0",
        ),
        (
            'kind = "cylinder", material = "metal", length = 1, radius = -0.1',
            r"cylinder.*radius is -0\.1; .*above 0",
        ),
        (
            'kind = "box", material = "metal", size = [1, 0, 1]',
            "box.*size along y is 0; .*above 0",
        ),
        (
            'kind = "plate", material = "metal", normal = "z", thickness = 0.1, outline = [[0, 0], [1, 0]]',
            "outline has 2 .* 3",
        ),
        (
            'kind = "plate", material = "metal", normal = "z", thickness = 0.1, bevel = 0.06, '
            "outline = [[0, 0], [1, 0], [0, 1]]",
            r"bevel is 0\.06; .*half the thickness",
        ),
        (
            'kind = "shell", material = "metal", length = 1, radius = 1, thickness = 0.1, sweep = 7',
            "sweep is 7; .*2 pi",
        ),
        (
            'kind = "shell", material = "metal", length = 1, radius = 1, radius_end = 0.5, thickness = 0.6',
            r"thickness is 0\.6; .*radius",
        ),
        (
            'kind = "ring", material = "metal", radius = 1, bar = 0',
            "ring.*bar is 0; .*above 0",
        ),
        ('kind = "sphere", material = "metal", radius = inf', r"radius: got inf m; expected -1000 to 1000 m"),
        ('kind = "light", radius = 1, cone = 1, reach = 0, intensity = 1', "light.*reach is 0"),
        ('kind = "group", shapes = []', "group has no shapes.* 1"),
        (
            'kind = "group", shapes = [{ kind = "sphere", material = "metal", radius = -1 }]',
            "sphere.*radius is -1; .*above 0",
        ),
        ('kind = "sphere", material = "cheese", radius = 1', " blanket, liner, tiles"),
        (
            'kind = "sphere", material = "metal", radius = 1, colour = "red"',
            "colour: unknown.* position",
        ),
        ('kind = "pyramid"', "kind: .*box, cylinder, shell"),
    ],
)
def test_invalid_shape_is_rejected_with_its_location(tmp_path: Path, text: str, pattern: str) -> None:
    file = tmp_path / "bad.toml"
    file.write_text(f'camera = []\n[[body]]\nname = "arm.base"\nshapes = [{{ {text} }}]\n')
    with pytest.raises(ScenarioError) as caught:
        shapes_of(replace(load_model("srms"), shapes=read(file)))
    assert str(caught.value).startswith("bad.toml:4: body[0].shapes[0]")
    assert re.search(pattern, str(caught.value))


def test_arm_shapes_without_all_frames_are_rejected(tmp_path: Path) -> None:
    file = tmp_path / "short.toml"
    file.write_text('camera = []\n[[body]]\nname = "arm.base"\nshapes = []\n')
    with pytest.raises(ScenarioError, match=r"arm\.base, arm\.shoulder_yaw.*; .* arm\.base"):
        shapes_of(replace(load_model("srms"), shapes=read(file)))


def test_missing_shape_file_is_rejected_by_name(tmp_path: Path) -> None:
    file = tmp_path / "arm.toml"
    file.write_text(SRMS.with_name("srms.toml").read_text().replace("srms.shapes.toml", "none.toml"))
    with pytest.raises(ScenarioError, match=r"none\.toml: .*No such file"):
        load_model(file)


def test_arm_shapes_have_seven_visible_frames_in_order(srms: ArmShapes) -> None:
    assert tuple(srms.bodies) == loaded.arm().model.linkage.frames
    assert all(srms.bodies.values())


def test_shapes_round_trip_through_json(srms: ArmShapes) -> None:
    shapes = srms.bodies["arm.wrist_roll"]
    assert msgspec.json.decode(msgspec.json.encode(shapes), type=tuple[Shape, ...]) == shapes


def test_every_material_is_used(srms: ArmShapes) -> None:
    bodies = [*srms.bodies.values(), *(body.shapes for body in load_worksite("orbiter").bodies)]
    bodies += details_of(load_scenario("srms-deploy"))
    payloads = [load_scenario(name).payload for name in built_in()]
    bodies += [payload.shapes for payload in payloads if payload is not None]
    used = {
        "glow" if isinstance(shape, Light) else shape.material
        for shapes in bodies
        for shape in leaves(shapes)
        if not isinstance(shape, Group)
    }
    assert used == set(get_args(Material))


@pytest.mark.parametrize(
    ("frame", "length", "below"), [("arm.shoulder_pitch", 5.30, 0.0), ("arm.elbow_pitch", 5.75, -0.1524)]
)
def test_booms_are_15_in_wide_and_on_the_boom_line(srms: ArmShapes, frame: str, length: float, below: float) -> None:
    shapes = leaves(srms.bodies[frame])
    (boom,) = (shape for shape in shapes if isinstance(shape, Cylinder) and shape.material == "boom")
    assert boom.length == pytest.approx(length)
    assert 2 * boom.radius == pytest.approx(15 * INCH, abs=0.005)
    assert boom.position[1:] == pytest.approx((0.0, below), abs=0.001)


def in_arm_axes(structural: tuple[float, float, float]) -> tuple[float, float, float]:
    """Convert structural components [in] (aft, starboard, up) to L's axes [m] (aft, port, down), tilted by `LEAN`."""
    x, y, z = (component * INCH for component in structural)
    return x, -cos(LEAN) * y - sin(LEAN) * z, sin(LEAN) * y - cos(LEAN) * z


def axis_of_camera(srms: ArmShapes, name: str) -> tuple[float, ...]:
    """Return a camera's reference position: 0.18 m behind its lens, along its boresight."""
    (camera,) = (camera for camera in srms.cameras if camera.name == name)
    length = hypot(*camera.boresight)
    return tuple(p - 0.18 * b / length for p, b in zip(camera.position, camera.boresight, strict=True))


def test_elbow_camera_is_at_its_surveyed_position(srms: ArmShapes) -> None:
    surveyed = in_arm_axes((953.03 - 930.55, -100.59 + 105.999, 468.44 - 439.108))
    assert axis_of_camera(srms, "ELB") == pytest.approx(surveyed, abs=0.002)


def test_wrist_camera_is_straight_above_the_cradled_roll_axis(srms: ArmShapes) -> None:
    surveyed = in_arm_axes((1253.7 - 1226.5, 0.0, 456.015 - 444.765))
    assert axis_of_camera(srms, "WR") == pytest.approx(surveyed, abs=0.002)


def test_wrist_camera_points_along_the_roll_axis_past_the_rim(srms: ArmShapes) -> None:
    (camera,) = (camera for camera in srms.cameras if camera.name == "WR")
    assert camera.boresight == (1.0, 0.0, 0.0)
    rim = 0.176
    off_axis = hypot(*camera.position[1:])
    down_to_rim = (off_axis - rim) / (1.4224 - camera.position[0])
    assert off_axis > rim
    assert down_to_rim < camera.field_of_view / 2 * 3 / 4, "the rim is in a 4:3 picture, below its middle"
    assert camera.field_of_view < pi / 3

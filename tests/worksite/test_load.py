"""The worksite file: loading, rejection of errors, and the orbiter against its published dimensions."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from math import hypot
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from aftdeck.errors import ScenarioError
from aftdeck.shapes import Box, Cylinder, Group, Hexahedron, Light, Loft, Plate, Ring, Shape, Shell, Sphere
from aftdeck.tuples import Vec3
from aftdeck.worksite import Worksite, load_worksite, worksites

Points = NDArray[np.float64]
INCH = 0.0254


@pytest.fixture(scope="module")
def orbiter() -> Worksite:
    return load_worksite("orbiter")


def turned(points: Points, rotation: Vec3, position: Vec3) -> Points:
    """Return points rotated by roll, pitch, yaw about fixed axes, then moved."""
    for axis, angle in enumerate(rotation):
        p, q = (axis + 1) % 3, (axis + 2) % 3
        matrix = np.eye(3)
        matrix[[p, p, q, q], [p, q, p, q]] = [np.cos(angle), -np.sin(angle), np.sin(angle), np.cos(angle)]
        points = points @ matrix.T
    moved: Points = points + np.array(position)
    return moved


def corners(half: tuple[float, float, float]) -> Points:
    """Return the corners of a box around the origin."""
    signs: Points = np.array(list(product((-1.0, 1.0), repeat=3)))
    scaled: Points = signs * np.array(half)
    return scaled


def hull(shape: Shape) -> Points:
    """Return points whose bounding box contains a shape, in the coordinate frame of the shape's body or group."""
    return turned(np.vstack(list(own_hull(shape))), shape.rotation, shape.position)


def own_hull(shape: Shape) -> Iterator[Points]:
    """Yield points in a shape's own frame; a round body is replaced by its bounding box."""
    match shape:
        case Box():
            x, y, z = shape.size
            yield corners((x / 2, y / 2, z / 2))
        case Cylinder() | Shell():
            radius = max(shape.radius, shape.radius_end or shape.radius)
            half = [radius, radius, radius]
            half["xyz".index(shape.axis)] = shape.length / 2
            yield corners((half[0], half[1], half[2]))
        case Ring():
            yield corners((shape.radius, shape.radius, shape.radius))
        case Sphere() | Light():
            yield corners((shape.radius, shape.radius, shape.radius))
        case Plate():
            normal = "xyz".index(shape.normal)
            for side in (-1, 1):
                yield np.insert(np.array(shape.outline), normal, side * shape.thickness / 2, axis=1)
        case Hexahedron():
            yield np.array(shape.vertices)
        case Loft():
            for section in shape.sections:
                for y, z in product((-section.half_width, section.half_width), (section.bottom, section.top)):
                    yield np.array([[section.x, y, z]])
        case Group():
            own = np.vstack([hull(child) for child in shape.shapes])
            for i in range(shape.count):
                dx, dy, dz = shape.step
                roll, pitch, yaw = shape.turn
                yield turned(own, (i * roll, i * pitch, i * yaw), (i * dx, i * dy, i * dz))


def whole(worksite: Worksite) -> Points:
    """Return points that enclose all shapes of the orbiter, with mirrored groups on both sides."""
    points: list[Points] = []
    for shape in worksite.bodies[0].shapes:
        points.append(hull(shape))
        if isinstance(shape, Group) and shape.mirror:
            points.append(points[-1] * np.array([1.0, -1.0, 1.0]))
    return np.vstack(points)


def test_orbiter_worksite_is_built_in(orbiter: Worksite) -> None:
    assert "orbiter" in worksites()
    assert orbiter.bodies[0].name == "orbiter"


def test_worksite_loads_by_path(orbiter: Worksite, tmp_path: Path) -> None:
    file = tmp_path / "mine.toml"
    file.write_text(
        'name = "mine"\ntitle = "Mine"\norigin = [0, 0, 0]\n'
        '[[body]]\nname = "rock"\nsource = "assumed"\n'
        'shapes = [{ kind = "sphere", material = "structure", radius = 2 }]\n'
    )
    assert load_worksite(file).bodies[0].shapes == (Sphere(material="structure", radius=2.0),)


def test_orbiter_has_its_published_dimensions(orbiter: Worksite) -> None:
    low, high = whole(orbiter).min(axis=0), whole(orbiter).max(axis=0)
    assert high[0] - low[0] == pytest.approx(37.2, abs=0.4), "length over all"
    assert high[1] - low[1] == pytest.approx(23.8, abs=0.2), "span"
    assert high[2] == pytest.approx(10.6, abs=0.1), "tail tip above the origin"


def test_port_and_starboard_are_symmetric(orbiter: Worksite) -> None:
    low, high = whole(orbiter).min(axis=0), whole(orbiter).max(axis=0)
    assert low[1] == pytest.approx(-high[1])


@pytest.mark.parametrize(
    ("name", "place"),
    [
        ("A", (588.76, -71.5, 446.06)),
        ("B", (1293.76, -87.0, 446.0)),
        ("C", (1293.76, 87.0, 446.0)),
        ("D", (588.76, 71.5, 446.06)),
    ],
)
def test_bay_cameras_are_at_their_surveyed_positions(orbiter: Worksite, name: str, place: Vec3) -> None:
    """Surveyed positions of the pan axes, structural [in]; the lens is 0.18 m in front of its axis."""
    (camera,) = (camera for camera in orbiter.cameras if camera.name == name)
    length = hypot(*camera.boresight)
    axis = [p - 0.18 * b / length for p, b in zip(camera.position, camera.boresight, strict=True)]
    surveyed = [(place[0] - 942) * INCH, place[1] * INCH, (place[2] - 400) * INCH]
    assert axis == pytest.approx(surveyed, abs=0.002)
    body, _ = (
        shape
        for shape in orbiter.bodies[0].shapes
        if isinstance(shape, Group) and shape.position == pytest.approx(surveyed, abs=0.002)
    )
    ahead = turned(np.array([[1.0, 0.0, 0.0]]), body.rotation, (0.0, 0.0, 0.0))[0]
    assert ahead == pytest.approx(np.array(camera.boresight) / length, abs=0.002)


@pytest.mark.parametrize("height", [3.0, 4.0, 5.0])
@pytest.mark.parametrize("name", ["A", "B", "C", "D"])
def test_tip_above_mid_bay_is_well_inside_every_bay_camera_picture(orbiter: Worksite, name: str, height: float) -> None:
    (camera,) = (camera for camera in orbiter.cameras if camera.name == name)
    ahead = np.array(camera.boresight) / hypot(*camera.boresight)
    right = np.cross(ahead, camera.up)
    right /= np.linalg.norm(right)
    towards = np.array([0.0, 0.0, height]) - np.array(camera.position)
    half_width = np.tan(camera.field_of_view / 2)
    across = towards @ right / (towards @ ahead) / half_width
    upwards = towards @ np.cross(right, ahead) / (towards @ ahead) / (half_width * 3 / 5)
    assert abs(across) < 0.8
    assert abs(upwards) < 0.8, "the tip is too near the edge of a 5:3 picture"


def test_unknown_worksite_is_rejected_with_the_built_in_names() -> None:
    with pytest.raises(ScenarioError, match=r"'moon'.*: concept-1972, orbiter"):
        load_worksite("moon")


def test_name_that_no_file_can_have_is_not_a_worksite() -> None:
    with pytest.raises(ScenarioError, match="is not a worksite"):
        load_worksite("a" * 300)


HEAD = 'name = "bad"\ntitle = "Bad"\norigin = [0, 0, 0]\n'
BODY = '[[body]]\nname = "a"\nsource = "assumed"\n'
CAMERA = (
    '[[camera]]\nname = "X"\ntitle = "X"\nposition = [0, 0, 9]\nup = [0, 0, 1]\nsource = "assumed"\n'
    'body = "a"\nboresight = [1, 0, 0]\nfield_of_view = 1\n'
)
BLOCK = 'solids = [{ part = "wall", kind = "block", x = [0, 1], y = [0, 1], z = [0, 1] }]\n'
PORT = (
    '[[seat]]\nname = "port"\ntitle = "Port"\nkind = "port"\nbody = "a"\nposition = [1, 0.5, 0.5]\nlatch = "auto"\n'
    'distance = 0.1\nangle = 0.1\nradius = 0.3\nmaterial = "dark"\nsource = "assumed"\n'
)
CARGO = (
    '[[cargo]]\nname = "c"\ntitle = "C"\nmass = 1\nsource = "assumed"\n'
    'body = { kind = "cylinder", radius = 1, length = 2, material = "foil" }\n'
    'receptacle = { length = 1, width = 0.1, height = 0.1, material = "metal" }\n'
    "start = { position = [0, 0, 5] }\n"
)


@pytest.mark.parametrize(
    ("text", "where", "named"),
    [
        ("body = []\n", "bad.toml:4: body", ()),
        (BODY * 2, "bad.toml:7: body[1]", ("'a'",)),
        (
            BODY.replace("source", 'fixed_to = "space"\nsource'),
            "bad.toml:4: body[0]",
            ("orbiter",),
        ),
        (BODY + CAMERA.replace('"a"', '"b"'), "bad.toml:13: camera[0].body", ("'b'", ": a")),
        (
            BODY + CAMERA.replace("[1, 0, 0]", "[0, 0, -2]"),
            "bad.toml:7: camera[0]",
            ("camera X", "boresight", "up"),
        ),
        (
            BODY + CAMERA.replace("_of_view = 1", "_of_view = 4"),
            "bad.toml:7: camera[0]",
            ("camera X", "field_of_view", "4", "pi"),
        ),
        (
            BODY + CAMERA + 'drive = "d"\n',
            "bad.toml:7: camera[0]",
            ("camera X", "drive 'd'", ": none"),
        ),
        (
            BODY + BLOCK.replace("x = [0, 1]", "x = [1, 0]"),
            "bad.toml:7: body[0].solids[0]",
            ("body a: wall: x", "1 to 0 m"),
        ),
        (
            BODY + BLOCK.replace("x = [0, 1]", "x = [1, 1]"),
            "bad.toml:7: body[0].solids[0]",
            ("body a: wall: x", "1 to 1 m"),
        ),
        (
            BODY + 'solids = [{ part = "wall", kind = "hexahedron", vertices = [[0,0,0], [0,0,1], [1,0,0], [1,0,1], '
            "[0,1,0], [0,1,1], [1,1,0], [1,1,1.5]] }]\n",
            "bad.toml:7: body[0].solids[0]",
            ("body a: wall: vertex 8", "(1, 1, 1.5)", "0.5 m"),
        ),
        (
            BODY + BLOCK + CAMERA.replace("0, 9]", "0, -0.5]"),
            "bad.toml:12: camera[0].position",
            ("camera X", "0.5 m from wall", "0.6 m"),
        ),
        (
            BODY + BLOCK + CAMERA.replace("[0, 0, 9]", "[0.5, 0.5, 0.5]"),
            "bad.toml:12: camera[0].position",
            ("camera X", "in wall", "0.6 m"),
        ),
        (
            BODY + BLOCK + PORT.replace("0.5, 0.5]", "0.5, 1.5]"),
            "bad.toml:13: seat[0].position",
            ("seat port", "face"),
        ),
        (BODY + PORT.replace('"a"', '"b"'), "bad.toml:11: seat[0].body", ("'b'", ": a")),
        (
            BODY + "[orbiter]\nmass = 1\ninertia = [1, 5, 1]\ncentre = [0, 0, 0]\nsource = 'assumed'\n",
            "bad.toml:7: orbiter",
            ("1, 5, 1",),
        ),
        (BODY + BLOCK + PORT.replace("radius = 0.3", "radius = 0"), "bad.toml:8: seat[0]", ("radius", "0 m")),
        (
            BODY + CARGO + CARGO.replace("receptacle", "#"),
            "bad.toml:15: cargo[1]",
            ("receptacle", "grapple", "neither"),
        ),
        (
            BODY + CARGO.replace("position = [0, 0, 5]", 'seat = "bay"'),
            "bad.toml:7: cargo[0]",
            ("cargo c: start.seat: 'bay'", ": none"),
        ),
        (
            BODY + BLOCK + PORT + CARGO.replace("position = [0, 0, 5]", 'seat = "port"'),
            "bad.toml:20: cargo[0]",
            ("cargo c: start.seat: 'port'", "no probe"),
        ),
        (
            BODY + CARGO.replace("position", 'seat = "bay", position'),
            "bad.toml:14: cargo[0].start",
            ("'bay'", "position"),
        ),
        (
            BODY + CARGO.replace('"c"', '"orbiter"'),
            "bad.toml:7: cargo[0]",
            ("'orbiter'",),
        ),
        (
            BODY + CARGO.replace("mass = 1", 'mass = "0 lb"'),
            "bad.toml:7: cargo[0]",
            ("mass", "0 kg"),
        ),
        (
            BODY + BLOCK.replace("wall", "c") + CARGO,
            "bad.toml:8: cargo[0]",
            ("part 'c'", "orbiter"),
        ),
    ],
)
def test_invalid_file_is_rejected_with_line_and_names(
    tmp_path: Path, text: str, where: str, named: tuple[str, ...]
) -> None:
    file = tmp_path / "bad.toml"
    head = HEAD.replace("\norigin", "\ncamera_clearance = 0.6\norigin") if "0.6 m" in named else HEAD
    file.write_text(head + text)
    with pytest.raises(ScenarioError) as caught:
        load_worksite(file)
    (problem,) = caught.value.problems
    assert problem.startswith(f"{where}: ")
    assert all(name in problem for name in named), problem


def test_all_errors_of_a_file_are_reported_together(tmp_path: Path) -> None:
    file = tmp_path / "bad.toml"
    file.write_text(HEAD + BODY + BLOCK.replace("[0, 1] }", "[1, 0] }") + CAMERA + 'drive = "d"\n' + PORT)
    with pytest.raises(ScenarioError) as caught:
        load_worksite(file)
    assert [problem.split(": ")[1] for problem in caught.value.problems] == [
        "body[0].solids[0]",
        "camera[0]",
        "seat[0].position",
    ]

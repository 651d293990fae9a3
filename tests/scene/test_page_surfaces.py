"""Surfaces of shapes: the page, which draws with three.js, and the package's meshes describe the same bodies."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Iterator
from math import cos, pi
from pathlib import Path
from typing import Literal

import msgspec
import pytest

from aftdeck.details.details_of import details_of
from aftdeck.scenario.load import built_in
from aftdeck.scene.bodies import bodies_of
from aftdeck.scene.mesh import Mesh, volume
from aftdeck.scene.placed import Leaf, placed
from aftdeck.scene.solids import solid
from aftdeck.shapes import Box, Cylinder, Hexahedron, Light, Loft, Plate, Ring, Section, Shell, Sphere
from aftdeck.tuples import Vec3
from tests.loaded import scenario

WEB = Path(__file__).parents[2] / "web"
PROGRAM = """
    import { readFileSync } from 'node:fs';
    import { runnerImport } from 'vite';
    const { module } = await runnerImport('./tests/measured.ts', { configFile: false, logLevel: 'error' });
    const shapes = JSON.parse(readFileSync(process.argv[1], 'utf8'));
    const found = ['low', 'full'].map((quality) => [quality, module.measured(shapes, quality)]);
    console.log(JSON.stringify(Object.fromEntries(found)));
"""
"""JavaScript that measures the shapes in a file as the page draws them in both profiles."""

COARSE, FINE = 16, 128
"""Numbers of sides of small round bodies; the page draws 24 to 96 in its full profile."""

Quality = Literal["low", "full"]


class Measured(msgspec.Struct):
    """Volume [m^3] and bounds [m] of a surface."""

    volume: float
    low: Vec3
    high: Vec3


def every_shape() -> Iterator[Leaf]:
    """Yield every shape of every built-in scenario's bodies and details, and kinds of shapes that these do not have."""
    for name in built_in():
        one = scenario(name)
        for body, details in zip(bodies_of(one), details_of(one), strict=True):
            for shape, _ in placed((*body.shapes, *details)):
                yield shape
    outline = ((0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 3.0), (0.0, 3.0))
    for axis in ("x", "y", "z"):
        yield Cylinder(material="metal", axis=axis, length=3.0, radius=0.8, radius_end=0.3)
        yield Shell(
            material="metal", axis=axis, length=3.0, radius=0.8, radius_end=0.5, thickness=0.1, start=0.7, sweep=2.5
        )
        yield Shell(material="metal", axis=axis, length=0.1, radius=0.8, thickness=0.8, start=-2.0, sweep=4.0)
        yield Ring(material="metal", axis=axis, radius=0.6, bar=0.05, start=0.7, sweep=2.5)
        yield Plate(material="metal", normal=axis, outline=outline, thickness=0.2, bevel=0.05)
        yield Plate(material="metal", normal=axis, outline=outline[::-1], thickness=0.2)
    yield Loft(
        material="metal",
        sections=(
            Section(x=-1.0, half_width=0.5, top=0.4, middle=0.1, bottom=-0.2, exponents=(2.0, 5.0)),
            Section(x=0.3, half_width=0.9, top=0.7, middle=0.1, bottom=-0.6, exponents=(3.0, 1.5)),
        ),
    )


@pytest.fixture(scope="module")
def shapes() -> list[Leaf]:
    """Return every shape once; where it is does not matter."""
    unplaced = (
        msgspec.structs.replace(shape, position=(0.0, 0.0, 0.0), rotation=(0.0, 0.0, 0.0)) for shape in every_shape()
    )
    once = {msgspec.json.encode(shape): shape for shape in unplaced}
    assert {type(shape) for shape in once.values()} == {
        Box, Cylinder, Shell, Ring, Sphere, Plate, Loft, Hexahedron, Light,
    }  # fmt: skip
    return list(once.values())


@pytest.fixture(scope="module")
def meshes(shapes: list[Leaf]) -> dict[int, list[Mesh]]:
    """Return the package's meshes of the shapes, with fewer sides and with more sides than the page draws."""
    return {sides: [solid(shape, sides) for shape in shapes] for sides in (COARSE, FINE)}


@pytest.fixture(scope="module")
def drawn(shapes: list[Leaf], tmp_path_factory: pytest.TempPathFactory) -> dict[Quality, list[Measured]]:
    """Return the sizes of the surfaces that the page draws, in both profiles."""
    node = shutil.which("node")
    assert node, "Node.js is not on PATH; `make test` finds or installs it"
    file = tmp_path_factory.mktemp("shapes") / "shapes.json"
    file.write_bytes(msgspec.json.encode(shapes))
    program = [node, "--input-type=module", "--eval", PROGRAM, str(file)]
    done = subprocess.run(program, cwd=WEB, capture_output=True, timeout=600.0, check=False)
    assert not done.returncode, done.stderr.decode()
    return msgspec.json.decode(done.stdout, type=dict[Quality, list[Measured]])


def off(sides: int) -> float:
    """Return how far a regular polygon may end before its circle of radius 1: a corner may be half a side away."""
    return 1.0 - cos(pi / sides)


def slack(shape: Leaf, quality: Quality) -> float:
    """Return the distance by which the bounds of a drawn shape may be within those of the true one [m]."""
    sides = {"low": 8, "full": 24}[quality]
    match shape:
        case Cylinder() | Shell():
            return off(sides) * max(shape.radius, shape.radius_end or 0.0)
        case Light():
            return off(sides) * shape.radius
        case Ring():
            return off(40) * (shape.radius + shape.bar) + off({"low": 4, "full": 12}[quality]) * shape.bar
        case Sphere():
            return 2.0 * off(max(12, sides)) * shape.radius
        case _:
            return 0.0


@pytest.mark.parametrize("quality", ["low", "full"])
def test_page_draws_every_shape_in_the_bounds_of_its_mesh(
    shapes: list[Leaf], meshes: dict[int, list[Mesh]], drawn: dict[Quality, list[Measured]], quality: Quality
) -> None:
    for shape, mesh, found in zip(shapes, meshes[FINE], drawn[quality], strict=True):
        within = slack(shape, quality) + 1e-5
        assert found.low == pytest.approx(mesh.vertices.min(axis=0), abs=within), shape
        assert found.high == pytest.approx(mesh.vertices.max(axis=0), abs=within), shape


def test_page_draws_every_shape_with_the_volume_of_its_mesh(
    shapes: list[Leaf], meshes: dict[int, list[Mesh]], drawn: dict[Quality, list[Measured]]
) -> None:
    for shape, coarse, fine, found in zip(shapes, meshes[COARSE], meshes[FINE], drawn["full"], strict=True):
        match shape:
            case Box() | Hexahedron() | Plate():
                assert found.volume == pytest.approx(volume(fine), rel=1e-5), shape
            case Light():
                assert found.volume == 0.0
            case _:
                assert 0.995 * volume(coarse) <= found.volume <= 1.001 * volume(fine), shape

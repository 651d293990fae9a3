"""Camera housings follow their cameras; the inside of the bay ends at its walls."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from aftdeck.arrays import Array
from aftdeck.errors import ScenarioError
from aftdeck.scene.placed import placed
from aftdeck.worksite import Worksite, load_worksite

A = 'name = "A"\ntitle = "Forward bulkhead port"\nbody = "orbiter"\nposition = [-8.798, -1.779, 1.194]'


def changed(tmp_path: Path, name: str, old: str, new: str) -> Worksite:
    """Load a built-in worksite with one line changed."""
    text = load_worksite(name).text
    assert text.count(old) == 1
    file = tmp_path / "changed.toml"
    file.write_text(text.replace(old, new))
    return load_worksite(file)


def block(site: Worksite, camera: str) -> Array:
    (found,) = [solid.vertices for solid in site.solids if solid.part == f"camera {camera}"]
    return found


def middles(site: Worksite) -> set[tuple[float, float, float]]:
    """Return the positions of all shapes on the first body."""
    return {tuple(pose.position.round(9).tolist()) for _, pose in placed(site.bodies[0].shapes)}


def test_moved_camera_moves_its_shapes_and_its_solid(tmp_path: Path) -> None:
    here = load_worksite("orbiter")
    there = changed(tmp_path, "orbiter", A, A.replace("-8.798, -1.779", "-7.798, -1.479"))
    shift = np.array([1.0, 0.3, 0.0])
    assert block(there, "A") - block(here, "A") == pytest.approx(np.tile(shift, (8, 1)))
    assert (block(there, "B") == block(here, "B")).all()
    before, after = middles(here), middles(there)
    removed, added = np.array(sorted(before - after)), np.array(sorted(after - before))
    assert removed + shift == pytest.approx(added) and len(removed) == 3, "its box, its lens, its post"


def test_housing_encloses_its_camera_at_any_orientation() -> None:
    """Surveyed pan axis (SSV): Xo 588.76, Yo -71.5, Zo 446.06 in. The lens is seven inches in front of this axis."""
    site = load_worksite("orbiter")
    middle = (block(site, "A").max(axis=0) + block(site, "A").min(axis=0))[:2] / 2.0
    assert middle == pytest.approx([-8.972, -1.816], abs=1e-3)
    for camera in site.cameras:
        if camera.drive is not None and camera.drive.lens:
            body = block(site, camera.name)
            assert (body.min(axis=0) < camera.position).all() and (camera.position < body.max(axis=0)).all()


@pytest.mark.parametrize(
    ("old", "new", "pattern"),
    [
        ('[[housing]]\ndrive = "bay', '[[housing]]\ndrive = "', r"housing\[0\]\.drive: ' unit'"),
        (A, A.replace('"orbiter"', '"nowhere"'), "'nowhere' is not"),
        (A, f'inside = "cabin"\n{A}', r"camera\[0\]\.inside: .*'bay unit'"),
        ("x = [-0.21, 0.21]", "x = [0.21, -0.21]", r"housing\[0\]"),
        ("y = [-2.31, 2.31]", "y = [-2.0, 2.31]", r"bay\.y: .*-2 m"),
        ("y = [-2.31, 2.31]", "y = [-2.31, 2.6]", r"bay\.y: .*2\.6 m"),
    ],
)  # fmt: skip
def test_inconsistent_housing_or_bay_is_rejected(tmp_path: Path, old: str, new: str, pattern: str) -> None:
    with pytest.raises(ScenarioError) as raised:
        changed(tmp_path, "orbiter", old, new)
    assert any(re.search(pattern, line) for line in raised.value.problems), raised.value.problems


def test_concept_bay_ends_at_its_walls(tmp_path: Path) -> None:
    bay = load_worksite("concept-1972").bay
    assert bay is not None and bay.high[1] == pytest.approx(7.5 * 0.3048)
    wall = 'y = ["= bay_side", "= hull_side"], z = ["= -bay_depth", "0 ft"]'
    with pytest.raises(ScenarioError, match=r"bay\.y: .*-2\.286 m"):
        changed(tmp_path, "concept-1972", wall, wall.replace("bay_side", "bay_side + 1 ft"))

"""The page computes camera views with its own code: both the page and `view` have to give these views."""

from __future__ import annotations

from pathlib import Path

import msgspec
import pytest

from aftdeck.bodies.cameras import Camera, Setting, view
from aftdeck.tuples import Vec3

VIEWS = Path(__file__).parents[2] / "web" / "tests" / "views.json"


class Witness(msgspec.Struct):
    """A camera, the setting of its drives, and its view at that setting."""

    camera: Camera
    setting: Setting
    position: Vec3
    boresight: Vec3
    up: Vec3


def test_simulation_computes_the_camera_views_of_the_page() -> None:
    witnesses = msgspec.json.decode(VIEWS.read_bytes(), type=list[Witness])
    assert len(witnesses) > 10
    for one in witnesses:
        seen = view(one.camera, one.setting)
        assert seen.position == pytest.approx(one.position, abs=1e-8)
        assert seen.boresight == pytest.approx(one.boresight, abs=1e-8)
        assert seen.up == pytest.approx(one.up, abs=1e-8)

"""Views of cameras: `view` gives the same views as the page, which computes them with its own code."""

from __future__ import annotations

from pathlib import Path

import msgspec
import pytest

from aftdeck.bodies.cameras import Camera, Setting, view
from aftdeck.tuples import Vec3

VIEWS = Path(__file__).parents[2] / "web" / "tests" / "views.json"


class CameraView(msgspec.Struct):
    """A camera, the setting of its drives, and its view at that setting."""

    camera: Camera
    setting: Setting
    position: Vec3
    boresight: Vec3
    up: Vec3


def test_simulation_computes_the_camera_views_of_the_page() -> None:
    expected = msgspec.json.decode(VIEWS.read_bytes(), type=list[CameraView])
    assert len(expected) > 10
    for case in expected:
        found = view(case.camera, case.setting)
        assert found.position == pytest.approx(case.position, abs=1e-8)
        assert found.boresight == pytest.approx(case.boresight, abs=1e-8)
        assert found.up == pytest.approx(case.up, abs=1e-8)

"""Cameras of a report's pictures."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.report.page.gather import Moment
from aftdeck.report.page.pictures import best_cameras
from aftdeck.scene.cameras import SceneCameras
from aftdeck.simulation.frame import Frame
from aftdeck.visual.scene import VisualScene
from tests.loaded import scenario
from tests.visual.states import states

_CLEAR_M = 0.6
"""Distance from the tip up to which a body is at the tip [m]."""
_STEP_M = 0.005
"""Distance between two sampled points [m]."""
_THIN = 8
"""Least number of consecutive points in a body; a body with fewer is too thin for a sample to decide."""


def _is_hidden(scene: VisualScene, frame: Frame, eye: Array, tip: Array) -> bool | None:
    """Return whether a sampled point before the tip is in a body; None if this is a question of rounding."""
    reach = float(np.linalg.norm(tip - eye))
    along = np.arange(_STEP_M, reach - _CLEAR_M, _STEP_M) / reach
    points = eye + along[:, None] * (tip - eye)
    poses, absent = scene.frames_at(frame), scene.absent(frame)
    most = 0
    for cluster, number in zip(scene.clusters.clusters, scene.clusters.frame.tolist(), strict=True):
        if cluster.part in absent:
            continue
        turn, planes = poses[number, 3:].reshape(3, 3), cluster.body.planes
        inside = np.all((points - poses[number, :3]) @ turn @ planes[:, :3].T <= planes[:, 3], axis=1)
        if not inside[0]:  # a body around the camera does not count
            most = max(most, int(inside.sum()))
    return None if 0 < most < _THIN else most > 0


def test_cameras_with_nothing_before_the_tip_come_first() -> None:
    loaded = scenario("concept-1972-script")
    scene, placed = VisualScene(loaded), SceneCameras(loaded)
    both = 0
    for frame in states(loaded, 12, np.random.default_rng(3)):
        chosen = best_cameras(scene, placed, Moment("", frame, ()))
        bodies, tip = placed.bodies_at(frame), np.array(placed.poses.point(frame.position))
        found = [_is_hidden(scene, frame, placed.seen(frame, bodies, camera).position, tip) for camera in chosen]
        hidden = [one for one in found if one is not None]
        if len(hidden) < len(found):
            continue
        both += len(set(hidden)) == 2
        assert not hidden or hidden[0] == all(hidden), chosen
        assert hidden[2:] == sorted(hidden[2:]), chosen
    assert both >= 3

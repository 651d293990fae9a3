"""Pictures of cameras at the key moments of a run, by visual priority, without a GPU."""

from __future__ import annotations

import base64
import math
from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from itertools import islice
from pathlib import Path
from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.errors import AftdeckError, SimulationError
from aftdeck.recording.reader import Recording
from aftdeck.recording.records import FrameRecord
from aftdeck.report.page.gather import Gathered, Moment, scenario_of_run
from aftdeck.scenario.light import LightCondition, condition_named
from aftdeck.scene.cameras import SceneCameras
from aftdeck.simulation.frame import Frame
from aftdeck.visual.page import single
from aftdeck.visual.picture import picture_of
from aftdeck.visual.png import png
from aftdeck.visual.scene import VisualScene

SIZE = (400, 300)
"""Width and height of a picture [pixels]."""
CAMERAS = 2
"""Number of pictures of a moment."""
_TURNED = math.radians(30.0)
"""Least angle between the directions of two chosen cameras [rad]."""
_AT_TIP_M = 0.6
"""Distance from the tip up to which a body is at the tip: the end effector, the payload's fixture [m]."""
_FAR_M = 20.0
"""Distance that counts as much as a tip at the edge of the picture [m]."""


class CameraPicture(NamedTuple):
    """Picture of a camera.

    Attributes:
        what: what it shows, for a reader who cannot see it.
        png: the PNG file in base64.
        width: width [pixels].
        height: height [pixels].
    """

    what: str
    png: str
    width: int
    height: int


class KeyMoment(NamedTuple):
    """Pictures of a key moment, and the text below them."""

    pictures: Sequence[CameraPicture]
    caption: str


def key_moments(run: Gathered) -> Iterator[KeyMoment]:
    """Yield the pictures of two cameras at each key moment."""
    scene, placed = VisualScene(run.scenario), SceneCameras(run.scenario)
    light = condition_named(run.scenario.lighting.condition)
    for moment in run.moments:
        shown = [name for name in moment.monitors if name in placed.cameras]
        pictures = list(islice(_pictures(scene, moment, shown or best_cameras(scene, placed, moment), light), CAMERAS))
        if pictures:
            yield KeyMoment(pictures, f"{moment.frame.time_s:.1f} s: {moment.title}")


def draw_first(file: Path) -> None:
    """Draw a picture of the first step of a recording, which calls the laws of all pictures and makes the scene.

    Nothing is drawn of a recording that cannot be read, or if the camera is inside a body.
    """
    with suppress(AftdeckError):
        recording = Recording(file)
        frame = next((one for one in recording.messages() if isinstance(one, FrameRecord)), None)
        if frame is not None:
            scenario = scenario_of_run(recording.opening)
            scene, moment = VisualScene(scenario), Moment("start", frame, ())
            cameras = best_cameras(scene, SceneCameras(scenario), moment) or scene.cameras
            next(_pictures(scene, moment, cameras, condition_named(scenario.lighting.condition)), None)


def _pictures(
    scene: VisualScene, moment: Moment, cameras: Iterable[str], light: LightCondition
) -> Iterator[CameraPicture]:
    for name in cameras:
        try:
            picture = picture_of(scene, moment.frame, name, SIZE, "colour", light, brief=True)
        except SimulationError:  # the camera is inside a body
            continue
        data = base64.b64encode(png(single(picture))).decode()
        yield CameraPicture(f"{moment.title}, camera {name}", data, *SIZE)


def best_cameras(scene: VisualScene, placed: SceneCameras, moment: Moment) -> list[str]:
    """Return the cameras that have the tip in their picture: those with nothing before it, then near it, come first.

    The second one looks in another direction than the first, if there is one.
    """
    frame = moment.frame
    bodies, tip = placed.bodies_at(frame), np.array(placed.poses.point(frame.position))
    found = []
    for name in placed.cameras:
        seen = placed.seen(frame, bodies, name)
        right, down, ahead = (seen.axes @ (tip - seen.position)).tolist()
        half = math.tan(0.5 * seen.view.field_of_view)
        if ahead > 0.0 and max(abs(right), abs(down)) < half * ahead:
            off_centre = math.hypot(right, down) / (half * ahead)
            order = (_is_hidden(scene, frame, seen.position, tip), off_centre + ahead / _FAR_M)
            found.append((order, name, seen.axes[2]))
    found.sort(key=lambda one: one[0])
    for k in range(1, len(found)):
        if math.acos(max(-1.0, min(1.0, float(found[0][2] @ found[k][2])))) > _TURNED:
            found.insert(1, found.pop(k))
            break
    return [name for _, name, _ in found]


def _is_hidden(scene: VisualScene, frame: Frame, eye: Array, point: Array) -> bool:
    """Return whether a body is between an eye and a point, both in the scene; bodies at the point or the eye not."""
    poses, absent = scene.frames_at(frame), scene.absent(frame)
    last = 1.0 - _AT_TIP_M / max(float(np.linalg.norm(point - eye)), _AT_TIP_M)
    for cluster, number in zip(scene.clusters.clusters, scene.clusters.frame.tolist(), strict=True):
        turn, planes = poses[number, 3:].reshape(3, 3), cluster.body.planes
        begin, along = turn.T @ (eye - poses[number, :3]), turn.T @ (point - eye)
        height, slope = planes[:, :3] @ begin - planes[:, 3], planes[:, :3] @ along
        with np.errstate(divide="ignore", invalid="ignore"):
            crossed = -height / slope
        enters = np.max(crossed[slope < 0.0], initial=-math.inf)
        leaves = np.min(crossed[slope > 0.0], initial=math.inf)
        if cluster.part not in absent and 0.0 < enters < min(leaves, last) and not (height[slope == 0.0] > 0.0).any():
            return True
    return False

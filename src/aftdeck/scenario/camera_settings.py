"""Settings that a scenario gives to the drives of its cameras for the start."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from aftdeck.bodies.cameras import Camera, Drive, Setting, setting
from aftdeck.files import Where
from aftdeck.scenario.problems import Problems
from aftdeck.scenario.schema import CameraSpec


def camera_settings(
    problems: Problems, specs: Mapping[str, CameraSpec], cameras: Sequence[Camera]
) -> dict[str, Setting]:
    """Return the settings at the start of the cameras that a scenario aims, by the camera's name.

    Args:
        problems: collects the problems found.
        specs: the decoded settings, by the camera's name.
        cameras: cameras that are present.
    """
    driven = {camera.name: camera for camera in cameras if camera.drive is not None}
    found = {}
    for name, spec in specs.items():
        where: Where = ("cameras", name)
        if name in driven:
            found[name] = _setting(problems, spec, driven[name], where)
            continue
        known = any(camera.name == name for camera in cameras)
        what = f"camera {name!r} has no drive" if known else f"no camera {name!r}"
        problems.add(where, f"{what}: cameras with a drive are {', '.join(driven) or 'none'}")
    return found


def _setting(problems: Problems, spec: CameraSpec, camera: Camera, where: Where) -> Setting:
    """Return a camera's own setting with the angles that the scenario gives."""
    given = {name: float(angle) for name in Setting._fields if (angle := getattr(spec, name)) is not None}
    if not given:
        problems.add(where, f"give at least one of {', '.join(Setting._fields)}")
    if camera.drive is not None:
        for name, angle in given.items():
            if what := misfit(camera.drive, name, angle):
                problems.add((*where, name), what)
    return setting(camera)._replace(**given)


def misfit(drive: Drive, name: str, angle: float) -> str:
    """Return why a drive cannot have an angle [rad]; "" if it can."""
    travels = {"pan": drive.pan, "tilt": drive.tilt, "zoom": drive.zoom}
    travel = travels[name]
    if travel is None:
        moved = ", ".join(one for one, own in travels.items() if own is not None)
        return f"this camera's drive has no {name}, only {moved}"
    if travel.least <= angle <= travel.greatest:
        return ""
    got, least, greatest = map(math.degrees, (angle, travel.least, travel.greatest))
    return f"got {got:.6g} deg, expected {least:.6g} to {greatest:.6g} deg, the range of this camera's drive"

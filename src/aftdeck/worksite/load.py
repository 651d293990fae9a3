"""Read a worksite's file: built in by name, or any other by path."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import msgspec

from aftdeck.bodies.cameras import Camera
from aftdeck.errors import ScenarioError
from aftdeck.files import parse, read
from aftdeck.worksite.model import Body, Worksite

_BUILT_IN = Path(__file__).parent


class _File(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A worksite's file as it is written."""

    name: str
    title: str
    body: tuple[Body, ...]
    camera: tuple[Camera, ...]


def worksites() -> tuple[str, ...]:
    """Names of the built-in worksites."""
    return tuple(sorted(path.stem for path in _BUILT_IN.glob("*.toml")))


def load_worksite(name_or_path: str | Path) -> Worksite:
    """Worksite of a built-in name (``orbiter``) or of the TOML file at a path.

    Raises:
        ScenarioError: no such name or file, or things in it that cannot be drawn; says what and where.
    """
    built_in = str(name_or_path) in worksites()
    path = _BUILT_IN / f"{name_or_path}.toml" if built_in else Path(name_or_path)
    if not path.is_file():
        raise ScenarioError(
            [
                f"no worksite {str(name_or_path)!r}; give the path of a worksite's file or one of: "
                + ", ".join(worksites())
            ]
        )
    source = read(path)
    file = parse(_File, source)
    if problems := list(_problems(file)):
        raise ScenarioError([f"{path.name}: {problem}" for problem in problems])
    return Worksite(name=file.name, title=file.title, bodies=file.body, cameras=file.camera, text=source.text)


def _problems(file: _File) -> Iterator[str]:
    """No body, names used twice, and cameras on bodies that are not there."""
    bodies = [body.name for body in file.body]
    cameras = [camera.name for camera in file.camera]
    if not bodies:
        yield "body: none is listed; the first one gives the scene frame"
    for kind, names in (("body", bodies), ("camera", cameras)):
        for name in sorted({name for name in names if names.count(name) > 1}):
            yield f"{kind}: {name!r} is listed {names.count(name)} times; names have to differ"
    for i, camera in enumerate(file.camera):
        if camera.body not in bodies:
            yield f"camera[{i}].body: {camera.body!r} is no body; there are: {', '.join(bodies)}"

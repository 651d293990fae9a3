"""Loading of worksite files: a built-in file by its name, or any other file by its path."""

from __future__ import annotations

import functools
from collections.abc import Collection, Mapping, Sequence
from pathlib import Path

import msgspec

from aftdeck.arms.geometry import frozen
from aftdeck.bodies.cameras import Camera
from aftdeck.bodies.solid import Solid
from aftdeck.dimensions import KEY, derive
from aftdeck.errors import InputError, ScenarioError
from aftdeck.files import Problem, Text, as_path, examine, is_file, line_of, read, sentences
from aftdeck.shapes import Shape
from aftdeck.tuples import plain_vector
from aftdeck.worksite.berths.berth import Berth
from aftdeck.worksite.body import Body
from aftdeck.worksite.file.check import (
    ARM,
    bay_without_walls,
    blind_cameras,
    inside_nothing,
    misnamed,
    parts_in_two_frames,
)
from aftdeck.worksite.file.housing import Housed, housed
from aftdeck.worksite.file.payload import payload_of
from aftdeck.worksite.file.schema import BayFile, BodyFile, OrbiterFile, WorksiteFile
from aftdeck.worksite.file.solids import as_solids, drawn, moved, solids_of
from aftdeck.worksite.model import (
    Bay,
    Jets,
    Mounted,
    OrbiterMass,
    Translation,
    Worksite,
)
from aftdeck.worksite.payload import FITTINGS, Payload
from aftdeck.worksite.relation import Essential

_BUILT_IN = Path(__file__).parents[1]


def worksites() -> tuple[str, ...]:
    """Return the names of the built-in worksites."""
    return tuple(sorted(path.stem for path in _BUILT_IN.glob("*.toml")))


def load_worksite(name_or_path: str | Path, dimensions: Mapping[str, float | str] | None = None) -> Worksite:
    """Return the built-in worksite of a name (``orbiter``), or the worksite that the TOML file at a path describes.

    Arguments and errors as for `worksite_text` and `worksite_of`.
    """
    return worksite_of(worksite_text(name_or_path), dimensions)


def worksite_of(source: Text, dimensions: Mapping[str, float | str] | None = None) -> Worksite:
    """Return the worksite that the text of a file describes.

    Args:
        source: name and text of the file.
        dimensions: values that replace those in the file's ``[dimensions]``.

    Raises:
        ScenarioError: the text is invalid: for example, a solid is not convex, or a camera is inside a solid. The
            message names each error and its location.
    """
    return _of_text(source, tuple((dimensions or {}).items()))


def dimensions_of(source: Text, over: Mapping[str, float | str]) -> dict[str, str | float]:
    """Return a worksite's dimensions, computed after the values in `over` have replaced those in the worksite's file.

    Invalid dimensions are left out.

    Raises:
        ScenarioError: the text is not valid TOML.
    """
    file, _ = examine(_Dimensions, source, {(KEY, key): value for key, value in over.items()}, derive)
    return {} if file is None else file.dimensions


class _Dimensions(msgspec.Struct, frozen=True):
    """The table of named quantities in a worksite's file."""

    dimensions: dict[str, str | float] = msgspec.field(default_factory=dict)


def worksite_text(name_or_path: str | Path) -> Text:
    """Return the name and the unparsed text of a worksite's file.

    Args:
        name_or_path: name of a built-in worksite, or path of a file.

    Raises:
        ScenarioError: the name or file does not exist, or the file cannot be read.
    """
    built_in = str(name_or_path) in worksites()
    path = _BUILT_IN / f"{name_or_path}.toml" if built_in else as_path(name_or_path)
    if not is_file(path):
        raise ScenarioError(
            [
                f"{str(name_or_path)!r} is not a worksite; give the path of a worksite's file or one of: "
                + ", ".join(worksites())
            ]
        )
    return read(path)


@functools.lru_cache(maxsize=8)
def _of_text(source: Text, dimensions: tuple[tuple[str, float | str], ...]) -> Worksite:
    """Return the worksite that a file's text describes. A worksite is immutable and can therefore be cached."""
    name, text = source
    file, problems = examine(WorksiteFile, source, {(KEY, key): value for key, value in dimensions}, derive)
    if file is None or problems:
        raise ScenarioError(sentences(problems, name, text))
    if unknown := [key for key, _ in dimensions if line_of((KEY, key), text) in (None, line_of((KEY,), text))]:
        choices = ", ".join(key for key in file.dimensions if key not in unknown) or "none"
        raise ScenarioError([f"{name} has no dimension {', '.join(map(repr, unknown))}; dimensions are: {choices}"])
    problems = list(misnamed(file))
    worksite = None if problems else _made(file, text, problems)
    if worksite is None or problems:
        raise ScenarioError(sentences(problems, name, text))
    return worksite


def _made(file: WorksiteFile, text: str, problems: list[Problem]) -> Worksite:
    """Return the worksite without its invalid items, and add a problem for each invalid item to `problems`."""
    cameras = _cameras(file, problems)
    made = [
        _body(body, i, _marks(file, body.name), housed(tuple(cameras.values()), file, body.name), problems)
        for i, body in enumerate(file.body)
    ]
    bodies = tuple(body for body, _ in made)
    solids = tuple(solid for _, own in made for solid in own)
    berths = _berths(file, made, problems)
    on_frames = {
        name: housed(tuple(cameras.values()), file, name)
        for name in dict.fromkeys(camera.body for camera in cameras.values())
    }
    mounted = {
        name: Mounted(tuple(own.shapes), own.as_solids(name))
        for name, own in on_frames.items()
        if name.startswith(ARM) and own.solids
    }
    listed = _payloads(file, berths, on_frames, problems)
    payloads = tuple(listed.values())
    problems += parts_in_two_frames(
        [
            *((("body", i), own) for i, (_, own) in enumerate(made)),
            *((("cargo", i), payload.solids) for i, payload in listed.items()),
            *((("camera",), own.solids) for own in mounted.values()),
        ]
    )
    parts = dict.fromkeys(solid.part for own in (solids, *(payload.solids for payload in payloads)) for solid in own)
    problems += inside_nothing(file, parts)
    bay = None if file.bay is None else _bay(file.bay)
    if bay is not None and not problems:
        problems += bay_without_walls(bay, solids)
    problems += blind_cameras(cameras, bodies, solids, payloads, file.camera_clearance)
    return Worksite(
        name=file.name,
        title=file.title,
        bodies=bodies,
        cameras=tuple(cameras.values()),
        text=text,
        dimensions=file.dimensions,
        origin=plain_vector(file.origin),
        solids=solids,
        mounted=mounted,
        berths=berths,
        payloads=payloads,
        essential=tuple(
            Essential((a, b), pair.relation, float(pair.depth))
            for pair in file.essential
            for a in _named(pair.parts[0], parts)
            for b in _named(pair.parts[1], parts)
        ),
        acquisition=file.acquisition,
        bay=bay,
        translation=None
        if file.translation is None
        else Translation(float(file.translation.speed), float(file.translation.reached_in)),
        orbiter=None if file.orbiter is None else _orbiter(file.orbiter),
    )


def _orbiter(file: OrbiterFile) -> OrbiterMass:
    """Return the orbiter's mass properties and jets."""
    jets = file.jets
    return OrbiterMass(
        float(file.mass),
        plain_vector(file.inertia),
        None if file.centre is None else plain_vector(file.centre),
        None
        if jets is None
        else Jets(plain_vector(jets.torque), float(jets.least_pulse), float(jets.angle), float(jets.rate)),
        file.motion,
    )


def _marks(file: WorksiteFile, body: str) -> list[Shape]:
    """Return the shapes that mark a body's berths."""
    return [shape for berth in file.seat if berth.body == body for shape in berth.marks()]


def _body(
    file: BodyFile, i: int, marks: list[Shape], cameras: Housed, problems: list[Problem]
) -> tuple[Body, tuple[Solid, ...]]:
    """Return a body, and its solids in the coordinate frame to which the body is fixed."""
    shapes = [*file.shapes, *marks, *cameras.shapes]
    body = Body(file.name, (), file.details, file.fixed_to, plain_vector(file.position), plain_vector(file.rotation))
    solids: list[Solid] = []
    solids += cameras.as_solids(file.fixed_to, body.pose)
    for k, solid in enumerate(file.solids):
        try:
            parts = solids_of(solid)
        except InputError as error:
            problems.append(Problem(("body", i, "solids", k), f"body {file.name}: {error}"))
            continue
        for part, own in parts.items():
            solids += as_solids(part, file.fixed_to, frozen(moved(own, body.pose)))
            if solid.material is not None:
                shapes += drawn(own, solid.material)
    return msgspec.structs.replace(body, shapes=tuple(shapes)), tuple(solids)


def _berths(
    file: WorksiteFile, made: Sequence[tuple[Body, tuple[Solid, ...]]], problems: list[Problem]
) -> tuple[Berth, ...]:
    homes = {body.name: (body, solids) for body, solids in made}
    berths = []
    for i, berth in enumerate(file.seat):
        try:
            berths.append(berth.berth(*homes[berth.body]))
        except ValueError as error:
            problems.append(Problem(("seat", i, "position"), f"seat {berth.name}: {error}"))
    return tuple(berths)


def _payloads(
    file: WorksiteFile, berths: Sequence[Berth], cameras: Mapping[str, Housed], problems: list[Problem]
) -> dict[int, Payload]:
    """Return the valid payloads by their index in the file, and add a problem for each invalid payload.

    `cameras` has the housings of the cameras on each payload.
    """
    by_name = {berth.name: berth for berth in berths}
    payloads = {}
    for i, payload in enumerate(file.cargo):
        try:
            made = payload_of(payload, by_name)
        except ValueError as error:
            problems.append(Problem(("cargo", i), f"cargo {payload.name}: {error}"))
            continue
        if own := cameras.get(payload.name):
            made = msgspec.structs.replace(
                made, shapes=(*made.shapes, *own.shapes), solids=(*made.solids, *own.as_solids(payload.name))
            )
        payloads[i] = made
    return payloads


def _cameras(file: WorksiteFile, problems: list[Problem]) -> dict[int, Camera]:
    """Return the valid cameras by their index in the file, and add a problem for each invalid camera."""
    cameras = {}
    for i, camera in enumerate(file.camera):
        try:
            cameras[i] = camera.camera(file.drive)
        except ValueError as error:
            problems.append(Problem(("camera", i), str(error)))
    return cameras


def _named(name: str, parts: Collection[str]) -> tuple[str, ...]:
    """Return the parts that a name in the file denotes.

    The name of a fitting denotes this fitting of every payload. The name of a mirrored solid denotes its port and
    starboard parts. Any other name denotes one part.
    """
    if name in FITTINGS:
        return tuple(part for part in parts if part.endswith(f" {name}"))
    sides = tuple(part for part in (f"{name} port", f"{name} starboard") if part in parts)
    return (name,) if name in parts else sides or (name,)


def _bay(file: BayFile) -> Bay:
    (a, b), (c, d), (e, f) = file.x, file.y, file.z
    return Bay(plain_vector((a, c, e)), plain_vector((b, d, f)))

"""Read a worksite's file: built in by name, or any other by path."""

from __future__ import annotations

import functools
from collections.abc import Collection, Sequence
from pathlib import Path

from aftdeck.arms.geometry import frozen
from aftdeck.bodies.cameras import Camera, Vec3
from aftdeck.bodies.solid import Solid
from aftdeck.errors import InputError, ScenarioError
from aftdeck.files import Problem, Text, parse, read, sentences
from aftdeck.shapes import Shape
from aftdeck.worksite.cargo import FITTINGS, cargo_of
from aftdeck.worksite.check import bay_without_walls, blind_cameras, misnamed, parts_in_two_frames
from aftdeck.worksite.housing import Housed, housed
from aftdeck.worksite.model import BarAcquisition, Bay, Body, Cargo, Seat, SnareCapture, Translation, Worksite
from aftdeck.worksite.schema import BarFile, BayFile, BodyFile, PortFile, SnareFile, WorksiteFile
from aftdeck.worksite.seats import disc, seat_of
from aftdeck.worksite.solids import as_solids, drawn, moved, solids_of

_BUILT_IN = Path(__file__).parent


def worksites() -> tuple[str, ...]:
    """Names of the built-in worksites."""
    return tuple(sorted(path.stem for path in _BUILT_IN.glob("*.toml")))


def load_worksite(name_or_path: str | Path) -> Worksite:
    """Worksite of a built-in name (``orbiter``) or of the TOML file at a path.

    Raises:
        ScenarioError: no such name or file, or things in it that cannot be drawn or stand in each other's way; says
            what and where.
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
    return _of_text(source.text, path.name)


@functools.lru_cache(maxsize=8)
def _of_text(text: str, name: str) -> Worksite:
    """The worksite of a file's text, made and checked once: nothing changes it."""
    file = parse(WorksiteFile, Text(name, text))
    problems = list(misnamed(file))
    worksite = None if problems else _made(file, text, problems)
    if worksite is None or problems:
        raise ScenarioError(sentences(problems, name, text))
    return worksite


def _made(file: WorksiteFile, text: str, problems: list[Problem]) -> Worksite:
    """The worksite without what is wrong in it, which is noted."""
    cameras = _cameras(file, problems)
    made = [
        _body(body, i, _discs(file, body.name), housed(cameras, file, body.name), problems)
        for i, body in enumerate(file.body)
    ]
    bodies = tuple(body for body, _ in made)
    solids = tuple(solid for _, own in made for solid in own)
    seats = _seats(file, made, problems)
    cargoes = _cargoes(file, seats, problems)
    problems += parts_in_two_frames(
        [
            *((("body", i), own) for i, (_, own) in enumerate(made)),
            *((("cargo", i), cargo.solids) for i, cargo in enumerate(cargoes)),
        ]
    )
    parts = dict.fromkeys(solid.part for own in (solids, *(cargo.solids for cargo in cargoes)) for solid in own)
    bay = None if file.bay is None else _bay(file.bay)
    if bay is not None and not problems:
        problems += bay_without_walls(bay, solids)
    problems += blind_cameras(cameras, bodies, solids, cargoes, file.camera_clearance)
    return Worksite(
        name=file.name,
        title=file.title,
        bodies=bodies,
        cameras=cameras,
        text=text,
        origin=_plain(file.origin),
        solids=solids,
        seats=seats,
        cargoes=cargoes,
        essential=tuple(
            (a, b) for pair in file.essential for a in _named(pair[0], parts) for b in _named(pair[1], parts)
        ),
        acquisition=_acquisition(file.acquisition),
        bay=bay,
        translation=None
        if file.translation is None
        else Translation(float(file.translation.speed), float(file.translation.reached_in)),
    )


def _discs(file: WorksiteFile, body: str) -> list[Shape]:
    """What shows a body's ports."""
    return [disc(seat) for seat in file.seat if isinstance(seat, PortFile) and seat.body == body]


def _body(
    file: BodyFile, i: int, ports: list[Shape], cameras: Housed, problems: list[Problem]
) -> tuple[Body, tuple[Solid, ...]]:
    """A body, and its solids in its frame of motion."""
    shapes = [*file.shapes, *ports, *cameras.shapes]
    body = Body(file.name, (), file.fixed_to, _plain(file.position), _plain(file.rotation))
    solids: list[Solid] = []
    for part, own in cameras.solids.items():
        solids += as_solids(part, file.fixed_to, frozen(moved(own, body.pose)))
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
    return Body(body.name, tuple(shapes), body.fixed_to, body.position, body.rotation), tuple(solids)


def _seats(
    file: WorksiteFile, made: Sequence[tuple[Body, tuple[Solid, ...]]], problems: list[Problem]
) -> tuple[Seat, ...]:
    homes = {body.name: (body, solids) for body, solids in made}
    seats = []
    for i, seat in enumerate(file.seat):
        try:
            seats.append(seat_of(seat, *homes[seat.body]))
        except ValueError as error:
            problems.append(Problem(("seat", i, "position"), f"seat {seat.name}: {error}"))
    return tuple(seats)


def _cargoes(file: WorksiteFile, seats: Sequence[Seat], problems: list[Problem]) -> tuple[Cargo, ...]:
    by_name = {seat.name: seat for seat in seats}
    cargoes = []
    for i, cargo in enumerate(file.cargo):
        try:
            cargoes.append(cargo_of(cargo, by_name))
        except ValueError as error:
            problems.append(Problem(("cargo", i), f"cargo {cargo.name}: {error}"))
    return tuple(cargoes)


def _cameras(file: WorksiteFile, problems: list[Problem]) -> tuple[Camera, ...]:
    cameras = []
    for i, camera in enumerate(file.camera):
        try:
            cameras.append(camera.camera(file.drive))
        except ValueError as error:
            problems.append(Problem(("camera", i), str(error)))
    return tuple(cameras)


def _named(name: str, parts: Collection[str]) -> tuple[str, ...]:
    """The parts that a name stands for: that fitting of every cargo, both sides of what is mirrored, or itself."""
    if name in FITTINGS:
        return tuple(part for part in parts if part.endswith(f" {name}"))
    sides = tuple(part for part in (f"{name} port", f"{name} starboard") if part in parts)
    return (name,) if name in parts else sides or (name,)


def _acquisition(file: BarFile | SnareFile | None) -> BarAcquisition | SnareCapture | None:
    match file:
        case BarFile():
            return BarAcquisition(*map(float, (file.spacing, file.window, file.front, file.rear, file.fingers_within)))
        case SnareFile():
            envelope = (file.radial, file.nearest, file.farthest, file.pitch, file.yaw, file.roll)
            return SnareCapture(*map(float, (*envelope, file.ring, file.carriage, file.tension)))
        case None:
            return None


def _bay(file: BayFile) -> Bay:
    (a, b), (c, d), (e, f) = file.x, file.y, file.z
    return Bay(_plain((a, c, e)), _plain((b, d, f)))


def _plain(values: tuple[float, float, float]) -> Vec3:
    x, y, z = map(float, values)
    return x, y, z

"""Command ``arm``: poses, joint angles, limits, modes and natural frequencies of an arm."""

from __future__ import annotations

import math
from enum import StrEnum
from typing import TYPE_CHECKING, Annotated

import typer

from aftdeck.cli.app import Json, app
from aftdeck.cli.printing import print_json, print_table
from aftdeck.errors import InputError
from aftdeck.lines import print_line

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from aftdeck.frames import Pose
    from aftdeck.kinematics.arm import Arm


POSE = 6
"""Numbers of a pose: three coordinates and three angles."""


class Question(StrEnum):
    """Questions that `aftdeck arm` answers."""

    forward = "forward"
    inverse = "inverse"
    limits = "limits"
    modes = "modes"
    frequencies = "frequencies"


class FrameChoice(StrEnum):
    """Coordinate frames of the poses that the command reads and prints."""

    L = "L"
    orbiter = "orbiter"
    panel = "panel"


class PayloadAxis(StrEnum):
    """Names of frame 7's axes 1, 2, 3 at the tip of the straight arm; a payload can lie along each of them."""

    arm = "arm"
    pitch = "pitch"
    yaw = "yaw"


@app.command(
    short_help="Print poses, joint angles, limits, modes or natural frequencies of an arm.",
    epilog="Examples: aftdeck arm srms forward 0 25 -25 5 0 0 --deg --frame panel; "
    "aftdeck arm srms inverse 10 0 -2 0 0 0 --deg; "
    "aftdeck arm srms frequencies --payload-mass '65000 lb' --payload-axis pitch --free",
    context_settings={"ignore_unknown_options": True},
)
def arm(
    name: Annotated[str, typer.Argument(metavar="NAME", help="Name of a built-in arm, or path of an arm file.")],
    question: Annotated[Question, typer.Argument(metavar="QUESTION")],
    numbers: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="[NUMBERS]",
            help="forward: the angle of each joint; of one that slides, its length [m]. inverse: X Y Z and ROLL PITCH "
            "YAW (in L and orbiter: metres and ENDORI's roll, elevation, azimuth of frame 7; in panel: inches and the "
            "end effector's attitude). frequencies: as for forward; default: all zero.",
        ),
    ] = None,
    deg: Annotated[bool, typer.Option("--deg", help="Read and print angles in degrees; default: radians.")] = False,
    frame: Annotated[FrameChoice, typer.Option(help="Coordinate frame of the pose.")] = FrameChoice.L,
    payload_mass: Annotated[
        str | None, typer.Option(metavar="MASS", help="frequencies: mass of a payload at the tip, such as '65000 lb'.")
    ] = None,
    payload_axis: Annotated[
        PayloadAxis | None,
        typer.Option(help="frequencies: axis along which the payload, a cylinder, lies; default: pitch."),
    ] = None,
    payload: Annotated[
        str | None,
        typer.Option(
            metavar="SCENARIO",
            help="frequencies: the payload that the end effector holds at the start of a scenario, in place of a "
            "cylinder.",
        ),
    ] = None,
    free: Annotated[bool, typer.Option("--free", help="frequencies: on a free orbiter; default: fixed.")] = False,
    orbiter_mass: Annotated[
        str | None, typer.Option(metavar="MASS", help="frequencies: mass of the free orbiter; default: 100000 kg.")
    ] = None,
    as_json: Json = False,
) -> None:
    """Print poses, joint angles, limits, modes or natural frequencies of an arm.

    The natural frequencies are those of the flexible arm with its brakes on. Its payload is a uniform cylinder with the
    density of 65,000 lb in 60 by 15 ft, whose centre is at the tip, or the payload of a scenario.
    """
    from aftdeck.kinematics.arm import load_arm

    if question is not Question.frequencies:
        only = {
            "--payload-mass": payload_mass,
            "--payload-axis": payload_axis,
            "--payload": payload,
            "--free": free or None,
            "--orbiter-mass": orbiter_mass,
        }
        if given := [option for option, value in only.items() if value is not None]:
            raise InputError(f"{question.value}: {', '.join(given)} can only be given with frequencies")
    if frame is not FrameChoice.L and question not in (Question.forward, Question.inverse):
        raise InputError(f"{question.value}: --frame can only be given with forward or inverse")
    loaded = load_arm(name)
    given, joints = numbers or [], len(loaded.joints)
    needed = {Question.forward: joints, Question.inverse: POSE, Question.frequencies: joints if given else 0}
    values = _numbers(given, needed.get(question, 0), question.value)
    match question:
        case Question.forward:
            _forward(loaded, values, deg, frame.value, as_json)
        case Question.inverse:
            _inverse(loaded, values, deg, frame.value, as_json)
        case Question.limits:
            _limits(loaded, deg, as_json)
        case Question.modes:
            _modes(as_json)
        case Question.frequencies:
            from aftdeck.cli.arm_frequencies import print_frequencies

            angles = _coordinates(loaded, values or [0.0] * joints, deg)
            print_frequencies(loaded, angles, payload_mass, payload_axis, payload, free, orbiter_mass, as_json)


def _numbers(texts: list[str], expected: int, question: str) -> list[float]:
    if unknown := next((text for text in texts if text.startswith("--")), None):
        raise InputError(f"{question}: there is no option {unknown}")
    if len(texts) != expected:
        raise InputError(f"{question} needs {expected} numbers, got {len(texts)}: {' '.join(texts)}")
    values = []
    for text in texts:
        try:
            value = float(text)
        except ValueError:
            raise InputError(f"{question}: {text!r} is not a number") from None
        if not math.isfinite(value):
            raise InputError(f"{question}: numbers must be finite, got {text!r}")
        values.append(value)
    return values


def _coordinates(loaded: Arm, values: list[float], deg: bool) -> list[float]:
    """Return the joints' coordinates in SI units; a joint that slides has its own in metres always."""
    scales = _scales(loaded, deg)
    return [value / factor for value, (factor, _) in zip(values, scales, strict=True)]


def _scales(loaded: Arm, deg: bool) -> list[tuple[float, str]]:
    """Return for each joint the factor from the SI unit to the unit that is shown, and this unit."""
    from aftdeck.arms.by_joint import scale

    return [scale(slides, deg) for slides in loaded.model.slides]


def _forward(loaded: Arm, values: list[float], deg: bool, frame: str, as_json: bool) -> None:
    pose = loaded.forward(_coordinates(loaded, values, deg))
    position, angles, unit = _shown(loaded, pose, frame)
    shown = [math.degrees(a) if deg else a for a in angles]
    names = ("pitch", "yaw", "roll") if frame == "panel" else ("roll", "pitch", "yaw")
    if as_json:
        angles_json = dict(zip(names, shown, strict=True))
        units = {"position_unit": unit, "angle_unit": "deg" if deg else "rad"}
        print_json({"frame": frame, "position": position, **angles_json, **units})
        return
    print_line(f"frame {frame}")
    for axis, value in zip("XYZ", position, strict=True):
        print_line(f"  {axis:<6}{value:>13.4f} {unit}")
    for label, value in zip(names, shown, strict=True):
        print_line(f"  {label:<6}{value:>13.4f} {'deg' if deg else 'rad'}")


def _shown(loaded: Arm, pose: Pose, frame: str) -> tuple[list[float], tuple[float, ...], str]:
    """Return a pose's position in `frame`, its angles in `frame` [rad], and the position's unit."""
    from aftdeck.frames import oriend

    if frame == "panel":
        inches, degrees = loaded.panel(pose)
        return list(inches), tuple(math.radians(d) for d in degrees), "in"
    if frame == "orbiter":
        position, angles = loaded.orbiter(pose)
        return list(position), angles, "m"
    return pose.position.tolist(), oriend(pose.rotation), "m"


def _inverse(loaded: Arm, values: list[float], deg: bool, frame: str, as_json: bool) -> None:
    import numpy as np

    from aftdeck.frames import Pose, endori
    from aftdeck.units import INCH

    roll, pitch, yaw = (math.radians(v) if deg else v for v in values[3:])
    if frame == "panel":
        pose = loaded.from_panel([v * INCH for v in values[:3]], [pitch, yaw, roll])
    else:
        in_frame = Pose(np.array(values[:3]), endori(roll, pitch, yaw))
        pose = loaded.model.mount.from_("orbiter" if frame == "orbiter" else "L", in_frame)
    solutions = loaded.inverse(pose)
    scales = _scales(loaded, deg)
    rows = (solutions * np.array([factor for factor, _ in scales])).tolist()
    if as_json:
        units = {"angle_unit": "deg" if deg else "rad", "joint_units": [unit for _, unit in scales]}
        print_json({"joints": loaded.joints, "solutions": rows, **units})
        return
    print_line("  ".join(f"{joint:>14}" for joint in loaded.joints))
    if any(loaded.model.slides):
        print_line("  ".join(f"{unit:>14}" for _, unit in scales))
    for row in rows:
        print_line("  ".join(f"{value:>14.4f}" for value in row))


def _limits(loaded: Arm, deg: bool, as_json: bool) -> None:
    scales, unit = _scales(loaded, deg), "deg" if deg else "rad"
    named = {**loaded.limits._asdict(), **{f"{name}_rate": r for name, r in loaded.rates._asdict().items()}}
    rows = [
        {
            "joint": joint,
            "unit": joint_unit,
            **{name: (values[i] * factor).round(9).tolist() for name, values in named.items()},
        }
        for i, (joint, (factor, joint_unit)) in enumerate(zip(loaded.joints, scales, strict=True))
    ]
    if as_json:
        print_json({"angle_unit": unit, "rate_unit": f"{unit}/s", "joints": rows})
        return
    lengths = "; of joints that slide, in m and m/s" if any(loaded.model.slides) else ""
    print_line(f"angles in {unit}, rates in {unit}/s{lengths}")
    print_table(_shown_limits(rows, loaded.limits._fields, ""), ("joint", *loaded.limits._fields), False)
    print_line()
    print_table(_shown_limits(rows, loaded.rates._fields, "_rate"), ("joint", *loaded.rates._fields), False)


def _shown_limits(rows: Sequence[Mapping[str, object]], names: tuple[str, ...], ending: str) -> list[dict[str, object]]:
    """Return a table's rows with the limits `names` as text; a limit's key in `rows` is its name plus `ending`."""
    return [{"joint": row["joint"]} | {name: _range(row[name + ending]) for name in names} for row in rows]


def _range(limit: object) -> str:
    """Return ``-2 .. 145`` for a pair of limits, ``2.29`` for a rate."""
    return " .. ".join(f"{v:.4g}" for v in limit) if isinstance(limit, list) else f"{limit:.4g}"


def _modes(as_json: bool) -> None:
    from aftdeck.steering.mode import MODES

    rows = [
        {
            "position": m.position,
            "laws": m.laws if as_json else ", ".join(str(n) for n in m.laws),
            "kind": m.kind,
            "title": m.title,
        }
        for m in MODES.values()
    ]
    print_table(rows, ("position", "laws", "kind", "title"), as_json)

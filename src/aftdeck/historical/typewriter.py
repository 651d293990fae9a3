"""Words of the report's TABLE III: what its operator read and wrote by typewriter while the program ran.

Each word has an octal address in the memory of the scene generator's computer, a quantity, a coordinate system and a
scale: distances at B11 or B16, angles with 180 deg as the most significant bit. Source: the final report of the Remote
Manipulator Simulation, section V.A and TABLE III. Assumed: distances in feet; rates for each control period, positive
in the word whose name begins with P; the upper word of a pair has the sign of the lower one, at B11; heading and pitch
are the angles that the panel shows as PAN and TILT; the zoom rate is that of the field of view in radians, at B3.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from aftdeck.arms.body_file import BlockBody
from aftdeck.bodies.cameras import Camera
from aftdeck.bodies.pose import POSE, compose, row_of
from aftdeck.errors import InputError
from aftdeck.frames import Pose
from aftdeck.historical.frame_words import BITS, fixed, number
from aftdeck.scenario.all_cameras import cameras_of, first_setting
from aftdeck.scenario.keys import WORKSITE, contents_of
from aftdeck.scenario.load import text_of
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.constants.site import scene_in_l
from aftdeck.simulation.frame import Frame
from aftdeck.tuples import Vec3
from aftdeck.units import FOOT

STATIONS = "ABCDEFGHI"
"""Camera stations in the order of their words."""
SYSTEMS = {"F": "ZERO", "G": "ONE"}
"""Coordinate system of a station's position; R for all others."""
_WHOLE = 1 << BITS


class Run(NamedTuple):
    """Run whose words are read.

    Attributes:
        scenario: scenario with the changes in force.
        frame: newest frame; None before the first step.
    """

    scenario: Scenario
    frame: Frame | None

    def camera(self, name: str) -> Camera:
        """Return a camera with a drive.

        Raises:
            InputError: there is none.
        """
        for camera in cameras_of(self.scenario):
            if camera.name == name and camera.drive is not None:
                return camera
        raise InputError(f"this scenario has no camera {name} with a drive")

    def key_of_camera(self, name: str) -> str:
        """Return the key of a camera of the worksite."""
        listed = contents_of(text_of(self.scenario, WORKSITE)).get("camera", [])
        names = [camera.get("name") for camera in listed]
        if name not in names:
            raise InputError(f"the worksite of this scenario has no camera {name}")
        return f"worksite.camera[{names.index(name)}]"

    def key_of_joint(self, driver: str) -> str:
        """Return the key of the joint that a switch drives."""
        joints = self.scenario.arm.model.source.joint
        found = [i for i, joint in enumerate(joints) if getattr(joint, "driver", None) == driver]
        if not found:
            raise InputError(f"the arm of this scenario has no {driver}")
        return f"arm.joint[{found[0]}]"


class Word(NamedTuple):
    """A word of TABLE III.

    Attributes:
        label: name in the report.
        system: coordinate system, or a remark.
        scale: n for a number at scale Bn; -1 for an angle with 180 deg as the most significant bit.
        unit: unit of the quantity: ft or rad.
        read: returns the quantity.
        write: returns the changes in flight for a new quantity.
        upper: whether the word has only the sign of the next one.
    """

    label: str
    system: str
    scale: int
    unit: str
    read: Callable[[Run], float]
    write: Callable[[Run, float], dict[str, str]]
    upper: bool = False

    def encoded(self, value: float) -> int:
        """Return the word of a quantity."""
        if self.scale < 0:
            return round(value / math.tau * _WHOLE) % _WHOLE
        word = fixed(value, self.scale, self.label)
        return (_WHOLE - 1 if word >> (BITS - 1) else 0) if self.upper else word

    def decoded(self, word: int) -> float:
        """Return the quantity of a word."""
        return number(word, 0) * math.pi if self.scale < 0 else number(word, self.scale)


def addresses() -> tuple[str, ...]:
    """Return the addresses of all words, in octal."""
    return tuple(f"{address:o}" for address in _TABLE)


def read_word(address: str, scenario: Scenario, frame: Frame | None) -> str:
    """Return a word of a run, with its quantity.

    Raises:
        InputError: there is no word at this address, or the scenario has nothing that it describes.
    """
    word = _word(address)
    value = word.read(Run(scenario, frame))
    shown = f"{math.degrees(value):.5g} deg" if word.unit == "rad" else f"{value:.6g} {word.unit}"
    if word.upper:
        shown = "sign of the next word"
    scale = "MSB = 180 deg" if word.scale < 0 else f"B{word.scale}"
    return f"{address} = {word.encoded(value):08o}  {word.label}, {word.system}, {scale}: {shown}"


def write_word(address: str, given: str, scenario: Scenario, frame: Frame | None) -> dict[str, str]:
    """Return the changes in flight for a new word.

    Raises:
        InputError: as for `read_word`, or the text is not a word in octal, or the word cannot be written.
    """
    word = _word(address)
    if not re.fullmatch(r"[0-7]{1,8}", given):
        raise InputError(f"expected ADDRESS = WORD with up to eight digits from 0 to 7, got {given[:40]!r}")
    if word.upper:
        raise InputError(f"{address} is the upper word of a pair, which has the sign; write the lower word")
    return word.write(Run(scenario, frame), word.decoded(int(given, 8)))


def _word(address: str) -> Word:
    if not re.fullmatch(r"[0-7]{1,8}", address) or int(address, 8) not in _TABLE:
        first, last = addresses()[0], addresses()[-1]
        raise InputError(f"TABLE III has no word at {address[:40]!r}: its addresses are octal, {first} to {last}")
    return _TABLE[int(address, 8)]


def _table() -> dict[int, Word]:
    """Return the words by their addresses, in the order of the addresses."""
    found: dict[int, Word] = {}
    for k, name in enumerate(STATIONS):
        system = SYSTEMS.get(name, "REF.")
        for i, axis in enumerate("XYZ"):
            found[0o16000 + 3 * k + i] = Word(f"CAMERA {name} {axis} POSITION", system, 11, "ft", *_position(name, i))
        for i, (what, part) in enumerate((("HEADING", "pan"), ("PITCH", "tilt"))):
            found[0o16033 + 2 * k + i] = Word(f"CAMERA {name} {what}", "N.A.", -1, "rad", *_angle(name, part))
    for i, axis in enumerate("XYZ"):
        for upper in (True, False):
            label = f"CENTER OF PAYLOAD {axis} {'UPPER' if upper else 'LOWER'} WORD"
            found[0o16121 + 2 * i + (not upper)] = Word(label, "REF.", 11, "ft", *_payload(i), upper)
            label = f"INITIAL TR VECTOR TR{axis}{'U' if upper else 'L'}"
            found[_TR[2 * i + (not upper)]] = Word(label, "REF.", 11, "ft", *_telescope_top(i), upper)
    for k in range(5):
        found[0o16170 + k] = Word(f"TOP OF TELESCOPING ARM V{k + 1}Z", "REF.", 16, "ft", *_telescope_top(_Z))
    for k in range(8):
        found[0o16203 + k] = Word(f"MOVEABLE FINGER V{k + 1}Y", "TWO", 16, "ft", *_finger(outer=k in _OUTER))
    for names, first, scale, driver in (
        (("PDV", "NDV"), 0o16306, 16, "telescope"),
        (("NDT", "PDT"), 0o16213, 11, "telescope"),
        (("NDF", "PDF"), 0o16215, 16, "prong"),
    ):
        for k, name in enumerate(names):
            found[first + k] = Word(f"{driver.upper()} RATE {name}", "REF.", scale, "ft", *_slide_rate(driver, name))
    for k, name in enumerate(("PDA", "NDA")):
        found[0o16227 + k] = Word(f"CAMERA PITCH/PAN RATE {name}", "N.A.", -1, "rad", *_drive_rate(name, "pan", "tilt"))
    for k, name in enumerate(("PDPCX", "NDPCX")):
        found[0o16231 + k] = Word(f"CAMERA ZOOM RATE {name}", "N.A.", 3, "rad", *_drive_rate(name, "zoom"))
    return dict(sorted(found.items()))


_OUTER = range(4)
"""Vertices of the movable finger's outer face."""
_Z = 2
_TR = 0o16077, 0o16100, 0o16101, 0o16102, 0o16103, 0o16104
_Pair = tuple[Callable[[Run], float], Callable[[Run, float], dict[str, str]]]


def _position(name: str, i: int) -> _Pair:
    def read(run: Run) -> float:
        at = _in_system(run, run.camera(name), run.camera(name).position)
        return at[i] / FOOT

    def write(run: Run, value: float) -> dict[str, str]:
        camera = run.camera(name)
        at = list(_in_system(run, camera, camera.position))
        at[i] = value * FOOT
        return {f"{run.key_of_camera(name)}.position": _list(_in_body(run, camera, at))}

    return read, write


def _angle(name: str, part: str) -> _Pair:
    def read(run: Run) -> float:
        driven = [camera.name for camera in cameras_of(run.scenario) if camera.drive is not None]
        camera = run.camera(name)
        at = first_setting(run.scenario, camera) if run.frame is None else run.frame.views[driven.index(name)]
        return float(getattr(at, part))

    def write(run: Run, value: float) -> dict[str, str]:
        run.camera(name)
        return {f"cameras.{name}.{part}": f"{value:.12g}"}

    return read, write


def _payload(i: int) -> _Pair:
    def read(run: Run) -> float:
        return _payload_at(run)[i] / FOOT

    def write(run: Run, value: float) -> dict[str, str]:
        at = list(_payload_at(run))
        at[i] = value * FOOT
        scene = scene_in_l(run.scenario)
        return {"cargo[0].start.position": _list(_relative(scene, at))}

    return read, write


def _payload_at(run: Run) -> Vec3:
    """Return the present position of the first payload's centre in R [m]."""
    if not run.scenario.payloads:
        raise InputError("this scenario has no payload")
    if run.frame is not None:
        return run.frame.work.cargo[0].position
    return _times(scene_in_l(run.scenario), run.scenario.payloads[0].start.pose.position.tolist())


def _telescope_top(i: int) -> _Pair:
    """Words of the top of the telescope at its lower limit; its x and y are those of R's origin."""

    def read(run: Run) -> float:
        telescope = run.scenario.arm.model.telescope
        if telescope is None:
            raise InputError("the arm of this scenario has no telescope")
        return -telescope.least / FOOT if i == _Z else 0.0

    def write(run: Run, value: float) -> dict[str, str]:
        if i != _Z:
            raise InputError("the telescope slides along Z: its X and Y are 0 and cannot be written")
        return {f"{run.key_of_joint('telescope')}.least.value": f"{-value * FOOT:.12g}"}

    return read, write


def _finger(*, outer: bool) -> _Pair:
    """Words of the movable finger's vertices while it is open: its inner face, or its outer one."""

    def offset(run: Run) -> float:
        prong = run.scenario.arm.model.prong
        if prong is None:
            raise InputError("the arm of this scenario has no movable finger")
        bodies = [body for body in run.scenario.arm.model.source.bodies if body.frame == prong.frame]
        width = next((float(b.high[1]) - float(b.low[1]) for b in bodies if isinstance(b, BlockBody)), 0.0)
        return width if outer else 0.0

    def read(run: Run) -> float:
        by = offset(run)
        prong = run.scenario.arm.model.prong
        assert prong is not None, "`offset` has checked it"
        return (prong.least - by) / FOOT

    def write(run: Run, value: float) -> dict[str, str]:
        return {f"{run.key_of_joint('prong')}.least.value": f"{value * FOOT + offset(run):.12g}"}

    return read, write


def _slide_rate(driver: str, name: str) -> _Pair:
    sign = 1.0 if name.startswith("P") else -1.0

    def read(run: Run) -> float:
        model = run.scenario.arm.model
        joint = model.telescope if driver == "telescope" else model.prong
        if joint is None:
            raise InputError(f"the arm of this scenario has no {driver}")
        return sign * joint.rate * run.scenario.control_period / FOOT

    def write(run: Run, value: float) -> dict[str, str]:
        rate = sign * value * FOOT / run.scenario.control_period
        return {f"{run.key_of_joint(driver)}.rate.value": f"{rate:.12g}"}

    return read, write


def _drive_rate(name: str, *parts: str) -> _Pair:
    sign = 1.0 if name.startswith("P") else -1.0

    def read(run: Run) -> float:
        drive = run.camera(STATIONS[0]).drive
        travel = getattr(drive, parts[0])
        if travel is None:
            raise InputError(f"camera {STATIONS[0]} has no {parts[0]}")
        return sign * float(travel.rate) * run.scenario.control_period

    def write(run: Run, value: float) -> dict[str, str]:
        rate = f"{sign * value / run.scenario.control_period:.12g}"
        drives = contents_of(text_of(run.scenario, WORKSITE)).get("drive", [])
        return {
            f"worksite.drive[{k}].{part}.rate": rate for k, one in enumerate(drives) for part in parts if part in one
        }

    return read, write


def _body(run: Run, camera: Camera) -> np.ndarray:
    """Return the pose (12,) of a camera's body in the coordinate system in which TABLE III gives its position."""
    if camera.name in SYSTEMS or camera.body.startswith("arm."):
        return row_of(Pose(np.zeros(3), np.eye(3)))  # the frames of the links are systems 0 and 1, the base's is R
    body = next((one for one in run.scenario.worksite.bodies if one.name == camera.body), None)
    if body is None:
        raise InputError(f"camera {camera.name} is on {camera.body}, which moves: TABLE III has no such camera")
    placed = np.empty(POSE)
    compose(scene_in_l(run.scenario), row_of(body.pose), placed)
    return placed


def _in_system(run: Run, camera: Camera, at: Vec3) -> Vec3:
    return _times(_body(run, camera), list(at))


def _in_body(run: Run, camera: Camera, at: list[float]) -> list[float]:
    return _relative(_body(run, camera), at)


def _times(pose: np.ndarray, at: list[float]) -> Vec3:
    """Return a point of a frame with this pose (12,) in the frame in which the pose is given."""
    x, y, z = (pose[:3] + pose[3:].reshape(3, 3) @ np.array(at)).tolist()
    return x, y, z


def _relative(pose: np.ndarray, at: list[float]) -> list[float]:
    """Return a point in the frame with this pose (12,)."""
    found: list[float] = (pose[3:].reshape(3, 3).T @ (np.array(at) - pose[:3])).tolist()
    return found


def _list(values: list[float]) -> str:
    return "[" + ", ".join(f"{value:.12g}" for value in values) + "]"


_TABLE = _table()

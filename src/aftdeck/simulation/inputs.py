"""Operator inputs of one control step, from a person, a script or a policy."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache
from operator import attrgetter
from typing import Literal, get_args, get_origin, get_type_hints

import msgspec

from aftdeck.arms.by_joint import implausible
from aftdeck.bounds import COMPONENT, COORDINATE, Bounds
from aftdeck.errors import InputError
from aftdeck.kinematics.arm import Arm
from aftdeck.scenario.disturbance import MOST_DISTURBANCES, Disturbance
from aftdeck.scenario.in_flight import MOST_CHANGES
from aftdeck.scenario.target import Target
from aftdeck.simulation.camera_drives import CameraDrive
from aftdeck.steering.mode import LawChoice
from aftdeck.tuples import Joints, Vec3
from aftdeck.units import short

AGREED, AGREED_TURN = 1e-3, math.radians(0.01)
"""Allowed difference between a target's pose and the tip's pose at the target's joint angles [m], [rad].

Rounding of the angles to a thousandth of a degree can cause such a difference (assumed).
"""


class Inputs(msgspec.Struct, frozen=True):
    """Sticks and switches of one step. A switch that is None keeps its position. `Inputs()` centres the sticks.

    Sticks act along and about the axes of the present mode; full deflection commands the limit in force. Numbers and
    arrays of NumPy and of learning libraries are allowed too; `simulation.plain` converts them.
    """

    translation: Vec3 = (0.0, 0.0, 0.0)
    """THC along axes 1, 2, 3, each in [-1, 1]."""
    rotation: Vec3 = (0.0, 0.0, 0.0)
    """RHC about axes 1 (roll), 2 (pitch), 3 (yaw), each in [-1, 1]."""
    drive: float = 0.0
    """SINGLE/DIRECT DRIVE switch in [-1, 1]."""
    mode: str | None = None
    """MODE rotary: a panel position."""
    joint: int | None = None
    """JOINT rotary, from 0."""
    rate: Literal["coarse", "vernier"] | None = None
    target: Target | None = None
    """Final pose of OPR CMD, if it is keyed in during this step."""
    law: LawChoice | None = None
    """Switch that selects the steering law of OPR CMD and AUTO 1-4: 1 position, 2 closed loop, 3 open loop."""
    payload_axes: bool | None = None
    """Switch beside ORB LD: True for rotation about payload axes (mode 7), False for orbiter axes (mode 4)."""
    rate_hold: bool = False
    """RATE HOLD pressed in this step: keep the present stick command, or cancel RATE HOLD if it is on."""
    position_hold: bool | None = None
    """POSITION HOLD: keep the tip's position and attitude while the sticks are centred."""
    brakes: bool | None = None
    """BRAKES: True sets the brakes of all joints. Without masses they stop at once; with masses a brake can slip."""
    safing: bool | None = None
    """SAFING: True commands zero joint rates and overrides all other inputs; False is CANCEL."""
    proceed: bool = False
    """AUTO SEQ switch set to PROCEED in this step."""
    stop: bool = False
    """AUTO SEQ switch set to STOP in this step."""
    effector: Literal["stop", "close", "open"] | None = None
    """End effector switch: closes or opens the prong, or makes the snares capture or release."""
    effector_mode: Literal["auto", "manual"] | None = None
    """END EFFECTOR MODE: with auto, the end effector switch moves snares and carriage; with manual, only the snares."""
    rigid: Literal["off", "rigid", "derigid"] | None = None
    """END EFFECTOR MAN CONTR: moves the carriage, and rigidizes or derigidizes, if END EFFECTOR MODE is manual."""
    latch: Literal["latch", "unlatch"] | None = None
    """LATCH or UNLATCH of a berth, pressed in this step: fix the payload in its berth, or release it."""
    telescope: float = 0.0
    """Drive of the telescope in [-1, 1]: +1 longer, -1 shorter."""
    orbiter: Vec3 = (0.0, 0.0, 0.0)
    """Translation of the orbiter along its own axes (forward, starboard, down), each in [-1, 1]."""
    master: Joints | None = None
    """Joint angles of the master arm [rad], which the arm follows in MASTER; with None, no new angles are set."""
    initialise: Literal["full problem", "acquisition", "extraction", "manoeuvring"] | None = None
    """Re-initialisation of arm and payloads in this step, to the start of the full problem or of one of its parts."""
    camera: CameraDrive | None = None
    """Command of a camera's drive in this step; `simulation.camera_drives.Cameras.check` checks it."""
    disturbances: tuple[Disturbance, ...] = ()
    """Forces and torques on bodies in this step, on a plant with masses. The command delay does not delay them.
    `simulation.payloads.disturbances` checks them."""
    changes: dict[str, str] = {}
    """Changes in flight: a value, as TOML or plain text, for each key of the scenario, ``arm.…`` or ``worksite.…``.
    They act from this step on. The command delay does not delay them. `scenario.in_flight` checks them."""
    script: bool = False
    """Whether the scenario's script supplies all inputs except the changes, as with None in place of the inputs."""

    def check(self, arm: Arm) -> None:
        """Check that hand controllers and switches can produce these inputs, which have plain values.

        `simulation.plain.plain_inputs` returns such inputs.

        Raises:
            InputError: a stick is outside [-1, 1] or not finite, a switch does not have the given position, a joint
                does not exist, a text is not printable, an angle or a position is not plausible, or the target's joint
                angles put the tip of `arm` at another pose. The message begins with the name of the field.
        """
        if self.script and self != Inputs(changes=self.changes, script=True):
            raise InputError("script: the script supplies all inputs; only changes can be given with it")
        sticks = (*self.translation, *self.rotation, *self.orbiter, self.drive, self.telescope)
        if not all([-1.0 <= deflection <= 1.0 for deflection in sticks]):
            name = next(name for name in STICKS if not _within_travel(getattr(self, name)))
            raise self._error(name)
        if not _possible(_switches(self)):
            name = next(name for name, value in zip(POSITIONS, _switches(self), strict=True) if not _is(name, value))
            raise self._error(name)
        number = len(arm.joints)
        if self.joint is not None and not 0 <= self.joint < number:
            raise InputError(f"joint: got {short(self.joint)}, expected 0 to {number - 1}")
        if self.mode is not None and not (self.mode.isprintable() and len(self.mode) <= LONGEST_NAME):
            raise self._error("mode")
        if self.master is not None:
            if len(self.master) != number:
                raise InputError(f"master: got {len(self.master)} joint angles, expected {number}")
            if why := implausible(arm.model.slides, self.master):
                raise InputError(f"master: {why}")
        if self.target is not None:
            _check_target(arm, self.target)

    def _error(self, name: str) -> InputError:
        """Return the error about a field."""
        return InputError(f"{name}: got {short(getattr(self, name))}, expected {EXPECTED[name]}")


STICKS = {"translation": 3, "rotation": 3, "orbiter": 3, "drive": 1, "telescope": 1}
"""Number of axes of each stick, by field name."""
others = attrgetter(*(name for name in Inputs.__struct_fields__ if name not in (*STICKS, "changes")))
"""Function that returns the values of an `Inputs` besides sticks and changes."""
NO_OTHERS = others(Inputs())
"""These values if the inputs only move sticks."""
LONGEST_NAME = 64
"""Greatest length of the name of a mode [characters]."""


def _positions() -> dict[str, tuple[object, ...]]:
    """Return the positions of each switch, by field name: the values that the field's type allows, except `None`."""
    positions = {}
    for name, hint in get_type_hints(Inputs).items():
        kind, *none = get_args(hint) or (hint,)
        if none == [type(None)] and (kind is bool or get_origin(kind) is Literal):
            positions[name] = (True, False) if kind is bool else get_args(kind)
    return positions


POSITIONS = _positions()
"""Positions of each switch, by field name."""


_switches = attrgetter(*POSITIONS)
"""Function that returns the positions of all switches of an `Inputs`, in the order of `POSITIONS`."""


@lru_cache(maxsize=256)
def _possible(positions: tuple[object, ...]) -> bool:
    """Return whether each switch has its position, or keeps it."""
    return all(_is(name, position) for name, position in zip(POSITIONS, positions, strict=True))


def _is(name: str, position: object) -> bool:
    """Return whether a switch has a position; None keeps it."""
    return position is None or position in POSITIONS[name]


def _either(positions: Sequence[object]) -> str:
    """Return the positions of a switch as a text, joined by commas and "or"."""
    *others, last = map(str, positions)
    return f"{', '.join(others)} or {last}"


EXPECTED: dict[str, str] = {
    **dict.fromkeys(Inputs.__struct_fields__, "True or False"),
    **{name: f"{count} numbers in [-1, 1]" if count > 1 else "a number in [-1, 1]" for name, count in STICKS.items()},
    **{name: _either(positions) for name, positions in POSITIONS.items()},
    "mode": f"the name of a panel position, printable and of at most {LONGEST_NAME} characters",
    "joint": "the number of a joint, from 0",
    "master": "a finite coordinate of each joint [rad or m]",
    "camera": "a CameraDrive",
    "disturbances": f"at most {MOST_DISTURBANCES} Disturbances: each on a body, with a force (3,) and a torque (3,)",
    "changes": f"at most {MOST_CHANGES} values by their keys, such as {{'limits.por.translation': '0.2 m/s'}}",
    "target": "a Target: a position (3,), a rotation (3, 3), and the joint angles or None",
}
"""What each field allows, for error messages."""


def _within_travel(stick: float | Vec3) -> bool:
    """Return whether all deflections of a stick are in [-1, 1]."""
    return all(-1.0 <= deflection <= 1.0 for deflection in (stick if isinstance(stick, tuple) else (stick,)))


def _is_plausible(value: float, bounds: Bounds) -> bool:
    return bounds.least <= value <= bounds.greatest


def _check_target(arm: Arm, target: Target) -> None:
    """Raise InputError if a number of a target is not plausible, or if its joint angles contradict its pose."""
    position, rotation, joints = target.position, target.rotation, target.joints
    components = tuple(x for row in rotation for x in row)
    for what, values, bounds in (
        ("position", position, COORDINATE),
        ("rotation", components, COMPONENT),
    ):
        wrong = next((value for value in values if not _is_plausible(value, bounds)), None)
        if wrong is not None:
            raise InputError(f"target: {what}: {bounds.problem(wrong, 'm' if bounds is COORDINATE else '')}")
    if joints is None:
        return
    if len(joints) != len(arm.joints):
        raise InputError(f"target: joints: got {len(joints)} joint angles, expected {len(arm.joints)}")
    if why := implausible(arm.model.slides, joints):
        raise InputError(f"target: joints: {why}")
    tip = arm.forward(joints)
    distance = math.dist(tip.position, position)
    chord = math.dist(tip.rotation.ravel(), components)  # detects non-rotations, too
    angle = 2.0 * math.asin(min(1.0, chord / math.sqrt(8.0)))
    if distance > AGREED or angle > AGREED_TURN:
        raise InputError(
            f"target: the joint angles put the tip {distance:.4g} m and {math.degrees(angle):.4g} deg from the pose, "
            f"at most {AGREED:g} m and {math.degrees(AGREED_TURN):g} deg are allowed"
        )

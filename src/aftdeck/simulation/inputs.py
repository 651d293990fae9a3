"""Operator inputs of one control step, from a person, a script or a policy."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from numbers import Integral
from typing import Literal, get_args, get_origin, get_type_hints

import msgspec

from aftdeck.errors import InputError
from aftdeck.kinematics.arm import Arm
from aftdeck.scenario.target import Target
from aftdeck.simulation.camera_drives import CameraDrive
from aftdeck.steering.mode import LawChoice
from aftdeck.tuples import Six, Vec3

JOINTS = 6
AGREED, AGREED_TURN = 1e-3, math.radians(0.01)
"""Allowed difference between a target's pose and the tip's pose at the target's joint angles [m], [rad].

Rounding of the angles to a thousandth of a degree can cause such a difference (assumed).
"""


class Inputs(msgspec.Struct, frozen=True):
    """Sticks and switches of one step. A switch that is None keeps its position. `Inputs()` centres the sticks.

    Sticks act along and about the axes of the present mode; full deflection commands the limit in force. Numbers and
    arrays of NumPy are allowed too; `simulation.plain` converts them.
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
    """JOINT rotary, 0 to 5."""
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
    """BRAKES: True stops every joint immediately and keeps it stopped."""
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
    master: Six | None = None
    """Six joint angles of the master arm [rad], which the arm follows in MASTER; with None, no new angles are set."""
    initialise: Literal["full problem", "acquisition", "extraction", "manoeuvring"] | None = None
    """Re-initialisation of arm and payloads in this step, to the start of the full problem or of one of its parts."""
    camera: CameraDrive | None = None
    """Command of a camera's drive in this step; `simulation.camera_drives.Cameras.check` checks it."""

    def check(self, arm: Arm) -> None:
        """Check that hand controllers and switches can produce these inputs.

        Raises:
            InputError: a stick is outside [-1, 1] or not finite, a switch does not have the given position, a joint
                does not exist, a master angle is not finite, the target is not a pose, or the target's joint angles
                put the tip of `arm` at another pose. The message begins with the name of the field.
        """
        for name, count in _STICKS.items():
            value = getattr(self, name)
            numbers = _numbers(value if count > 1 else (value,), count)
            if not numbers or not all(-1.0 <= s <= 1.0 for s in numbers):
                expected = f"{count} numbers" if count > 1 else "a number"
                raise InputError(f"{name}: got {value!r}, expected {expected} in [-1, 1]")
        if self.master is not None and not _numbers(self.master, JOINTS):
            raise InputError(f"master: got {self.master!r}, expected six finite joint angles [rad]")
        if self.joint is not None and not _numbered(self.joint):
            raise InputError(f"joint: got {self.joint!r}, expected 0 to 5")
        for name, positions in POSITIONS.items():
            if (value := getattr(self, name)) is not None and value not in positions:
                raise InputError(f"{name}: got {value!r}, expected {_either(positions)}")
        if not isinstance(self.mode, str | None):
            raise InputError(f"mode: got {self.mode!r}, expected the name of a panel position")
        if not isinstance(self.camera, CameraDrive | None):
            raise InputError(f"camera: got {self.camera!r}, expected a CameraDrive")
        if self.target is not None:
            _check_target(arm, self.target)


_STICKS = {"translation": 3, "rotation": 3, "orbiter": 3, "drive": 1, "telescope": 1}
"""Number of axes of each stick, by field name."""


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


def _either(positions: Sequence[object]) -> str:
    """Return the positions of a switch as a text, joined by commas and "or"."""
    *others, last = map(str, positions)
    return f"{', '.join(others)} or {last}"


def _numbered(joint: object) -> bool:
    """Return whether `joint` is a valid joint number, 0 to 5."""
    return isinstance(joint, Integral) and 0 <= int(joint) < JOINTS


def _numbers(values: object, count: int) -> list[float]:
    """Return `values` as a list of `count` finite numbers; an empty list if they are anything else."""
    if isinstance(values, str) or not isinstance(values, Iterable):
        return []
    try:
        numbers = [float(value) for value in values]
    except (TypeError, ValueError):
        return []
    return numbers if len(numbers) == count and all(map(math.isfinite, numbers)) else []


def _check_target(arm: Arm, target: Target) -> None:
    """Raise InputError if a target is not a pose, or if its joint angles contradict its pose."""
    position, rotation, joints = target.position, target.rotation, target.joints
    sizes = (len(position), *(len(row) for row in rotation), 6 if joints is None else len(joints))
    if sizes != (3, 3, 3, 3, 6):
        raise InputError(
            f"target: got {target}, expected a position (3,), a rotation (3, 3), and six joint angles or None"
        )
    numbers = (*position, *(x for row in rotation for x in row), *(() if joints is None else joints))
    if not all(map(math.isfinite, numbers)):
        raise InputError(f"target: got {target}, expected finite numbers")
    if joints is None:
        return
    tip = arm.forward(joints)
    distance = math.dist(tip.position, position)
    chord = math.dist(tip.rotation.ravel(), [x for row in rotation for x in row])  # detects non-rotations, too
    angle = 2.0 * math.asin(min(1.0, chord / math.sqrt(8.0)))
    if not (distance <= AGREED and angle <= AGREED_TURN):  # an overflow gives NaN, which is also rejected
        raise InputError(
            f"target: the joint angles put the tip {distance:.4g} m and {math.degrees(angle):.4g} deg from the pose, "
            f"at most {AGREED:g} m and {math.degrees(AGREED_TURN):g} deg are allowed"
        )

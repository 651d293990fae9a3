"""Welcome message: all data that stays the same while a scenario runs, from joint limits to the drawn shapes."""

from __future__ import annotations

from typing import Literal

import msgspec

from aftdeck.bodies.cameras import Camera
from aftdeck.scenario.light import LightCondition
from aftdeck.scenario.schema import Plant
from aftdeck.scenario.task_file import DeskGroup, Use
from aftdeck.shapes import Shape
from aftdeck.station.messages.kinds import ProblemPart, WireMessage
from aftdeck.tuples import Joints, Vec3


class JointInfo(msgspec.Struct, frozen=True):
    """Joint of the arm: names, limits [rad], rate limits [rad/s] and torque limits [N m].

    A joint that slides has [m], [m/s] and [N] in their places, here and in frames.
    """

    name: str
    """Name in the arm file: ``shoulder_yaw``."""
    label: str
    """Name on the page: ``Sho yaw``."""
    stick: str | None
    """Axis of the hand controllers that moves this joint of the master arm: ``THC Y``; null if no axis moves it."""
    slides: bool
    """Whether the joint slides along its axis; otherwise it turns about it."""
    hard: tuple[float, float]
    soft: tuple[float, float]
    reach: tuple[float, float]
    coarse: float
    vernier: float
    servo: float
    torque: float | None
    """Greatest torque of the motor; null on the kinematic plant."""
    holding: float | None
    """Greatest torque of the brake; null on the kinematic plant."""


class ModeInfo(msgspec.Struct, frozen=True):
    """Position of the MODE rotary."""

    position: str
    """Name as printed on the panel: ``ORB UNL``."""
    laws: tuple[int, ...]
    """Steering laws of this position, the default first; 0 for TEST, 9 for DIRECT, 10 for MASTER."""
    title: str
    """Motion in this mode, in a few words: ``tip along its own axes``."""
    kind: Literal["automatic", "manual", "single", "test", "master"]
    point: str
    """Point that this mode moves: ``tip``, ``payload``."""
    enabled: bool
    """False only for a mode of AUTO 1-4 without stored points in this scenario.

    A mode that moves a payload also needs a captured payload; this value does not include that condition.
    """
    axes: str
    """Axes along which the sticks act: ``orbiter axes``."""
    axis_names: tuple[str, str, str]
    """Meaning of + for the three axes of the THC: ``+X fwd``, ``+Y stbd``, ``+Z down``."""


class BodyInfo(msgspec.Struct, frozen=True):
    """Rigid body to draw; its pose is in `Display.poses`, at the body's index in `Welcome.bodies`."""

    name: str
    shapes: tuple[Shape, ...]
    details: tuple[Shape, ...]
    """Shapes that only decorate the body: they hide nothing in the survey of cameras, and ghosts do not have them."""


class FlexureInfo(msgspec.Struct, frozen=True):
    """Part of the arm that bends: the base or a boom; its bend is in `Dynamics.bends`, at the same index."""

    body: int
    """Index in `Welcome.bodies` of the body that carries the part."""
    end: Vec3
    """Place of the part's end in this body, as long as the part is straight [m]; zero for the base."""


class StandInfo(msgspec.Struct, frozen=True):
    """Telescope under an arm: minimum and maximum length, and rate."""

    least: float
    """Minimum length [m]."""
    greatest: float
    """Maximum length [m]."""
    rate: float
    """Rate of the length [m/s]."""


class SeatInfo(msgspec.Struct, frozen=True):
    """Berth: location where a payload can be fixed."""

    name: str
    """Name of the berth in frames (`Cargo.seat`)."""
    title: str
    """Name for display."""


class WorkInfo(msgspec.Struct, frozen=True):
    """Equipment of arm and worksite, and thresholds of the clearance."""

    hand: Literal["prong", "snares"]
    """Kind of the arm's end effector."""
    effector: tuple[str, ...]
    """Names of the end effector's bodies: the one that carries the tip, then a prong."""
    stand: StandInfo | None
    """Telescope under the arm; null if the arm has no telescope."""
    cargo: tuple[str, ...]
    """Names of the payloads; each payload has a body of the same name."""
    seats: tuple[SeatInfo, ...]
    """Berths of the worksite."""
    parts: tuple[ProblemPart, ...]
    """Task phases at which the operator can re-initialise; ``full problem`` is the start."""
    caution: float
    """Clearance below which the page shows a caution [m]."""
    warning: float
    """Clearance below which the page shows a warning [m]."""


class PayloadInfo(msgspec.Struct, frozen=True):
    """Row of the payload table (SPEC 94 item 3): rate limits with this payload captured."""

    id: int
    """PL ID; 0 is the row without a payload."""
    name: str
    mass: float
    """Mass [kg]."""
    translation: tuple[float, float]
    """Speed limit of the point of resolution, coarse and vernier [m/s]."""
    rotation: tuple[float, float]
    """Angular rate limit of the point of resolution, coarse and vernier [rad/s]."""
    coarse: Joints
    """Joint rate limits in SINGLE, DIRECT and MASTER with the rate setting coarse [rad/s]."""
    vernier: Joints
    """Joint rate limits in SINGLE, DIRECT and MASTER with the rate setting vernier [rad/s]."""


class StoredPoint(msgspec.Struct, frozen=True):
    """Stored point of AUTO 1-4, in panel components."""

    position: Vec3
    """X, Y, Z [m]."""
    attitude: Vec3
    """Pitch, yaw, roll [rad], each in [0, 2 pi)."""
    pause: bool
    """True if the sequence waits for PROCEED at this point; false for a fly-by point."""


class StoredSequence(msgspec.Struct, frozen=True):
    """Stored points of one mode, AUTO 1 to 4 (SPEC 94 items 13-16)."""

    position: str
    """Position of the MODE rotary, as in `ModeInfo.position`."""
    points: tuple[StoredPoint, ...]


class UseInfo(msgspec.Struct, frozen=True):
    """Function of the controls that a step of the task needs."""

    use: Use
    does: str
    """Effect of the function in this step, in one or two words."""


class HintInfo(msgspec.Struct, frozen=True):
    """Text that replaces a step's text in a certain state."""

    text: str
    uses: tuple[UseInfo, ...]


class StepInfo(msgspec.Struct, frozen=True):
    """Step of the operator's task.

    In the texts, `{+X}` stands for the key or button of a function, `{0.05 m}` for a length, `{wanting}` for the first
    condition that fails; `*...*` quotes a text on the desk.
    """

    title: str
    text: str
    mode: str | None
    """Position of the MODE rotary that the step needs; null if any will do."""
    uses: tuple[UseInfo, ...]
    groups: tuple[DeskGroup, ...]
    """Groups of the desk that the step needs."""
    cameras: tuple[str, ...]
    """The two cameras that show the step best; empty if the scenario names none."""
    hints: tuple[HintInfo, ...]


class Welcome(WireMessage, frozen=True, tag="welcome"):
    """Answer to `Hello`, sent again when the scenario changes: all data that stays the same in a session."""

    protocol: int
    version: str
    scenario: str
    title: str
    text: str
    """Task of the operator in this scenario, in a sentence or two."""
    arm: str
    plant: Plant
    """Model that turns commanded rates into motion."""
    control_period_s: float
    command_delay_s: float
    """Time from a command to its arrival at the arm [s]."""
    telemetry_delay_s: float
    """Delay with which the page displays numbers, lamps and log [s]."""
    camera_delay_s: float
    """Delay with which the page displays pictures [s]."""
    units: Literal["ft-in", "SI"]
    """Units of the panel's read-outs, as given in the arm file."""
    joints: tuple[JointInfo, ...]
    modes: tuple[ModeInfo, ...]
    bodies: tuple[BodyInfo, ...]
    flexures: tuple[FlexureInfo, ...]
    """Parts of the arm that bend, from the base to the wrist; empty if nothing bends."""
    ghost: tuple[int, ...]
    """Indices of the bodies whose poses are in `Ahead.poses`."""
    cameras: tuple[Camera, ...]
    work: WorkInfo
    conditions: tuple[LightCondition, ...]
    """Light conditions that the operator can select: directions of sun and Earth."""
    lamps: tuple[str, ...]
    """Names of the lamps of this scenario."""
    payloads: tuple[PayloadInfo, ...]
    """Payload table by PL ID, from 0."""
    sequences: tuple[StoredSequence, ...]
    singularities: tuple[str, ...]
    """Names of the arm's singularities, in the order of `Frame.singularity`."""
    singular: float
    """Normalised distance from a singularity; the page shows a caution below this value."""
    steps: tuple[StepInfo, ...]
    """Steps of the operator's task; empty if the scenario describes none."""
    next: str
    """Name of the scenario that the page proposes after the last step; empty if it proposes none."""
    phases: tuple[str, ...] = ()
    """Names of the script's phases in order, as in `Frame.phase`.

    Empty if the scenario has no script, or if the session does not begin with the script.
    """

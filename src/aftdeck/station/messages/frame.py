"""Frame message to a page: the simulation's frame, and the data that the page needs to display it."""

from __future__ import annotations

from operator import attrgetter
from typing import Literal, NamedTuple

import msgspec

from aftdeck.report.grade import Grade
from aftdeck.report.lamps import Lamp
from aftdeck.scenario.light import Lighting
from aftdeck.simulation import frame as sim
from aftdeck.station.messages.kinds import Quat
from aftdeck.station.messages.measure import Measure
from aftdeck.tuples import Vec3


class Resolution(msgspec.Struct, frozen=True, gc=False):
    """Point of resolution, in panel components."""

    position: Vec3
    """X, Y, Z [m]."""
    attitude: Vec3
    """Pitch, yaw, roll [rad], each in [0, 2 pi)."""
    velocity: Vec3
    """Rate of X, Y, Z [m/s]."""
    turn_rate: Vec3
    """Angular velocity about panel pitch, yaw, roll axes [rad/s]."""


class Aim(msgspec.Struct, frozen=True, gc=False):
    """Target of an automatic mode, in panel components; `Frame.goal` has the remaining distance and angle."""

    position: Vec3
    attitude: Vec3


class ClosestPoints(msgspec.Struct, frozen=True, gc=False):
    """Closest points of two monitored parts, in the scene frame."""

    point_a: Vec3
    point_b: Vec3
    plane: Vec3
    """Point of the separating plane, halfway between the closest points."""
    normal: Vec3
    """Unit normal of this plane, from a to b; zero if the parts overlap."""


class Push(msgspec.Struct, frozen=True, gc=False):
    """Force between two parts in contact, or of a disturbance, in the scene frame."""

    point: Vec3
    """Point at which the force acts [m]."""
    force: Vec3
    """Force on the second part, or on the disturbed body [N]."""


class Ahead(msgspec.Struct, frozen=True):
    """Look-ahead: predicted state of the arm after some seconds with the present stick command.

    The station computes it every 10 control steps: five times a second with the default control period.
    """

    seconds: float
    """Time span of the look-ahead [s]."""
    held: bool
    """True if the look-ahead was computed with the present stick command.

    False under BRAKES or SAFING, and if the sticks are centred. In the last case, the look-ahead may assume full
    deflection of the axis that was deflected last.
    """
    moves: bool
    """True if the arm's pose at the end of the time span differs from the present pose."""
    clearance: float | None
    """Minimum clearance at the end of the time span [m]; null if no pair then counts for CLEARANCE."""
    a: str
    """`a` and `b`: the two parts with this clearance; empty if `clearance` is null."""
    b: str
    contact_s: float | None
    """Time to the first contact [s]; null if the look-ahead found no contact."""
    stopping: float
    """Distance that the tip still moves if the sticks are centred now [m]."""
    joint: int
    """Joint nearest to a reach limit at the end of the time span, from 0."""
    room: float
    """Motion from this joint to its reach limit at the end of the time span [rad or m]; negative past the limit."""
    poses: tuple[float, ...]
    """Seven numbers for each body of `Welcome.ghost`, as in `Display.poses`."""


AutopilotName = Literal["script", "policy", "synthetic operator"]
"""What flies until a stick moves, named for the operator."""


class TaskPair(msgspec.Struct, frozen=True, gc=False):
    """Two parts that the present step of the task brings together, or takes apart."""

    a: str
    b: str
    clearance: float
    """Distance of the two parts [m]; negative if they overlap."""
    closing: float
    """Speed at which their closest points approach each other [m/s]; negative if they separate."""


class ToGo(msgspec.Struct, frozen=True, gc=False):
    """Remaining motion to the place where the task needs the tip or the held payload."""

    to: str
    """The place: ``pin``, ``bar``, a berth's title, ``target``, or a joint's name."""
    translation: Vec3 | None
    """Displacement of the point that the sticks move, along the axes of the sticks [m]; null without sticks."""
    rotation: Vec3 | None
    """Rotation vector about the axes of the sticks: roll, pitch, yaw [rad]; null without sticks."""
    distance: float
    """Distance to the place, or of a joint that slides [m]; 0 for a joint that turns."""
    angle: float
    """Rotation that is left [rad]; for a joint, its signed motion [rad or m]."""
    near: tuple[float, float]
    """Distance [m] and angle [rad] within which the place is reached; for a joint that slides, a length twice."""
    closing: float | None
    """Speed at which the distance becomes smaller [m/s]; negative if it grows, null if it is not known."""
    shift: tuple[float, ...]
    """Motion of the tip, and of a held payload, to the place, in the scene frame: x, y, z [m], then w, x, y, z.

    Empty if a joint has to move.
    """


class Debrief(msgspec.Struct, frozen=True):
    """Result of a run, when all steps of the task are past."""

    grade: Grade | None
    """A without faults; each kind of fault lowers the grade by one. Null if a step was skipped or the script flew."""
    faults: tuple[str, ...]
    """Kinds of faults: ``2 warnings by CLEARANCE``."""
    figures: tuple[Measure, ...]
    """Values that summarise the run."""


class TaskNow(msgspec.Struct, frozen=True, gc=False):
    """Progress through `Welcome.steps`."""

    at: int
    """Index of the present step; the number of steps when all are past."""
    hint: int
    """Index of the present step's hint that applies; -1 for the step's own text."""
    first: int
    """Index of the step at which the run began; above 0 after a re-initialisation to a part of the problem."""
    done_s: tuple[float | None, ...]
    """For each step, the simulated time at which it was completed [s]; null if it is open or was skipped."""
    debrief: Debrief | None = None
    """Result of the run; null until all steps are past."""


class CameraStep(NamedTuple):
    """Step whose picture of a camera the pages show."""

    camera: str
    step: int


class LinkSteps(msgspec.Struct, frozen=True, gc=False):
    """Number of a step, and the steps that the pages show when it has been made.

    The numbers count all steps of a session from 1; a restart does not reset them. A page shows the newest frame that
    it has up to a step, or else its first one. A number below 1 belongs to no step: nothing has arrived yet.
    """

    step: int
    """Number of the step itself."""
    telemetry: int
    """Step whose values, lamps and log the pages show."""
    pictures: int
    """Step that the pictures of all cameras show, except those in `cameras`."""
    cameras: tuple[CameraStep, ...]
    """Cameras whose pictures show another step."""

    def of(self, camera: str) -> int:
        """Return the step that the picture of a camera shows."""
        return next((own.step for own in self.cameras if own.camera == camera), self.pictures)


class Display(msgspec.Struct, frozen=True):
    """Data that a page needs to display a frame: read-outs in panel components, lamps, and poses in the scene frame."""

    link: LinkSteps | None
    """Steps that the page shows; null in a replay, which shows this step."""
    stick_seq: int
    """`seq` of the last `Sticks` received before this step; the page computes the latency from this number."""
    flown_seq: int
    """`seq` of the `Sticks` that acted in this step, after the command delay; -1 if no page's `Sticks` acted."""
    autopilot: AutopilotName | None
    """What supplied the inputs of this step, until a stick moves; null with the inputs of a page."""
    recording_s: float | None
    """Simulated time in the recording so far [s]; null if the run is not recorded."""
    actual: Resolution
    commanded: Resolution
    aim: Aim | None
    """Target of an automatic mode."""
    payload_id: int
    """PL ID of the captured payload, as in `Welcome.payloads`; 0 if there is none."""
    por_offset: Vec3
    """Vector from the tip to the point of resolution of ORB LD and PL, in the end effector's axes [m]."""
    task_pair: TaskPair | None
    """Newest pair that the present step of the task brings together, or takes apart; null if there is none."""
    to_go: ToGo | None
    """Remaining motion; null if there is no place to move to."""
    task: TaskNow | None
    """Progress through the task; null in a replay."""
    orbiter: Vec3
    """Displacement of the orbiter: forward, starboard, down [m]."""
    orbiter_velocity: Vec3
    """Velocity of the orbiter along the same axes [m/s]."""
    lamps: tuple[Lamp, ...]
    gap: ClosestPoints | None
    """Closest points of `Work.nearest`."""
    contacts: tuple[ClosestPoints, ...]
    """Closest points of each contact, in the order of `Work.contacts`."""
    pushes: tuple[Push, ...]
    """Forces between parts in contact, in the order of `Dynamics.contacts`, then those of `Dynamics.disturbances`."""
    ahead: Ahead | None
    """Newest look-ahead; null before the first one."""
    axes: Quat
    """Orientation of the control frame in the scene frame; the page draws these axes in the pictures."""
    poses: tuple[float, ...]
    """Seven numbers for each body, in the order of `Welcome.bodies`: x, y, z [m], w, x, y, z, in the scene frame."""
    lighting: Lighting


class Frame(sim.Frame, frozen=True, kw_only=True, tag_field="type", tag="frame"):
    """All data that the page shows of one control step. The server may skip frames and sends the newest one."""

    display: Display


_fields = attrgetter(*sim.Frame.__struct_fields__)


def with_display(frame: sim.Frame, display: Display) -> Frame:
    """Return a frame of the simulation as a message to a page."""
    return Frame(*_fields(frame), display=display)

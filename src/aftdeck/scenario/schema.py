"""Types of a scenario file. A bare number is in SI units; a string contains its unit."""

from __future__ import annotations

from typing import Annotated, Any, Literal

import msgspec

from aftdeck.arms.body_file import Cover
from aftdeck.arms.constant import Text
from aftdeck.arms.model import (
    RiseTime,
    TipRate,
    TipSpeed,
)
from aftdeck.bounds import COMPONENT, Bounds
from aftdeck.scenario.task_file import DeskGroup, HintSpec, StateSpec, StickAxis
from aftdeck.shapes import Shape
from aftdeck.units import (
    Acceleration,
    Angle,
    AngularAcceleration,
    AngularRate,
    Coordinate,
    CoordinateAcceleration,
    CoordinateRate,
    Force,
    Length,
    Mass,
    Speed,
    Time,
    Torque,
)
from aftdeck.worksite.file.cargo_file import StartFile
from aftdeck.worksite.file.mass_file import MassTable
from aftdeck.worksite.model import OrbiterMotion

Stick = Annotated[float, Bounds(-1.0, 1.0, "1 is the full deflection")]
Sticks = tuple[Stick, Stick, Stick]
JointAngles = tuple[Coordinate, ...]
"""Coordinate of each joint, from base to tip. Their number and kinds are those of the arm (`scenario.by_joint`)."""
JointRanges = tuple[tuple[Coordinate, Coordinate], ...]
"""Least and greatest coordinate of each joint."""
Point = tuple[Length, Length, Length]
Velocity = tuple[Speed, Speed, Speed]
AngularVelocity = tuple[AngularRate, AngularRate, AngularRate]
_SOON = "the Shuttle's arm reaches its speed within seconds"
TipAcceleration = Annotated[Acceleration, Bounds(1e-6, 100.0, _SOON)]
TipAngularAcceleration = Annotated[AngularAcceleration, Bounds(1e-6, 100.0, _SOON)]
Delay = Annotated[Time, Bounds(0.0, 30.0, "a signal to the Moon and back takes 2.6 s")]
Component = Annotated[float, COMPONENT]
Row = tuple[Component, Component, Component]
_FAST_JOINT = "the Shuttle's joints turn at 0.09 rad/s at most, small arms at about 1 rad/s"
_JOINT_SOON = "a joint reaches its greatest rate in 0.1 s to minutes"
JointRate = Annotated[CoordinateRate, Bounds(1e-6, 10.0, _FAST_JOINT)]
"""Limit of a joint's rate."""
JointAcceleration = Annotated[CoordinateAcceleration, Bounds(1e-6, 100.0, _JOINT_SOON)]
"""Limit of a joint's acceleration."""
StartRates = tuple[CoordinateRate, ...]
"""Rate of each joint at the start, in either direction."""
Rate = Literal["coarse", "vernier"]
PayloadEvent = Literal["captured", "released", "latched", "unlatched"]
"""Events of the payloads: one is captured, released, latched in its berth, or unlatched."""
Until = Literal[PayloadEvent, "at rest"]
"""Events for which a phase may wait: one of a payload, or that the arm is at rest (manual modes)."""
ScenarioGroup = Literal["learn", "fly", "study"]
"""Groups of the list of scenarios: lessons, missions, and motions to examine."""
Plant = Literal["kinematic", "rigid", "flexible"]
"""Models that turn commanded rates into motion: without masses, with rigid bodies, with bending booms and gearboxes."""
FreeContact = Literal["stop", "reflect"]
"""Effect of a contact on a floating payload."""


class _Part(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A table of a scenario file; unknown fields are rejected."""


class PoseSpec(_Part, frozen=True):
    """A pose of the tip, by joint angles or by position and orientation.

    With `joints`, the pose is the tip's pose at these joint angles. Without `joints`, the pose has a `position` and an
    orientation, both in the coordinate frame `frame`. The orientation is given by the angles `roll`, `pitch`, `yaw`, or
    by a `matrix` whose columns are the rotated axes (the report's S1 = 0). In the orbiter frame and in L, the
    orientation is that of frame 7, and the angles are ENDORI's roll, elevation, azimuth. In the panel frame, the
    orientation is the end effector's attitude, and the angles are applied in the order pitch, yaw, roll. The panel
    frame has X = -Xo, Y = Yo, Z = -Zo.

    A phase's target, and the pose at which a run starts, may also be given relative to the present poses of objects:

    - `cargo` names a payload. At the pose, the end effector can capture this payload.
    - `seat` names a berth. When the end effector is at the pose, the held payload is in this berth.
    - `above` is a distance. With `cargo`, it moves the pose back along the end effector's axis. With `seat`, it moves
      the pose up out of the bay, or out from the port.
    - `offset` displaces the pose along the axes of the payload (`cargo`) or of the berth (`seat`).
    - `frame` may name a body, a berth or a payload. Position and orientation, given as in L, are then in the axes of
      this object.
    """

    joints: JointAngles | None = None
    position: Point | None = None
    frame: Text = "orbiter"
    roll: Angle | None = None
    pitch: Angle | None = None
    yaw: Angle | None = None
    matrix: tuple[Row, Row, Row] | None = None
    cargo: Text | None = None
    seat: Text | None = None
    above: Length | None = None
    offset: Point | None = None


class GraspSpec(_Part, frozen=True):
    """A payload of the worksite that the end effector holds at the start, and the joint angles at its capture.

    At the capture, the payload was at its own start pose. The joint angles at the capture are given either by `joints`,
    or by the distance `above` of the end effector from the payload, as in `PoseSpec`. If several sets of joint angles
    are possible, the set nearest to `near` in `Initial` is used. `stand` is the length of the telescope at the
    capture.
    """

    cargo: Text
    joints: JointAngles | None = None
    above: Length | None = None
    stand: Length | None = None


class Initial(_Part, frozen=True):
    """Initial state of the arm (RMSIST).

    `joints` or a `pose` gives the joint angles. Of several sets of joint angles for a pose, the set nearest to `near`
    is used. `rates` are the joint rates. `stand` is the length of the telescope. `grasped` describes a payload that the
    end effector holds.
    """

    joints: JointAngles | None = None
    rates: StartRates | None = None
    pose: PoseSpec | None = None
    near: JointAngles | None = None
    stand: Length | None = None
    grasped: GraspSpec | None = None


class CargoSpec(MassTable, frozen=True, kw_only=True):
    """A payload of the worksite's file that is present in the run.

    `start`, `mass`, `inertia` with its `products`, and `centre_of_mass` replace that file's values. If `mass` is given
    without `inertia`, the tensor of inertia changes in proportion to it.
    """

    name: Text
    start: StartFile | None = None
    mass: Mass | None = None


class InitialiseSpec(_Part, frozen=True):
    """Initial states for the parts of the problem to which a run can be re-initialised (the report's input 2)."""

    acquisition: Initial | None = None
    extraction: Initial | None = None
    manoeuvring: Initial | None = None


class ClearanceSpec(_Part, frozen=True):
    """Clearances below which the page shows a caution and a warning.

    While the arm is not stretched out, the clearance between the Shuttle's upper boom and the sill's fittings is a
    little more than the default of `caution`. With a greater default, the caution would always be lit.
    """

    caution: Length = Length(0.5)
    warning: Length = Length(0.15)


class LightSpec(_Part, frozen=True):
    """Light at the worksite at the start: a condition by name, and the lamps that are lit.

    `condition` is `high sun` (the default), `low sun`, `night` or `terminator`, as defined in `scenario/light.toml`.
    `lamps` names the lamp switches that are on; without `lamps`, all are on. The orbiter has the switches `fwd floods`,
    `mid floods` and `aft floods`; the Shuttle's arm has `end effector`.
    """

    condition: Text | None = None
    lamps: tuple[Text, ...] | None = None


class CameraSpec(_Part, frozen=True):
    """Setting of a camera's drive at the start.

    `pan` is positive to the right in the picture, `tilt` is positive upwards, and `zoom` is the horizontal field of
    view. The page shows these three numbers in the camera's picture. An angle that is not given is the camera's own.
    """

    pan: Angle | None = None
    tilt: Angle | None = None
    zoom: Angle | None = None


class PorOverride(_Part, frozen=True):
    """Limits of the point of resolution. For every payload, they replace the arm's limits.

    The limits of acceleration are given in one of two forms: by `reached_in`, the time from rest to the coarse limits
    of translation and rotation, or by `acceleration` and `angular_acceleration`, the report's limits V_L_dot and
    omega_L_dot.
    """

    translation: TipSpeed | None = None
    vernier_translation: TipSpeed | None = None
    rotation: TipRate | None = None
    vernier_rotation: TipRate | None = None
    reached_in: RiseTime | None = None
    acceleration: TipAcceleration | None = None
    angular_acceleration: TipAngularAcceleration | None = None


class RatesOverride(_Part, frozen=True):
    """Limits of rates and accelerations of the joints, and limits of the point of resolution (`por`).

    A scenario's limits replace the arm's limits. A phase's limits replace the scenario's limits.
    """

    servo: tuple[JointRate, ...] | None = None
    coarse: tuple[JointRate, ...] | None = None
    vernier: tuple[JointRate, ...] | None = None
    acceleration: tuple[JointAcceleration, ...] | None = None
    por: PorOverride = PorOverride()


class LimitsOverride(RatesOverride, frozen=True):
    """Limits of a scenario that replace the limits in the arm's file."""

    hard: JointRanges | None = None
    soft: JointRanges | None = None
    reach: JointRanges | None = None


CONTROL_PERIOD = Bounds(0.001, 0.2, "the arm's own computer ran at 0.08 s")
"""Plausible duration of a control step [s]."""


class DynamicsSpec(_Part, frozen=True):
    """Properties of a plant with masses; the kinematic plant ignores them.

    `orbiter` is `free` if the orbiter reacts to the arm's motion and drifts, `held` if jets hold its attitude besides,
    and `fixed` if it keeps its position and attitude. Without `orbiter`, it moves as the worksite's file says (`motion`
    in ``[orbiter]``), and is fixed if its mass is not known.
    `inhibit` tells whether a detrimental contact also inhibits the arm, as on the kinematic plant.
    """

    orbiter: OrbiterMotion | None = None
    inhibit: bool = False


class AttachedSpec(MassTable, frozen=True, kw_only=True):
    """A payload that the scenario attaches to the end effector.

    `position` is r_87, the vector from the tip to the payload's centre, in payload axes. `roll`, `pitch`, `yaw` or a
    `matrix` give the rotation from frame 7 to the payload's axes (T_78). The angles are ENDORI's roll, elevation,
    azimuth; azimuth is applied first. `por` is the vector from the payload's centre to its point of resolution, in
    payload axes. Without `inertia`, the payload has that of a uniform box around its `body` entries, or of a cylinder
    with 1/4 of its length as diameter and the density of 65,000 lb in 60 x 15 ft, its axis along payload axis 1.
    """

    mass: Mass
    position: Point = (Length(0.0), Length(0.0), Length(0.0))
    roll: Angle = Angle(0.0)
    pitch: Angle = Angle(0.0)
    yaw: Angle = Angle(0.0)
    matrix: tuple[Row, Row, Row] | None = None
    por: Point = (Length(0.0), Length(0.0), Length(0.0))


class PayloadSpec(AttachedSpec, frozen=True, kw_only=True):
    """A payload that is attached to the end effector from the start and is never released.

    The `shape` entries are drawn. The `body` entries collide; they enclose the drawn shapes. Both kinds of entries are
    given relative to the payload's centre.
    """

    shape: tuple[Shape, ...] = ()
    body: tuple[Cover, ...] = ()


class Phase(_Part, frozen=True):
    """One phase of the script: a mode, the operator's inputs in the phase, and the end of the phase.

    The mode is a position of the MODE rotary, or the report's number, 1 to 8. `law` selects one of the report's modes 1
    to 3 in OPR CMD and AUTO 1-4. `payload_axes` selects mode 7 instead of mode 4 in ORB LD.

    OPR CMD needs a `target`. AUTO 1-4 use their stored points; the script gives PROCEED at every pause point. A phase
    in these modes ends when the arm arrives at the target, or at the last point. `duration` is the longest time
    allowed.

    Manual modes take stick positions; the phase ends after `duration`. SINGLE and DIRECT take a `joint` and either
    `drive` with a `duration`, or `joint_at`, the angle to which the joint moves. MASTER takes the angles of the
    `master` arm; the phase ends when the arm has reached these angles.

    Instead of stick positions, manual modes take `velocity` (V_C') and `angular_velocity` (omega_C'), along and about
    the axes in which the sticks act. Instead of `drive`, SINGLE and DIRECT take `joint_rate` (theta_dot_C'). A value
    beyond the present limits is reduced to the limit, in the same direction.

    `limits` are the limits during the phase (V_L, omega_L, V_L_dot, omega_L_dot, theta_dot_L). With inputs from an
    operator instead of the script, the scenario's limits apply. A `payload` (PA, T_78, r_87) is attached from the
    beginning of this phase until a later phase gives another `payload` or `detached`.

    In every mode a phase may set the `effector` switch and the switches BRAKES (`brakes`) and SAFING (`safing`), press
    `latch`, move the telescope to `stand_at`, translate the `orbiter`, and wait `until` an event has occurred. With
    `stand_at` or `until`, `duration` is the longest time allowed. `until = "at rest"`, in manual modes only, waits
    until the tip is at rest after a command; without masses, the arm is at rest at once.
    """

    mode: int | Text
    name: str = ""
    rate: Rate = "coarse"
    translation: Sticks = (0.0, 0.0, 0.0)
    rotation: Sticks = (0.0, 0.0, 0.0)
    velocity: Velocity | None = None
    angular_velocity: AngularVelocity | None = None
    joint: str | None = None
    drive: Stick = 0.0
    joint_rate: CoordinateRate | None = None
    joint_at: Coordinate | None = None
    target: PoseSpec | None = None
    law: Literal["position", "closed loop", "open loop"] | None = None
    payload_axes: bool | None = None
    master: JointAngles | None = None
    effector: Literal["stop", "close", "open"] | None = None
    latch: Literal["latch", "unlatch"] | None = None
    brakes: bool | None = None
    safing: bool | None = None
    stand_at: Length | None = None
    orbiter: Sticks = (0.0, 0.0, 0.0)
    limits: RatesOverride = RatesOverride()
    payload: AttachedSpec | None = None
    detached: bool = False
    until: Until | None = None
    duration: Time | None = None


class DisturbanceSpec(_Part, frozen=True):
    """A force and a torque that act on a body for a time, on a plant with masses.

    `on` is `tip`, `orbiter`, the name of a payload of the worksite, or `payload` for the payload that the scenario
    itself attaches. The disturbance acts from the time `begin` of the run for `duration`, with every operator. `force`
    acts at the point `at`: of a payload, from its centre in its axes; of the tip, from the tip in frame 7; of the
    orbiter, in the orbiter frame. Without `at`, it acts at the tip itself, or at the body's centre of mass. `torque`
    acts in addition.

    `frame` gives the axes of both: `orbiter`, `panel`, `L`, `space` (the axes of L at the start of the run, which do
    not turn), `tip` (frame 7) or the name of a payload. Force and torque are constant within a control period, in the
    axes at its beginning. In a period of which the disturbance covers a part, they act with this share, so that the
    impulse is exact.
    """

    on: Text
    duration: Time
    begin: Time = Time(0.0)
    force: tuple[Force, Force, Force] = (Force(0.0), Force(0.0), Force(0.0))
    torque: tuple[Torque, Torque, Torque] = (Torque(0.0), Torque(0.0), Torque(0.0))
    frame: Text = "orbiter"
    at: Point | None = None


class EventSpec(_Part, frozen=True):
    """Change of values while the run lasts: in the first step that begins at or after the time `at` of the run.

    `set` has a value for each key, such as ``limits.por.translation = "0.2 m/s"``; keys that begin with ``arm.`` and
    ``worksite.`` are those of the arm's and the worksite's file. It acts with every operator.
    """

    at: Time
    set: dict[str, Any]


class PointSpec(_Part, frozen=True):
    """A prestored point of AUTO 1-4: a pause point, at which the arm waits for PROCEED, or a fly-by point."""

    target: PoseSpec
    pause: bool = False


class SequenceSpec(_Part, frozen=True):
    """Points of one sequence: AUTO 1, 2, 3 or 4."""

    slot: Annotated[int, Bounds(1, 4, "the panel has AUTO 1 to 4")]
    point: Annotated[tuple[PointSpec, ...], msgspec.Meta(min_length=1)]


Part = Literal["full problem", "acquisition", "extraction", "manoeuvring"]
"""The full problem of the report, or one of its parts."""


class StepSpec(_Part, frozen=True):
    """One step of the operator's task, which the station explains until it is done.

    In `text`, `{+X}` stands for the operator's key or button with this function (`task_file.Use`), `{2 in}` for a
    length in the operator's units, `{wanting}` for the first condition that fails, `{keys|sticks}` for words that fit
    the device in use, and `*...*` quotes the desk.
    The first `hint` whose state holds replaces the text.

    `done` is the state that completes the step. If it names `held`, `fixed` or `berth`, it also completes the earlier
    steps that are still open. `target` is the pose to which the tip, or the held payload, has to move; or `joint_at`
    is the angle to which the `joint` has to move. `mode` is the position of the MODE rotary that the step needs. `way`
    lists axes of the THC in the order in which the place is approached; without it, all axes are used at once.

    `uses` lists the functions that matter, each with its effect: ``"-X: back"``. `groups` are the groups of the desk
    that the step needs, `cameras` the two cameras that show it best. A re-initialisation to `part` begins at this step.
    """

    title: Text
    text: Text
    done: StateSpec
    target: PoseSpec | None = None
    joint: Text | None = None
    joint_at: Coordinate | None = None
    mode: Text | None = None
    way: tuple[StickAxis, ...] = ()
    uses: tuple[Text, ...] = ()
    groups: tuple[DeskGroup, ...] = ()
    cameras: tuple[Text, Text] | None = None
    part: Part | None = None
    hint: tuple[HintSpec, ...] = ()


class ScenarioFile(_Part, frozen=True):
    """A scenario file, decoded; `scenario.build` makes the checks that types cannot make."""

    title: Text
    initial: Initial
    text: str = ""
    group: ScenarioGroup = "fly"
    minutes: Annotated[int, Bounds(1, 1440, "a run lasts a day at most")] | None = None
    """Time that the task takes a practised operator, or the script if there are no steps, rounded up [min]."""
    arm: Text = "srms"
    worksite: Text = "orbiter"
    dimensions: dict[str, float | str] = msgspec.field(default_factory=dict)
    """Values that replace those in the worksite's ``[dimensions]``."""
    seed: Annotated[int, Bounds(0, 2**53, "JSON and JavaScript represent no greater integer exactly")] = 0
    duration: Time = Time(600.0)
    control_period: Annotated[Time, CONTROL_PERIOD] = Time(0.02)
    command_delay: Delay = Time(0.0)
    telemetry_delay: Delay = Time(0.0)
    camera_delay: Delay = Time(0.0)
    plant: Plant = "kinematic"
    dynamics: DynamicsSpec = DynamicsSpec()
    mode: int | Text = "ORB UNL"
    rate: Rate = "coarse"
    soft_stops: Literal["mended", "as-flown"] = "mended"
    strict: bool = False
    guards: bool | None = None
    arrive_within: Length | None = None
    """Radius of the end sphere of the automatic modes; the default depends on the plant (`build.END_SPHERE`)."""
    arrive_within_angle: Angle | None = None
    """Angle of the end sphere; the default depends on the plant."""
    fly_by_within: Length = Length(0.5)
    fly_by_angle: Angle = Angle(0.2)
    law: Literal["position", "closed loop", "open loop"] = "closed loop"
    position_hold: bool = False
    limits: LimitsOverride = LimitsOverride()
    sequence: tuple[SequenceSpec, ...] = ()
    payload: PayloadSpec | None = None
    cargo: tuple[CargoSpec, ...] = ()
    docking: Literal["all axes", "y axis"] = "all axes"
    free_contact: FreeContact = "stop"
    initialise: InitialiseSpec = InitialiseSpec()
    clearance: ClearanceSpec = ClearanceSpec()
    light: LightSpec = LightSpec()
    cameras: dict[str, CameraSpec] = msgspec.field(default_factory=dict)
    """Settings of cameras at the start, by the camera's name."""
    disturbance: tuple[DisturbanceSpec, ...] = ()
    event: tuple[EventSpec, ...] = ()
    phase: tuple[Phase, ...] = ()
    step: tuple[StepSpec, ...] = ()
    next: Text | None = None
    """Name of the built-in scenario that the station proposes after the last step."""

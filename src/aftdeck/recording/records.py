"""The session file's messages, defined once: schemas and docs/recording.md are made from these types.

Numbers are SI. The clock of every message is the run's: simulated time, counted from the wall time at which the run
began; `wall_s` tells when the step was really done. Inputs are exact. Frames are rounded for the file's sake, lengths
and angles to nine decimals, sticks and twists to seven; the digest beside each is that of the exact one.
"""

from __future__ import annotations

from typing import Annotated, Literal

from aftdeck.recording.told import Message, Numbers, told
from aftdeck.recording.work_records import WorkRecord

FORMAT = 1
"""Number of the file's layout; a reader refuses a greater one."""
PROFILE = "aftdeck"
"""MCAP profile of the file's header."""


class Opening(Message, frozen=True):
    """The first message: everything that the run started from."""

    format: Annotated[int, told("number of the file's layout")]
    version: Annotated[str, told("Aftdeck's version")]
    laws: Annotated[str, told("digest of the laws' sources; others may give other last digits")]
    machine: Annotated[str, told("processor, system and compilers; equal ones repeat a run bit for bit")]
    began: Annotated[str, told("wall time at which the run began, ISO 8601, UTC")]
    scenario: Annotated[str, told("the scenario's name")]
    title: Annotated[str, told("the same for people")]
    seed: Annotated[int, told("of everything random")]
    control_period_s: Annotated[float, told("one tick", "s")]
    joints: Annotated[tuple[str, ...], told("names in the order of every list of joints")]
    scenario_text: Annotated[str, told("the scenario's file, whole")]
    arm_text: Annotated[str, told("the arm's file, whole")]
    shapes_file: Annotated[str, told("name of the arm's shapes file in the arm's file; empty: none")]
    shapes_text: Annotated[str, told("the arm's shapes file, whole")]
    worksite_text: Annotated[str, told("the worksite's file, whole")]
    changes: Annotated[tuple[str, ...], told("KEY=VALUE: what a replay changed in the scenario")] = ()
    participant: Annotated[str, told("code of who took part, as a study gave it; empty: none was given")] = ""
    condition: Annotated[str, told("condition of the trial, as a study gave it; empty: none was given")] = ""
    digests: Annotated[str, told("names what the frames' digests are made of; others say nothing to them")] = ""


class CameraRecord(Message, frozen=True, omit_defaults=True):
    """The switches that turned a camera."""

    camera: Annotated[str, told("which camera, by its name")]
    pan: Annotated[float, told("to the right, in [-1, 1]", "1")] = 0.0
    tilt: Annotated[float, told("upwards, in [-1, 1]", "1")] = 0.0
    zoom: Annotated[float, told("in, in [-1, 1]", "1")] = 0.0
    slow: Annotated[bool, told("at the low speed")] = False


class Input(Message, frozen=True, omit_defaults=True):
    """The operator's sticks and switches in one step, exact; what is absent was left as it is."""

    tick: Annotated[int, told("of the step that flew them")]
    script: Annotated[bool, told("the scenario's script flew this step; nobody's inputs")] = False
    translation: Annotated[Numbers, told("THC along axes 1, 2, 3, in [-1, 1]", "1", "control")] = (0.0, 0.0, 0.0)
    rotation: Annotated[Numbers, told("RHC about axes 1, 2, 3, in [-1, 1]", "1", "control")] = (0.0, 0.0, 0.0)
    drive: Annotated[float, told("SINGLE/DIRECT DRIVE in [-1, 1]", "1")] = 0.0
    mode: Annotated[str | None, told("MODE rotary: position entered")] = None
    joint: Annotated[int | None, told("JOINT rotary, 0 to 5")] = None
    rate: Annotated[Literal["coarse", "vernier"] | None, told("rate switch")] = None
    target_position: Annotated[Numbers | None, told("keyed-in tip of OPR CMD", "m", "L")] = None
    target_rotation: Annotated[Numbers | None, told("its matrix row by row; columns are frame 7's axes", "1", "L")] = (
        None
    )
    target_joints: Annotated[Numbers | None, told("its joint angles, where given", "rad")] = None
    law: Annotated[Literal["position", "closed loop", "open loop"] | None, told("law of the automatic modes")] = None
    payload_axes: Annotated[bool | None, told("switch beside ORB LD")] = None
    rate_hold: Annotated[bool, told("RATE HOLD pressed")] = False
    position_hold: Annotated[bool | None, told("POSITION HOLD switch")] = None
    brakes: Annotated[bool | None, told("BRAKES switch")] = None
    safing: Annotated[bool | None, told("SAFING: on, or its CANCEL")] = None
    proceed: Annotated[bool, told("AUTO SEQ switch to PROCEED")] = False
    stop: Annotated[bool, told("AUTO SEQ switch to STOP")] = False
    effector: Annotated[Literal["stop", "close", "open"] | None, told("end effector switch")] = None
    effector_mode: Annotated[Literal["auto", "manual"] | None, told("END EFFECTOR MODE of the snares")] = None
    rigid: Annotated[Literal["off", "rigid", "derigid"] | None, told("END EFFECTOR MAN CONTR")] = None
    latch: Annotated[Literal["latch", "unlatch"] | None, told("payload retention or docking port pressed")] = None
    telescope: Annotated[float, told("the stand: +1 longer, -1 shorter", "1")] = 0.0
    orbiter: Annotated[Numbers, told("translation of the orbiter, in [-1, 1]", "1", "orbiter")] = (0.0, 0.0, 0.0)
    master: Annotated[Numbers | None, told("the master arm's joint angles", "rad")] = None
    initialise: Annotated[
        Literal["full problem", "acquisition", "extraction", "manoeuvring"] | None,
        told("part of the problem begun anew"),
    ] = None
    camera: Annotated[CameraRecord | None, told("a camera turned")] = None


class LimitRecord(Message, frozen=True):
    """A limit that acted in a step."""

    kind: Annotated[str, told("which kind")]
    joint: Annotated[int, told("0 to 5; -1: no single joint")]
    text: Annotated[str, told("for people")]


class WayOutRecord(Message, frozen=True):
    """What leads away from a singularity or a stop."""

    cause: Annotated[str, told("singularity or joint")]
    text: Annotated[str, told("for people")]
    stick: Annotated[Literal["translation", "rotation", "joint"], told("which stick")]
    axis: Annotated[int, told("0 to 2, or the joint")]
    sign: Annotated[int, told("+1 or -1")]


class GoalRecord(Message, frozen=True):
    """An automatic mode's target."""

    position_m: Annotated[Numbers, told("tip", "m", "L")]
    rotation: Annotated[Numbers, told("attitude, quaternion w x y z", "1", "L")]
    distance_m: Annotated[float, told("what is left", "m")]
    angle_rad: Annotated[float, told("what is left", "rad")]
    remaining_s: Annotated[float, told("time to arrival; 0 when not under way", "s")]


class TimesRecord(Message, frozen=True):
    """JSC-12628's times of the phase under way, from its beginning."""

    tp_s: Annotated[float, told("TP: how long it has lasted", "s")] = 0.0
    eta_s: Annotated[float | None, told("ETA: when it ends; null: unknown", "s")] = None
    etap_s: Annotated[float | None, told("ETAP: when its rotation alone would end; null: unknown", "s")] = None


class EventRecord(Message, frozen=True):
    """A line of the log."""

    time_s: Annotated[float, told("simulated time", "s")]
    kind: Annotated[str, told("what it is about")]
    level: Annotated[Literal["info", "caution", "warning"], told("how urgent")]
    text: Annotated[str, told("for people")]


class FrameRecord(Message, frozen=True):
    """What was true after one control step."""

    tick: Annotated[int, told("control steps done")]
    time_s: Annotated[float, told("simulated time: tick x control period", "s")]
    wall_s: Annotated[float, told("wall time since the run began", "s")]
    latency_ms: Annotated[float | None, told("stick to picture, 95th percentile that the page showed", "ms")]
    sha256: Annotated[str, told("first 16 digits of the SHA-256 of the exact state that the frame tells of")]
    phase: Annotated[str, told("the script's phase; empty by hand")]
    by: Annotated[Literal["hand", "script"], told("who flew this step")]
    mode: Annotated[str, told("panel position entered")]
    law: Annotated[int, told("JSC-12628's mode 1 to 8; 0 TEST, 9 DIRECT")]
    law_choice: Annotated[Literal["position", "closed loop", "open loop"], told("law of the automatic modes")]
    payload_axes: Annotated[bool, told("switch beside ORB LD")]
    rate_hold: Annotated[bool, told("RATE HOLD keeps a stick command")]
    position_hold: Annotated[bool, told("POSITION HOLD is on")]
    brakes: Annotated[bool, told("BRAKES are on: the joints stand")]
    safing: Annotated[bool, told("zero joint rates are commanded")]
    joint: Annotated[int, told("selected joint, 0 to 5")]
    rate: Annotated[Literal["coarse", "vernier"], told("rate setting")]
    sequence: Annotated[Literal["idle", "checking", "ready", "in progress"], told("CHECKING, READY and IN PROG")]
    point: Annotated[int, told("AUTO 1-4: the point flown to, from 1; 0 elsewhere")]
    points: Annotated[int, told("AUTO 1-4: how many")]
    check: Annotated[str, told("CMD CK: GOOD or FAIL and why; empty: none")]
    translation: Annotated[Numbers, told("THC as flown", "1", "control")]
    rotation: Annotated[Numbers, told("RHC as flown", "1", "control")]
    drive: Annotated[float, told("DRIVE as flown", "1")]
    angles_rad: Annotated[Numbers, told("joint angles, measured", "rad")]
    rates_rad_s: Annotated[Numbers, told("joint rates, measured", "rad/s")]
    angles_commanded_rad: Annotated[Numbers, told("where the commanded rates would have brought the joints", "rad")]
    rates_commanded_rad_s: Annotated[Numbers, told("joint rates, commanded", "rad/s")]
    rate_limits_rad_s: Annotated[Numbers, told("joint rate limits in force", "rad/s")]
    zones: Annotated[tuple[int, ...], told("per joint: 0 free, 1 past reach, 2 past soft stop, 3 at hard stop")]
    tip_m: Annotated[Numbers, told("tip", "m", "L")]
    tip_rotation: Annotated[Numbers, told("attitude of frame 7, quaternion w x y z", "1", "L")]
    point_m: Annotated[Numbers, told("point of resolution", "m", "L")]
    payload_m: Annotated[Numbers | None, told("centre of the payload in the grasp", "m", "L")]
    payload_rotation: Annotated[Numbers | None, told("its attitude, quaternion w x y z", "1", "L")]
    twist: Annotated[Numbers, told("of the point of resolution: angular, then translational", "rad/s, m/s", "L")]
    twist_commanded: Annotated[Numbers, told("the same after every limit", "rad/s, m/s", "L")]
    twist_demanded: Annotated[Numbers, told("the same before every limit", "rad/s, m/s", "L")]
    por_limits: Annotated[Numbers, told("speed and angular rate of the point of resolution in force", "m/s, rad/s")]
    ratio: Annotated[float, told("what RATLMT left of the demand, 0 to 1", "1")]
    limits: Annotated[tuple[LimitRecord, ...], told("limits that acted")]
    singularity: Annotated[Numbers, told("signed distances: shoulder, elbow, wrist", "1")]
    singular: Annotated[tuple[str, ...], told("singularities that are near")]
    ways_out: Annotated[tuple[WayOutRecord, ...], told("what leads away from what is near")]
    goal: Annotated[GoalRecord | None, told("target of an automatic mode")]
    work: Annotated[WorkRecord, told("contacts, captures, and where the worksite's things are")]
    events: Annotated[tuple[EventRecord, ...], told("what happened in this step")]
    views: Annotated[
        Numbers, told("pan, tilt and field of view of each camera that turns, as the worksite lists them", "rad")
    ]
    times: Annotated[TimesRecord, told("of the phase under way; all 0 or null in files made before")] = TimesRecord()
    attached: Annotated[
        int | None, told("which of the scenario's own payloads is in the grasp, from 1; null in files made before")
    ] = None
    wrist_pitch: Annotated[
        Numbers | None, told("T_B5: attitude of frame 5, quaternion w x y z; null in files made before", "1", "orbiter")
    ] = None


class Note(EventRecord, frozen=True):
    """A line that the station, not the simulation, wrote in the log."""

    wall_s: Annotated[float, told("wall time since the run began", "s")]


class ControllerRecord(Message, frozen=True):
    """A device that moves the hand controllers."""

    kind: Annotated[str, told("keyboard, pad, thc pad, rhc pad, thc joystick, rhc joystick, spacemouse or touch")]
    name: Annotated[str, told("as the browser calls it")]
    deadband: Annotated[float, told("part of an axis' travel about its centre that counts as zero", "1")]
    expo: Annotated[float, told("of what is left x: (1 - expo) x + expo x**3", "1")]
    bindings: Annotated[tuple[str, ...], told("key, button or axis, and what it does: `KeyW +X`, `a1 -X`")]
    centres: Annotated[Numbers, told("where each axis rests; beyond the last: 0", "1")]


class ControllersRecord(Message, frozen=True):
    """What moves the hand controllers from a time on, with its mapping; `Input` holds what came of it."""

    time_s: Annotated[float, told("simulated time", "s")]
    controllers: Annotated[tuple[ControllerRecord, ...], told("all in use; none: nobody flies")]
    wall_s: Annotated[float, told("wall time since the run began", "s")]


class Shown(Message, frozen=True):
    """What the monitors of the page that flew showed from now on."""

    time_s: Annotated[float, told("simulated time", "s")]
    mon_1: Annotated[tuple[str, ...], told("names of MON 1's cameras: two where it was split; none: no page flew")]
    mon_2: Annotated[tuple[str, ...], told("the same of MON 2")]


class LockRecord(Message, frozen=True):
    """A camera whose exposure did not follow its picture."""

    camera: Annotated[str, told("the camera's name")]
    stops: Annotated[float, told("its exposure, over that of full sunlight", "stops")]


class LightRecord(Message, frozen=True):
    """How the light stood from now on."""

    time_s: Annotated[float, told("simulated time", "s")]
    condition: Annotated[str, told("where sun and Earth stood: `high sun`, `low sun`, `night`, `terminator`")]
    lamps: Annotated[tuple[str, ...], told("switches of the lamps that were on")]
    locked: Annotated[tuple[LockRecord, ...], told("locked exposures; those of other cameras followed their pictures")]


class Closing(Message, frozen=True):
    """The last message of a run that was ended in order."""

    ended: Annotated[Literal["completed", "time", "fault", "stopped", "restarted"], told("how it ended")]
    ticks: Annotated[int, told("steps done")]
    frames_sha256: Annotated[str, told("SHA-256 over those of all frames, 32 bytes each")]
    summary: Annotated[str, told("summary of a scripted run, as `aftdeck run --json` prints it; empty by hand")]


CHANNELS: dict[str, tuple[type[Message], str]] = {
    "/opening": (Opening, "once, first"),
    "/inputs": (Input, "every step"),
    "/frames": (FrameRecord, "every step"),
    "/notes": (Note, "when the station writes one"),
    "/controllers": (ControllersRecord, "when somebody begins to fly by hand, and when devices or mappings change"),
    "/shown": (Shown, "when a monitor shows another camera"),
    "/light": (LightRecord, "at the first step, and when light, a lamp or an exposure's lock is set otherwise"),
    "/closing": (Closing, "once, last"),
}
"""Type and times of each channel's messages."""

"""Messages of a recording, defined once: schemas and docs/recording.md are generated from these types.

Numbers are in SI units. The time of every message is the wall time at which the run began plus the simulated time.
`wall_s` is the wall time since the run began. Inputs are exact. Frames are rounded to keep the file small: lengths and
angles to nine decimals, sticks and twists to seven. A frame's digest is computed from the exact state.
"""

from __future__ import annotations

from typing import Annotated, Literal

from aftdeck.field_meta import field_meta
from aftdeck.recording.delays import Delays
from aftdeck.recording.environment import Environment
from aftdeck.recording.message import Message, Numbers
from aftdeck.simulation.frame import Event, Frame
from aftdeck.simulation.inputs import Inputs

FORMAT = 2
"""Number of the file's layout; a reader rejects files with another number."""
PROFILE = "aftdeck"
"""MCAP profile of the file's header."""


class Opening(Message, frozen=True):
    """Header: all data from which the run starts."""

    format: Annotated[int, field_meta("number of the file's layout")]
    version: Annotated[str, field_meta("Aftdeck's version")]
    laws: Annotated[str, field_meta("digest of the laws' source code; changed laws may change the last digits")]
    machine: Annotated[
        str,
        field_meta("processor, system and compilers, for readers that do not know `environment`"),
    ]
    began: Annotated[str, field_meta("wall time at which the run began, ISO 8601, UTC")]
    scenario: Annotated[str, field_meta("name of the scenario")]
    title: Annotated[str, field_meta("title of the scenario")]
    seed: Annotated[int, field_meta("random seed")]
    control_period_s: Annotated[float, field_meta("control period", "s")]
    joints: Annotated[tuple[str, ...], field_meta("names of the joints, in the order of all lists of joints")]
    scenario_text: Annotated[str, field_meta("complete text of the scenario's file")]
    arm_text: Annotated[str, field_meta("complete text of the arm's file")]
    shapes_file: Annotated[
        str,
        field_meta(
            "name of the shapes file, as written in the arm's file (never opened); empty if it names no such file"
        ),
    ]
    shapes_text: Annotated[str, field_meta("complete text of the arm's shapes file")]
    worksite_text: Annotated[str, field_meta("complete text of the worksite's file")]
    changes: Annotated[tuple[str, ...], field_meta("changes of the scenario by a re-run, each as KEY=VALUE")] = ()
    participant: Annotated[str, field_meta("code of the participant; empty if not given")] = ""
    condition: Annotated[str, field_meta("condition of the trial; empty if not given")] = ""
    digests: Annotated[
        str,
        field_meta(
            "hash of the state's declared fields; frame digests of two recordings are comparable only if these "
            "hashes are equal"
        ),
    ] = ""
    environment: Annotated[
        Environment | None, field_meta("everything that computed the run; null in a file of an earlier version")
    ] = None
    real_time: Annotated[
        bool, field_meta("whether the steps were due at times of the wall clock, and late steps are recorded")
    ] = False
    viewed: Annotated[bool, field_meta("whether the file also has the channels with Foxglove's schemas")] = True


class Input(Inputs, Message, frozen=True, omit_defaults=True, kw_only=True):
    """Exact inputs of one step. A stick without a value is centred; a switch without a value is unchanged."""

    tick: Annotated[int, field_meta("number of the step in which the inputs acted")]


class FrameRecord(Frame, Message, frozen=True, kw_only=True):
    """Frame of one control step, rounded to the declared decimals."""

    wall_s: Annotated[float, field_meta("wall time since the run began", "s", decimals=6)]
    latency_ms: Annotated[
        float | None,
        field_meta("time from stick to picture, 95th percentile, as displayed by the page; null if not measured", "ms"),
    ]


class Note(Event, Message, frozen=True):
    """Log line of the station."""

    wall_s: Annotated[float, field_meta("wall time since the run began", "s")]


class ControllerRecord(Message, frozen=True):
    """Device that moves the hand controllers."""

    kind: Annotated[str, field_meta("keyboard, pad, thc pad, rhc pad, thc joystick, rhc joystick, spacemouse or touch")]
    name: Annotated[str, field_meta("name that the browser reports")]
    deadband: Annotated[float, field_meta("fraction of an axis' travel, about its centre, that counts as zero", "1")]
    expo: Annotated[
        float, field_meta("weight of the cubic part: after the deadband, x becomes (1 - expo) x + expo x**3", "1")
    ]
    bindings: Annotated[tuple[str, ...], field_meta("key, button or axis, and its function: `KeyW +X`, `a1 -X`")]
    centres: Annotated[Numbers, field_meta("rest position of each axis; an axis without an entry rests at 0", "1")]


class ControllersRecord(Message, frozen=True):
    """Devices that move the hand controllers from `time_s` on, with all mappings; `Input` has the resulting inputs."""

    time_s: Annotated[float, field_meta("simulated time", "s")]
    controllers: Annotated[
        tuple[ControllerRecord, ...], field_meta("controllers in use; none if no page is in control")
    ]
    wall_s: Annotated[float, field_meta("wall time since the run began", "s")]


class Shown(Message, frozen=True):
    """Cameras that the monitors of the operator's page showed from `time_s` on."""

    time_s: Annotated[float, field_meta("simulated time", "s")]
    mon_1: Annotated[
        tuple[str, ...],
        field_meta("names of MON 1's cameras: one, or two if the monitor is split; none if no page is in control"),
    ]
    mon_2: Annotated[tuple[str, ...], field_meta("names of MON 2's cameras, as for MON 1")]


class LockRecord(Message, frozen=True):
    """Camera with locked exposure."""

    camera: Annotated[str, field_meta("the camera's name")]
    stops: Annotated[float, field_meta("exposure, relative to the exposure for full sunlight", "stops")]


class LightRecord(Message, frozen=True):
    """Lighting from `time_s` on: sun and Earth, lamps, and locked exposures of cameras."""

    time_s: Annotated[float, field_meta("simulated time", "s")]
    condition: Annotated[str, field_meta("positions of sun and Earth: `high sun`, `low sun`, `night`, `terminator`")]
    lamps: Annotated[tuple[str, ...], field_meta("names of the lamps that are on")]
    locked: Annotated[tuple[LockRecord, ...], field_meta("locked exposures; all other cameras have automatic exposure")]


class DelayRecord(Message, frozen=True):
    """Step of a run in real time that began more than one control period after it was due."""

    tick: Annotated[int, field_meta("number of the step")]
    time_s: Annotated[float, field_meta("simulated time at which the step began", "s")]
    late_s: Annotated[float, field_meta("delay of the step", "s")]
    lost_s: Annotated[
        float, field_meta("part of the delay that was not made up: all later steps were postponed by it", "s")
    ]
    wall_s: Annotated[float, field_meta("wall time since the run began", "s")]
    commanded: Annotated[bool, field_meta("whether an input had been given before")] = True


class Closing(Message, frozen=True):
    """Footer: last message of a recording that was not cut short."""

    ended: Annotated[
        Literal["completed", "time", "fault", "stopped", "restarted"], field_meta("reason for the end of the run")
    ]
    ticks: Annotated[int, field_meta("number of steps done")]
    frames_sha256: Annotated[str, field_meta("SHA-256 over the digests of all frames, 32 bytes each")]
    summary: Annotated[
        str, field_meta("summary of a scripted run, as `aftdeck run --json` prints it; empty for manual inputs")
    ]
    chain: Annotated[
        str,
        field_meta(
            "head of the hash chain over all messages and the footer's other fields; empty in earlier versions' files"
        ),
    ] = ""
    delays: Annotated[
        Delays | None,
        field_meta("number of late steps, greatest delay and lost time of a run in real time; otherwise null"),
    ] = None


CHANNELS: dict[str, tuple[type[Message], str]] = {
    "/opening": (Opening, "once, as the first message of the recording"),
    "/inputs": (Input, "in every step"),
    "/frames": (FrameRecord, "in every step"),
    "/notes": (Note, "when the station logs a line"),
    "/controllers": (ControllersRecord, "when manual control begins, and when devices or mappings change"),
    "/shown": (Shown, "when a monitor changes its camera"),
    "/delays": (DelayRecord, "when a step of a run in real time begins late"),
    "/light": (LightRecord, "at the first step, and when the lighting changes"),
    "/closing": (Closing, "once, as the last message of the recording"),
}
"""Channels, each with the type of its messages and a text that says when they are written."""

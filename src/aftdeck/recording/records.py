"""Messages of a recording, defined once: schemas and docs/recording.md are generated from these types.

Numbers are SI. The clock of every message is the run's: simulated time, counted from the wall time at which the run
began. `wall_s` is the wall time that had really passed since then. Inputs are exact. Frames are rounded to keep the
file small: lengths and angles to nine decimals, sticks and twists to seven. Each frame's digest is that of the exact
state.
"""

from __future__ import annotations

from typing import Annotated, Literal

from aftdeck.field_meta import field_meta
from aftdeck.recording.message import Message, Numbers
from aftdeck.simulation.frame import Event, Frame
from aftdeck.simulation.inputs import Inputs

FORMAT = 2
"""Number of the file's layout; a reader rejects a greater one."""
PROFILE = "aftdeck"
"""MCAP profile of the file's header."""


class Opening(Message, frozen=True):
    """The first message: everything that the run started from."""

    format: Annotated[int, field_meta("number of the file's layout")]
    version: Annotated[str, field_meta("Aftdeck's version")]
    laws: Annotated[str, field_meta("digest of the laws' sources; different laws may give different last digits")]
    machine: Annotated[
        str, field_meta("processor, system and compilers; on an equal machine a run repeats bit for bit")
    ]
    began: Annotated[str, field_meta("wall time at which the run began, ISO 8601, UTC")]
    scenario: Annotated[str, field_meta("the scenario's name")]
    title: Annotated[str, field_meta("title of the scenario")]
    seed: Annotated[int, field_meta("random seed")]
    control_period_s: Annotated[float, field_meta("control period", "s")]
    joints: Annotated[tuple[str, ...], field_meta("names of the joints, in the order of every list of joints")]
    scenario_text: Annotated[str, field_meta("complete text of the scenario's file")]
    arm_text: Annotated[str, field_meta("complete text of the arm's file")]
    shapes_file: Annotated[
        str, field_meta("name of the arm's shapes file, as the arm's file gives it; empty if it gives none")
    ]
    shapes_text: Annotated[str, field_meta("complete text of the arm's shapes file")]
    worksite_text: Annotated[str, field_meta("complete text of the worksite's file")]
    changes: Annotated[tuple[str, ...], field_meta("changes of the scenario by a replay, each as KEY=VALUE")] = ()
    participant: Annotated[str, field_meta("code of the participant; empty if none was given")] = ""
    condition: Annotated[str, field_meta("condition of the trial; empty if none was given")] = ""
    digests: Annotated[
        str, field_meta("identifies the declaration of the state; digests are comparable only if it is equal")
    ] = ""


class Input(Inputs, Message, frozen=True, omit_defaults=True, kw_only=True):
    """The operator's sticks and switches in one step, exact; an absent stick is centred, an absent switch unchanged."""

    tick: Annotated[int, field_meta("number of the step in which they acted")]
    script: Annotated[bool, field_meta("whether the scenario's script supplied the inputs")] = False


class FrameRecord(Frame, Message, frozen=True):
    """State after one control step: the frame, rounded to its recorded decimals."""

    wall_s: Annotated[float, field_meta("wall time since the run began", "s", decimals=6)]
    latency_ms: Annotated[
        float | None,
        field_meta("time from stick to picture, 95th percentile, as displayed by the page; null if not measured", "ms"),
    ]


class Note(Event, Message, frozen=True):
    """A line of the log that the station wrote, not the simulation."""

    wall_s: Annotated[float, field_meta("wall time since the run began", "s")]


class ControllerRecord(Message, frozen=True):
    """A device that moves the hand controllers."""

    kind: Annotated[str, field_meta("keyboard, pad, thc pad, rhc pad, thc joystick, rhc joystick, spacemouse or touch")]
    name: Annotated[str, field_meta("name that the browser reports")]
    deadband: Annotated[float, field_meta("fraction of an axis' travel, about its centre, that counts as zero", "1")]
    expo: Annotated[
        float, field_meta("weight of the cubic part: x becomes (1 - expo) x + expo x**3 after the deadband", "1")
    ]
    bindings: Annotated[tuple[str, ...], field_meta("key, button or axis, and its effect: `KeyW +X`, `a1 -X`")]
    centres: Annotated[Numbers, field_meta("rest position of each axis; 0 for axes beyond the last", "1")]


class ControllersRecord(Message, frozen=True):
    """Devices that move the hand controllers from a time on, with mappings; `Input` holds the resulting inputs."""

    time_s: Annotated[float, field_meta("simulated time", "s")]
    controllers: Annotated[
        tuple[ControllerRecord, ...], field_meta("controllers in use; none if no page is in control")
    ]
    wall_s: Annotated[float, field_meta("wall time since the run began", "s")]


class Shown(Message, frozen=True):
    """Cameras that the monitors of the operator's page showed from a time on."""

    time_s: Annotated[float, field_meta("simulated time", "s")]
    mon_1: Annotated[
        tuple[str, ...], field_meta("names of MON 1's cameras, two if it is split; none if no page is in control")
    ]
    mon_2: Annotated[tuple[str, ...], field_meta("names of MON 2's cameras, as for MON 1")]


class LockRecord(Message, frozen=True):
    """A camera whose exposure was locked, and so did not follow its picture."""

    camera: Annotated[str, field_meta("the camera's name")]
    stops: Annotated[float, field_meta("exposure above that of full sunlight", "stops")]


class LightRecord(Message, frozen=True):
    """Light from a time on: sun and Earth, lamps, and locked exposures of cameras."""

    time_s: Annotated[float, field_meta("simulated time", "s")]
    condition: Annotated[str, field_meta("positions of sun and Earth: `high sun`, `low sun`, `night`, `terminator`")]
    lamps: Annotated[tuple[str, ...], field_meta("names of the lamps that are on")]
    locked: Annotated[tuple[LockRecord, ...], field_meta("locked exposures; all other cameras have automatic exposure")]


class Closing(Message, frozen=True):
    """The last message of a recording that was not cut short."""

    ended: Annotated[
        Literal["completed", "time", "fault", "stopped", "restarted"], field_meta("reason for the end of the run")
    ]
    ticks: Annotated[int, field_meta("number of steps done")]
    frames_sha256: Annotated[str, field_meta("SHA-256 over the digests of all frames, 32 bytes each")]
    summary: Annotated[
        str, field_meta("summary of a scripted run, as `aftdeck run --json` prints it; empty for manual inputs")
    ]


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
"""Type of each channel's messages, and when they are written."""

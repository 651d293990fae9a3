"""Messages of a recording, defined once: schemas and docs/recording.md are generated from these types.

Numbers are SI. The clock of every message is the run's: simulated time, counted from the wall time at which the run
began. `wall_s` is the wall time that had really passed since then. Inputs are exact. Frames are rounded to keep the
file small: lengths and angles to nine decimals, sticks and twists to seven. Each frame's digest is that of the exact
state.
"""

from __future__ import annotations

from typing import Annotated, Literal

from aftdeck.recording.message import Message, Numbers
from aftdeck.simulation.frame import Event, Frame
from aftdeck.simulation.inputs import Inputs
from aftdeck.told import told

FORMAT = 2
"""Number of the file's layout; a reader rejects a greater one."""
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


class Input(Inputs, Message, frozen=True, omit_defaults=True, kw_only=True):
    """The operator's sticks and switches in one step, exact; an absent stick is centred, an absent switch unchanged."""

    tick: Annotated[int, told("of the step that flew them")]
    script: Annotated[bool, told("the scenario's script flew this step; nobody's inputs")] = False


class FrameRecord(Frame, Message, frozen=True):
    """State after one control step: the frame, rounded to its recorded decimals."""

    wall_s: Annotated[float, told("wall time since the run began", "s", decimals=6)]
    latency_ms: Annotated[float | None, told("stick to picture, 95th percentile that the page showed", "ms")]


class Note(Event, Message, frozen=True):
    """A line of the log that the station wrote, not the simulation."""

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
    """Devices that move the hand controllers from a time on, with mappings; `Input` holds the resulting inputs."""

    time_s: Annotated[float, told("simulated time", "s")]
    controllers: Annotated[tuple[ControllerRecord, ...], told("all in use; none: nobody flies")]
    wall_s: Annotated[float, told("wall time since the run began", "s")]


class Shown(Message, frozen=True):
    """Cameras that the monitors of the operator's page showed from a time on."""

    time_s: Annotated[float, told("simulated time", "s")]
    mon_1: Annotated[tuple[str, ...], told("names of MON 1's cameras: two where it was split; none: no page flew")]
    mon_2: Annotated[tuple[str, ...], told("the same of MON 2")]


class LockRecord(Message, frozen=True):
    """A camera whose exposure was locked, and so did not follow its picture."""

    camera: Annotated[str, told("the camera's name")]
    stops: Annotated[float, told("its exposure, over that of full sunlight", "stops")]


class LightRecord(Message, frozen=True):
    """Light from a time on: sun and Earth, lamps, and locked exposures of cameras."""

    time_s: Annotated[float, told("simulated time", "s")]
    condition: Annotated[str, told("where sun and Earth stood: `high sun`, `low sun`, `night`, `terminator`")]
    lamps: Annotated[tuple[str, ...], told("switches of the lamps that were on")]
    locked: Annotated[tuple[LockRecord, ...], told("locked exposures; those of other cameras followed their pictures")]


class Closing(Message, frozen=True):
    """The last message of a recording that was not cut short."""

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
"""Type of each channel's messages, and when they are written."""

"""Recording as the page plays it: data of the whole run, and the frames in blocks.

The playback server and the one-file page deliver the same two things: first a `PlaybackIndex`, then a `Block` whenever
the playhead comes near it. The page's TypeScript is generated from these types. All quantities are SI and radians;
times are simulated times, counted from the beginning of the run.
"""

from __future__ import annotations

from typing import Literal

import msgspec

from aftdeck.simulation.frame import Event
from aftdeck.station.messages.curves import Lane, Quantity, Strip
from aftdeck.station.messages.frame import Frame
from aftdeck.station.messages.kinds import Level
from aftdeck.station.messages.welcome import Welcome

BLOCK = 256
"""Number of moments in each block but the last: about 5 s of a recording at 50 steps a second."""


class Pictured(msgspec.Struct, frozen=True):
    """Cameras that the monitors of the page in control showed from a time on."""

    time_s: float
    monitors: tuple[tuple[str, ...], ...]
    """Camera names of MON 1 and MON 2: two if the monitor was split, none if no page was in control."""


class Measure(msgspec.Struct, frozen=True):
    """Figure of the whole run."""

    name: str
    quantity: Quantity
    value: float | None
    text: str
    """Value in words if `quantity` is ``words``; otherwise empty."""
    about: str
    """Explanation of the figure, in a sentence."""
    angle: float | None = None
    """Angle that belongs to a distance: rotation of the two objects relative to each other [rad]; null if none."""
    level: Level = "info"
    """Worst alarm level that belongs to the figure."""


class Verdict(msgspec.Struct, frozen=True):
    """Result of comparing the re-simulated frames with the recorded ones."""

    state: Literal["checking", "equal", "different", "impossible"]
    text: str
    """Text for display: ``all 2002 frames equal``."""


class Recorded(msgspec.Struct, frozen=True):
    """Recording in the folder of a station that records."""

    file: str
    """Name of the file, without its folder."""
    changed: str
    """Wall time of the last write to the file, ISO 8601, UTC."""
    now: bool
    """True if the present run is being recorded into this file."""


class PlaybackIndex(msgspec.Struct, frozen=True):
    """Data of a recording that the page needs before it draws the first frame."""

    welcome: Welcome
    file: str
    """Name of the file, without its folder."""
    began: str
    """Wall time at which the run began, ISO 8601, UTC."""
    version: str
    """Version of Aftdeck that made the recording."""
    seed: int
    changes: tuple[str, ...]
    """KEY=VALUE for each change that a re-run made to the scenario."""
    participant: str
    """Participant's code; empty if none was given."""
    condition: str
    """Condition of the trial; empty if none was given."""
    period_s: float
    """Duration of a control step [s]."""
    ticks: int
    """Number of steps in the recording."""
    stride: int
    """Steps from one drawn frame to the next; 1 if every frame is drawn."""
    block: int
    """Number of moments in each block but the last."""
    ended: str
    """Reason for the end of the run; empty if the recording was cut short."""
    verdict: Verdict
    events: tuple[Event, ...]
    lanes: tuple[Lane, ...]
    pictures: tuple[Pictured, ...]
    strips: tuple[Strip, ...]
    measures: tuple[Measure, ...]


class Moment(msgspec.Struct, frozen=True):
    """One recorded frame, with the exact value of each curve in it."""

    frame: Frame
    values: tuple[float | None, ...]
    """Values of all curves, strip after strip; null where a curve has no value."""
    worst: str
    """Joint nearest to its rate limit; empty at rest."""


Block = tuple[Moment, ...]
"""Consecutive moments, `PlaybackIndex.stride` steps apart."""

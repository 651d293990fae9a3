"""Recording in the form in which the page plays it: data of the whole run, and the frames in blocks.

The page reads a `PlaybackIndex` first, and each `Block` when the playhead approaches it. It reads them from a server or
from its own HTML file. The page's TypeScript is generated from these types. All quantities are SI and radians; times
are simulated times since the beginning of the run.
"""

from __future__ import annotations

from typing import Literal

import msgspec

from aftdeck.report.curves import Lane, Strip
from aftdeck.simulation.frame import Event
from aftdeck.station.messages.frame import Frame
from aftdeck.station.messages.measure import Measure
from aftdeck.station.messages.to_page import Changed
from aftdeck.station.messages.welcome import Welcome

BLOCK = 256
"""Number of moments in each block except the last: about 5 s of a recording at 50 steps a second."""


class Pictured(msgspec.Struct, frozen=True):
    """Cameras that the monitors of the operator's page showed from `time_s` on."""

    time_s: float
    monitors: tuple[tuple[str, ...], ...]
    """Names of the cameras on MON 1 and on MON 2: two if the monitor was split, none if no page was in control."""


class Verdict(msgspec.Struct, frozen=True):
    """Result of comparing the re-simulated frames with the recorded ones."""

    state: Literal["checking", "equal", "different", "impossible"]
    text: str
    """Text for display: ``all 2002 frames equal``."""


class Recorded(msgspec.Struct, frozen=True):
    """File in the folder of a station that records."""

    file: str
    """Name of the file, without its folder."""
    changed: str
    """Wall time of the last write to the file, ISO 8601, UTC."""
    now: bool
    """True if the present run is being recorded into this file."""
    title: str
    """Title of the scenario; empty if the list of recordings does not have this file."""
    time_s: float | None
    """Simulated time of the run [s]; null during the run, and if the list does not have this file."""
    ended: str
    """End of the run: ``completed``, ``time``, ``fault``, ``stopped``, ``restarted``, ``cut``; empty if not known."""
    grade: str
    """Grade of the operator's task: ``A`` to ``D``; empty if the task was not completed or has no grade."""


class ChangedFrom(msgspec.Struct, frozen=True):
    """Fields of the welcome that are in force from a step on."""

    tick: int
    fields: Changed


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
    """Changes that a re-run made to the scenario, each as KEY=VALUE."""
    participant: str
    """Code of the participant; empty if not given."""
    condition: str
    """Condition of the trial; empty if not given."""
    period_s: float
    """Duration of a control step [s]."""
    ticks: int
    """Number of steps in the recording."""
    stride: int
    """Number of steps from one frame to the next: 1 if the blocks contain every frame."""
    block: int
    """Number of moments in each block except the last."""
    ended: str
    """Reason for the end of the run; empty if the recording was cut short."""
    verdict: Verdict
    events: tuple[Event, ...]
    lanes: tuple[Lane, ...]
    pictures: tuple[Pictured, ...]
    strips: tuple[Strip, ...]
    measures: tuple[Measure, ...]
    changed: tuple[ChangedFrom, ...]
    """Fields of the welcome that changes in flight have changed, in the order of the steps; the first one is in force
    at the start. Empty if nothing was changed."""


class Moment(msgspec.Struct, frozen=True):
    """Recorded frame, with the value of each curve in this step."""

    frame: Frame
    values: tuple[float | None, ...]
    """Values of all curves, in the order of the strips; null where a curve has no value."""
    worst: str
    """Name of the joint nearest to its rate limit; empty if no joint moves."""


Block = tuple[Moment, ...]
"""Consecutive moments, `PlaybackIndex.stride` steps apart."""

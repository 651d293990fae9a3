"""A recording as the page plays it: what is known of the whole run, and its frames in blocks.

The replay's server and the page in one file hand over the same two things: a `PlaybackIndex` at first, a `Block`
whenever the playhead comes near it. The page's TypeScript is generated from these types. All quantities are SI and
radians; times are simulated ones, from the run's beginning.
"""

from __future__ import annotations

from typing import Literal

import msgspec

from aftdeck.station.curves import Lane, Quantity, Strip
from aftdeck.station.kinds import Level
from aftdeck.station.to_page import Event, Frame, Welcome

BLOCK = 256
"""Moments in a block, but the last one: 5 s of a recording at 50 steps a second."""


class Pictured(msgspec.Struct, frozen=True):
    """What the monitors of the page that flew showed from a time on."""

    time_s: float
    monitors: tuple[tuple[str, ...], ...]
    """Of MON 1 and MON 2: the camera's name, two where it was split; none: no page flew."""


class Measure(msgspec.Struct, frozen=True):
    """A figure of the whole run."""

    name: str
    quantity: Quantity
    value: float | None
    text: str
    """In words, where the quantity is such."""
    about: str
    """How it is reckoned, in a sentence."""
    angle: float | None = None
    """What belongs to a distance: how far the two are turned against each other [rad]."""
    level: Level = "info"
    """The worst alarm that it stands for."""


class Verdict(msgspec.Struct, frozen=True):
    """Whether the recomputed frames are equal to the recorded ones."""

    state: Literal["checking", "equal", "different", "impossible"]
    text: str
    """For people: ``all 2002 frames equal``."""


class Recorded(msgspec.Struct, frozen=True):
    """A recording in the folder of a station that records."""

    file: str
    """The file's name, without its folder."""
    changed: str
    """Wall time at which it was written to last, ISO 8601, UTC."""
    now: bool
    """The present flight goes on in it."""


class PlaybackIndex(msgspec.Struct, frozen=True):
    """All that is known of a recording before its first frame is drawn."""

    welcome: Welcome
    file: str
    """The file's name, without its folder."""
    began: str
    """Wall time at which the run began, ISO 8601, UTC."""
    version: str
    """Of the Aftdeck that recorded it."""
    seed: int
    changes: tuple[str, ...]
    """KEY=VALUE, where a replay changed the scenario."""
    participant: str
    """Code of who took part; empty: none was given."""
    condition: str
    """Of the trial; empty: none was given."""
    period_s: float
    """A control step."""
    ticks: int
    """Steps that the recording holds."""
    stride: int
    """Steps from one drawn frame to the next; 1: every frame is drawn."""
    block: int
    """Moments in each block but the last."""
    ended: str
    """How the run ended; empty where the recording was cut short."""
    verdict: Verdict
    events: tuple[Event, ...]
    lanes: tuple[Lane, ...]
    pictures: tuple[Pictured, ...]
    strips: tuple[Strip, ...]
    measures: tuple[Measure, ...]


class Moment(msgspec.Struct, frozen=True):
    """One recorded frame, with each curve's exact value in it."""

    frame: Frame
    values: tuple[float | None, ...]
    """Of every curve, strip after strip."""
    worst: str
    """The joint that is nearest to its rate limit; empty at rest."""


Block = tuple[Moment, ...]
"""Moments that follow one another, `PlaybackIndex.stride` steps apart."""

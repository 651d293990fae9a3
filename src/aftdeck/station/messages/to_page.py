"""Messages from the server to a page."""

from __future__ import annotations

import msgspec

from aftdeck.simulation.frame import Event
from aftdeck.station.messages.curves import Lane, Strip
from aftdeck.station.messages.frame import Frame
from aftdeck.station.messages.kinds import WireMessage
from aftdeck.station.messages.welcome import Welcome


class ScenarioInfo(msgspec.Struct, frozen=True):
    """Scenario that this station can run."""

    name: str
    title: str
    text: str
    """Task of the operator, in a sentence or two."""
    given: bool
    """True for the user's own file; the others are built in."""


class Scenarios(WireMessage, frozen=True, tag="scenarios"):
    """Scenarios that this station can run: sent on connection and whenever something in the message changes."""

    scenarios: tuple[ScenarioInfo, ...]
    flown: int
    """Number of the scenario that is running."""
    coming: int | None
    """Number of the scenario that is being prepared; null if there is none.

    The sticks are at zero meanwhile. When the scenario runs, every page gets a new `Welcome`.
    """


class NamedPage(msgspec.Struct, frozen=True):
    """Page at which a person has given a name."""

    number: int
    name: str
    """Name as the other pages get it: the page's number is appended if two pages have the same name."""


class Role(WireMessage, frozen=True, tag="role"):
    """Role of this page, and which page is in control: sent on connection and whenever it changes."""

    flying: bool
    watchers: int
    """Number of observers: pages with a seat, without the one in control."""
    number: int
    """Number of this page, from 1; 0 if it only shows the run."""
    flier: int
    """Number of the page in control; 0 if there is none."""
    asking: int
    """Number of the page that asks for the sticks; 0 if there is none."""
    name: str
    """Name as it was given at this page; empty if none was given."""
    names: tuple[NamedPage, ...]
    """Names of all pages that have one, this page included."""


class Events(WireMessage, frozen=True, tag="events"):
    """New log lines, oldest first; none is ever skipped."""

    events: tuple[Event, ...]


class Preparing(WireMessage, frozen=True, tag="preparing"):
    """Line of progress while the station prepares its first session; comes before the welcome."""

    text: str


class Refused(WireMessage, frozen=True, tag="refused"):
    """Rejection of a message or command, with the reason in a sentence for the operator."""

    seq: int
    """`seq` of the message; -1 if the message could not be read, or if the rejection concerns no single message."""
    text: str


class Sample(msgspec.Struct, frozen=True):
    """Values of all strips at one instant."""

    time_s: float
    values: tuple[float | None, ...]
    """Values of all curves, strip after strip; null where a curve has no value."""
    worst: str
    """Joint nearest to its rate limit; empty at rest."""


class Recent(WireMessage, frozen=True, tag="recent"):
    """Data for a window that draws strips: first the last minutes of the run, then only new data."""

    strips: tuple[Strip, ...]
    """All strips, with curves that have no points: a run begins, and the data sent before is no longer valid.

    Empty while the run continues.
    """
    samples: tuple[Sample, ...]
    lanes: tuple[Lane, ...]
    """Lanes of the last minutes if a stretch has begun, otherwise empty; the last stretch of each lane continues."""


FromServer = Preparing | Welcome | Scenarios | Role | Frame | Events | Recent | Refused

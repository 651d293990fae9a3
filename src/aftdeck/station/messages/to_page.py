"""Messages from the server to a page."""

from __future__ import annotations

import msgspec

from aftdeck.bodies.cameras import Camera
from aftdeck.report.curves import Lane, Strip
from aftdeck.scenario.schema import ScenarioGroup
from aftdeck.simulation.frame import Event
from aftdeck.station.messages.frame import Frame
from aftdeck.station.messages.kinds import WaitsFor, WireMessage
from aftdeck.station.messages.welcome import JointInfo, PayloadInfo, Welcome, WorkInfo


class ScenarioInfo(msgspec.Struct, frozen=True):
    """Scenario that this station can run."""

    name: str
    title: str
    text: str
    """Task of the operator, in a sentence or two."""
    group: ScenarioGroup
    minutes: int | None
    """Time that the task takes a practised operator, or the script if there are no steps [min]; null if unknown."""
    given: bool
    """True for the user's own file; false for a built-in scenario."""
    scripted: bool
    """Whether the scenario has a script that can fly it."""


class Scenarios(WireMessage, frozen=True, tag="scenarios"):
    """Scenarios that this station can run. The server sends the list on connection and whenever it changes."""

    scenarios: tuple[ScenarioInfo, ...]
    flown: int
    """Number of the scenario that is running."""
    coming: int | None
    """Number of the scenario that is being prepared; null if no scenario is being prepared.

    During the preparation the sticks are centred. When the scenario starts, every page receives a new `Welcome`.
    """


class NamedPage(msgspec.Struct, frozen=True):
    """Number of a page, and the name of its user."""

    number: int
    name: str
    """Name for display on all pages; if two pages have the same name, the page's number is appended."""


class Role(WireMessage, frozen=True, tag="role"):
    """Role of this page, and the page in control.

    The server sends this message on connection, and whenever its content changes.
    """

    flying: bool
    may_fly: bool
    """False if the page's address is for observing only: this page cannot take control."""
    watchers: int
    """Number of observers: pages that can take control but are not in control."""
    number: int
    """Number of this page, from 1; 0 if it cannot take control."""
    flier: int
    """Number of the page in control; 0 if no page is in control."""
    asking: int
    """Number of the page that asks for the sticks; 0 if no page asks."""
    name: str
    """Name that the person at this page has set; empty if no name is set."""
    names: tuple[NamedPage, ...]
    """Names of all pages that have a name, including this page."""


class Events(WireMessage, frozen=True, tag="events"):
    """New log lines, oldest first. The server may skip frames, but never a log line."""

    events: tuple[Event, ...]


class Preparing(WireMessage, frozen=True, tag="preparing"):
    """One line about the progress of preparing the first session; sent before the welcome."""

    text: str


class Readiness(WireMessage, frozen=True, tag="readiness"):
    """What is not ready yet, and whether the run waits for it. Sent on connection and whenever it changes.

    Until the laws are compiled, the run uses them as plain Python, and has no look-ahead.
    """

    waits_for: WaitsFor
    """What the run waits for: the first pictures of the page in control, or the laws; empty if it goes on."""
    share: float | None
    """Part of the compilation of the laws that is done, 0 to 1 in steps of 0.01; null if none is in progress."""
    left_s: float | None
    """Time until its end, in whole seconds [s]; null if it is not known."""
    failure: str
    """Sentence that says why the laws stay plain Python; empty if they are compiled or will be."""


class Refused(WireMessage, frozen=True, tag="refused"):
    """Rejection of a message or command. `text` gives the operator the reason, in one sentence."""

    seq: int
    """`seq` of the rejected message; -1 if the message could not be decoded, or if `text` is not about a message."""
    text: str


class Sample(msgspec.Struct, frozen=True):
    """Values of all strips in one control step."""

    time_s: float
    values: tuple[float | None, ...]
    """Values of all curves, in the order of the strips; null where a curve has no value."""
    worst: str
    """Name of the joint nearest to its rate limit; empty if no joint moves."""


class Recent(WireMessage, frozen=True, tag="recent"):
    """Data for a page that draws strips: at first the data of the last minutes of the run, later only new data."""

    strips: tuple[Strip, ...]
    """All strips, with empty curves, in the first message about a run: the page then deletes all older data.

    Empty in later messages.
    """
    samples: tuple[Sample, ...]
    lanes: tuple[Lane, ...]
    """All lanes of the last minutes, if an interval of any lane has started since the last message.

    Otherwise empty: the last interval of each lane then continues.
    """


class Polygons(WireMessage, frozen=True, tag="polygons"):
    """Picture of a camera in the look of 1972: convex polygons, in the order in which they are painted.

    The server sends it to the pages that have asked for it (`ShowPolygons`), with each frame that it draws.
    """

    step: int
    """Step of the frame: `LinkSteps.step`, in a replay `Frame.tick`; -1 if the picture belongs to no frame."""
    camera: str
    points: bytes
    """x and y of all corners, as 16-bit integers (little-endian): 10,000 is half the width of the picture.

    The origin is the middle of the picture; x points to the right and y downwards.
    """
    corners: bytes
    """Number of corners of each polygon, a byte each."""
    greys: bytes
    """Grey of each polygon, 0 to 255, a byte each."""
    text: str
    """Sentence that says why there are no polygons; empty if there are."""
    share: float | None = None
    """Part of the preparation of the first picture that is done, 0 to 1; null if none is in progress."""


class Typed(WireMessage, frozen=True, tag="typed"):
    """Answer of the console to a line."""

    seq: int
    """`seq` of the line."""
    lines: tuple[str, ...]
    refused: bool
    """Whether the line was not understood, or its change was refused; the lines say why."""


class Completed(WireMessage, frozen=True, tag="completed"):
    """Words with which the last word of a line on the console can go on."""

    seq: int
    """`seq` of the request."""
    words: tuple[str, ...]
    """The words, whole; at most 40."""


class Changed(WireMessage, frozen=True, tag="changed"):
    """New values of fields of the welcome, after a change in flight or a restart; all other fields stay the same."""

    joints: tuple[JointInfo, ...]
    cameras: tuple[Camera, ...]
    work: WorkInfo
    payloads: tuple[PayloadInfo, ...]
    singular: float
    telemetry_delay_s: float
    camera_delay_s: float


Answers = Typed | Completed | Refused
"""Answers to a message of a page."""
FromServer = (
    Preparing
    | Welcome
    | Changed
    | Scenarios
    | Role
    | Frame
    | Polygons
    | Events
    | Recent
    | Readiness
    | Typed
    | Completed
    | Refused
)

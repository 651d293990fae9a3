"""A reading, and what it is used for: strip, metrics, time history, state of a dataset."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache
from operator import attrgetter
from typing import Annotated, Any, Literal, NamedTuple, get_type_hints

from aftdeck.field_meta import field_meta
from aftdeck.plant.readings import Readings
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Dynamics, Frame
from aftdeck.simulation.readings.quantity import SLID, UNITS, Quantity
from aftdeck.simulation.readings.source import OWN
from aftdeck.table import Cell
from aftdeck.tuples import Vec3
from aftdeck.worksite.report import Hand, Work
from aftdeck.worksite.watch.alarm import Level

Parts = tuple[str, ...] | Literal["joints", "singularities"]
"""What distinguishes the numbers of a reading; () for a single one; or one for each joint or singularity of the arm."""
XYZ = ("x", "y", "z")
MATRIX = tuple(f"r{i}{j}" for i in "123" for j in "123")
"""Elements of an attitude's matrix: row, column."""


class Along(NamedTuple):
    """Remaining motion, and present motion, along the axes of the sticks."""

    to_go: Annotated[
        Vec3, field_meta("remaining motion of the point that the sticks move, along their axes; 0 for no place", "m")
    ]
    rotation_to_go: Annotated[
        Vec3, field_meta("remaining rotation about the sticks' axes: unit axis times angle; 0 for no place", "rad")
    ]
    velocity: Annotated[Vec3, field_meta("velocity of the point that the sticks move, along their axes", "m/s")]
    turning: Annotated[Vec3, field_meta("angular velocity about the sticks' axes", "rad/s")]


class Known(NamedTuple):
    """What is known of a control step.

    Attributes:
        frame: its frame.
        scenario: the scenario.
        gauges: readings of the gauges; None without gauges.
        latency_ms: time from stick to picture [ms]; None if it was not measured.
        along: motion along the sticks' axes; None if it was not computed.
    """

    frame: Frame
    scenario: Scenario
    gauges: Readings | None = None
    latency_ms: float | None = None
    along: Along | None = None


Value = Callable[[Known], Any]
"""Function that returns a reading's number or text, or a sequence of one for each part; None for no value."""
Needs = Literal["", "masses", "gauges"]
"""What a run must have: nothing; masses; or masses and gauges, which are neither in a frame nor in a recording."""
Role = Literal["actual", "commanded"]
Reducer = Literal["greatest", "least", "mean", "last", "integral", "time", "share", "begun"]
"""What makes one number of a reading's values in a run.

Greatest and least value, mean over time, value in the last step, sum of all values times the control period; of a state
that holds or not, the time in which it holds, the share of the time, and the number of times that it began after the
first step.
"""


class Strip(NamedTuple):
    """Strip that shows a reading.

    Attributes:
        role: role of the reading's value: actual, or command of a stick.
        limit: limit of the value.
        alarms: returns the values below which there is a caution and a warning.
        shown: whether the strip is shown before the user selects strips.
        rests: whether zero is the value at rest; the drawn range then includes zero.
    """

    role: Role = "actual"
    limit: float | None = None
    alarms: Callable[[Scenario], tuple[float, float]] | None = None
    shown: bool = False
    rests: bool = True


class Recorded(NamedTuple):
    """Metric that a reading has over a run.

    Attributes:
        by: how it is reduced.
        name: name of the metric in tables, without the unit.
        title: name for people.
        definition: what is measured, in a sentence; ``{k}`` stands for a joint's number; empty for what the reducer
            makes of the reading's definition.
        quantity: kind of the number; None for that of the reducer, or else of the reading.
        of: returns the value in place of the reading's.
        detail: returns where or when it occurred, from the step that decided it and the name of the joint, which is
            empty for a reading without joints; None for nothing.
        level: returns the alarm level in a step, of which the worst counts; None if there is none.
    """

    by: Reducer
    name: str
    title: str
    definition: str = ""
    quantity: Quantity | None = None
    of: Value | None = None
    detail: Callable[[Known, str], str] | None = None
    level: Callable[[Known], Level] | None = None


class Reading(NamedTuple):
    """One number that is shown, or several of a kind.

    Attributes:
        name: name, unique in the table.
        definition: what it is, in a phrase; for a state whose beginnings are counted, what begins.
        of: returns the value.
        parts: what distinguishes its numbers.
        quantity: kind of the number, with its unit; a count or a state by default.
        title: name for people, in which ``{part}`` stands for a part or a joint's label; empty for `name` in words.
        commanded: returns the commanded value; None if there is none.
        source: document that defines it, or asks for its metrics.
        needs: what a run must have.
        strip: strip that shows it; None for none.
        metrics: metrics of a run.
        group: group of the time history to which its columns belong; empty for none.
        column: beginning of its columns' names; empty for `name`.
        state: beginning of its names in the state of datasets; empty if it does not belong to the state.
    """

    name: str
    definition: str
    of: Value
    parts: Parts = ()
    quantity: Quantity = "count"
    title: str = ""
    commanded: Value | None = None
    source: str = OWN
    needs: Needs = ""
    strip: Strip | None = None
    metrics: tuple[Recorded, ...] = ()
    group: str = ""
    column: str = ""
    state: str = ""

    @property
    def heading(self) -> str:
        """Name for people."""
        return self.title or self.name.replace("_", " ").capitalize()

    @property
    def sentence(self) -> str:
        """Definition as a sentence."""
        return f"{self.definition[0].upper()}{self.definition[1:]}."

    def names(self, beginning: str, scenario: Scenario) -> tuple[str, ...]:
        """Return the names of its numbers, which begin so."""
        match self.parts:
            case "joints":
                parts = scenario.arm.joints
            case "singularities":
                parts = scenario.arm.model.singularities
            case parts:
                pass
        return tuple(f"{beginning}_{part}" for part in parts) or (beginning,)

    def labels(self, scenario: Scenario) -> tuple[str, ...]:
        """Return the names of its parts for people."""
        match self.parts:
            case "joints":
                return scenario.arm.model.labels
            case "singularities":
                return tuple(name.capitalize() for name in scenario.arm.model.singularities)
            case parts:
                return parts

    def quantities(self, scenario: Scenario) -> tuple[Quantity, ...]:
        """Return the kind of each of its numbers: those of a joint that slides have lengths in place of angles."""
        if self.parts != "joints":
            return (self.quantity,) * max(1, len(self.labels(scenario)))
        slid = SLID.get(self.quantity, self.quantity)
        return tuple(slid if slides else self.quantity for slides in scenario.arm.model.slides)

    def values(self, known: Known) -> Sequence[Cell]:
        """Return its values, one for each part."""
        value = self.of(known)
        return value if self.parts else (value,)


_QUANTITIES: dict[str, Quantity] = {unit: quantity for quantity, unit in reversed(UNITS.items())} | {"1": "ratio"}
"""First quantity of each unit."""
_PLACES: dict[type, Callable[[Known], Any]] = {
    Frame: attrgetter("frame"),
    Work: attrgetter("frame.work"),
    Hand: attrgetter("frame.work.hand"),
    Dynamics: attrgetter("frame.dynamics"),
    Readings: attrgetter("gauges"),
    Along: attrgetter("along"),
}
"""Functions that return the only struct of its type in a step."""


@cache
def _hints(kind: type) -> dict[str, Any]:
    return get_type_hints(kind, include_extras=True)


def shown(
    kind: type,
    field: str,
    name: str,
    parts: Parts = (),
    *,
    at: Callable[[Known], Any] | None = None,
    of: Value | None = None,
    owner: str = "",
    quantity: Quantity | None = None,
    **uses: Any,
) -> Reading:
    """Return the reading of a declared field, which has the field's value, unit and definition.

    Args:
        kind: struct or named tuple that declares the field.
        field: name of the field.
        name: name of the reading.
        parts: as in `Reading`.
        at: returns the struct; None for the only one of its type.
        of: returns the value in place of that of the field.
        owner: what the field belongs to, for the definition.
        quantity: quantity in place of that of the field's unit.
        uses: further fields of the reading.
    """
    (meta,) = _hints(kind)[field].__metadata__
    axes = f" ({meta.extra['frame']})" if meta.extra["frame"] else ""
    definition = f"{owner}: {meta.description}{axes}" if owner else f"{meta.description}{axes}"
    of = of or _field(at or _PLACES[kind], field, matrix=parts == MATRIX)
    quantity = quantity or _QUANTITIES[meta.extra["unit"]]
    return Reading(name, definition, of, parts, quantity, **uses)


def _field(at: Callable[[Known], Any], field: str, *, matrix: bool) -> Value:
    """Return the function that returns a field's value, of a matrix its elements row by row."""
    get = attrgetter(field)
    return (lambda s: [x for row in get(at(s)) for x in row]) if matrix else (lambda s: get(at(s)))


def pose(
    kind: type, name: str, at: Callable[[Known], Any] | None = None, *, state: str = "", **uses: Any
) -> tuple[Reading, Reading]:
    """Return the readings of a pose: position, and matrix of the attitude; `state` is that of the position."""
    return (
        shown(kind, "position", name, XYZ, at=at, state=state, **uses),
        shown(kind, "orientation", f"{name}_matrix", MATRIX, at=at, column=name, **uses),
    )

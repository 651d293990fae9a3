"""What the pilot reads: the present step, its keys, and the remaining motion."""

from __future__ import annotations

import re
from dataclasses import dataclass

from tests.browser.text_pilot.snapshot import Node, parse

UNITS = {"in": 0.0254, "ft": 0.3048, "cm": 0.01, "m": 1.0, "°": 1.0}
"""Each unit of a component in metres or degrees."""
_PART = re.compile(r"(?:(?P<key>.+) )?(?P<value>[\d.]+) ?(?P<unit>in|ft|cm|m|°)$")
_CLOCK = re.compile(r"MET (\d+)/(\d+):(\d\d):(\d\d)")
_HOLD = re.compile(r"\w+ (?P<key>.+), hold (?P<seconds>[\d.]+) s$")


@dataclass(frozen=True)
class Part:
    """A component of the remaining motion.

    Attributes:
        stick: axis and direction: `+X`, `−yaw`.
        key: key that reduces it; empty if it is small.
        size: magnitude [m], or [deg] for a rotation.
        near: whether the page says that it is within the tolerance.
    """

    stick: str
    key: str
    size: float
    near: bool

    @property
    def axis(self) -> str:
        """Name of the axis, without a direction."""
        return self.stick.lstrip("+−")

    @property
    def turns(self) -> bool:
        """Whether it is a rotation."""
        return self.axis in ("roll", "pitch", "yaw")


@dataclass(frozen=True)
class Reading:
    """What the page says.

    Attributes:
        clock: mission elapsed time [s]; None if it is not there.
        welcome, begin: the one thing to do at a visitor's first start, and the button beside it; empty later.
        count: number of the step, `2 of 6`.
        title, text: the step.
        keys: keys of the step, each with its effect.
        to: sentence of the remaining motion.
        parts: its components.
        enter: button that enters the mode of the step; empty if this mode is entered.
        shut: whether only the line shows the step, without its keys.
        rate: `Coarse` or `Vernier`; empty if the page does not say it.
        holds: keys that have to be held, each with its time [s].
        escape: key that leads out of a contact; empty if none is named.
        busy: mechanism that moves; empty if none does.
        result: grade and faults; empty before the end.
        alerts: what the lamps and the newest events report.
    """

    clock: float | None = None
    welcome: str = ""
    begin: str = ""
    count: str = ""
    title: str = ""
    text: str = ""
    keys: tuple[tuple[str, str], ...] = ()
    to: str = ""
    parts: tuple[Part, ...] = ()
    enter: str = ""
    shut: bool = False
    rate: str = ""
    holds: tuple[tuple[str, float], ...] = ()
    escape: str = ""
    busy: str = ""
    result: str = ""
    alerts: str = ""

    @property
    def step(self) -> tuple[str, str]:
        """Number and title of the step."""
        return self.count, self.title

    @property
    def over(self) -> bool:
        """Whether all steps are past."""
        return self.count.startswith("All ") or "done" in self.count

    def part(self, key: str) -> Part | None:
        """Return the component that a key reduces."""
        return next((part for part in self.parts if part.key == key), None)


def read(snapshot: str) -> Reading:
    """Return what a snapshot of the page, or of the guide alone, says."""
    page = parse(snapshot)
    guide, line = page.first("region", "Guide"), page.first("region", "Task")
    shut = not guide.children
    step = line if shut else guide
    go = step.first("group", "To ")
    texts = [node for node in step.children if node.role == "paragraph" and not node.words().startswith("Next: ")]
    text = texts[0].words() if texts else ""
    return Reading(
        clock=_clock(page),
        welcome=page.first("region", "Welcome").first("paragraph").words(),
        begin=page.first("region", "Welcome").first("button").name,
        count=next((node.text for node in step.children if node.role == "text"), ""),
        title=text if shut else step.first("heading").name,
        text=text,
        keys=tuple(_key(item.words()) for item in step.first("list", "Controls of this step").children),
        to=go.name,
        parts=tuple(_part(item) for item in go.all("listitem")),
        enter=step.first("button", "Enter ").name,
        shut=shut,
        rate=next((node.name for node in page.first("group", "Rate").children if "pressed" in node.states), ""),
        holds=tuple(
            (found["key"], float(found["seconds"])) for node in page.all("button") if (found := _HOLD.match(node.name))
        ),
        escape=_escape(page),
        busy=_busy(page),
        result=_result(step),
        alerts=_alerts(page),
    )


def _clock(page: Node) -> float | None:
    found = _CLOCK.search(page.first("banner").words())
    if found is None:
        return None
    days, hours, minutes, seconds = (int(part) for part in found.groups())
    return float(((days * 24 + hours) * 60 + minutes) * 60 + seconds)


def _key(words: str) -> tuple[str, str]:
    """Split the text of a key cap into the name of the key and its effect."""
    names = ("full stop", "left bracket", "right bracket", "Page ↑", "Page ↓")
    key = next((name for name in names if words.startswith(f"{name} ")), words.partition(" ")[0])
    return key, words.removeprefix(key).strip()


def _part(item: Node) -> Part:
    stick, *rest = item.name.split(", ")
    found = _PART.match(item.words())
    if not found:
        raise ValueError(f"{item.words()!r} is not a component; expected a key, a number and a unit")
    return Part(stick, found["key"] or "", float(found["value"]) * UNITS[found["unit"]], bool(rest))


def _escape(page: Node) -> str:
    """Return the key of the newest `Escape: THC −X (S)`."""
    found = (re.match(r"Escape: .*\((.+)\)", node.name) for node in page.all("listitem", "Escape: "))
    return next((match[1] for match in found if match), "")


def _busy(page: Node) -> str:
    """Return the mechanism that moves, with its remaining time: `payload latches open, 12 s`."""
    found = re.match(r"End effector (.*, \d+ s)\b", page.first("region", "End effector").name)
    return found[1] if found else ""


def _alerts(page: Node) -> str:
    """Return what the lamps and the newest events report."""
    lamps = page.first("region", "Lamps")
    events = page.first("region", "Events").all("listitem")[:2]
    texts = [*lamps.all("paragraph"), *lamps.all("alert"), page.first("status", "Inhibited"), *events]
    return "; ".join(words for node in texts if (words := node.words()))


def _result(step: Node) -> str:
    """Return the grade and the figures at the end."""
    words = step.words()
    return words[words.index("Grade ") :] if "Grade " in words else ""

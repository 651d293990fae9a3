"""Boxes of the concept arm, computed from the dimensions in an arm file of Aftdeck 0.2 and before."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from aftdeck.files import Where
from aftdeck.units import Length, Quantity

Table = dict[str, Any]
Three = list[float]

AT_PRONG = {
    "least": "prong_open",
    "greatest": "prong_closed",
    "start": "prong_open",
    "rate": "prong_rate",
    "facing": "fixed_finger",
}
"""Constants of the prong's joint, and their names in the table ``effector``."""
_EFFECTOR = [-3, 2, 1]
"""(x, y, z) = (-Z2, Y2, X2): face c then faces the wrist, and face d the bar (restored from the report's MO2SET)."""
_SOURCE = {"source": "computed from the dimensions of the arm (converted)", "confidence": "assumed"}
_HAND = ("stub", "palm", "fixed finger", "prong")
"""Parts whose volumes share the mass of the hand."""
_ENDS = 2
"""Number of coordinates of a span."""


class Dimensions:
    """Dimensions of an old file: constants that are read once, and used often.

    Args:
        take: removes a constant from the file and returns it.
        number: reads a quantity from a value at a place.
    """

    def __init__(self, take: Callable[..., Table], number: Callable[[type[Quantity], object, Where], float]) -> None:
        self._take, self._number, self._known = take, number, dict[tuple[str, ...], Table]()

    def constant(self, *where: str) -> Table:
        """Return a constant with its source and confidence."""
        if where not in self._known:
            self._known[where] = self._take(*where)
        return self._known[where]

    def number(self, *where: str) -> float:
        """Return a length [m]."""
        return self._number(Length, self.constant(*where)["value"], (*where, "value"))

    def span(self, *where: str) -> tuple[float, float]:
        """Return the coordinates of two ends [m]."""
        value, at = self.constant(*where)["value"], (*where, "value")
        begin, end = value if isinstance(value, list) and len(value) == _ENDS else (value, value)
        return self._number(Length, begin, (*at, 0)), self._number(Length, end, (*at, 1))


def blocks(d: Dimensions, frames: list[str], hand: float, tube: float) -> list[Table]:
    """Return the arm's blocks, from the foot to the prong, each with the name of the table of its dimensions.

    Args:
        d: the dimensions.
        frames: frames of the joints: telescope, the six that turn, prong.
        hand: mass of the hand [kg]; 0 for none.
        tube: mass of the telescope's tube [kg]; 0 for none.
    """
    made = [*_stand(d, frames), *_booms(d, frames), *_effector(d, frames)]
    for block in made:
        block |= {"kind": "block", **_SOURCE}
    volume = 0.0
    for block in made:
        volume += _volume(block) if block["part"] in _HAND else 0.0
    for block in made:
        if block["part"] in _HAND and hand > 0.0:
            block["mass"] = hand / volume * _volume(block)
        elif block["part"] == "telescope" and tube > 0.0:
            block["mass"] = tube
    return made


def _block(table: str, part: str, frame: str, low: Three, high: Three, material: str) -> Table:
    return {"table": table, "part": part, "frame": frame, "low": low, "high": high, "material": material}


def _stand(d: Dimensions, frames: list[str]) -> Iterator[Table]:
    """Yield the telescope's sleeve and the tube that slides in the sleeve, which is as long as the travel."""
    below, least = d.number("stand", "top_below_shoulder"), d.number("stand", "least")
    sleeve = _along(2, below - least, 0.0, d.number("stand", "side"))
    yield _block("stand", "stand", "arm.base", *sleeve, "structure")
    travel = d.number("stand", "greatest") - least
    tube = _along(2, below, below + travel, d.number("stand", "tube_side"))
    yield _block("stand", "telescope", frames[0], *tube, "metal")


def _booms(d: Dimensions, frames: list[str]) -> Iterator[Table]:
    """Yield the upper arm, the lower arm, the stub, and the cubes around the pins."""
    back, side = d.number("booms", "set_back"), d.number("booms", "side")
    for name, k, boom in (("shoulder", 2, "upper"), ("elbow", 3, "lower"), ("wrist", 4, "")):
        edge = d.number("booms", f"{name}_housing")
        cube = _along(0, -0.5 * edge, 0.5 * edge, edge)
        yield _block("booms", name, frames[k], *cube, "housing")
        if boom:
            ends = back, d.number("geometry", f"{boom}_arm") - back
            yield _block("booms", f"{boom} boom", frames[k], *_along(0, *ends, side), "boom")
    stub = _along(0, *d.span("booms", "stub"), d.number("booms", "stub_side"))
    yield _block("booms", "stub", frames[6], *stub, "padding")


def _effector(d: Dimensions, frames: list[str]) -> Iterator[Table]:
    """Yield HEX 1 to HEX 3; the origin of the prong's frame is at the prong's inner face."""

    def part(name: str, frame: str, ends: tuple[float, float], ys: tuple[float, float], high: float, of: str) -> Table:
        (begin, end), (least, greatest) = ends, ys
        low, top = [begin, least, -high], [end, greatest, high]
        return _block("effector", name, frame, low, top, of) | {"axes": _EFFECTOR}

    wide, high = d.number("effector", "palm_half_width"), d.number("effector", "palm_half_height")
    yield part("palm", frames[6], d.span("effector", "palm"), (-wide, wide), high, "structure")
    ends, thick = d.span("effector", "fingers"), d.number("effector", "finger_thickness")
    high, inner = d.number("effector", "finger_half_height"), d.number("effector", "fixed_finger")
    yield part("fixed finger", frames[6], ends, (inner, inner + thick), high, "bright")
    yield part("prong", frames[7], ends, (-thick, 0.0), high, "bright")


def _along(axis: int, begin: float, end: float, side: float) -> tuple[Three, Three]:
    """Return the corners of a box with a square section along one axis of its frame, whose number is 0, 1 or 2."""
    half = 0.5 * side
    low, high = [-half] * 3, [half] * 3
    low[axis], high[axis] = begin, end
    return low, high


def _volume(block: Table) -> float:
    """Return the volume of a block [m3]."""
    x, y, z = (high - low for high, low in zip(block["high"], block["low"], strict=True))
    return float(x * y * z)

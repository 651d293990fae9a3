"""Arm files of Aftdeck 0.2 and before, also those in recordings, in the form of today.

They belonged to one of two families: that of the Shuttle's arm (yaw, pitch, pitch, pitch, yaw, roll), or that of the
concept arm of 1972 (heading, pitch, pitch, heading, pitch, roll). Their tables had one value for each joint.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from aftdeck.arms.old_blocks import AT_PRONG, Dimensions, blocks
from aftdeck.arms.old_masses import LINKS, with_links
from aftdeck.files import Problem, Where
from aftdeck.units import Length, Mass, Quantity

Table = dict[str, Any]
_RATES = ("servo", "coarse", "vernier", "acceleration")
_SIX = 6
"""Number of joints of both families."""
_CITED = ("source", "confidence")
_MADE = {"source": "the family of the arm (converted)", "confidence": "firm"}
"""Source of what a family stated for all its arms."""


class Conversion:
    """Conversion of one file.

    Attributes:
        problems: why the file cannot be converted, at places in it.
    """

    def __init__(self) -> None:
        self.problems: list[Problem] = []
        self._places: dict[Where, Where] = {}

    def convert(self, raw: Table) -> list[Problem]:
        """Convert decoded TOML of an arm file, and return the problems; a file of today is left as it is."""
        convert = _FAMILIES.get(str(raw.get("family")))
        if convert is None:
            return []
        with_links(raw)
        old = _Old(raw)
        try:
            convert(old)
        except _WrongError as wrong:
            self.problems = [wrong.problem]
            return self.problems
        self._places = old.places
        raw.clear()
        raw.update({**old.raw, **old.new})  # the reader rejects what is left of the old tables
        return []

    def in_file(self, problem: Problem) -> Problem:
        """Return a problem of the converted contents at its place in the file."""
        for end in range(len(problem.where), 0, -1):
            if (place := self._places.get(problem.where[:end])) is not None:
                return Problem((*place, *problem.where[end:]), problem.what)
        return problem


class _WrongError(Exception):
    def __init__(self, where: Where, what: str) -> None:
        self.problem = Problem(where, what)


class _Old:
    """File that is being converted.

    Attributes:
        raw: what is left of its contents.
        new: contents in the form of today.
        places: places in the new contents, and where in the file they come from.
    """

    def __init__(self, raw: Table) -> None:
        self.raw = {key: value for key, value in raw.items() if key != "family"}
        self.new: Table = {"sources": {}, "joint": []}
        self.places: dict[Where, Where] = {}

    def take(self, *where: str) -> Any:
        """Remove a value and return it."""
        if (table := self._table(where)) is None or where[-1] not in table:
            raise _WrongError(where[:-1], f"the field {where[-1]!r} is missing")
        value = table.pop(where[-1])
        for end in range(len(where) - 1, 0, -1):  # a table of which nothing is left
            if (outer := self._table(where[:end])) is not None and not outer.get(where[end - 1], True):
                del outer[where[end - 1]]
        return value

    def has(self, *where: str) -> bool:
        """Return whether the file has a table or value."""
        return (table := self._table(where)) is not None and where[-1] in table

    def constant(self, *where: str) -> Table:
        """Remove a constant and return it."""
        value = self.take(*where)
        if not isinstance(value, dict):
            raise _WrongError(where, "expected a table with value, source and confidence")
        for name in ("value", *_CITED):
            if name not in value:
                raise _WrongError(where, f"the field {name!r} is missing")
        return value

    def list(self, count: int, *where: str) -> list[Any]:
        """Remove a list and return it."""
        return _of_length(self.take(*where), count, where)

    def put(self, value: object, new: Where, old: Where) -> None:
        """Write a value, and where it comes from."""
        at: Any = self.new
        for part in new[:-1]:
            at = at[part] if isinstance(part, int) else at.setdefault(part, {})
        at[new[-1]] = value
        self.places[new] = old

    def _table(self, where: tuple[str, ...]) -> Table | None:
        at: Any = self.raw
        for part in where[:-1]:
            at = at.get(part) if isinstance(at, dict) else None
        return at if isinstance(at, dict) else None


def _of_length(value: Any, count: int, where: Where) -> list[Any]:
    if not isinstance(value, list) or len(value) != count:
        got = f"`array` of length {len(value)}" if isinstance(value, list) else repr(value)
        raise _WrongError(where, f"expected `array` of length {count}, got {got}")
    return value


def _number(kind: type[Quantity], value: object, where: Where) -> float:
    try:
        return float(kind.read(value))
    except (ValueError, TypeError) as error:
        raise _WrongError(where, str(error)) from None


def _turns(old: _Old, axes: tuple[int, ...], sticks: tuple[str, ...]) -> None:
    """Convert names, labels, limits and rates of the joints. `axes`: number of each joint's axis of L, from 0."""
    first = len(old.new["joint"])
    names, labels = old.list(_SIX, "joints"), old.list(_SIX, "labels")
    if len(set(map(str, names))) < _SIX:
        raise _WrongError(("joints",), f"has to be different names, got {', '.join(map(str, names))}")
    for k in range(_SIX):
        axis = [float(number == axes[k]) for number in range(3)]
        old.new["joint"].append({"kind": "turn", "axis": axis, "stick": sticks[k], "step": [0.0, 0.0, 0.0], **_MADE})
        old.put(names[k], ("joint", first + k, "name"), ("joints", k))
        old.put(labels[k], ("joint", first + k, "label"), ("labels", k))
    for table, quantities in (("limits", ("hard", "soft", "reach")), ("rates", _RATES)):
        for quantity in quantities:
            constant, where = old.constant(table, quantity), (table, quantity)
            _cite(old, quantity, constant, where)
            for k, value in enumerate(_of_length(constant["value"], _SIX, (*where, "value"))):
                old.put(value, ("joint", first + k, quantity), (*where, "value", k))
    old.put(old.constant("limits", "singular"), ("singular",), ("limits", "singular"))


def _cite(old: _Old, quantity: str, constant: Table, where: Where) -> None:
    old.put({name: constant[name] for name in _CITED}, ("sources", quantity), where)


def _step(old: _Old, joint: int, *where: str) -> list[Any]:
    """Give a joint the source of a constant, and return the constant's value."""
    constant = old.constant(*where)
    for name in _CITED:
        old.put(constant[name], ("joint", joint, name), (*where, name))
    old.places["joint", joint, "step"] = where
    value: list[Any] = constant["value"]
    return value


def _of_yaw_arm(old: _Old) -> None:
    """Convert a file of the family of the Shuttle's arm."""
    _turns(old, (2, 1, 1, 1, 2, 0), ("THC Y", "THC X", "THC Z", "RHC pitch", "RHC yaw", "RHC roll"))
    where = ("geometry", "shoulder_yaw_to_pitch")
    height = _number(Length, _step(old, 1, *where), (*where, "value"))
    old.new["joint"][1]["step"] = [0.0, 0.0, -height]
    for joint, name in ((2, "upper_arm"), (3, "lower_arm")):
        at = ("geometry", name, "value")
        along, down = _of_length(_step(old, joint, "geometry", name), 2, at)
        if not _number(Length, along, (*at, 0)) > 0.0:
            raise _WrongError((*at, 0), f"got {along}; expected a length above 0")
        old.new["joint"][joint]["step"] = [along, 0.0, down]
        old.places |= {("joint", joint, "step", k): (*at, n) for k, n in ((0, 0), (2, 1))}
    old.new["joint"][4]["step"] = [_step(old, 4, "geometry", "wrist_pitch_to_yaw"), 0.0, 0.0]
    tip = old.constant("geometry", "wrist_yaw_to_tip")
    old.put({**tip, "value": [tip["value"], 0.0, 0.0]}, ("tip",), ("geometry", "wrist_yaw_to_tip"))
    old.places["tip", "value", 0] = ("geometry", "wrist_yaw_to_tip", "value")
    lengths = {"shoulder_yaw_to_pitch": height, "wrist_pitch_to_yaw": old.new["joint"][4]["step"][0]}
    for name, length in (lengths | {"wrist_yaw_to_tip": tip["value"]}).items():
        if _number(Length, length, ("geometry", name, "value")) < 0.0:
            raise _WrongError(("geometry", name, "value"), f"got {length}; expected 0 to 200 m")
    old.put(old.constant("geometry", "end_effector_roll"), ("end_effector_roll",), ("geometry", "end_effector_roll"))
    _rods(old, tip["value"])
    frames = ("shoulder_yaw", "shoulder_pitch", "elbow_pitch", "wrist_pitch", "wrist_yaw", "wrist_roll")
    named = {f"arm.{frame}": f"arm.{joint['name']}" for frame, joint in zip(frames, old.new["joint"], strict=True)}
    bodies = old.raw.get("bodies")
    for body in bodies if isinstance(bodies, list) else ():
        if isinstance(body, dict) and str(body.get("frame")) in named:
            body["frame"] = named[str(body["frame"])]


def _rods(old: _Old, tip: object) -> None:
    """Convert the masses and, if the file has them, the links."""
    at = ("masses", "parts", "value")
    parts = old.constant("masses", "parts")
    masses = _masses(old, parts["value"], LINKS)
    beams = {name: old.constant("flexibility", f"booms_{name}") for name in _BEAM if old.has("flexibility")}
    if not old.has("links"):
        return
    given = {name: old.constant("links", name) for name in ("inertia", "foot", "boom_radius", "wrist_yaw_to_roll")}
    given |= {name: old.constant("links", name) for name in ("centre",) if old.has("links", name)}
    _cite(old, "mass", parts, at[:-1])
    for name, constant in beams.items():
        _cite(old, name, constant, ("flexibility", f"booms_{name}"))
    for name, constant in given.items():
        _cite(old, _LINK_NAMES[name], constant, ("links", name))
    origin, roll = [0.0, 0.0, 0.0], [given["wrist_yaw_to_roll"]["value"], 0.0, 0.0]
    spans = {0: [[0.0, 0.0, given["foot"]["value"]], origin], 5: [origin, roll], 6: [roll, [tip, 0.0, 0.0]]}
    for k, name in enumerate(LINKS):
        if masses[name] == 0.0:
            continue  # a plant with masses refuses such an arm
        where: Where = ("joint", k - 1, "link") if k else ("foot",)
        old.put({"kind": "rod", "part": name}, where, ("links",))
        old.put(parts["value"][name], (*where, "mass"), (*at, name))
        for of in given.keys() & {"inertia", "centre"}:
            values = _of_length(given[of]["value"], len(LINKS), ("links", of, "value"))
            old.put(values[k], (*where, _LINK_NAMES[of]), ("links", of, "value", k))
        if k in spans:
            old.put(spans[k], (*where, "span"), ("links", "wrist_yaw_to_roll" if k else "foot"))
        if name in _BOOMS:
            old.put(given["boom_radius"]["value"], (*where, "radius"), ("links", "boom_radius", "value"))
            for of, constant in beams.items():
                n, place = _BOOMS.index(name), ("flexibility", f"booms_{of}", "value")
                values = _of_length(constant["value"], len(_BOOMS), place)
                old.put(values[n], (*where, of), (*place, n))


def _masses(old: _Old, parts: object, names: tuple[str, ...]) -> dict[str, float]:
    """Convert the total of the masses, and return the masses of the parts [kg]."""
    at: Where = ("masses", "parts", "value")
    if not isinstance(parts, dict) or set(parts) != set(names):
        raise _WrongError(at, f"expected the masses of {', '.join(names)}")
    old.put(old.constant("masses", "total"), ("mass",), ("masses", "total"))
    return {name: _number(Mass, value, (*at, name)) for name, value in parts.items()}


_BOOMS = ("upper_boom", "lower_boom")
_BEAM = ("bending", "torsion")
_LINK_NAMES = {
    "inertia": "moments",
    "centre": "centre",
    "foot": "span",
    "wrist_yaw_to_roll": "span",
    "boom_radius": "radius",
}
"""Quantities of links, by their names in the old table ``links``."""


def _of_heading_arm(old: _Old) -> None:
    """Convert a file of the family of the concept arm of 1972."""
    joints = old.new["joint"]
    joints.append({"name": "stand", "label": "Telescope", "axis": [0.0, 0.0, -1.0]})
    _turns(old, (2, 1, 1, 2, 1, 0), ("THC Y", "THC X", "THC Z", "RHC yaw", "RHC pitch", "RHC roll"))
    joints.append({"name": "prong", "label": "Prong", "axis": [0.0, 1.0, 0.0]})
    d = Dimensions(old.constant, _number)
    for joint, driver, moved in (
        (0, "telescope", {name: ("stand", name) for name in ("least", "greatest", "start", "rate")}),
        (_SIX + 1, "prong", {new: ("effector", name) for new, name in AT_PRONG.items()}),
    ):
        joints[joint] |= {"kind": "slide", "driver": driver, "step": [0.0, 0.0, 0.0], **_MADE}
        old.places["joint", joint] = (moved["least"][0],)
        moved |= {name: ("slides", f"{driver}_{name}") for name in ("gain", "force") if old.has("slides")}
        for new, where in moved.items():
            old.put(d.constant(*where), ("joint", joint, new), where)
    parts = old.constant("masses", "parts")
    masses, half = _masses(old, parts["value"], ("upper_arm", "lower_arm", "hand")), 0.5 * d.number("booms", "side")
    for joint, name in ((2, "upper_arm"), (3, "lower_arm")):
        constant, length = d.constant("geometry", name), d.number("geometry", name)
        if not length > 0.0:
            raise _WrongError(("geometry", name, "value"), f"got {length:g} m; expected 0.0005 to 200 m")
        joints[joint + 1] |= {"step": [constant["value"], 0.0, 0.0], **{cited: constant[cited] for cited in _CITED}}
        old.places["joint", joint + 1, "step", 0] = ("geometry", name, "value")
        if masses[name] > 0.0:
            ends = {"low": [0.0, -half, -half], "high": [length, half, half]}
            link = {"kind": "box", "mass": parts["value"][name], **ends}
            old.put(link, ("joint", joint, "link"), ("masses", "parts", "value", name))
    palm = d.constant("effector", "palm")
    old.put({**palm, "value": [d.span("effector", "palm")[1], 0.0, 0.0]}, ("tip",), ("effector", "palm"))
    old.places["tip", "value", 0] = ("effector", "palm", "value", 1)
    tube = 0.0
    if old.has("slides"):
        tube = _number(Mass, old.constant("slides", "telescope_mass")["value"], ("slides", "telescope_mass", "value"))
    old.new["bodies"] = blocks(d, [f"arm.{joint['name']}" for joint in joints], masses["hand"], tube)
    for k, body in enumerate(old.new["bodies"]):
        old.places["bodies", k] = (body.pop("table"),)


_FAMILIES: dict[str, Callable[[_Old], None]] = {
    "yaw-pitch-pitch-pitch-yaw-roll": _of_yaw_arm,
    "heading-pitch-pitch-heading-pitch-roll": _of_heading_arm,
}

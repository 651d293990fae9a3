"""Attack on a step's inputs: objects of any kind are flown as plain values, or rejected with the state unchanged."""

from __future__ import annotations

import decimal
import enum
import fractions
import functools
import random
from collections import deque
from collections.abc import Callable, Iterator
from typing import Any, NoReturn

import msgspec
import numpy as np

from aftdeck.errors import InputError
from aftdeck.recording.convert import input_record, inputs_of
from aftdeck.scenario.disturbance import Disturbance
from aftdeck.scenario.target import Target
from aftdeck.simulation.camera_drives import CameraDrive
from aftdeck.simulation.inputs import POSITIONS, Inputs
from aftdeck.simulation.run import SavedSimulation, Simulation
from fuzz.flights import not_finite

STEPS = 6
"""Number of control steps of each attack."""
SCENARIOS = ("concept-1972", "first-flight", "free-flyer")
_SHAPED = {"translation": 3, "rotation": 3, "orbiter": 3, "master": 6}


class Rude:
    """Object whose methods raise."""

    def _rude(self, *_: object) -> NoReturn:
        raise RuntimeError("rude")

    __float__ = __int__ = __index__ = __iter__ = __len__ = __eq__ = __hash__ = __bool__ = __repr__ = _rude
    __lt__ = __le__ = __gt__ = __ge__ = __getitem__ = __str__ = __neg__ = __array__ = tolist = _rude


class RudeFloat(float):
    """Number that cannot be converted."""

    def __float__(self) -> NoReturn:
        raise ZeroDivisionError("rude")


class OwnText(str):
    """Text of a class of its own, whose conversion to text is another text."""

    def __str__(self) -> str:
        return "coarse"


class OwnNumber(float):
    """Number of a class of its own."""


class Rate(enum.StrEnum):
    """Switch positions of a caller's own."""

    COARSE = "coarse"


class Endless(list[float]):
    """Sequence without an end."""

    def __iter__(self) -> Iterator[float]:
        while True:
            yield 0.0


class Foreign:
    """Object with the fields of a target and of a camera's drive, but of another class."""

    position, rotation, joints = (0.0, 0.0, 0.0), ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)), None
    camera, pan, tilt, zoom, slow = "A", 0.0, 0.0, 0.0, False


NUMBERS: tuple[Callable[[float], object], ...] = (
    float, np.float64, np.float32, np.float16, np.longdouble, np.array, OwnNumber, fractions.Fraction, decimal.Decimal,
    lambda x: np.array(x, dtype=np.float32), lambda x: np.array([x]), int, np.int8, np.int64, np.bool_, bool, complex,
    np.complex64, str, np.str_, RudeFloat, lambda x: x * 4.0, lambda x: -0.0 * x, lambda x: [x], lambda x: {x}, repr,
)  # fmt: skip
"""Types of a number; some keep its value, some change it, and some are no numbers."""
SEQUENCES: tuple[Callable[[list[Any]], object], ...] = (
    tuple, list, np.array, deque, set, iter, frozenset, Endless, lambda x: tuple(x)[:-1], lambda x: (*x, 0.0),
    lambda x: dict.fromkeys(map(repr, x)), lambda x: np.array(x, dtype=object), lambda x: np.array([x]),
    lambda x: (y for y in x), lambda x: range(len(x)), lambda x: bytes(len(x)), repr,
)  # fmt: skip


def _anything(rng: random.Random) -> object:
    """Return an object that no field, or only some field, allows."""
    return rng.choice(
        (
            None, True, False, 0, 1, -1, 5, 6, 0.5, 1.0, -1.0, 2.0, -0.0, float("nan"), float("inf"), -1e308, 10**400,
            2**63, "", "no", "yes", "coarse", "SINGLE", "OPR CMD", "A", "\ud800", "\x1b[2J", "x" * 100_000, b"coarse",
            bytearray(3), memoryview(b"abc"), [], (), {}, set(), frozenset({1.0}), object(), Rude(), RudeFloat(0.5),
            OwnText("no"), OwnText("vernier"), Rate.COARSE, Endless(), Foreign(), iter([0.0] * 3), range(3), slice(3),
            type, len, NotImplemented, Ellipsis, 1j, decimal.Decimal("0.5"), fractions.Fraction(1, 2), np.float32(0.1),
            np.float64("nan"), np.int16(1), np.uint64(2**63), np.bool_(True), np.str_("coarse"), np.bytes_(b"open"),
            np.datetime64("2020-01-01"), np.timedelta64(1, "s"), np.array("coarse"), np.array(True), np.array(0.5),
            np.array([]), np.zeros(3), np.zeros((3, 3)), np.zeros(6, dtype=np.int8), np.array([None] * 3), np.ma.masked,
            np.zeros(3, dtype="M8[s]"), np.zeros(3)[::-1], Inputs(), CameraDrive("A"),
            Target((0.0, 0.0, 0.0), ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))),
        )
    )  # fmt: skip


def _number(rng: random.Random) -> object:
    value = rng.choice((0.0, 0.5, -0.5, 1.0, -1.0, 0.25))
    return _anything(rng) if rng.random() < 0.1 else rng.choice(NUMBERS)(value)


def _sequence(rng: random.Random, count: int) -> object:
    values = [rng.choice((float, np.float64, np.float32))(rng.uniform(-1.0, 1.0)) for _ in range(count)]
    if rng.random() < 0.3:
        values[rng.randrange(count)] = _number(rng)  # type: ignore[call-overload]
    try:
        return rng.choice(SEQUENCES)(values)
    except Exception:  # a set of unhashable items, for example
        return values


def _rotation(rng: random.Random) -> object:
    rows = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
    made = (rows, np.array(rows), np.array(rows, dtype=np.float32), tuple(map(tuple, rows)), rows[:2], [rows])
    return _anything(rng) if rng.random() < 0.2 else rng.choice(made)


def _disturbance(rng: random.Random) -> object:
    made: Any = (
        rng.choice(("tip", "orbiter", "payload", np.str_("tip"), OwnText("tip"), _anything(rng))),
        _sequence(rng, 3),
        _sequence(rng, 3),
        rng.choice(("L", "space", "orbiter", "tip", "payload", _anything(rng))),
        rng.choice((None, _sequence(rng, 3))),
    )
    return Disturbance(*made) if rng.random() < 0.9 else _anything(rng)


def _field(name: str, rng: random.Random) -> object:
    """Return a value for a field of `Inputs`: plausible, of an unusual type, or anything at all."""
    if rng.random() < 0.25:
        return _anything(rng)
    if name in _SHAPED:
        return _sequence(rng, _SHAPED[name])
    if name in ("drive", "telescope"):
        return _number(rng)
    if name == "target":
        made: Any = (_sequence(rng, 3), _rotation(rng), rng.choice((None, _sequence(rng, 6))))
        return Target(*made)
    if name == "camera":
        drive: Any = (rng.choice(("A", "B", _anything(rng))), _number(rng), _number(rng), _number(rng), _anything(rng))
        return CameraDrive(*drive)
    if name == "disturbances":
        found = [_disturbance(rng) for _ in range(rng.randrange(3))]
        return rng.choice((tuple, list, deque, iter))(found) if rng.random() < 0.9 else _disturbance(rng)
    if name == "joint":
        return rng.choice((int, np.int8, np.array, float, str))(rng.randrange(7))
    if name == "mode":
        return rng.choice((str, np.str_, OwnText, np.array))(rng.choice(("SINGLE", "MASTER", "OPR CMD", "TEST")))
    if name in POSITIONS:
        return rng.choice((lambda x: x, np.array, OwnText, repr, type))(rng.choice(POSITIONS[name]))
    return rng.choice((bool, np.bool_, int, np.array, str))(rng.random() < 0.5)


def inputs_of_any_kind(rng: random.Random) -> Inputs:
    """Return inputs in which one to four fields have values of any kind."""
    names = rng.sample(Inputs.__struct_fields__, rng.choice((1, 1, 2, 4)))
    values: Any = {name: _field(name, rng) for name in names}
    return Inputs(**values)


@functools.cache
def _started(name: str) -> tuple[Simulation, SavedSimulation]:
    sim = Simulation(name)
    return sim, sim.save()


def attack(seed: int) -> str:
    """Make steps with inputs of any kind; return how many of them were flown.

    Raises:
        Exception: a step raised something other than an `InputError`.
        AssertionError: rejected inputs changed the state, or flown inputs differ from the recorded ones.
    """
    rng = random.Random(seed)
    sim, start = _started(rng.choice(SCENARIOS))
    sim.restore(start)
    flown = 0
    for _ in range(STEPS):
        flown += _step(sim, rng.choice((inputs_of_any_kind, inputs_of_any_kind, inputs_of_any_kind, _anything))(rng))
    return f"{flown} of {STEPS} flown"


def _step(sim: Simulation, inputs: Any) -> bool:
    """Make a step, and return whether the inputs were flown."""
    if inputs is None:
        inputs = Inputs()  # None selects the script
    before = sim.save()
    try:
        frame = sim.step(inputs)
    except InputError as error:
        assert str(error), "the message is empty"
        assert sim.save() == before, f"the rejected inputs changed the state: {error}"
        sim.step(Inputs())
        return False
    given = sim.given
    assert given is not None
    assert not (wrong := not_finite(msgspec.to_builtins(frame))), wrong
    written = input_record(frame.tick, given)
    record = msgspec.msgpack.decode(msgspec.msgpack.encode(written), type=type(written))
    assert (inputs_of(record) or Inputs(script=True)) == given, f"flown {given}, recorded {record}"
    after = sim.save()
    sim.restore(before)
    assert sim.step(given).sha256 == frame.sha256, f"a repetition with the plain values differs: {given}"
    assert sim.save() == after
    return True

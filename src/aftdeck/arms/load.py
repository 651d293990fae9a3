"""Loader that converts an arm file to arrays; `arms.check` makes the checks that field types cannot express."""

from __future__ import annotations

import functools
from collections.abc import Callable
from dataclasses import dataclass, replace
from decimal import Context, Decimal
from pathlib import Path
from typing import Literal, NamedTuple

import numpy as np

from aftdeck.arms.body_file import BlockBody
from aftdeck.arms.check import arm_problems
from aftdeck.arms.dynamics import Flexibility, Servo, flexibility_of, servo_of
from aftdeck.arms.geometry import Linkage, frozen, linkage_of, raised
from aftdeck.arms.joints import StickAxis, Switch
from aftdeck.arms.limits import JointRates, Limits, limits_of, rates_of
from aftdeck.arms.model import ArmFile, PorRow
from aftdeck.arms.old_file import Conversion
from aftdeck.arms.switched import PRONG, TELESCOPE, SwitchedJoint, switched_of
from aftdeck.arrays import Array
from aftdeck.dimensions import derive
from aftdeck.errors import ArmError, InputError, ScenarioError
from aftdeck.files import Text, examine, find_toml, read, sentences
from aftdeck.frames import Mount, rotation_x
from aftdeck.matrices import product

HERE = Path(__file__).parent

_LENGTH_TOLERANCE = 1e-9
"""Distance by which a telescope's length may be outside its limits, to allow for rounding in unit conversions [m]."""


class PorLimits(NamedTuple):
    """Limits of the point of resolution for one payload mass.

    Attributes:
        translation: V_L, greatest speed, for coarse and for vernier [m/s].
        rotation: omega_L, greatest angular rate, for coarse and for vernier [rad/s].
        acceleration: greatest acceleration, for both rate settings [m/s2].
        angular_acceleration: greatest angular acceleration, for both rate settings [rad/s2].
    """

    translation: tuple[float, float]
    rotation: tuple[float, float]
    acceleration: float
    angular_acceleration: float


@dataclass(frozen=True, eq=False)
class ArmModel:
    """Checked constants of an arm. Arrays are read-only.

    Attributes:
        name: name in the file.
        title: full name for display.
        units: units that the panel shows by default.
        joints: names of the joints, from base to tip.
        labels: short names of the joints for the page.
        linkage: the joints, as the laws and the pictures use them.
        switched: joints that switches drive, such as a telescope; they have no joint angles.
        master: for each joint of the master arm, the axis of the hand controllers that moves the joint. These axes are
            used if no other device gives the master arm's angles; None for a joint that no axis moves.
        covered: whether the arm's solids are covers that enclose round parts. If so, neighbouring solids overlap at
            joints.
        mount: position and orientation of the arm's base frame L on the orbiter.
        limits: joint limits.
        singular: normalised distance below which the SINGULAR lamp lights [1].
        rates: joint rate limits.
        por: rows of limits by payload mass, lightest first.
        servo: servos and brakes; None if the file does not describe them.
        flexibility: springs of the arm; None if the file does not describe them.
        source: the decoded file, with the source and confidence of each constant.
        text: text of the file as it was read.
        shapes: file of the arm's drawn shapes; None if the arm file names no such file.
    """

    name: str
    title: str
    units: Literal["ft-in", "SI"]
    joints: tuple[str, ...]
    labels: tuple[str, ...]
    linkage: Linkage
    switched: tuple[SwitchedJoint, ...]
    master: tuple[StickAxis | None, ...]
    covered: bool
    mount: Mount
    limits: Limits
    singular: float
    rates: JointRates
    por: tuple[PorRow, ...]
    servo: Servo | None
    flexibility: Flexibility | None
    source: ArmFile
    text: str
    shapes: Text | None

    @property
    def links(self) -> Array:
        """Array for the laws of the arm's solver (`kinematics.solver`)."""
        return self.linkage.links

    @property
    def slides(self) -> tuple[bool, ...]:
        """For each joint, whether it slides along its axis; otherwise it turns about it."""
        return self.linkage.slides

    @property
    def singularities(self) -> tuple[str, ...]:
        """Names of the singularities that the arm's solver tells apart."""
        return self.linkage.singularities

    @property
    def frames(self) -> tuple[str, ...]:
        """Names of all frames that carry a body: the linkage's frames, then those of the joints that switches drive."""
        return (*self.linkage.frames, *(joint.frame for joint in self.switched))

    @functools.cached_property
    def telescope(self) -> SwitchedJoint | None:
        """Joint that carries the arm, driven by the telescope's switch; None if the arm has no telescope."""
        return self._driven_by(TELESCOPE)

    @functools.cached_property
    def prong(self) -> SwitchedJoint | None:
        """Prong of the end effector, driven by its switch; None if the end effector has snares."""
        return self._driven_by(PRONG)

    def _driven_by(self, switch: Switch) -> SwitchedJoint | None:
        return next((joint for joint in self.switched if joint.driver == switch), None)

    @property
    def end_effector_roll(self) -> float:
        """Roll from frame 7 to the end effector's own axes E [rad]: the angle r in R_E = R_7 Rx(r)."""
        return self.linkage.end_effector_roll

    @property
    def stand(self) -> float | None:
        """Length of the telescope, which is the height of the shoulder [m]; None if the arm has no telescope."""
        return None if self.telescope is None else float(self.links[0])

    def at(self, stand: float) -> ArmModel:
        """Return the same arm with its telescope at another length [m].

        Raises:
            InputError: the arm has no telescope, or the length is outside the telescope's limits.
        """
        if self.telescope is None:
            raise InputError(f"the arm {self.name} has no telescope: `stand` cannot be given")
        least, greatest = self.telescope.least, self.telescope.greatest
        if not least - _LENGTH_TOLERANCE <= stand <= greatest + _LENGTH_TOLERANCE:
            raise InputError(
                f"the telescope (`stand`) of {self.name} is {least:g} to {greatest:g} m long, got {stand:g} m"
            )
        return self.standing(stand)

    def standing(self, height: float) -> ArmModel:
        """Return the same arm with its shoulder at this height above L's origin [m].

        The height is not checked: a telescope with a mass can pass the end of its range by some millimetres.
        """
        return replace(self, linkage=raised(self.linkage, height))

    def por_limits(self, payload_mass: float) -> PorLimits:
        """Return the limits of the point of resolution for a payload's mass [kg].

        Between two rows for payloads, the limits are interpolated linearly in the logarithm of the mass. Between the
        row without a payload and the row of the lightest payload, they are interpolated linearly in the mass. If the
        mass is greater than in the row of the heaviest payload, the limits of that row apply (assumed).

        Raises:
            InputError: the mass is negative.
        """
        if not payload_mass >= 0.0:
            raise InputError(f"a payload's mass has to be 0 or more, got {payload_mass:g} kg")
        rows = self.por
        upper = next((i for i, row in enumerate(rows) if row.mass >= payload_mass), len(rows) - 1)
        low, high = rows[max(upper - 1, 0)], rows[upper]
        if payload_mass >= high.mass or low is high:
            share = 1.0
        elif low.mass == 0.0:
            share = payload_mass / high.mass
        else:
            share = _log(payload_mass / low.mass) / _log(high.mass / low.mass)

        def between(a: float, b: float) -> float:
            return float(b if share == 1.0 else a + share * (b - a))

        translation, rotation = between(low.translation, high.translation), between(low.rotation, high.rotation)
        reached_in = between(low.reached_in, high.reached_in)
        return PorLimits(
            (translation, between(low.vernier_translation, high.vernier_translation)),
            (rotation, between(low.vernier_rotation, high.vernier_rotation)),
            translation / reached_in,
            rotation / reached_in,
        )


def built_in() -> tuple[str, ...]:
    """Return the names of the arms that come with Aftdeck."""
    return tuple(sorted(p.stem for p in HERE.glob("*.toml") if "." not in p.stem))


def load_model(name_or_path: str | Path) -> ArmModel:
    """Return a built-in arm by its name, or the arm that a file describes.

    Raises:
        ArmError: no built-in arm has that name.
        ScenarioError: the file has errors (the message lists all of them), or the arm's shape file cannot be read.
    """
    path = find_toml(name_or_path, HERE, built_in(), ("arm", "arms"), ArmError)
    return model_of(read(path), lambda name: read(path.parent / name))


def model_of(source: Text, shapes: Callable[[str], Text]) -> ArmModel:
    """Return the arm that the text of an arm file describes.

    Args:
        source: name and text of the arm file.
        shapes: returns the arm's shape file; its argument is the file's name as written in the arm file.

    Raises:
        ScenarioError: the text has errors; the message lists all of them. `shapes` may raise other errors.
    """
    file = _checked(source)
    return _model(source, shapes(file.shapes) if file.shapes else None)


@functools.lru_cache(maxsize=8)
def _checked(source: Text) -> ArmFile:
    """Return the contents of an arm file, which are immutable and can therefore be cached."""
    old = Conversion()
    file, problems = examine(ArmFile, source, derive=lambda raw: old.convert(raw) or derive(raw))
    problems = old.problems or problems or ([] if file is None else arm_problems(file))
    if file is None or problems:
        raise ScenarioError(sentences([old.in_file(problem) for problem in problems], *source))
    return file


def _log(ratio: float) -> float:
    """Return the natural logarithm, which `decimal` rounds correctly on every machine."""
    return float(Context(prec=30).ln(Decimal(ratio)))


@functools.lru_cache(maxsize=8)
def _model(source: Text, shapes: Text | None) -> ArmModel:
    """Return the arm of an arm file and its shape file. An arm is immutable and can therefore be cached."""
    file = _checked(source)
    mount = Mount(
        _panel(file.mount.origin.value),
        frozen(product(np.diag([-1.0, -1.0, 1.0]), rotation_x(file.mount.lean.value))),
        _panel(file.mount.orbiter_origin.value),
    )
    rates = rates_of(file)
    return ArmModel(
        name=file.name,
        title=file.title,
        units=file.units,
        joints=file.joints,
        labels=file.labels,
        linkage=linkage_of(file),
        switched=switched_of(file),
        master=tuple(joint.stick for joint in file.steered),
        covered=not any(isinstance(body, BlockBody) for body in file.bodies),
        mount=mount,
        limits=limits_of(file),
        singular=file.singular.value,
        rates=rates,
        por=file.por,
        servo=servo_of(file, rates),
        flexibility=flexibility_of(file),
        source=file,
        text=source.text,
        shapes=shapes,
    )


def _panel(structural: tuple[float, float, float]) -> Array:
    """Convert structural Xo, Yo, Zo into panel components X = -Xo, Y = Yo, Z = -Zo."""
    return frozen([-structural[0], structural[1], -structural[2]])

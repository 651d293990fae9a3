"""Question ``frequencies`` of the command ``arm``. Only this question imports MuJoCo."""

from __future__ import annotations

from typing import TYPE_CHECKING

from aftdeck.arms.by_joint import shown
from aftdeck.cli.arm import PayloadAxis
from aftdeck.cli.printing import print_cautions, print_json
from aftdeck.errors import InputError
from aftdeck.lines import print_line
from aftdeck.plant.multibody.frequencies import frequencies
from aftdeck.plant.usual_payload import HEAVIEST, PAYLOAD_MASS, usual_payload
from aftdeck.scenario.changes import value_of
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.begin import initial_state
from aftdeck.simulation.constants.flight import run_constants
from aftdeck.units import Mass
from aftdeck.worksite.file.load import load_worksite
from aftdeck.worksite.file.schema import ORBITER_MASS
from aftdeck.worksite.model import OrbiterMass

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from aftdeck.bodies.mass_properties import MassProperties
    from aftdeck.bounds import Bounds
    from aftdeck.kinematics.arm import Arm


SCALED = 10.0
"""Ratio to the usual orbiter's mass beyond which its proportions are no longer those of a spacecraft (assumed) [1]."""
ROUNDED = 1e-9
"""Excess of an angle [rad] or of a share of a mass [1] that comes from the conversion of units."""


def print_frequencies(
    arm: Arm,
    angles: Sequence[float],
    payload_mass: str | None,
    payload_axis: PayloadAxis | None,
    payload_of: str | None,
    free: bool,
    orbiter_mass: str | None,
    as_json: bool,
) -> None:
    """Print the natural frequencies of an arm, lowest first; on standard error, cautions about strange arguments.

    Raises:
        ArmError: the arm has no table `flexibility`.
        InputError: a mass is not plausible, an option lacks the option that it refers to, or
            the end effector of the scenario holds nothing.
    """
    if payload_axis is not None and payload_mass is None:
        raise InputError("--payload-axis needs --payload-mass")
    if orbiter_mass is not None and not free:
        raise InputError("--orbiter-mass needs --free")
    payload = None if payload_of is None else _held(payload_of)
    orbiter = None
    if payload_mass is not None:
        if payload is not None:
            raise InputError("--payload has its own mass: give either --payload or --payload-mass")
        axis = list(PayloadAxis).index(payload_axis or PayloadAxis.pitch)
        payload = usual_payload(_mass("--payload-mass", payload_mass, PAYLOAD_MASS), axis)
    if free:
        usual = load_worksite("orbiter").orbiter
        assert usual is not None, "the orbiter's worksite has an orbiter"
        mass = usual.mass if orbiter_mass is None else _mass("--orbiter-mass", orbiter_mass, ORBITER_MASS)
        x, y, z = (moment * mass / usual.mass for moment in usual.inertia)
        orbiter = OrbiterMass(mass, (x, y, z), usual.centre).in_l(arm.model.mount)
    found = frequencies(arm.model, angles, payload=payload, orbiter=orbiter).tolist()
    option = "--payload-mass" if payload_of is None else "--payload"
    cautions = list(_cautions(arm, angles, option, payload, orbiter))
    print_cautions(cautions)
    if as_json:
        print_json({"arm": arm.name, "frequencies_hz": found, "cautions": cautions})
        return
    for number, frequency in enumerate(found, start=1):
        print_line(f"{number:>3}  {frequency:>10.4f} Hz")


def _cautions(
    arm: Arm, angles: Sequence[float], option: str, payload: MassProperties | None, orbiter: MassProperties | None
) -> Iterator[str]:
    """Yield what is strange about a pose, a payload (from an option) and an orbiter, although it can be computed."""
    for joint, slides, angle, (low, high) in zip(
        arm.joints, arm.model.slides, angles, arm.limits.hard.tolist(), strict=True
    ):
        if not low - ROUNDED <= angle <= high + ROUNDED:
            least, given, most = (shown(value, slides, ".4g") for value in (low, angle, high))
            yield f"{joint} at {given} is beyond its hard stops, {least} and {most}"
    if payload is not None and payload.mass > HEAVIEST * (1.0 + ROUNDED):
        yield f"{option}: {payload.mass:.6g} kg is more than the Shuttle's heaviest payload, {HEAVIEST:.6g} kg"
    usual = load_worksite("orbiter").orbiter
    assert usual is not None, "the orbiter's worksite has an orbiter"
    if orbiter is not None and not usual.mass / SCALED <= orbiter.mass <= usual.mass * SCALED:
        yield (
            f"--orbiter-mass: {orbiter.mass:.6g} kg is far from the {usual.mass:.6g} kg of the orbiter whose centre of "
            "mass and proportions are taken"
        )


def _held(name: str) -> MassProperties:
    """Return the mass properties of the payload that the end effector holds at the start of a scenario."""
    scenario = load_scenario(name)
    payload = initial_state(run_constants(scenario)).carried.payload
    if payload is None:
        raise InputError(f"--payload: the end effector of {scenario.name!r} holds no payload at the start")
    return payload.properties


def _mass(option: str, text: str, bounds: Bounds) -> float:
    """Return the mass that an option gives, as in a file [kg]."""
    try:
        value = Mass.read(value_of(text))
    except ValueError as error:
        raise InputError(f"{option}: {error}") from None
    if why := bounds.problem(value, Mass.unit):
        raise InputError(f"{option}: {why}")
    return float(value)

"""Arm, payload and orbiter of `dynamics`, checked."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from aftdeck.analysis.coordinates import ROUNDED, finite
from aftdeck.arms.load import ArmModel
from aftdeck.arms.masses import servo_needed
from aftdeck.arrays import floats_of
from aftdeck.bodies.mass_properties import MassProperties, impossible
from aftdeck.bounds import COORDINATE, Bounds
from aftdeck.errors import InputError
from aftdeck.plant.usual_payload import PAYLOAD_MASS, usual_payload
from aftdeck.units import Mass, short
from aftdeck.worksite.file.load import load_worksite, worksites
from aftdeck.worksite.file.schema import ORBITER_MASS

PITCH = 1
"""Axis of frame 7 along which a payload of which only the mass is given lies."""


def without_friction(model: ArmModel) -> ArmModel:
    """Return an arm without friction in motors and gearboxes, and without steps of encoders and tachometers."""
    springs, exact = model.flexibility, np.zeros(len(model.joints))
    return replace(
        model,
        servo=servo_needed(model)._replace(friction=exact, encoder_step=exact, tachometer_step=exact),
        flexibility=None if springs is None else springs._replace(friction=exact),
    )


def smooth(model: ArmModel) -> ArmModel:
    """Return an arm without friction, as `without_friction`, and without stops."""
    limits = model.limits._replace(hard=np.full_like(model.limits.hard, [-1e6, 1e6]))
    return replace(without_friction(model), limits=limits)


def given_payload(payload: object) -> MassProperties | None:
    """Return a payload's mass properties in frame 7, with the tip as origin; None for no payload.

    Raises:
        InputError: it is neither None, a mass [kg] nor `MassProperties`, or no body has these properties.
    """
    if payload is None:
        return None
    if isinstance(payload, MassProperties):
        return _checked(payload, "payload", PAYLOAD_MASS)
    if isinstance(payload, tuple | list):
        raise InputError(f"payload: expected a mass [kg] or aftdeck.MassProperties, got {short(payload)}")
    return usual_payload(_mass(payload, "payload", PAYLOAD_MASS), PITCH)


def given_orbiter(orbiter: object, model: ArmModel) -> MassProperties | None:
    """Return the free orbiter's mass properties in L; None if it is fixed.

    Raises:
        InputError: it is neither ``fixed``, ``free`` nor `MassProperties`, or no body has these properties.
    """
    if isinstance(orbiter, MassProperties):
        return _checked(orbiter, "orbiter", ORBITER_MASS)
    if orbiter == "fixed":
        return None
    if orbiter != "free":
        raise InputError(f"orbiter: expected 'fixed', 'free' or aftdeck.MassProperties, got {short(orbiter)}")
    usual = load_worksite(model.name if model.name in worksites() else "orbiter").orbiter
    assert usual is not None, "the worksites of arms have an orbiter"
    return usual.in_l(model.mount)


def _mass(given: object, what: str, bounds: Bounds) -> float:
    array = floats_of(given, f"{what}'s mass")
    if array.ndim:
        raise InputError(f"{what}'s mass: expected one number [kg], got {short(given)}")
    if why := bounds.problem(float(array), Mass.unit):
        raise InputError(f"{what}'s mass: {why}")
    return float(array)


def _checked(body: MassProperties, what: str, bounds: Bounds) -> MassProperties:
    mass, centre, inertia = (
        _mass(body.mass, what, bounds),
        finite(body.centre, f"{what}'s centre"),
        finite(body.inertia, f"{what}'s inertia"),
    )
    if centre.shape != (3,) or inertia.shape != (3, 3):
        raise InputError(
            f"{what}: expected a centre (3,) and an inertia (3, 3), got shapes {centre.shape} and {inertia.shape}"
        )
    for value in centre.tolist():
        if why := COORDINATE.problem(value, "m"):
            raise InputError(f"{what}'s centre: {why}")
    if np.abs(inertia - inertia.T).max() > ROUNDED * np.abs(inertia).max():
        raise InputError(f"{what}'s inertia: expected a symmetric matrix, got {inertia.tolist()}")
    if why := impossible(inertia):
        raise InputError(f"{what}'s inertia: {why}")
    return MassProperties(mass, centre, inertia)

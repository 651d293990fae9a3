"""Acquiring a payload and releasing it: the prong about a bar (the report's mode 1), the snares about a pin."""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import NDArray

from aftdeck.bodies.hexahedron import BODY, place
from aftdeck.bodies.pose import POSE, compose, pose_of, relative, row_of
from aftdeck.frames import Pose
from aftdeck.simulation.flight import Flight
from aftdeck.simulation.grasp import let_go, place_held, regrasp, take_hold
from aftdeck.simulation.hand import Bar, Snares
from aftdeck.simulation.log import log
from aftdeck.simulation.seating import stay_or_leave
from aftdeck.simulation.state import State
from aftdeck.worksite.acquisition import AWAY, FOUND, acquire, acquisition
from aftdeck.worksite.conditions import Condition
from aftdeck.worksite.draw_in import remaining
from aftdeck.worksite.grapple import in_envelope
from aftdeck.worksite.snare import SnareCommand, advance

Array = NDArray[np.float64]

NEAR = 3.0
"""A bar or a fixture farther from the hand than this [m] is not yet being captured."""
_ALL = np.arange(4)
_TRIGGERS: dict[str, Literal["", "capture", "release"]] = {"close": "capture", "open": "release", "stop": ""}
_CONTR: dict[str, Literal["RIGID", "OFF", "DERIGID"]] = {"rigid": "RIGID", "off": "OFF", "derigid": "DERIGID"}
_NOWHERE = row_of(Pose(np.zeros(3), np.eye(3)))


def capture(flight: Flight, state: State, pressed: bool) -> None:
    """Take hold of a payload or let it go, as the hand's conditions say.

    Args:
        flight: what never changes.
        state: at the step's end, all frames in place.
        pressed: the end effector switch was put in this step: the snares' trigger.
    """
    if flight.site.bar is not None:
        _prong(flight, state, flight.site.bar)
    elif flight.site.snares is not None:
        _snares(flight, state, flight.site.snares, pressed)


def _prong(flight: Flight, state: State, bar: Bar) -> None:
    """Acquired when the six conditions hold; released as soon as the fingers are farther apart than they allow."""
    site, things = flight.site, state.site
    held = things.held
    if held is not None:
        if bar.fixed_finger - things.prong.position > bar.tolerances.spacing:
            _release(flight, state, held)
        return
    least, found = NEAR, np.empty(FOUND)
    for k, packed in enumerate(bar.receptacles):
        if packed is None:
            continue
        bodies = np.empty((4, BODY))
        for row, solid in enumerate(bar.solids):
            bodies[row] = things.watch.placed[solid, :BODY]
        pose = things.frames[site.cargo_row(k)]
        place(packed, pose[:3], pose[3:].reshape(3, 3), bodies[3])
        if acquire(bodies, _ALL, bar.packed, found):
            _acquired(flight, state, k)
            return
        if found[AWAY] < least:
            least = float(found[AWAY])
            things.pursuit = f"acquire {site.cargo[k].title}"
            things.conditions = acquisition(found, bar.tolerances, flight.scenario.arm.model.units)


def _snares(flight: Flight, state: State, snares: Snares, pressed: bool) -> None:
    """CAPTURE and RELEASE, and the carriage between them."""
    site, things, scenario = flight.site, state.site, flight.scenario
    held = things.held
    k = held
    conditions: tuple[Condition, ...] = ()
    if held is None and (k := _nearest(flight, state, snares)) is not None:
        fixture = pose_of(_fixture(flight, state, snares, k))
        conditions = in_envelope(fixture, snares.envelope, scenario.arm.model.units)
        things.pursuit, things.conditions = f"capture {site.cargo[k].title}", conditions
    command = SnareCommand(
        "AUTO" if things.effector_mode == "auto" else "MAN",
        _TRIGGERS[things.switch] if pressed else "",
        _CONTR[things.rigid],
    )
    drawn = things.snare.drawn
    things.snare, said = advance(things.snare, snares.times, command, scenario.control_period, conditions)
    for line in said:
        log(flight, state, line.kind, line.level, line.text)
    if held is None and k is not None and things.snare.captured:
        things.cargo[k].first = _fixture(flight, state, snares, k).tolist()
        _acquired(flight, state, k)
    elif held is not None and not things.snare.captured:
        _release(flight, state, held)
    elif held is not None and things.snare.drawn != drawn:
        _draw_in(flight, state, snares, held)


def _nearest(flight: Flight, state: State, snares: Snares) -> int | None:
    """The cargo whose fixture is nearest to the end effector, if one is near."""
    best, least = None, NEAR
    for k, fixture in enumerate(snares.fixtures):
        if fixture is not None:
            away = float(np.linalg.norm(_fixture(flight, state, snares, k)[:3]))
            if away < least:
                best, least = k, away
    return best


def _fixture(flight: Flight, state: State, snares: Snares, k: int) -> Array:
    """(12,) a cargo's grapple fixture in the end effector's axes E."""
    site, frames = flight.site, state.site.frames
    effector, fixture, found = np.empty(POSE), np.empty(POSE), np.empty(POSE)
    compose(frames[site.last_joint], site.effector, effector)
    compose(frames[site.cargo_row(k)], snares.fixture(k), fixture)
    relative(effector, fixture, found)
    return found


def _draw_in(flight: Flight, state: State, snares: Snares, k: int) -> None:
    """The carriage draws the pin to its seat; a payload that is fixed stays, and the arm gives way (assumed)."""
    site, things = flight.site, state.site
    thing = things.cargo[k]
    if thing.seat or thing.first is None:
        return
    left = row_of(remaining(pose_of(np.array(thing.first)), things.snare.misaligned))
    pin, centre, grasp = np.empty(POSE), np.empty(POSE), np.empty(POSE)
    compose(site.effector, left, pin)
    relative(snares.fixture(k), _NOWHERE, centre)
    compose(pin, centre, grasp)
    thing.grasp = grasp.tolist()
    place_held(flight, state)
    if things.snare.drawn == 1.0:
        regrasp(flight, state, k)


def _acquired(flight: Flight, state: State, k: int) -> None:
    """MODE 1 ends: the payload is in the grasp; what merely lies in the concept's bay comes along."""
    site, thing = flight.site, state.site.cargo[k]
    if thing.seat and site.lies(thing.seat):
        thing.seat = ""
    take_hold(flight, state, k)
    fixed = f", fixed in the {site.seat(thing.seat).title}" if thing.seat else ""
    log(flight, state, "acquired", "info", f"{site.cargo[k].title} acquired{fixed}")


def _release(flight: Flight, state: State, k: int) -> None:
    """The payload stays where it is fixed, or keeps its velocity."""
    site, thing = flight.site, state.site.cargo[k]
    let_go(flight, state, k)
    stay_or_leave(flight, state, k)
    where = f"it stays in the {site.seat(thing.seat).title}" if thing.seat else "it is free"
    log(flight, state, "released", "info", f"{site.cargo[k].title} released: {where}")

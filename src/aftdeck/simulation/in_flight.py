"""Changes in flight: constants and state of a run that goes on with changed values (the report's typewriter).

A change makes the scenario anew, with all its checks, and from it the constants of the run. The state is then resumed
with these constants, as a saved state is, so that nothing keeps an old value.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator
from typing import NamedTuple

import msgspec

from aftdeck.bodies.cameras import Setting
from aftdeck.errors import InputError
from aftdeck.files import Where
from aftdeck.scenario.in_flight import changing
from aftdeck.scenario.keys import key_at
from aftdeck.scenario.load import in_force
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.camera_drives import Views
from aftdeck.simulation.constants.flight import Flight, run_constants
from aftdeck.simulation.frame_poses import frames_with_prong_at
from aftdeck.simulation.operator.check_request import begin_check
from aftdeck.simulation.parts.free_flight import at_start
from aftdeck.simulation.parts.worksite_state import WorksiteState
from aftdeck.simulation.resume import restore_clearances, resume
from aftdeck.simulation.state import State
from aftdeck.state_part import encoded
from aftdeck.worksite.payload import Payload

_CHANGES = State.__struct_fields__.index("changes")
_ROUNDING = 1e-9
"""Distance [rad or m] by which a coordinate may be outside its limits because of rounding."""


class Resumed(NamedTuple):
    """Run that goes on: its constants and its state."""

    flight: Flight
    state: State


class Made(NamedTuple):
    """Constants of a run with changes in force, which another process may have made.

    Attributes:
        changes: the changes, each as KEY=VALUE.
        flight: the constants.
    """

    changes: tuple[str, ...]
    flight: Flight


def constants_with(base: Flight, changes: tuple[str, ...], *, gauged: bool) -> Flight:
    """Return the constants of a run with changes in flight.

    Args:
        base: constants with which the run began.
        changes: changes in force, each as KEY=VALUE.
        gauged: whether the plant has gauges.

    Raises:
        InputError: a change is not possible; the message says why.
    """
    scenario = in_force(base.scenario, changes)
    return base if scenario is base.scenario else run_constants(scenario, gauged=gauged)


def make(scenario: Scenario, changes: tuple[str, ...]) -> Made:
    """Return the constants of a run without gauges; arguments and errors as for `scenario.load.in_force`."""
    return Made(changes, run_constants(in_force(scenario, changes)))


def changes_in(saved: bytes) -> tuple[str, ...]:
    """Return the changes in force in an encoded state; none if the bytes are not a state."""
    try:
        changes = msgspec.msgpack.decode(saved)[_CHANGES]
        return msgspec.convert(changes, tuple[str, ...])
    except (msgspec.MsgspecError, IndexError, TypeError, KeyError, ValueError):
        return ()


def go_on(before: Flight, after: Flight, state: State, changes: tuple[str, ...], given: Collection[Where]) -> State:
    """Return the state of a run that goes on with other constants.

    Cameras and free payloads take a new setting or start. A verdict of CMD CK, or a check in progress, which were made
    with the old constants, begin again; a PROCEED that waits for the verdict stays.

    Args:
        before: constants of the run until now.
        after: its constants from now on.
        state: the state, which stays unchanged.
        changes: changes that are then in force.
        given: places of the values that change now.

    Raises:
        InputError: as for `check_fit`.
    """
    check_fit(before, after, state, given)
    new, panel = resume(after, encoded(state)), state.panel
    new.changes = changes
    new.views = _views(before, after, new.views, given)
    for k in _moved(before, after, given):
        _place(after, new, k)
    checked = panel.check is not None or state.checking is not None
    if checked and panel.target is not None and panel.sequence != "in progress" and any(map(_is_rehearsed, given)):
        begin_check(new, panel.target)
    return new


def _is_rehearsed(where: Where) -> bool:
    """Return whether a rehearsal depends on a value."""
    row = changing(key_at(where))
    return row is not None and row.rehearsed


def check_fit(before: Flight, after: Flight, state: State, given: Collection[Where]) -> None:
    """Check that a run can go on from its present state with other constants.

    Raises:
        InputError: it cannot; the message says why.
    """
    if why := next(_misfits(before, after, state, given), ""):
        raise InputError(why)


def _misfits(before: Flight, after: Flight, state: State, given: Collection[Where]) -> Iterator[str]:
    """Yield the reasons why a state does not fit new constants."""
    plant, worksite, arm = state.plant, state.worksite, after.scenario.arm.model
    if before.hard != after.hard:
        for name, at, (low, high), slides in zip(
            arm.joints, plant.angles.tolist(), after.hard, arm.slides, strict=True
        ):
            yield from _outside(f"the joint {name}", at, low, high, slides=slides)
    if before.telescope != after.telescope:
        yield from _outside("the telescope", plant.stand.position, after.telescope.low, after.telescope.high)
    if before.prong != after.prong:
        yield from _outside("the prong", worksite.prong.position, after.prong.low, after.prong.high)
    if type(before.scenario.worksite.acquisition) is not type(after.scenario.worksite.acquisition):
        yield "the kind of the end effector cannot change in flight"
    if before.cameras.axes != after.cameras.axes:
        yield "a camera would lose or get a drive, which cannot change in flight"
        return
    for name, at in zip(after.cameras.names, _views(before, after, state.views, given), strict=True):
        if why := after.cameras.misfit(name, at):
            yield f"camera {name} is set so that it does not fit: {why}"
    yield from _unplaceable(after, worksite, _moved(before, after, given))


def _unplaceable(flight: Flight, worksite: WorksiteState, payloads: Collection[int]) -> Iterator[str]:
    """Yield the reasons why payloads cannot be put at their starts."""
    for k in payloads:
        title = flight.site.payloads[k].title
        if flight.plant.has_contact_forces:
            yield f"{title} moves by forces alone on the plant {flight.scenario.plant!r}; its place cannot be set"
        elif worksite.floating[k] is None:
            yield f"{title} is held; its place can be set while nothing holds it"
        elif flight.site.payloads[k].start.berth:
            yield f"{title} cannot be put into a berth in flight; give a position"


def _outside(what: str, at: float, low: float, high: float, *, slides: bool = True) -> Iterator[str]:
    """Yield a sentence if a coordinate is outside its new limits."""
    if low - _ROUNDING <= at <= high + _ROUNDING:
        return
    factor, unit = (1.0, "m") if slides else (180.0 / math.pi, "deg")
    yield (
        f"{what} is at {at * factor:.6g} {unit}, outside the new limits {low * factor:.6g} to {high * factor:.6g} "
        f"{unit}: move it first"
    )


def _views(before: Flight, after: Flight, views: Views, given: Collection[Where]) -> Views:
    """Return the settings of the cameras' drives.

    An angle that is given now, or whose value at the start has changed otherwise, is that of the start.
    """
    found = []
    for name, *settings in zip(after.cameras.names, before.cameras.first, after.cameras.first, views, strict=True):
        parts = zip(Setting._fields, *settings, strict=True)
        found.append(
            Setting(*(new if new != old or ("cameras", name, part) in given else now for part, old, new, now in parts))
        )
    return tuple(found)


def _moved(before: Flight, after: Flight, given: Collection[Where]) -> list[int]:
    """Return the indices of the payloads whose start is given now, or has changed otherwise."""
    starts = zip(before.site.payloads, after.site.payloads, strict=True)
    named = {where[1] for where in given if where[:1] == ("cargo",) and "start" in where}
    return [k for k, (old, new) in enumerate(starts) if k in named or _start(old) != _start(new)]


def _start(payload: Payload) -> tuple[object, ...]:
    """Return the start of a payload in a form that can be compared."""
    at = payload.start
    return at.berth, *(array.tolist() for array in (*at.pose, at.velocity, at.rates))


def _place(flight: Flight, state: State, k: int) -> None:
    """Put a free payload at its start, with its motion at the start."""
    site, worksite = flight.site, state.worksite
    worksite.floating[k] = at_start(site, k)
    worksite.update_carrier(site, k)
    row = site.payload_rows[k]
    worksite.frames[row] = frames_with_prong_at(site, worksite, state.plant, worksite.prong.position)[row]
    worksite.before[row] = worksite.frames[row]
    restore_clearances(flight, state)


def resumed(base: Flight, saved: bytes, *, gauged: bool) -> Resumed:
    """Return the run of an encoded state, with the changes that were in force in it.

    Args:
        base: constants with which the run began.
        saved: the encoded state.
        gauged: whether the plant has gauges.

    Raises:
        InputError: the bytes are not a state of this run.
    """
    flight = constants_with(base, changes_in(saved), gauged=gauged)
    return Resumed(flight, resume(flight, saved))

"""Frame's part about the bodies behind the joints, on a plant with masses."""

from __future__ import annotations

import numpy as np

from aftdeck.arms.flexures import Flexure
from aftdeck.arrays import Array
from aftdeck.bodies.pose import POSE, compose, rows, vec3
from aftdeck.frames import angle_between
from aftdeck.law import law
from aftdeck.matrices import distance
from aftdeck.plant.state import Bodies
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.constants.site import Site
from aftdeck.simulation.frame import HOLDERS, Bend, Dynamics, Force, Holding, Placed
from aftdeck.simulation.observe.frame_numbers import six
from aftdeck.simulation.state import State
from aftdeck.tuples import Rows, Six, Vec3


@law
def body_numbers(frames: Array, last: int, tip: Array, base: Array, fired: Array) -> tuple[Vec3, Rows, Vec3, Rows, Six]:
    """Return position and attitude of the tip, position and attitude of L, and firing times.

    Args:
        frames: (F, 12) poses of all frames in L.
        last: row of the last joint's frame.
        tip: (12,) pose of the tip in this frame.
        base: (12,) pose of L, relative to its pose at the start of the run.
        fired: (6,) times for which the orbiter's jets have fired [s].
    """
    at = np.empty(POSE)
    compose(frames[last], tip, at)
    return vec3(at, 0), rows(at, 3), vec3(base, 0), rows(base, 3), six(fired, 0)


def dynamics_of(flight: Flight, state: State) -> Dynamics | None:
    """Return the true motion of the bodies; None on the kinematic plant."""
    bodies, site, target = state.plant.bodies, flight.site, state.panel.target
    if bodies is None:
        return None
    position, orientation, at, axes, fired = body_numbers(
        state.worksite.frames, site.last_joint, site.hand, state.plant.base, bodies.fired
    )
    miss = None
    if target is not None:
        miss = distance(target.position, position), angle_between(target.rotation, orientation)
    driven = bodies.overdriven.tolist()
    overdriven = tuple([joint for joint, beyond in enumerate(driven) if beyond]) if any(driven) else ()
    return Dynamics(
        position,
        orientation,
        miss,
        tuple(bodies.torques.tolist()),
        overdriven,
        Placed(at, axes),
        fired,
        _contacts(site, bodies),
        _holds(site, bodies),
        _bends(flight.scenario.flexures, bodies),
        state.disturbances,
    )


def _contacts(site: Site, bodies: Bodies) -> tuple[Force, ...]:
    """Return the forces between parts in contact."""
    if not bodies.touches:
        return ()
    return tuple(
        Force(*site.layout.named(touch.group), touch.force, touch.place, touch.greatest) for touch in bodies.touches
    )


def _holds(site: Site, bodies: Bodies) -> tuple[Holding, ...]:
    """Return the forces that hold payloads."""
    if not site.payloads:
        return ()
    return tuple(
        Holding(site.payloads[k].name, holder, force, greatest)
        for k, forces in enumerate(zip(bodies.held.tolist(), bodies.held_greatest.tolist(), strict=True))
        for holder, force, greatest in zip(HOLDERS, *forces, strict=True)
        if greatest
    )


def _bends(flexures: tuple[Flexure, ...], bodies: Bodies) -> tuple[Bend, ...]:
    """Return the bends of base and booms."""
    if not flexures:
        return ()
    numbers = zip(flexures, bodies.bends.tolist(), strict=True)
    return tuple(Bend(part.part, (a, b, c), (d, e, f)) for part, (a, b, c, d, e, f) in numbers)

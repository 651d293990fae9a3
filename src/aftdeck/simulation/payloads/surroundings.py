"""Worksite on a plant with masses: what holds the payloads, which solids can touch, and where the payloads move."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array, Indices
from aftdeck.bodies.pose import POSE, compose, relative
from aftdeck.errors import SimulationError
from aftdeck.law import law
from aftdeck.plant.plant import MOST_PAIRS, NOTHING_NEAR, Hold, Surroundings
from aftdeck.plant.state import Bodies, PlantState
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.constants.site import Site
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.parts.worksite_state import WorksiteState
from aftdeck.simulation.payloads.disturbances import pushes
from aftdeck.simulation.payloads.grasp import pose_in_hand
from aftdeck.simulation.payloads.jets import attitude_torques, translation_command
from aftdeck.simulation.state import State
from aftdeck.worksite.watch.near import near_pairs

NEAR = 0.02
"""Distance below which two solids can touch in the next control period [m], in addition to the distance that they cover
at their present speeds: for an acceleration of 0.5 m/s2, it is enough for periods up to 0.28 s (assumed)."""
NOTHING = Surroundings()
"""Surroundings on a plant without masses."""


def surroundings(flight: Flight, state: State, inputs: Inputs) -> Surroundings:
    """Return what acts on the bodies in the next control period, besides servos and brakes."""
    site, worksite, bodies = flight.site, state.worksite, state.plant.bodies
    if bodies is None:
        return NOTHING
    found = attitude_torques(site.payloads, worksite.floating, bodies, flight.scenario.control_period)
    if state.disturbances:
        found += pushes(site.payloads, state.disturbances, state.plant.base)
    return Surroundings(
        _holds(site, worksite),
        _near(flight, worksite),
        worksite.prong.position,
        translation_command(flight, worksite, bodies, inputs.orbiter),
        found,
    )


def _near(flight: Flight, worksite: WorksiteState) -> Indices:
    """Return the pairs of solids that can touch in the next control period.

    Raises:
        SimulationError: more pairs are near each other than the plant can test.
    """
    layout, watch = flight.site.layout, worksite.watch
    if watch.least >= flight.within:
        return NOTHING_NEAR
    near = np.empty((MOST_PAIRS, 3), np.int64)
    count = near_pairs(
        watch.active, watch.found, NEAR, flight.scenario.control_period, worksite.before, worksite.frames,
        layout.reach, layout.frame, layout.begins, layout.pairs, watch.placed, near,
    )  # fmt: skip
    if count > MOST_PAIRS:
        raise SimulationError(
            f"{count} pairs of solids are near each other; this plant can compute the forces of at most {MOST_PAIRS}"
        )
    return near[:count]


def _holds(site: Site, worksite: WorksiteState) -> list[Hold]:
    """Return all connections of the worksite's payloads.

    End effector and berth hold a payload in the poses that carriage and latches have reached. A payload that both hold
    is pulled by both: the latches draw it in, and the arm gives way.
    """
    found = []
    for k, payload in enumerate(worksite.payloads):
        if payload.grasp is not None:
            found.append(Hold(k, "hand", np.array(payload.grasp)))
        if (fit := site.fit(k, payload.berth)) is not None:
            seated, pose = np.empty(POSE), np.empty(POSE)
            compose(fit.place, np.array(payload.offset_in_berth), seated)
            compose(site.scene, seated, pose)
            in_space = fit.row == site.space_row
            found.append(Hold(k, "space" if in_space else "orbiter", pose, give=fit.berth.gives))
    device, place = site.capture, worksite.watch.place
    touched = None if device is None else device.touched(worksite.controls(), worksite.held, worksite.frames, place)
    if touched is not None:
        k, closed = touched
        found.append(Hold(k, "hand", pose_in_hand(site, worksite.frames, k), closed))
    return found


def follow_payloads(site: Site, worksite: WorksiteState, plant: PlantState, bodies: Bodies) -> None:
    """Set the payloads of the worksite to the poses and motions to which the plant has moved them."""
    for k, floating in enumerate(worksite.floating):
        if floating is not None:
            floating.pose[:], floating.motion[:] = bodies.payloads[k], bodies.motions[k]
    if site.payloads:
        ride(site.scene, plant.base, plant.frames, worksite.carrier, bodies.payloads, worksite.poses_in_carrier)


@law
def ride(scene: Array, base: Array, true: Array, carrier: Indices, poses: Array, rides: Array) -> None:
    """Write the poses of payloads in the frames that carry them.

    Args:
        scene: (12,) the orbiter's frame in L.
        base: (12,) pose of L in the frame that is fixed in space and coincided with L at the start.
        true: (f, 12) poses of the arm's frames in L.
        carrier: (c,) as in `place_everything`.
        poses: (c, 12) poses of the payloads, in the frame of `base`.
        rides: (c, 12) output: as in `place_everything`.
    """
    seen = np.empty(POSE)
    for c in range(len(carrier)):
        row = carrier[c]
        if row < 0:
            rides[c] = poses[c]
        elif row == len(true) + 1:  # space
            relative(scene, poses[c], rides[c])
        else:
            relative(base, poses[c], seen)
            relative(scene if row == 0 else true[row - 1], seen, rides[c])

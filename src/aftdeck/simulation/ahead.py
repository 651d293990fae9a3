"""Where everything would be after a step that is not made yet."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from aftdeck.bodies.pose import compose
from aftdeck.kinematics.frames import place_frames
from aftdeck.simulation.flight import Flight
from aftdeck.simulation.state import State

Array = NDArray[np.float64]


def frames_after(flight: Flight, state: State, rates: Array, telescope: float) -> Array:
    """(F, 12) where every frame would be after a step of joint rates (6,) and the telescope's drive; others stay."""
    site, things, plant = flight.site, state.site, state.plant
    period = flight.scenario.control_period
    after = things.frames.copy()
    height = plant.stand.after(telescope, period)
    angles = plant.angles + rates * period
    place_frames(site.arm.joints, angles, height, things.prong.position, after[site.arm_rows])
    for k, cargo in enumerate(things.cargo):
        if cargo.grasp is not None:
            compose(after[site.last_joint], np.array(cargo.grasp), after[site.cargo_row(k)])
    return after

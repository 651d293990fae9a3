"""Poses in which pairs of clusters are tested for overlaps."""

from __future__ import annotations

from itertools import chain, islice

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.pose import HERE, POSE, row_of
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.relative import composed, inverted, scene_in_l
from aftdeck.simulation.survey.poses import inside_soft_stops, placed, stops
from aftdeck.worksite.watch.pairs import STILL

SAMPLES = 300
"""Number of random poses; the stops of all joints are tested too."""
_AWAY = 1e6
"""Distance at which bodies that do not belong to the arm are placed [m]."""


def sampled_poses(scenario: Scenario, frames: tuple[str, ...]) -> Array:
    """Return poses (s, F, 12) of frames in the scene: all combinations of stops, and poses inside the soft stops.

    Payloads are far away. Further poses follow in which each payload is fixed to a berth, and the arm is far away.
    """
    scene = inverted(scene_in_l(scenario.arm.model.mount, scenario.worksite.origin))
    samples = chain((at[1:] for at in stops(scenario)), islice(inside_soft_stops(scenario), SAMPLES))
    rows = []
    for angles, stand, prong in samples:
        arm = placed(scenario, angles, stand, prong)
        row = np.empty((len(frames), POSE))
        for k, name in enumerate(frames):
            if name in arm:
                row[k] = row_of(composed(scene, arm[name]))
            else:
                row[k] = HERE
                row[k, 0] += 0.0 if name == "orbiter" else _AWAY * (1 + k)
        rows.append(row)
    for payload in scenario.payloads:
        for berth in scenario.worksite.berths:
            if payload.name in frames and not berth.lacks(payload.probe, payload.trunnions):
                row = np.tile(np.array(HERE), (len(frames), 1))
                row[:, 0] += [_AWAY * (1 + k) * (name not in STILL) for k, name in enumerate(frames)]
                row[frames.index(payload.name)] = row_of(berth.seated(payload.probe))
                rows.append(row)
    return np.array(rows)

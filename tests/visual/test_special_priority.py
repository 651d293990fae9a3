"""The report's special priority of end effector and receptacle, worked out apart, against the order of a picture.

The report has steps of their own for the palm, the two fingers and the receptacle: it traces the tree X1 of the end
effector, puts the receptacle at the bottom, and lifts it ahead of a finger or the palm if the plane between the two
(D1 to D3, from the collision test) has the receptacle on the eye's side. Here `aftdeck.separation` gives the planes.

Source: Remote Manipulator Simulation, final report, chapter V, special priority.
"""

from __future__ import annotations

from collections import Counter
from typing import NamedTuple

import numpy as np
import pytest

import aftdeck
from aftdeck.arrays import Array
from aftdeck.errors import SimulationError
from aftdeck.scenario.load import load_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.constants.site import all_solids
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.run import Simulation
from aftdeck.visual.scene import VisualScene

RECEPTACLE = "payload receptacle"
EFFECTOR = ("palm", "fixed finger", "prong")
NEAR_M = 1.0
"""Distance of the receptacle from the end effector up to which states are compared [m]."""


class Lifted(NamedTuple):
    """Result of the special priority.

    Attributes:
        row: the four parts, highest priority first.
        touching: parts of the end effector that touch the receptacle, so that there is no plane between them.
    """

    row: tuple[str, ...]
    touching: frozenset[str]


def corners(scenario: Scenario, scene: VisualScene, frame: Frame) -> dict[str, Array]:
    """Return the vertices (8, 3) of the solids of end effector and receptacle, in the scene [m]."""
    poses = dict(zip(scene.clusters.frames, scene.frames_at(frame), strict=True))
    return {
        solid.part: np.array(solid.vertices) @ poses[solid.frame][3:].reshape(3, 3).T + poses[solid.frame][:3]
        for solid in all_solids(scenario)
        if solid.part in (RECEPTACLE, *EFFECTOR)
    }


def special_priority(bodies: dict[str, Array], effector: tuple[str, ...], eye: Array) -> Lifted:
    """Return the parts in the order of the special priority; `effector`: its parts in the order of the trace of X1."""
    ahead_of, touching = [], set()
    for part in effector:
        found = aftdeck.separation(bodies[part], bodies[RECEPTACLE])
        if found.plane is None:
            touching.add(part)
        elif found.plane.normal @ eye > found.plane.distance:
            ahead_of.append(part)
    place = min((effector.index(part) for part in ahead_of), default=len(effector))
    return Lifted((*effector[:place], RECEPTACLE, *effector[place:]), frozenset(touching))


@pytest.mark.slow
def test_the_order_contains_the_special_priority() -> None:
    """From approach to docking, whenever the receptacle is near the end effector, for every camera."""
    scenario = load_scenario("concept-1972-script")
    scene, simulation = VisualScene(scenario), Simulation(scenario)
    parts = [cluster.part for cluster in scene.clusters.clusters]
    places: Counter[int] = Counter()
    compared = 0
    while not simulation.ended:
        for _ in range(25):
            simulation.advance()
        frame = simulation.look()
        bodies = corners(scenario, scene, frame)
        if min(aftdeck.separation(bodies[part], bodies[RECEPTACLE]).clearance for part in EFFECTOR) > NEAR_M:
            continue
        for camera in scene.cameras:
            aim = scene.aim(frame, camera, 4 / 3)
            try:
                table = [parts[k] for k in scene.order(frame, aim).clusters]
            except SimulationError:
                continue  # camera B is inside the payload
            effector = tuple(part for part in table if part in EFFECTOR)
            if RECEPTACLE not in table or len(effector) < len(EFFECTOR):
                continue
            lifted = special_priority(bodies, effector, aim.position)
            places[lifted.row.index(RECEPTACLE)] += 1
            for nearer, hidden in scene.hidden_pairs():
                pair = parts[nearer], parts[hidden]
                if RECEPTACLE in pair and set(pair) <= {RECEPTACLE, *EFFECTOR} and not set(pair) & lifted.touching:
                    assert lifted.row.index(pair[0]) < lifted.row.index(pair[1]), (frame.time_s, camera, pair)
                    compared += 1
    assert compared > 1000
    assert len(places) == len(EFFECTOR) + 1  # the receptacle was at the bottom, at the top, and at both places between

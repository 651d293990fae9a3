"""Drawn shapes of a scenario as surfaces, each in the frame that carries its body."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from aftdeck.details.details_of import details_of
from aftdeck.frames import IDENTITY, Pose
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.relative import inverted, scene_in_l
from aftdeck.scene.bodies import PAYLOAD, bodies_of
from aftdeck.scene.mesh import Mesh, moved
from aftdeck.scene.placed import Leaf, carried, placed
from aftdeck.scene.solids import solid


class Drawn(NamedTuple):
    """A single shape of a body.

    Attributes:
        body: name of the body.
        frame: name of the frame that carries the body.
        shape: the shape.
        surface: its surface, in that frame.
        is_detail: whether it only decorates the body.
    """

    body: str
    frame: str
    shape: Leaf
    surface: Mesh
    is_detail: bool


def drawn_shapes(scenario: Scenario) -> Iterator[Drawn]:
    """Yield all single shapes of a scenario, those of each body first, then its details."""
    model = scenario.arm.model
    mount = inverted(scene_in_l(model.mount, scenario.worksite.origin))
    home: dict[str, tuple[str, Pose]] = {body.name: (body.fixed_to, body.pose) for body in scenario.worksite.bodies}
    home[model.linkage.frames[0]] = ("orbiter", mount)
    if scenario.payload is not None:
        tip = Pose(model.linkage.tip, np.eye(3))
        home[PAYLOAD] = (model.linkage.frames[-1], scenario.payload.pose(tip))
    for body, details in zip(bodies_of(scenario), details_of(scenario), strict=True):
        frame, pose = home.get(body.name, (body.name, IDENTITY))
        for shapes, is_detail in ((body.shapes, False), (details, True)):
            for leaf, own in placed(shapes):
                yield Drawn(body.name, frame, leaf, moved(solid(leaf), carried(pose, own)), is_detail)

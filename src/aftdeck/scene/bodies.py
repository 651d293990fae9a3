"""Everything that is drawn: the worksite's bodies, the arm's, and the payload."""

from __future__ import annotations

from aftdeck.arms.shapes import shapes_of
from aftdeck.scenario.model import Scenario
from aftdeck.worksite.model import Body

PAYLOAD = "payload"
"""Name of the payload's body."""


def bodies_of(scenario: Scenario) -> tuple[Body, ...]:
    """The bodies of a scenario: those of the worksite, which stand still, the arm's from its foot on, the payload.

    An arm without a file of shapes has its frames' bodies too, with nothing to draw.
    """
    model = scenario.arm.model
    bodies = list(scenario.worksite.bodies)
    if model.shapes is None:
        bodies += [Body(name, ()) for name in model.linkage.frames]
    else:
        bodies += [Body(name, shapes) for name, shapes in shapes_of(model.shapes, model.linkage.frames).bodies.items()]
    if scenario.payload is not None:
        bodies.append(Body(PAYLOAD, scenario.payload.shapes))
    return tuple(bodies)

"""Everything that is drawn: the worksite's bodies, the arm's, the payload, and the worksite's payloads."""

from __future__ import annotations

from aftdeck.arms.shapes import shapes_of
from aftdeck.scenario.model import Scenario
from aftdeck.worksite.model import Body

PAYLOAD = "payload"
"""Name of the payload's body."""


def draws_payload(scenario: Scenario) -> bool:
    """Whether the payload in the grasp is drawn: one with a shape, which is never let go."""
    return scenario.payload is not None and scenario.payload.shapes != ()


def bodies_of(scenario: Scenario) -> tuple[Body, ...]:
    """The bodies of a scenario: of the worksite, of the arm from its foot on, the payload, the worksite's payloads."""
    bodies = list(scenario.worksite.bodies)
    bodies += [Body(name, shapes) for name, shapes in shapes_of(scenario.arm.model).bodies.items()]
    if draws_payload(scenario) and scenario.payload is not None:
        bodies.append(Body(PAYLOAD, scenario.payload.shapes))
    bodies += [Body(one.name, one.shapes) for one in scenario.cargo]
    return tuple(bodies)

"""Bodies that are drawn: the worksite's, the arm's, the payload, and the worksite's payloads."""

from __future__ import annotations

from aftdeck.arms.shapes import shapes_of
from aftdeck.scenario.model import Scenario
from aftdeck.worksite.model import Body

PAYLOAD = "payload"
"""Name of the payload's body."""


def draws_payload(scenario: Scenario) -> bool:
    """Return whether the scenario's own payload is drawn: one with a shape, which is never released."""
    return scenario.payload is not None and scenario.payload.shapes != ()


def bodies_of(scenario: Scenario) -> tuple[Body, ...]:
    """Return a scenario's bodies: the worksite's, the arm's from its base on, the payload, the worksite's payloads."""
    bodies = list(scenario.worksite.bodies)
    bodies += [Body(name, shapes) for name, shapes in shapes_of(scenario.arm.model).bodies.items()]
    if draws_payload(scenario) and scenario.payload is not None:
        bodies.append(Body(PAYLOAD, scenario.payload.shapes))
    bodies += [Body(one.name, one.shapes) for one in scenario.cargo]
    return tuple(bodies)

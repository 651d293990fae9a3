"""Bodies that are drawn: those of the worksite, those of the arm, the scenario's payload, the worksite's payloads."""

from __future__ import annotations

from aftdeck.arms.shapes import shapes_of
from aftdeck.scenario.model import Scenario
from aftdeck.worksite.model import Body

PAYLOAD = "payload"
"""Name of the body of the scenario's own payload."""


def draws_payload(scenario: Scenario) -> bool:
    """Return whether the scenario's own payload is drawn: it is, if it has a shape."""
    return scenario.payload is not None and scenario.payload.shapes != ()


def bodies_of(scenario: Scenario) -> tuple[Body, ...]:
    """Return a scenario's bodies in this order: worksite, arm from its base on, own payload, worksite's payloads."""
    bodies = list(scenario.worksite.bodies)
    bodies += [Body(name, shapes) for name, shapes in shapes_of(scenario.arm.model).bodies.items()]
    if draws_payload(scenario) and scenario.payload is not None:
        bodies.append(Body(PAYLOAD, scenario.payload.shapes))
    bodies += [Body(payload.name, payload.shapes) for payload in scenario.cargo]
    return tuple(bodies)

"""Bodies that are drawn: worksite, arm, the scenario's own payload, and the payloads of the worksite."""

from __future__ import annotations

from aftdeck.scenario.model import Scenario
from aftdeck.scenario.on_arm import arm_shapes
from aftdeck.worksite.body import Body

PAYLOAD = "payload"
"""Name of the body of the scenario's own payload."""


def draws_payload(scenario: Scenario) -> bool:
    """Return whether the scenario has its own payload and that payload has shapes to draw."""
    return scenario.payload is not None and scenario.payload.shapes != ()


def bodies_of(scenario: Scenario) -> tuple[Body, ...]:
    """Return a scenario's drawn bodies: worksite, arm from base to tip, own payload, payloads of the worksite."""
    bodies = list(scenario.worksite.bodies)
    bodies += [Body(name, shapes) for name, shapes in arm_shapes(scenario.arm.model, scenario.worksite).items()]
    if draws_payload(scenario) and scenario.payload is not None:
        bodies.append(Body(PAYLOAD, scenario.payload.shapes))
    bodies += [Body(payload.name, payload.shapes) for payload in scenario.payloads]
    return tuple(bodies)

"""Details of a scenario: shapes that only decorate its bodies (`worksite.model.Body.details`).

The station's page draws them, and the pictures without a depth buffer have them as marks on faces. Contacts, the survey
of cameras and recordings do not know them.
"""

from __future__ import annotations

from aftdeck.arms.shapes import shapes_of
from aftdeck.details.payload import payload_details
from aftdeck.scenario.model import Scenario
from aftdeck.scene.bodies import draws_payload
from aftdeck.shapes import Shape


def details_of(scenario: Scenario) -> tuple[tuple[Shape, ...], ...]:
    """Return the details of all drawn bodies, in the order of `scene.bodies.bodies_of`; each in its body's frame."""
    found = [body.details for body in scenario.worksite.bodies]
    found += shapes_of(scenario.arm.model).details.values()
    if draws_payload(scenario) and scenario.payload is not None:
        found.append(payload_details(scenario.payload.shapes, scenario.payload.mass))
    found += [payload.details + payload_details(payload.shapes, payload.mass) for payload in scenario.payloads]
    return tuple(found)

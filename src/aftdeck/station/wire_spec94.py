"""Data of the page of targets and payloads (SPEC 94 PDRS CONTROL): the payload table and the stored points."""

from __future__ import annotations

from typing import cast

from aftdeck.frames import Pose, panel_attitude
from aftdeck.scenario.limits import por_with
from aftdeck.scenario.model import Point, Scenario
from aftdeck.station import kinds, to_page
from aftdeck.steering.layout import RATE, SPEED, TURN
from aftdeck.steering.rules import rules_of


def payload_table(scenario: Scenario) -> tuple[to_page.PayloadInfo, ...]:
    """Return the payload table by PL ID: no payload, then the scenario's own payloads, then the worksite's."""
    own = [("payload" if k == 1 else f"payload {k}", one.mass) for k, one in enumerate(scenario.own_payloads, 1)]
    loads = (("no payload", 0.0), *own, *((cargo.name, cargo.mass) for cargo in scenario.cargo))
    return tuple(_row(scenario, number, name, mass) for number, (name, mass) in enumerate(loads))


def _row(scenario: Scenario, number: int, name: str, mass: float) -> to_page.PayloadInfo:
    """Return a row of the table: the steering's limits with a payload, which depend on its mass [kg] alone."""
    model = scenario.arm.model
    rules = rules_of(model, por_with(model, mass, scenario.por), scenario.control_period)
    coarse, vernier = rules["SINGLE", "coarse", 8], rules["SINGLE", "vernier", 8]
    return to_page.PayloadInfo(
        id=number,
        name=name,
        mass=mass,
        translation=(float(coarse[SPEED]), float(vernier[SPEED])),
        rotation=(float(coarse[TURN]), float(vernier[TURN])),
        coarse=cast("kinds.Six", tuple(coarse[RATE : RATE + 6].tolist())),
        vernier=cast("kinds.Six", tuple(vernier[RATE : RATE + 6].tolist())),
    )


def stored_sequences(scenario: Scenario) -> tuple[to_page.StoredSequence, ...]:
    """Return the points of AUTO 1-4, in panel components."""
    return tuple(
        to_page.StoredSequence(position, tuple(_stored(scenario, point) for point in points))
        for position, points in sorted(scenario.sequences.items())
    )


def _stored(scenario: Scenario, point: Point) -> to_page.StoredPoint:
    pose = point.target.pose
    hand = Pose(pose.position, scenario.arm.end_effector(pose.rotation))
    shown = scenario.arm.model.mount.to("panel", hand)
    position = cast("kinds.Vec3", tuple(shown.position.tolist()))
    return to_page.StoredPoint(position, panel_attitude(shown.rotation), point.pause)

"""Payload table and stored points, for the display SPEC 94 PDRS CONTROL."""

from __future__ import annotations

from typing import cast

from aftdeck.frames import Pose, panel_attitude
from aftdeck.scenario.limits import por_with
from aftdeck.scenario.model import Point, Scenario
from aftdeck.station.messages.welcome import PayloadInfo, StoredPoint, StoredSequence
from aftdeck.steering.layout import RATE, SPEED, TURN
from aftdeck.steering.rules import rules_of
from aftdeck.tuples import Vec3


def payload_table(scenario: Scenario) -> tuple[PayloadInfo, ...]:
    """Return the payload table, one row for each PL ID.

    PL ID 0 means "no payload". The next IDs are the payloads that the scenario attaches, then the worksite's payloads.
    """
    return tuple(_row(scenario, number, name, mass) for number, (name, mass) in enumerate(loads(scenario)))


def loads(scenario: Scenario) -> tuple[tuple[str, float], ...]:
    """Return name and mass [kg] of the payload with each PL ID."""
    own = [("payload" if k == 1 else f"payload {k}", load.mass) for k, load in enumerate(scenario.own_payloads, 1)]
    return (("no payload", 0.0), *own, *((payload.name, payload.mass) for payload in scenario.payloads))


def _row(scenario: Scenario, number: int, name: str, mass: float) -> PayloadInfo:
    """Return a row of the table: the steering limits for a payload of this mass [kg]."""
    model, joints = scenario.arm.model, len(scenario.arm.joints)
    rules = rules_of(model, por_with(model, mass, scenario.por), scenario.control_period)
    coarse, vernier = rules["SINGLE", "coarse", 8], rules["SINGLE", "vernier", 8]
    return PayloadInfo(
        id=number,
        name=name,
        mass=mass,
        translation=(float(coarse[SPEED]), float(vernier[SPEED])),
        rotation=(float(coarse[TURN]), float(vernier[TURN])),
        coarse=tuple(coarse[RATE : RATE + joints].tolist()),
        vernier=tuple(vernier[RATE : RATE + joints].tolist()),
    )


def stored_sequences(scenario: Scenario) -> tuple[StoredSequence, ...]:
    """Return the points of AUTO 1-4, in panel components."""
    return tuple(
        StoredSequence(position, tuple(_stored(scenario, point) for point in points))
        for position, points in sorted(scenario.sequences.items())
    )


def _stored(scenario: Scenario, point: Point) -> StoredPoint:
    pose = point.target.pose
    hand = Pose(pose.position, scenario.arm.end_effector(pose.rotation))
    shown = scenario.arm.model.mount.to("panel", hand)
    position = cast("Vec3", tuple(shown.position.tolist()))
    return StoredPoint(position, panel_attitude(shown.rotation), point.pause)

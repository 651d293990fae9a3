"""Conversion of the worksite's values to the page's: its equipment, and its state in each frame, in the scene."""

from __future__ import annotations

import math
from typing import cast

import numpy as np

from aftdeck.arrays import Array
from aftdeck.frames import SCENE_FROM_PANEL_AXES
from aftdeck.scenario.model import Scenario
from aftdeck.station import kinds, to_page
from aftdeck.worksite.report import Near, Vec3, Work


def work_info(scenario: Scenario) -> to_page.WorkInfo:
    """Return the equipment of a scenario's worksite and its clearance thresholds."""
    has = scenario.arm.model.equipment
    return to_page.WorkInfo(
        hand="snares" if has.prong is None else "prong",
        stand=None if has.telescope is None else to_page.StandInfo(*has.telescope),
        cargo=tuple(cargo.name for cargo in scenario.cargo),
        seats=tuple(seat.title for seat in scenario.worksite.seats),
        parts=tuple(scenario.parts),
        caution=scenario.caution,
        warning=scenario.warning,
    )


def effector_lamps(work: Work) -> tuple[to_page.Lamp, ...]:
    """Return DERIGIDIZE while the snares hold a payload that is not rigid, and RELEASE too while they release it."""
    hand = work.hand
    if hand.carriage is None or "RIGID" in hand.flags or not any(cargo.held for cargo in work.cargo):
        return ()
    releases = hand.switch == "open"
    moves = releases or hand.switch == "close" if hand.mode == "auto" else hand.rigid != "off"
    text = "the payload is held, not rigid"
    lamps = [to_page.Lamp("DERIGIDIZE", "info" if moves or releases else "caution", text)]
    if releases and hand.rigid == "off":
        lamps.append(to_page.Lamp("RELEASE", "info", "the payload is let go"))
    return tuple(lamps)


class WorkTranslator:
    """Converter of the state of one scenario's worksite to the page's coordinates."""

    def __init__(self, scenario: Scenario) -> None:
        mount = scenario.arm.model.mount
        self._panel_axes = mount.rotation
        self._axes = SCENE_FROM_PANEL_AXES @ mount.rotation
        self._titles = {"": "", **{seat.name: seat.title for seat in scenario.worksite.seats}}
        self._fixtures = {cargo.name: cargo.grapple.position for cargo in scenario.cargo if cargo.grapple is not None}
        self._origin = SCENE_FROM_PANEL_AXES @ mount.origin - scenario.worksite.origin

    def frame(self, work: Work, tip: Array, control: Array | None) -> to_page.WorkFrame:
        """Return the state of the worksite in a frame.

        Args:
            work: state of the worksite.
            tip: (3,) position of the end effector's tip, in L [m].
            control: (3, 3) the axes that the sticks act along, in panel components; None if the mode uses no sticks.
        """
        hand, way = work.hand, self._to_fixture(work, tip)
        return to_page.WorkFrame(
            task=work.task,
            nearest=None if work.nearest is None else self._near(work.nearest),
            clearance_level=work.clearance_level,
            contacts=tuple(self._near(near) for near in work.contacts),
            arm_inhibit=work.arm_inhibit,
            finger_inhibit=work.finger_inhibit,
            inhibits=work.inhibits,
            pursuit=work.pursuit,
            conditions=tuple(
                to_page.Condition(c.name, c.holds, c.value, c.limit, c.unit, c.margin, c.text) for c in work.conditions
            ),
            hand=to_page.HandFrame(
                hand.switch, hand.opening, hand.spacing, hand.carriage, hand.flags, hand.mode, hand.rigid
            ),
            stand=work.stand,
            orbiter=_vec3(self._panel_axes @ np.array(work.orbiter)),
            orbiter_velocity=_vec3(self._panel_axes @ np.array(work.orbiter_velocity)),
            cargo=tuple(
                to_page.CargoFrame(cargo.name, cargo.held, self._titles[cargo.seat], math.hypot(*cargo.velocity))
                for cargo in work.cargo
            ),
            master=work.master,
            fixture=None if way is None else math.hypot(*way.tolist()),
            to_fixture=None if way is None or control is None else _vec3(way @ control),
        )

    def _to_fixture(self, work: Work, tip: Array) -> Array | None:
        """Return the (3,) vector from the empty snares to the nearest fixture, in panel components [m].

        Returns:
            The vector; None if the arm has no snares, a payload is held, or no payload has a grapple fixture.
        """
        if work.hand.carriage is None or any(cargo.held for cargo in work.cargo):
            return None
        ways = (
            np.array(cargo.position) + np.array(cargo.orientation) @ self._fixtures[cargo.name] - tip
            for cargo in work.cargo
            if cargo.name in self._fixtures
        )
        nearest = min(ways, key=lambda way: math.hypot(*way.tolist()), default=None)
        return None if nearest is None else self._panel_axes @ nearest

    def _near(self, near: Near) -> to_page.Near:
        a, b = self._point(near.point_a), self._point(near.point_b)
        middle = tuple(0.5 * (x + y) for x, y in zip(a, b, strict=True))
        return to_page.Near(
            near.a,
            near.b,
            near.clearance,
            near.closing,
            a,
            b,
            cast("kinds.Vec3", middle),
            _vec3(self._axes @ np.array(near.normal)),
            near.essential,
        )

    def _point(self, point: Vec3) -> kinds.Vec3:
        return _vec3(self._axes @ np.array(point) + self._origin)


def _vec3(values: np.ndarray) -> kinds.Vec3:
    return cast("kinds.Vec3", tuple(values.tolist()))

"""Worksite's part of the state: poses, contacts, and which payloads are held, fixed or floating."""

from __future__ import annotations

from typing import Literal

import msgspec
import numpy as np

from aftdeck.arrays import Array, Indices, Mask
from aftdeck.bodies.pose import POSE, compose
from aftdeck.plant.linear_actuator import Slide, Travel
from aftdeck.scenario.schema import PayloadEvent
from aftdeck.simulation.constants.site import Site
from aftdeck.simulation.frame import WayOut
from aftdeck.simulation.parts.free_flight import Floating
from aftdeck.state_part import StatePart
from aftdeck.worksite.berths.latches import Latches
from aftdeck.worksite.capture.effector import Controls
from aftdeck.worksite.capture.snare import Snare
from aftdeck.worksite.watch.clearance_monitor import ClearanceMonitor
from aftdeck.worksite.watch.contacts import Contacts

Switch = Literal["stop", "close", "open"]
DRIVES: dict[Switch, float] = {"stop": 0.0, "close": 1.0, "open": -1.0}
"""Drive of the prong for each position of the end effector's switch."""
Halt = Literal["", "seat", "contact", "switch"]


class PayloadState(StatePart):
    """State of a payload. The payload is held by the end effector, fixed to a berth, both, or floating.

    A pose is a row of twelve numbers.
    """

    held: bool = False
    grasp: list[float] | None = None
    """Pose of the payload in the frame of the last joint; None if the payload is not held.

    The payload moves with this frame, unless a berth fixes the payload.
    """
    steered: list[float] | None = None
    """Pose of the payload that the steering uses, in the frame of the last joint; None if the payload is not held.

    This pose is set to `grasp` when the payload is captured, when the carriage has drawn it in fully, and when a berth
    releases it.
    """
    fixture_at_capture: list[float] | None = None
    """Pose of the fixture in E from which the carriage draws it in.

    This pose is set when the payload is captured, and when a berth releases it.
    """
    drawn_at_capture: float = 0.0
    """Value of `Snare.drawn` at the time when `fixture_at_capture` was set [1]."""
    berth: str = ""
    """Name of the berth that fixes the payload; "" if no berth does."""
    latches: Latches = Latches()
    offset_at_fixing: list[float] = msgspec.field(default_factory=list)
    """Pose of the payload relative to its final pose in the berth, at the time when the berth fixed the payload."""
    offset_in_berth: list[float] = msgspec.field(default_factory=list)
    """Present pose of the payload relative to its final pose in the berth, while the latches draw the payload in."""
    released_from: str = ""
    """Berth that has just released the payload; "" once the payload has left this berth.

    A port docks the payload again only after the payload has left the port, or on LATCH.
    """
    unlatch_asked_at: int = 0
    """Number of the control step of the last unconfirmed UNLATCH; 0 if there is none."""


class WorksiteState(StatePart):
    """State of the worksite: everything in the worksite on which the next step depends.

    Attributes:
        frames: (F, 12) pose of every coordinate frame, in L.
        before: (F, 12) poses of the frames one step earlier.
        monitored_before: (g,) 1 for pairs that were monitored in the last step.
        watch: clearances of the monitored pairs; they follow from `frames`, `before`, `monitored_before` and `nearest`.
        permitted: (g,) 1 for pairs that the task brings into contact; 0 for all other pairs. A pair of the task also
            has 0 while it touches in a relative position, or at a depth, that the task does not permit.
        contacts: contacts, and the inhibits that they cause.
        logged_contacts: pairs whose contact is logged.
        payloads: the payloads.
        floating: free flight of each payload; None while the end effector or a berth holds the payload.
        held: index of the payload in the grasp; None if no payload of the worksite is held.
        arm_fixed: True if the held payload is fixed to a berth, so that the arm cannot move.
        carrier: (c,) for each payload, the row of the frame that carries it; -1 if it floats.
        poses_in_carrier: (c, 12) pose of each payload in its carrier; if the payload floats, in the frame fixed in
            space that coincided with L at the start.
        nearest: pair with the minimum clearance among the pairs that count for CLEARANCE; -1 if no such pair is
            monitored.
        aligned_with: index of the payload with which the end effector is aligned for capture; None if there is none.
        orbiter: (3,) distance that the orbiter has moved forward, starboard and down [m].
        orbiter_velocity: (3,) velocity of the orbiter along the same axes [m/s].
        prong: prong of the concept arm's end effector; its position is the coordinate y2 of the prong's inner face.
        snare: state of the Shuttle's end effector.
        switch: position of the end effector switch.
        effector_mode: position of the switch END EFFECTOR MODE.
        rigid: position of the switch MAN CONTR.
        task: task phase, 1 to 4 (the report's mode).
        advice: escape direction from the contacts, as found last; None if there is none.
        orbiter_rejected: True if a translation of the orbiter was rejected in the last step.
        waiting: True if the carriage or the latches have stopped because further motion would make or deepen a contact.
        halt: cause that blocked the commanded motion in the last step: "seat" (a berth holds the held payload),
            "contact" (the motion would deepen a contact), "switch" (BRAKES, SAFING), or "" (none).
    """

    frames: Array
    before: Array
    monitored_before: Mask
    permitted: Mask
    contacts: Contacts
    payloads: list[PayloadState]
    floating: list[Floating | None]
    carrier: Indices
    poses_in_carrier: Array
    orbiter: Array
    orbiter_velocity: Array
    prong: Slide
    watch: ClearanceMonitor
    logged_contacts: tuple[int, ...] = ()
    held: int | None = None
    arm_fixed: bool = False
    nearest: int = -1
    aligned_with: int | None = None
    snare: Snare = Snare()
    switch: Switch = "stop"
    effector_mode: Literal["auto", "manual"] = "auto"
    rigid: Literal["off", "rigid", "derigid"] = "off"
    task: int = 1
    advice: WayOut | None = None
    orbiter_rejected: bool = False
    waiting: bool = False
    halt: Halt = ""

    @property
    def in_grasp(self) -> tuple[int, list[float] | None] | None:
        """The held payload and its pose as the steering uses it; None if the grasp is empty."""
        return None if self.held is None else (self.held, self.payloads[self.held].steered)

    @property
    def _addressed(self) -> list[PayloadState]:
        """Payloads to which latching and unlatching refer: the held payload, or all payloads if none is held."""
        return [payload for payload in self.payloads if payload.held] or self.payloads

    def has_occurred(self, what: PayloadEvent) -> bool:
        """Return whether an event for which a phase of a script can wait has occurred."""
        match what:
            case "captured":
                return self.held is not None and self.snare.motion != "capture"
            case "released":
                return self.held is None and self.snare.motion != "release"
            case "latched":
                return any(payload.berth and not payload.latches.motion for payload in self._addressed)
            case "unlatched":
                return not any(payload.berth for payload in self._addressed)

    def update_attachments(self, site: Site) -> None:
        """Update all values that depend on which payloads are held or fixed.

        These are the held payload, the carriers of the payloads, the monitored pairs, and the pairs that can inhibit
        the arm.
        """
        self.held = next((k for k, payload in enumerate(self.payloads) if payload.held), None)
        self.arm_fixed = self.held is not None and self.payloads[self.held].berth != ""
        for k in range(len(self.payloads)):
            self.update_carrier(site, k)
        self.contacts.arm[:] = site.by_arm
        if self.held is not None:
            self.contacts.arm |= site.of_payload[self.held]
        self.select_monitored(site)
        # a pair that is no longer monitored has not separated, so remove its contact without a log line "clear of"
        self.logged_contacts = tuple(group for group in self.logged_contacts if self.watch.active[group])

    def select_monitored(self, site: Site) -> None:
        """Mark all pairs as monitored, with two exceptions.

        The exceptions are pairs of a held payload with the end effector, and pairs of a fixed payload with the parts in
        its berth's frame.
        """
        active = self.watch.active
        active[:] = 1
        for k, payload in enumerate(self.payloads):
            if payload.held:
                active &= site.not_held[k]
            if payload.berth:
                active &= 1 - site.seated[k, payload.berth]

    def update_carrier(self, site: Site, k: int) -> None:
        """Set the carrier of payload k, and the payload's pose in the carrier.

        The carrier is the berth's frame if a berth fixes the payload, else the last joint's frame if the payload is
        held. A floating payload has no carrier.
        """
        payload = self.payloads[k]
        if (fit := site.fit(k, payload.berth)) is not None:
            self.carrier[k] = fit.row
            compose(fit.place, np.array(payload.offset_in_berth), self.poses_in_carrier[k])
        elif payload.grasp is not None:
            self.carrier[k], self.poses_in_carrier[k] = site.last_joint, payload.grasp
        elif (flight := self.floating[k]) is not None:
            self.carrier[k], self.poses_in_carrier[k] = -1, flight.pose

    def controls(self, *, pressed: bool = False) -> Controls:
        """Return controls and state of the end effector; `pressed`: whether its switch was pressed in this step."""
        return Controls(self.switch, pressed, self.effector_mode, self.rigid, self.prong.position, self.snare)

    def places(self, site: Site) -> tuple[Array, Array, Array, Array, Indices, Array]:
        """Return the arguments of `place_everything` that precede angles, stand and prong."""
        return site.arm.joints, site.scene, site.axes, self.orbiter, self.carrier, self.poses_in_carrier


def new_worksite_state(site: Site, prong: Travel) -> WorksiteState:
    """Return a worksite state with an open prong; `simulation.begin` then sets the start positions."""
    groups, payloads = len(site.layout.groups), len(site.payloads)
    return WorksiteState(
        frames=np.zeros((len(site.layout.frames), POSE)),
        before=np.zeros((len(site.layout.frames), POSE)),
        monitored_before=np.ones(groups, np.uint8),
        permitted=site.essential.copy(),
        contacts=Contacts(site.essential.copy(), site.by_arm.copy(), np.zeros(groups, np.uint8)),
        payloads=[PayloadState() for _ in range(payloads)],
        floating=[None] * payloads,
        carrier=np.full(payloads, -1),
        poses_in_carrier=np.zeros((payloads, POSE)),
        orbiter=np.zeros(3),
        orbiter_velocity=np.zeros(3),
        prong=Slide(prong.low),
        watch=ClearanceMonitor(site.layout),
    )

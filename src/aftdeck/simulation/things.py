"""The worksite's part of the state: where everything is, what touches, what is held and what is fixed."""

from __future__ import annotations

from typing import Literal

import msgspec
import numpy as np

from aftdeck.arrays import Array, Indices, Mask
from aftdeck.bodies.pose import POSE, compose
from aftdeck.plant.slide import Slide, Travel
from aftdeck.scenario.schema import Until
from aftdeck.simulation.floating import Floating
from aftdeck.simulation.site import Site
from aftdeck.state_part import StatePart
from aftdeck.worksite.contacts import Contacts
from aftdeck.worksite.latches import Latches
from aftdeck.worksite.snare import Snare
from aftdeck.worksite.watch import Watch

Switch = Literal["stop", "close", "open"]
Halt = Literal["", "seat", "contact", "switch"]


class Thing(StatePart):
    """How a payload of the worksite is: held, fixed to a seat, or both; else it floats. Poses are rows of twelve."""

    held: bool = False
    grasp: list[float] | None = None
    """While held: its pose in the frame of the last joint, with which it goes where no seat has it."""
    steered: list[float] | None = None
    """While held: the same as the steering takes it, which goes by how it was when it was taken or last set."""
    first: list[float] | None = None
    """Its fixture in the end effector's axes when the carriage began to draw it in."""
    since: float = 0.0
    """How far the carriage was retracted then."""
    seat: str = ""
    """What it is fixed to; empty: nothing."""
    latches: Latches = Latches()
    off: list[float] = msgspec.field(default_factory=list)
    """Its pose against its place in the seat, when that took it."""
    seated: list[float] = msgspec.field(default_factory=list)
    """The same now, drawn in by the latches."""
    parted: str = ""
    """The port that it was just undocked from, which takes it again only when it has left it."""
    asked: int = 0
    """Step of the last UNLATCH that waits for a second one to confirm it; 0: none does."""


class Things(StatePart):
    """Everything of the worksite that the next step depends on.

    Attributes:
        frames: (F, 12) where every frame is, in L.
        before: (F, 12) the same a step ago.
        looked: (g,) 1 for groups that were looked at in the last step.
        watch: the watched groups; what it found of them follows from the two before, `looked` and `nearest`.
        permitted: (g,) 1 for groups that the task brings into contact, but those that touch where, or deeper than,
            their relation permits.
        contacts: what touches, and what it inhibits.
        told: groups whose contact the log has told.
        cargo: the payloads.
        floating: the free flight of each; None while something holds it.
        held: the payload in the grasp; None: none is.
        fast: whether what the arm holds is fixed to something, so that the arm cannot move.
        carrier: (c,) for each payload, the row of the frame that carries it; -1: it floats.
        rides: (c, 12) its pose in that frame; where it floats, in L as that stood at the start.
        nearest: the group of least clearance of those that count (`simulation.lined_up`); -1: none is watched.
        lined_up: the cargo that the hand is about to take; None: none.
        orbiter: (3,) how far the orbiter has moved, forward, starboard, down [m].
        orbiter_velocity: (3,) how fast it does [m/s].
        prong: of the concept's hand: y2 of its inner face.
        snare: of the Shuttle's end effector.
        switch: end effector switch.
        effector_mode: END EFFECTOR MODE.
        rigid: MAN CONTR.
        task: the report's mode, 1 to 4.
        advice: the way out of the contacts that was found last.
        refused_orbiter: whether the orbiter's translation was asked for and refused in the last step.
        waiting: whether carriage or latches wait before a contact.
        halt: what kept the arm from what it was commanded in the last step: a seat that has what it holds, a contact
            that it would deepen, a switch (BRAKES, SAFING), or nothing.
    """

    frames: Array
    before: Array
    looked: Mask
    permitted: Mask
    contacts: Contacts
    cargo: list[Thing]
    floating: list[Floating | None]
    carrier: Indices
    rides: Array
    orbiter: Array
    orbiter_velocity: Array
    prong: Slide
    watch: Watch
    told: tuple[int, ...] = ()
    held: int | None = None
    fast: bool = False
    nearest: int = -1
    lined_up: int | None = None
    snare: Snare = Snare()
    switch: Switch = "stop"
    effector_mode: Literal["auto", "manual"] = "auto"
    rigid: Literal["off", "rigid", "derigid"] = "off"
    task: int = 1
    advice: str = ""
    refused_orbiter: bool = False
    waiting: bool = False
    halt: Halt = ""

    @property
    def _meant(self) -> list[Thing]:
        """The payload that latching and unlatching is about: the one in the grasp; with none there, any."""
        return [thing for thing in self.cargo if thing.held] or self.cargo

    def is_so(self, what: Until) -> bool:
        """Whether something has come about that a script may wait for."""
        match what:
            case "captured":
                return self.held is not None and self.snare.motion != "capture"
            case "released":
                return self.held is None and self.snare.motion != "release"
            case "latched":
                return any(thing.seat and not thing.latches.motion for thing in self._meant)
            case "unlatched":
                return not any(thing.seat for thing in self._meant)

    def settle(self, site: Site) -> None:
        """What carries each payload, which groups are looked at, and which move with the arm: as it is held now."""
        self.held = next((k for k, thing in enumerate(self.cargo) if thing.held), None)
        self.fast = self.held is not None and self.cargo[self.held].seat != ""
        for k in range(len(self.cargo)):
            self.ride(site, k)
        self.contacts.arm[:] = site.by_arm
        if self.held is not None:
            self.contacts.arm |= site.of_cargo[self.held]
        self.choose(site)
        # a contact that is looked at no more does not end: nothing is told of it
        self.told = tuple(group for group in self.told if self.watch.active[group])

    def choose(self, site: Site) -> None:
        """Choose the groups that are looked at: but those of what is held or fixed with what has it."""
        active = self.watch.active
        active[:] = 1
        for k, thing in enumerate(self.cargo):
            if thing.held:
                active &= 1 - site.held[k]
            if thing.seat:
                active &= 1 - site.seated[k, thing.seat]

    def ride(self, site: Site, k: int) -> None:
        """Cargo k goes with its seat, with the last joint, or floats."""
        thing = self.cargo[k]
        if (berth := site.berth(k, thing.seat)) is not None:
            self.carrier[k] = berth.row
            compose(berth.place, np.array(thing.seated), self.rides[k])
        elif thing.grasp is not None:
            self.carrier[k], self.rides[k] = site.last_joint, thing.grasp
        elif (flight := self.floating[k]) is not None:
            self.carrier[k], self.rides[k] = -1, flight.pose

    def places(self, site: Site) -> tuple[Array, Array, Array, Array, Indices, Array]:
        """What places everything besides the arm's joints: the first arguments of `place_everything`."""
        return site.arm.joints, site.scene, site.axes, self.orbiter, self.carrier, self.rides


def new_things(site: Site, prong: Travel) -> Things:
    """The worksite before anything is put into its place, the prong open."""
    groups, cargo = len(site.layout.groups), len(site.cargo)
    return Things(
        frames=np.zeros((len(site.layout.frames), POSE)),
        before=np.zeros((len(site.layout.frames), POSE)),
        looked=np.ones(groups, np.uint8),
        permitted=site.essential.copy(),
        contacts=Contacts(site.essential.copy(), site.by_arm.copy(), np.zeros(groups, np.uint8)),
        cargo=[Thing() for _ in range(cargo)],
        floating=[None] * cargo,
        carrier=np.full(cargo, -1),
        rides=np.zeros((cargo, POSE)),
        orbiter=np.zeros(3),
        orbiter_velocity=np.zeros(3),
        prong=Slide(prong.low),
        watch=Watch(site.layout),
    )

"""The worksite's part of the state: where everything is, what touches, what is held and what is fixed."""

from __future__ import annotations

from typing import Literal

import msgspec
import numpy as np

from aftdeck.arrays import Array, Indices
from aftdeck.bodies.pose import POSE, compose
from aftdeck.plant.effector import prong_of
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.schema import Until
from aftdeck.simulation.floating import Floating, SavedFloating, floating_so
from aftdeck.simulation.site import Site
from aftdeck.worksite.contacts import Contacts
from aftdeck.worksite.latches import Latches
from aftdeck.worksite.snare import Snare
from aftdeck.worksite.watch import SavedWatch, Watch

Switch = Literal["stop", "close", "open"]
Halt = Literal["", "seat", "contact", "switch"]


class Thing(msgspec.Struct):
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


class Things:
    """Everything of the worksite that the next step depends on.

    Attributes:
        frames: (F, 12) where every frame is, in L.
        before: (F, 12) the same a step ago.
        watch: the watched groups.
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
        counts: (g,) 1 for groups of which the next step finds the nearest.
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

    def __init__(self, scenario: Scenario, site: Site) -> None:
        self.frames = np.zeros((len(site.layout.frames), POSE))
        self.before = self.frames.copy()
        self.watch = Watch(site.layout)
        self.permitted = site.essential.copy()
        self.contacts = Contacts(site.layout, self.permitted, site.by_arm.copy(), site.by_prong)
        self.told: frozenset[int] = frozenset()
        self.cargo = [Thing() for _ in site.cargo]
        self.floating: list[Floating | None] = [None] * len(site.cargo)
        self.held: int | None = None
        self.fast = False
        self.carrier, self.rides = np.full(len(site.cargo), -1), np.zeros((len(site.cargo), POSE))
        self.counts = site.detrimental.copy()
        self.nearest = -1
        self.lined_up: int | None = None
        self.orbiter, self.orbiter_velocity = np.zeros(3), np.zeros(3)
        self.prong = prong_of(scenario.arm.model.equipment.prong)
        self.snare = Snare()
        self.switch: Switch = "stop"
        self.effector_mode: Literal["auto", "manual"] = "auto"
        self.rigid: Literal["off", "rigid", "derigid"] = "off"
        self.task = 1
        self.advice = ""
        self.refused_orbiter = False
        self.waiting = False
        self.halt: Halt = ""

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
        active, by_arm = self.watch.active, self.contacts.arm
        active[:], by_arm[:] = 1, site.by_arm
        for k, thing in enumerate(self.cargo):
            if thing.held:
                active &= 1 - site.held[k]
                by_arm |= site.of_cargo[k]
            if thing.seat:
                active &= 1 - site.seated[k, thing.seat]
        # a contact that is looked at no more does not end: nothing is told of it
        self.told = frozenset(group for group in self.told if active[group])

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

    def save(self) -> SavedThings:
        """A copy that nothing changes."""
        return SavedThings(
            self.frames.tolist(),
            self.before.tolist(),
            self.watch.save(),
            self.contacts.save(),
            tuple(sorted(self.told)),
            tuple(msgspec.structs.replace(thing) for thing in self.cargo),
            tuple(None if flight is None else flight.save() for flight in self.floating),
            self.orbiter.tolist(),
            self.orbiter_velocity.tolist(),
            self.prong.save(),
            self.snare,
            self.switch,
            self.effector_mode,
            self.rigid,
            self.task,
            self.advice,
            self.refused_orbiter,
            self.waiting,
            self.nearest,
            self.lined_up,
            self.halt,
        )

    def restore(self, saved: SavedThings) -> None:
        """Go on from what `save` gave."""
        self.frames[:], self.before[:] = saved.frames, saved.before
        self.watch.restore(saved.watch)
        self.contacts.restore(saved.contacts)
        self.told, self.cargo = frozenset(saved.told), [msgspec.structs.replace(thing) for thing in saved.cargo]
        self.floating = [None if flight is None else floating_so(flight) for flight in saved.floating]
        self.orbiter[:], self.orbiter_velocity[:] = saved.orbiter, saved.orbiter_velocity
        self.snare = saved.snare
        self.prong.restore(saved.prong)
        self.switch, self.effector_mode, self.rigid = saved.switch, saved.effector_mode, saved.rigid
        self.task = saved.task
        self.advice = saved.advice
        self.refused_orbiter, self.waiting = saved.refused_orbiter, saved.waiting
        self.nearest, self.lined_up, self.halt = saved.nearest, saved.lined_up, saved.halt


class SavedThings(msgspec.Struct, frozen=True):
    """The worksite's state as plain values, in the order of `Things`."""

    frames: list[list[float]]
    before: list[list[float]]
    watch: SavedWatch
    contacts: tuple[list[int], list[bool]]
    told: tuple[int, ...]
    cargo: tuple[Thing, ...]
    floating: tuple[SavedFloating | None, ...]
    orbiter: list[float]
    orbiter_velocity: list[float]
    prong: list[float]
    snare: Snare
    switch: Switch
    effector_mode: Literal["auto", "manual"]
    rigid: Literal["off", "rigid", "derigid"]
    task: int
    advice: str
    refused_orbiter: bool
    waiting: bool
    nearest: int
    lined_up: int | None
    halt: Halt

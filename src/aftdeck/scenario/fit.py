"""Checks that a scenario's contents fit together: payloads in their places, the hand at their bars, the telescope.

The checks use the solids that are present, at load and without compiled code. A misfit that makes every run senseless
is an error: a payload that starts inside something; a bar that the hand can never take; a seat that its payload does
not fit, if a payload starts in the seat or the script uses it. Other seats that a payload would not fit are cautions,
which ``aftdeck check`` shows. `simulation.survey` checks what depends on the arm's joints.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from aftdeck.arms.geometry import PRONG, STAND
from aftdeck.arms.load import ArmModel
from aftdeck.arms.solids import solids_of
from aftdeck.arrays import Array
from aftdeck.bodies.overlap import deepest
from aftdeck.bodies.solid import Solid
from aftdeck.files import Problem, Where
from aftdeck.frames import Pose
from aftdeck.kinematics.linkage import L5
from aftdeck.scenario.relative import at_cargo, composed, inverted, scene_in_l
from aftdeck.scenario.target import AtCargo
from aftdeck.worksite.conditions import Units, quantity_text
from aftdeck.worksite.file.cargo import part_of
from aftdeck.worksite.model import BarAcquisition, Cargo, Worksite

Parts = dict[str, list[Array]]
"""Hexahedra (8, 3) [m], by the part to which they belong."""

TOLERANCE = 1e-3
"""Overlap up to which two solids count as touching [m]; assumed: more than the rounding of dimensions in files."""
_HERE = Pose(np.zeros(3), np.eye(3))


class Misfit(NamedTuple):
    """A misfit in a scenario.

    Attributes:
        problem: description, and place in the scenario's file.
        senseless: whether the misfit makes every run of the scenario senseless.
    """

    problem: Problem
    senseless: bool


def misfits(
    model: ArmModel, worksite: Worksite, cargo: Sequence[Cargo], used: frozenset[str], held: frozenset[int]
) -> Iterator[Misfit]:
    """Yield every misfit of a scenario.

    Args:
        model: the arm.
        worksite: the worksite.
        cargo: payloads that are present, in the order of the scenario's file.
        used: names of the seats to which the script brings payloads.
        held: indices of the payloads that the hand holds at every start; these never start where their tables say.
    """
    around = parts_at(worksite.solids, _HERE)
    yield from _telescope(model, worksite, around)
    for k, one in enumerate(cargo):
        where: Where = ("cargo", k)
        if not one.start.seat and k not in held:
            own = parts_at(one.solids, one.start.pose)
            for what in _deep(own, around, model.units):
                yield Misfit(Problem(where, f"{one.name} starts where {what}"), True)
        for i, other in enumerate(cargo[:k]):
            if held & {i, k}:
                continue
            for what in _deep(
                parts_at(one.solids, one.start.pose), parts_at(other.solids, other.start.pose), model.units
            ):
                yield Misfit(Problem(where, f"{one.name} and {other.name} start where {what}"), True)
        senseless = [*_grasp(model, worksite, one), *_struck(model, worksite, one)]
        yield from (Misfit(Problem(where, what), True) for what in senseless)
        yield from _seats(model, worksite, one, where, around, used, not senseless)


def _seats(
    model: ArmModel,
    worksite: Worksite,
    one: Cargo,
    where: Where,
    around: Parts,
    used: frozenset[str],
    graspable: bool,
) -> Iterator[Misfit]:
    """Yield the overlaps of a payload, and of the hand at its bar, in each seat that takes the payload."""
    held = hands(model, worksite, one) if graspable else {}
    for seat in worksite.seats:
        if seat.lacks(one.probe, one.trunnions):
            continue
        pose = seat.seated(one.probe)
        senseless = seat.name in used or seat.name == one.start.seat
        if inside := "; ".join(_deep(parts_at(one.solids, pose), around, model.units)):
            yield Misfit(Problem(where, f"{one.name} in the seat {seat.name!r}: {inside}"), senseless)
        for how, hand in held.items():
            for what in _deep(_moved(hand, pose), around, model.units):
                text = f"the hand, {how}, at {one.name} in the seat {seat.name!r}: {what}"
                yield Misfit(Problem(where, text), senseless)


def _telescope(model: ArmModel, worksite: Worksite, around: Parts) -> Iterator[Misfit]:
    """Yield the overlaps of the telescope at either end of its travel."""
    telescope = model.equipment.telescope
    if telescope is None:
        return
    scene = inverted(scene_in_l(model.mount, worksite.origin))
    for length in (telescope.least, telescope.greatest):
        own = parts_at(
            [solid for solid in solids_of(model) if solid.frame == STAND],
            composed(scene, Pose(np.array([0.0, 0.0, -length]), np.eye(3))),
        )
        for what in _deep(own, around, model.units):
            at = quantity_text(length, "m", model.units)
            yield Misfit(Problem(("arm",), f"with the shoulder {at} up, {what}"), True)


def _grasp(model: ArmModel, worksite: Worksite, one: Cargo) -> Iterator[str]:
    """Yield the reasons why a prong can never acquire a payload's bar, or can never release it."""
    rule, prong, bar, units = worksite.acquisition, model.equipment.prong, one.receptacle, model.units
    if prong is None or not isinstance(rule, BarAcquisition) or bar is None:
        return

    def size(value: float) -> str:
        return quantity_text(value, "m", units)

    opened, closed, finger = -prong.opened, -prong.closed, prong.fixed_finger
    length, width, _ = np.ptp(bar, axis=0).tolist()
    spacing = size(rule.prong_spacing)
    if rule.prong_spacing >= opened:
        yield (
            f"prong_spacing (PRGSPC) is {spacing}, and the open prong is {size(opened)} from the palm's centre line: "
            f"it has to be less, or the hand never lets {one.name} go"
        )
    if rule.prong_spacing < closed:
        yield (
            f"prong_spacing (PRGSPC) is {spacing}, and the closed prong is {size(closed)} from the palm's centre "
            f"line: it has to be at least that, or the hand never acquires {one.name}"
        )
    room = min(finger + min(opened, rule.prong_spacing), 2.0 * finger)  # with the palm centred over the bar
    if width > room:
        yield f"the bar of {one.name} is {size(width)} wide; the hand spans {size(room)} when it has acquired a bar"
    if rule.front + rule.rear > length:
        inwards = size(rule.front + rule.rear)
        yield f"the bar of {one.name} is {size(length)} long; front and rear (FRONT, REAR) leave out {inwards} of it"


def _struck(model: ArmModel, worksite: Worksite, one: Cargo) -> Iterator[str]:
    """Yield the overlaps of the hand, at a payload's bar, with that payload.

    The bar itself is left out: the hand may take the bar away from the palm's middle.
    """
    bar = part_of(one.name, "receptacle")
    own = {part: bodies for part, bodies in parts_at(one.solids, _HERE).items() if part != bar}
    for how, solids in hands(model, worksite, one).items():
        for what in _deep(solids, own, model.units):
            yield f"the hand, {how}, at the bar of {one.name}: {what}"


def hands(model: ArmModel, worksite: Worksite, one: Cargo) -> Mapping[str, Parts]:
    """Return the concept's hand at a payload's bar, in the payload's axes: prong open, and closed on the bar."""
    rule, hand = worksite.acquisition, model.equipment.prong
    if hand is None or not isinstance(rule, BarAcquisition) or one.receptacle is None:
        return {}
    tip = at_cargo(model, one, AtCargo(0, above=0.5 * rule.window))
    joint = composed(tip, Pose(np.array([-float(model.links[L5]), 0.0, 0.0]), np.eye(3)))
    last = model.linkage.frames[-1]
    own = [solid for solid in solids_of(model) if solid.frame == last]
    prong = [solid for solid in solids_of(model) if solid.frame == PRONG]
    found: dict[str, Parts] = {}
    closed = max(hand.opened, min(hand.closed, -0.5 * float(np.ptp(one.receptacle[:, 1]))))
    for how, y in (("open", hand.opened), ("closed", closed)):
        at = composed(joint, Pose(np.array([0.0, y, 0.0]), np.eye(3)))
        found[how] = {**parts_at(own, joint), **parts_at(prong, at)}
    return found


def parts_at(solids: Sequence[Solid], pose: Pose) -> Parts:
    """Return solids by part, in the frame in which the solids' own frame has the given pose."""
    found: Parts = {}
    for solid in solids:
        found.setdefault(solid.part, []).append(solid.vertices @ pose.rotation.T + pose.position)
    return found


def _moved(parts: Parts, pose: Pose) -> Parts:
    return {part: [body @ pose.rotation.T + pose.position for body in own] for part, own in parts.items()}


def _deep(some: Parts, others: Parts, units: Units) -> Iterator[str]:
    """Yield a text for each pair of parts that overlap by more than `TOLERANCE`."""
    for a, own in some.items():
        for b, there in others.items():
            if (depth := deepest(own, there)) > TOLERANCE:
                yield f"{a} is {quantity_text(depth, 'm', units)} inside {b}"

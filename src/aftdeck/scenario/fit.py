"""Checks that a scenario's payloads, berths, end effector and telescope fit together.

The checks run when a scenario is loaded. They use only the solids that are present, and no compiled code. A misfit is
an error if it makes every run meaningless: a payload starts inside another body; the telescope's tube overlaps the
worksite; the end effector can never acquire a bar, or can never release it; a payload does not fit the berth in which
it starts, or a berth that the script uses. A payload that does not fit one of the other berths causes only a caution,
which ``aftdeck check`` prints. `simulation.survey` makes the checks that depend on the arm's joint angles.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from aftdeck.arms.load import ArmModel
from aftdeck.arrays import Array
from aftdeck.bodies.overlap import deepest
from aftdeck.bodies.solid import Solid
from aftdeck.files import Problem, Where
from aftdeck.frames import IDENTITY, Pose
from aftdeck.scenario.on_arm import arm_solids
from aftdeck.scenario.relative import at_payload, composed, inverted, scene_in_l
from aftdeck.scenario.target import AtPayload
from aftdeck.worksite.capture.bar import BarFile
from aftdeck.worksite.conditions import Units, quantity_text
from aftdeck.worksite.model import Worksite
from aftdeck.worksite.payload import Payload, part_of

Parts = dict[str, list[Array]]
"""Hexahedra (8, 3) [m], by the part to which they belong."""

TOLERANCE = 1e-3
"""Greatest overlap of two solids that is not a misfit [m]; assumed: greater than the rounding of lengths in files."""


class Misfit(NamedTuple):
    """A misfit in a scenario.

    Attributes:
        problem: description, and place in the scenario's file.
        senseless: True if the misfit makes every run of the scenario meaningless and is therefore an error.
    """

    problem: Problem
    senseless: bool


def misfits(
    model: ArmModel, worksite: Worksite, payloads: Sequence[Payload], used: frozenset[str], held: frozenset[int]
) -> Iterator[Misfit]:
    """Yield every misfit of a scenario.

    Args:
        model: the arm.
        worksite: the worksite.
        payloads: payloads that are present, in the order of the scenario's file.
        used: names of the berths to which the script brings payloads.
        held: indices of the payloads that the end effector holds in every initial state; the start poses of these
            payloads are not used.
    """
    around = parts_at(worksite.solids, IDENTITY)
    yield from _telescope_misfits(model, worksite, around)
    for k, payload in enumerate(payloads):
        where: Where = ("cargo", k)
        if not payload.start.berth and k not in held:
            own_parts = parts_at(payload.solids, payload.start.pose)
            for overlap in _overlaps(own_parts, around, model.units):
                yield Misfit(Problem(where, f"{payload.name} starts where {overlap}"), True)
        for i, other in enumerate(payloads[:k]):
            if held & {i, k}:
                continue
            for overlap in _overlaps(
                parts_at(payload.solids, payload.start.pose), parts_at(other.solids, other.start.pose), model.units
            ):
                yield Misfit(Problem(where, f"{payload.name} and {other.name} start where {overlap}"), True)
        errors = [*_bar_errors(model, worksite, payload), *_hand_overlaps(model, worksite, payload)]
        yield from (Misfit(Problem(where, text), True) for text in errors)
        yield from _berth_misfits(model, worksite, payload, where, around, used, not errors)


def _berth_misfits(
    model: ArmModel,
    worksite: Worksite,
    payload: Payload,
    where: Where,
    around: Parts,
    used: frozenset[str],
    graspable: bool,
) -> Iterator[Misfit]:
    """Yield the overlaps of a payload with its surroundings in each berth that can fix the payload.

    If the end effector can hold the payload's bar (`graspable`), also place the end effector at the bar of the payload
    in the berth, and yield the overlaps of the end effector with these surroundings.
    """
    hands_at_bar = hands(model, worksite, payload) if graspable else {}
    for berth in worksite.berths:
        if berth.lacks(payload.probe, payload.trunnions):
            continue
        pose = berth.seated(payload.probe)
        senseless = berth.name in used or berth.name == payload.start.berth
        if overlaps := "; ".join(_overlaps(parts_at(payload.solids, pose), around, model.units)):
            yield Misfit(Problem(where, f"{payload.name} in the berth {berth.name!r}: {overlaps}"), senseless)
        for prong_state, hand in hands_at_bar.items():
            for overlap in _overlaps(_moved(hand, pose), around, model.units):
                text = f"the end effector, {prong_state}, at {payload.name} in the berth {berth.name!r}: {overlap}"
                yield Misfit(Problem(where, text), senseless)


def _telescope_misfits(model: ArmModel, worksite: Worksite, around: Parts) -> Iterator[Misfit]:
    """Yield the overlaps of the telescope's tube with the worksite, for the telescope's least and greatest lengths."""
    telescope = model.telescope
    if telescope is None:
        return
    scene = inverted(scene_in_l(model.mount, worksite.origin))
    for length in (telescope.least, telescope.greatest):
        own_parts = parts_at(
            [solid for solid in arm_solids(model, worksite) if solid.frame == telescope.frame],
            composed(scene, Pose(np.array([0.0, 0.0, -length]), np.eye(3))),
        )
        for overlap in _overlaps(own_parts, around, model.units):
            height = quantity_text(length, "m", model.units)
            yield Misfit(Problem(("arm",), f"with the shoulder {height} up, {overlap}"), True)


def _bar_errors(model: ArmModel, worksite: Worksite, payload: Payload) -> Iterator[str]:
    """Yield the reasons why a prong can never acquire a payload's bar, or can never release it."""
    rule, prong, bar, units = worksite.acquisition, model.prong, payload.receptacle, model.units
    if prong is None or not isinstance(rule, BarFile) or bar is None:
        return

    def length_text(value: float) -> str:
        return quantity_text(value, "m", units)

    opened, closed, fixed_finger = -prong.least, -prong.greatest, prong.facing
    length, width, _ = np.ptp(bar, axis=0).tolist()
    spacing = length_text(rule.prong_spacing)
    if rule.prong_spacing >= opened:
        yield (
            f"prong_spacing (PRGSPC) is {spacing}, and the open prong is {length_text(opened)} from the palm's centre "
            f"line: prong_spacing has to be less than this distance, or the end effector never releases {payload.name}"
        )
    if rule.prong_spacing < closed:
        yield (
            f"prong_spacing (PRGSPC) is {spacing}, and the closed prong is {length_text(closed)} from the palm's "
            "centre line: prong_spacing has to be at least this distance, "
            f"or the end effector never acquires {payload.name}"
        )
    span = min(fixed_finger + min(opened, rule.prong_spacing), 2.0 * fixed_finger)  # with the palm centred over the bar
    if width > span:
        yield (
            f"the bar of {payload.name} is {length_text(width)} wide; "
            f"the end effector holds a bar of at most {length_text(span)}"
        )
    if rule.front + rule.rear > length:
        margins = length_text(rule.front + rule.rear)
        yield (
            f"the bar of {payload.name} is {length_text(length)} long; "
            f"front and rear (FRONT, REAR) together exclude {margins} of it"
        )


def _hand_overlaps(model: ArmModel, worksite: Worksite, payload: Payload) -> Iterator[str]:
    """Yield the overlaps of the end effector with a payload when the end effector is at the payload's bar.

    Overlaps with the bar itself are not checked, because the bar need not be at the palm's centre when the bar is
    acquired.
    """
    bar = part_of(payload.name, "receptacle")
    own = {part: bodies for part, bodies in parts_at(payload.solids, IDENTITY).items() if part != bar}
    for prong_state, solids in hands(model, worksite, payload).items():
        for overlap in _overlaps(solids, own, model.units):
            yield f"the end effector, {prong_state}, at the bar of {payload.name}: {overlap}"


def hands(model: ArmModel, worksite: Worksite, payload: Payload) -> Mapping[str, Parts]:
    """Return the parts of the concept arm's end effector at a payload's bar, in the payload's axes.

    The keys of the result are "open", for the open prong, and "closed", for the prong closed on the bar. The result is
    empty for an end effector without a prong and for a payload without a bar.
    """
    rule, hand = worksite.acquisition, model.prong
    if hand is None or not isinstance(rule, BarFile) or payload.receptacle is None:
        return {}
    tip = at_payload(model, payload, AtPayload(0, above=0.5 * rule.window))
    joint = composed(tip, Pose(-model.linkage.tip, np.eye(3)))
    last = model.linkage.frames[-1]
    hand_solids = [solid for solid in arm_solids(model, worksite) if solid.frame == last]
    prong = [solid for solid in arm_solids(model, worksite) if solid.frame == hand.frame]
    hands_at_bar: dict[str, Parts] = {}
    closed = max(hand.least, min(hand.greatest, -0.5 * float(np.ptp(payload.receptacle[:, 1]))))
    for prong_state, y in (("open", hand.least), ("closed", closed)):
        prong_pose = composed(joint, Pose(np.array([0.0, y, 0.0]), np.eye(3)))
        hands_at_bar[prong_state] = {**parts_at(hand_solids, joint), **parts_at(prong, prong_pose)}
    return hands_at_bar


def parts_at(solids: Sequence[Solid], pose: Pose) -> Parts:
    """Return the vertices of solids, grouped by part, in another coordinate frame.

    `pose` is the pose of the solids' own coordinate frame in that other coordinate frame.
    """
    by_part: Parts = {}
    for solid in solids:
        by_part.setdefault(solid.part, []).append(solid.vertices @ pose.rotation.T + pose.position)
    return by_part


def _moved(parts: Parts, pose: Pose) -> Parts:
    return {part: [body @ pose.rotation.T + pose.position for body in bodies] for part, bodies in parts.items()}


def _overlaps(parts: Parts, others: Parts, units: Units) -> Iterator[str]:
    """Yield a text for each pair of parts that overlap by more than `TOLERANCE`."""
    for name, bodies in parts.items():
        for other_name, other_bodies in others.items():
            if (depth := deepest(bodies, other_bodies)) > TOLERANCE:
                yield f"{name} is {quantity_text(depth, 'm', units)} inside {other_name}"

"""Constants of the worksite of a run."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np

from aftdeck.arms.load import ArmModel
from aftdeck.arms.switched import SwitchedJoint
from aftdeck.arrays import Array, Indices, Mask
from aftdeck.bodies.pose import POSE, row_of
from aftdeck.bodies.solid import Solid
from aftdeck.frames import Pose, rotation_x
from aftdeck.kinematics.frames import Frames, frames_of
from aftdeck.matrices import lengths, product
from aftdeck.scenario import relative
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.on_arm import arm_solids
from aftdeck.scenario.payload import PART
from aftdeck.worksite.berths.berth import Berth, Fit
from aftdeck.worksite.capture.effector import EndEffector, MadeFor
from aftdeck.worksite.model import Worksite
from aftdeck.worksite.payload import Payload, part_of
from aftdeck.worksite.relation import ALIGNED, Meeting
from aftdeck.worksite.watch.groups import CENTRE, Layout, PartPair, layout_of
from aftdeck.worksite.watch.pairs import among, part_pairs

ORBITER = 0
"""Row of the frame ``orbiter``, the scene's frame. The next rows are the arm's frames, ``space``, and the
payloads' frames."""
SHORT = 1.0
"""Length below which a link between two joints counts as short [m]. The parts at the two ends of a short link are
longer than the link (assumed). `_stationary_parts` uses the same length."""


@dataclass(frozen=True, eq=False)
class Site:
    """Constants of the worksite: frames, pairs of parts that can touch, and poses of the payloads in their berths.

    An array (g,) has one element for each monitored pair of the layout: 1 for the pairs named below, 0 for the others.

    Attributes:
        worksite: the worksite as its file describes it.
        payloads: the payloads at the worksite.
        arm: the arm's frames.
        last_joint: row of the frame that moves with the last joint.
        space_row: row of the frame ``space``.
        payload_rows: rows of the payloads' frames.
        layout: solids and monitored pairs.
        essential: (g,) 1 for pairs that the task brings into contact.
        meetings: relation and permitted depth of each pair in `essential`.
        meeting_groups: (m,) index in the layout of each pair in `meetings`.
        meeting_aligns: (m,) 1 for pairs with the relation "docking" or "guides"; their parts are aligned before they
            touch.
        by_arm: (g,) 1 for pairs with a part of the arm.
        by_prong: (g,) 1 for pairs with the prong; all 0 for an arm without a prong.
        of_payload: for each payload, (g,) 1 for pairs with a part of the payload.
        held: for each payload, (g,) 1 for its pairs with the end effector. These pairs are not monitored while the end
            effector holds the payload.
        not_held: for each payload, (g,) 0 for these pairs, and 1 for all others.
        seated: for each payload and berth, an array (g,): 1 for pairs that are not monitored while the payload is in
            the berth.
        scene: (12,) pose of the scene's frame in L.
        hand: (12,) pose of the tip in the frame of the last joint.
        effector: (12,) pose of the end effector's own axes E at the tip, in the frame of the last joint.
        prong: True if the end effector has a prong, False if it has snares.
        capture: constants of capture; None if the worksite has no rules for the arm's end effector.
        detrimental: (g,) 1 for pairs that are not essential.
        axes: (3, 3) the orbiter's axes (forward, starboard, down) in L.
        fits: for each payload, its constants in each berth that accepts it.
        berth_rows: for each payload, (n,) rows of the frames to which its berths are fixed.
        berth_places: for each payload, (n, 12) poses of the payload in its berths, in the frames of `berth_rows`.
        starts: for each payload, (12,) its pose in the scene at the start.
        slides: for each payload, (g,) 1 for its pairs with parts of the orbiter. A held payload may slide along
            these parts.
        bodies: for each payload, indices of its solids in the layout.
        bay: (2, 3) least and greatest coordinates of the inside of the bay, in the scene [m]. The least z is -inf,
            because z has no lower limit. None if there is no bay.
    """

    worksite: Worksite
    payloads: tuple[Payload, ...]
    arm: Frames
    last_joint: int
    space_row: int
    payload_rows: tuple[int, ...]
    layout: Layout
    essential: Mask
    meetings: tuple[Meeting, ...]
    meeting_groups: Indices
    meeting_aligns: Mask
    by_arm: Mask
    by_prong: Mask
    of_payload: tuple[Mask, ...]
    held: tuple[Mask, ...]
    not_held: tuple[Mask, ...]
    seated: dict[tuple[int, str], Mask]
    scene: Array
    hand: Array
    effector: Array
    prong: bool
    capture: EndEffector | None
    detrimental: Mask
    axes: Array
    fits: tuple[tuple[Fit, ...], ...]
    berth_rows: tuple[Indices, ...]
    berth_places: tuple[Array, ...]
    starts: tuple[Array, ...]
    slides: tuple[Mask, ...]
    bodies: tuple[Indices, ...]
    bay: Array | None

    def berth(self, name: str) -> Berth:
        """Return the berth with this name."""
        return next(berth for berth in self.worksite.berths if berth.name == name)

    def fit(self, k: int, name: str) -> Fit | None:
        """Return the constants of payload k in the berth with this name; None if the berth does not accept it."""
        return next((fit for fit in self.fits[k] if fit.berth.name == name), None)

    def number(self, k: int, name: str) -> int:
        """Return the number of the berth with this name among those of all payloads, one after the other.

        -1 if the berth does not accept payload k.
        """
        return self.numbered.index((k, name)) if (k, name) in self.numbered else -1

    @cached_property
    def numbered(self) -> tuple[tuple[int, str], ...]:
        """Payload and name of each berth that accepts it, in the order of `World.berths`."""
        return tuple((k, fit.berth.name) for k, own in enumerate(self.fits) for fit in own)

    def in_space(self, name: str) -> bool:
        """Return whether a berth is fixed in the frame ``space``, which does not move with the orbiter."""
        return self.berth(name).frame == "space"


@lru_cache(maxsize=8)
def site_of(scenario: Scenario) -> Site:
    """Return the worksite constants of a scenario; for a scenario that was asked for before, the same constants."""
    model, worksite, payloads = scenario.arm.model, scenario.worksite, scenario.payloads
    arm = frames_of(model)
    frames = ("orbiter", *arm.names, "space", *(payload.name for payload in payloads))
    last_joint, space_row = frames.index(model.linkage.frames[-1]), frames.index("space")
    payload_rows = tuple(range(space_row + 1, len(frames)))
    own, held = arm_solids(model, worksite), _attached_solids(scenario)
    solids = all_solids(scenario)
    foot, *joints = model.linkage.frames
    chain = [foot, *_moved_by(model.telescope), *joints, *_moved_by(model.prong)]
    stationary = _stationary_parts(model, own)
    mounted = {(a, b.part) for a in stationary for b in worksite.solids if b.frame == "orbiter"}
    hand = {
        solid.part for solid in own if solid.frame in (*_moved_by(model.prong), model.linkage.frames[-1], *_ball(model))
    }
    attached = {(part, solid.part) for part in hand for solid in held}
    layout = layout_of(frames, solids, part_pairs(solids, chain, mounted | attached | _unfoldable_pairs(model, own)))
    own_parts = {solid.part for solid in own}
    parts = [{solid.part for solid in payload.solids} for payload in payloads]
    by_arm = np.zeros(len(layout.groups), np.uint8)
    if own_parts:
        by_arm = layout.carried(arm.names)
    meetings = _meetings(worksite, layout, payloads)
    essential = np.zeros(len(layout.groups), np.uint8)
    essential[[meeting.group for meeting in meetings]] = 1
    of_payload = tuple(layout.carried([payload.name]) for payload in payloads)
    with_hand = tuple(layout.between(hand, own_parts) for own_parts in parts)
    walls = [solid.part for solid in worksite.solids if solid.frame == "orbiter"]
    fits = tuple(
        tuple(
            berth.fit(payload, ORBITER if berth.frame == "orbiter" else space_row, scenario.docking_axes)
            for berth in worksite.berths
            if not berth.lacks(payload.probe, payload.trunnions)
        )
        for payload in payloads
    )
    effector = row_of(Pose(model.linkage.tip, rotation_x(model.end_effector_roll)))
    made_for = MadeFor(model, payloads, [solid.part for solid in solids], last_joint, effector, payload_rows)
    return Site(
        worksite=worksite,
        payloads=payloads,
        arm=arm,
        last_joint=last_joint,
        space_row=space_row,
        payload_rows=payload_rows,
        layout=layout,
        essential=essential,
        meetings=meetings,
        meeting_groups=np.array([meeting.group for meeting in meetings], dtype=np.int64),
        meeting_aligns=np.array([meeting.relation in ALIGNED for meeting in meetings], dtype=np.uint8),
        by_arm=by_arm,
        by_prong=np.zeros_like(by_arm) if model.prong is None else layout.carried([model.prong.frame]),
        of_payload=of_payload,
        held=with_hand,
        not_held=tuple(1 - pairs for pairs in with_hand),
        seated={
            (k, berth.name): layout.between(own_parts, _parts_of(worksite, berth))
            for k, own_parts in enumerate(parts)
            for berth in worksite.berths
        },
        scene=scene_in_l(scenario),
        hand=row_of(Pose(model.linkage.tip, np.eye(3))),
        effector=effector,
        prong=model.prong is not None,
        capture=None if worksite.acquisition is None else worksite.acquisition.effector(made_for),
        detrimental=1 - essential,
        axes=model.mount.rotation.T.copy(),
        fits=fits,
        berth_rows=tuple(np.array([fit.row for fit in own], dtype=np.int64) for own in fits),
        berth_places=tuple(np.array([fit.place for fit in own]).reshape(-1, POSE) for own in fits),
        starts=tuple(row_of(payload.start.pose) for payload in payloads),
        slides=tuple(layout.between(own_parts, walls) for own_parts in parts),
        bodies=tuple(np.flatnonzero(layout.frame == frames.index(one.name)).astype(np.int64) for one in payloads),
        bay=None if worksite.bay is None else np.array([(*worksite.bay.low[:2], -np.inf), worksite.bay.high]),
    )


def _meetings(worksite: Worksite, layout: Layout, payloads: tuple[Payload, ...]) -> tuple[Meeting, ...]:
    """Return the essential pairs of the worksite's file whose two parts are in the layout."""
    found = []
    for essential in worksite.essential:
        if not set(essential.parts) <= set(layout.parts):
            continue
        frames = {layout.frames[layout.part_frame[layout.part(part)]] for part in essential.parts}
        for k, payload in enumerate(payloads):
            if payload.name in frames:
                own = _trunnions(layout, payload) if essential.relation == "guides" else {}
                for group in np.flatnonzero(among(layout, [essential.parts])).tolist():
                    pairs = layout.pairs[layout.begins[group] : layout.begins[group + 1]]
                    held = [own[i if i in own else j] for i, j in pairs.tolist()] if own else []
                    trunnions = np.array(held, dtype=np.int64)
                    found.append(Meeting(group, k, essential.relation, essential.depth, pairs, trunnions))
    return tuple(found)


def _trunnions(layout: Layout, payload: Payload) -> dict[int, int]:
    """Return, for each solid of a payload's trunnions, the index of the trunnion whose latch point is nearest."""
    solids = np.flatnonzero(layout.frame == layout.frames.index(payload.name))
    part = part_of(payload.name, "trunnions")
    own = [solid for solid, made in zip(solids.tolist(), payload.solids, strict=True) if made.part == part]
    distances = lengths(layout.solids[own, None, CENTRE : CENTRE + 3] - payload.trunnions)
    return dict(zip(own, distances.argmin(axis=1).tolist(), strict=True))


def all_solids(scenario: Scenario) -> tuple[Solid, ...]:
    """Return all solids of a run: of the arm, of the attached payload, of the worksite and of its payloads."""
    theirs = (solid for payload in scenario.payloads for solid in payload.solids)
    return (
        *arm_solids(scenario.arm.model, scenario.worksite),
        *_attached_solids(scenario),
        *scenario.worksite.solids,
        *theirs,
    )


def _attached_solids(scenario: Scenario) -> tuple[Solid, ...]:
    """Return the solids of the payload that the scenario attaches to the end effector, in the last joint's frame."""
    payload, model = scenario.payload, scenario.arm.model
    if payload is None:
        return ()
    tip = model.linkage.tip
    return tuple(
        Solid(PART, model.linkage.frames[-1], product(vertices + payload.centre, payload.rotation.T) + tip)
        for vertices in payload.solids
    )


def _moved_by(joint: SwitchedJoint | None) -> tuple[str, ...]:
    """Return the name of the frame that a joint moves; () without the joint."""
    return () if joint is None else (joint.frame,)


def _stationary_parts(model: ArmModel, own: tuple[Solid, ...]) -> set[str]:
    """Return the arm's parts that stay at the mount.

    These are the parts on the base, the telescope and the first joint, and those within `SHORT` of L's origin in every
    pose.
    """
    foot, first, *_ = model.linkage.frames
    places = np.cumsum(model.linkage.steps, axis=0)
    near = {foot, first, *_moved_by(model.telescope)}
    reach: dict[str, float] = {}
    for solid in own:
        if solid.frame in near:
            reach.setdefault(solid.part, 0.0)
        elif solid.frame in model.linkage.frames:
            joint = places[max(model.linkage.frames.index(solid.frame) - 1, 0)]
            farthest = float(lengths(joint) + lengths(solid.vertices).max())
            reach[solid.part] = max(reach.get(solid.part, 0.0), farthest)
    return {part for part, farthest in reach.items() if farthest < SHORT}


def _unfoldable_pairs(model: ArmModel, own: tuple[Solid, ...]) -> set[PartPair]:
    """Return the pairs of arm parts that cannot touch when the arm folds.

    The two parts of such a pair are at the two ends of a short link or of a ball wrist.
    """
    links, names, ball = lengths(model.linkage.steps), model.linkage.frames, _ball(model)
    first = 0 if model.telescope is None else 1  # a telescope carries the first joint away from the base
    ends = {(names[k], names[k + 2]) for k in range(first, len(links) - 1) if links[k + 1] < SHORT}
    if ball:
        before = names[names.index(ball[0]) - 1]
        ends |= {
            (inner, outer)
            for inner in (before, *ball)
            for outer in (names[-1], *_moved_by(model.prong))
            if inner != outer
        }
    return {(a.part, b.part) for inner, outer in ends for a in own if a.frame == inner for b in own if b.frame == outer}


def _ball(model: ArmModel) -> tuple[str, ...]:
    """Return the frames of a wrist whose three axes meet in one point, as in the concept arm; () for other wrists.

    Parts in the wrist's inner frames only rotate about that point. The end effector is at a distance from the
    point, and the joint limits keep it in front of the boom. It therefore touches neither the boom nor these parts.
    """
    between = lengths(model.linkage.steps)[1:]
    return model.linkage.frames[-3:] if len(between) > 1 and not between[-2:].any() else ()


def scene_in_l(scenario: Scenario) -> Array:
    """Return the pose (12,) of the scene's frame in L."""
    return row_of(relative.scene_in_l(scenario.arm.model.mount, scenario.worksite.origin))


def _parts_of(worksite: Worksite, berth: Berth) -> set[str]:
    """Return the worksite's parts that are fixed to the same frame as a berth."""
    return {solid.part for solid in worksite.solids if solid.frame == berth.frame}

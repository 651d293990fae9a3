"""Contacts, detrimental and essential, and the two-frame rule: what a collision inhibits.

Remote Manipulator Simulation, final report, chapter IV, subroutine COLLIDE: a detrimental collision raises its flag in
the first frame; in the second in succession it inhibits motion, until it is relieved. In mode 1 the prong moves apart
from the arm: a collision of the prong alone inhibits the finger, any other the arm; in the later modes both. Two
frames are two control steps.
"""

from __future__ import annotations

from typing import NamedTuple

import msgspec
import numpy as np
from numpy.typing import NDArray

from aftdeck.bodies.pair import CONTACT
from aftdeck.law import law
from aftdeck.worksite.conditions import Units, shown
from aftdeck.worksite.found import CLEARANCE
from aftdeck.worksite.layout import Indices, Layout, Mask

Array = NDArray[np.float64]

ACQUISITION = 1
"""The report's mode in which the prong moves by itself."""
FRAMES = 2
"""In how many successive frames a collision is found before it inhibits."""
_TOLD = 5e-4
"""Depths below this are told without a number [m]."""


class Inhibit(NamedTuple):
    """What the contacts of a frame do.

    Attributes:
        arm: the arm's motion is inhibited.
        finger: the prong's motion is inhibited.
        changed: a contact, of either kind, began, ended or began to inhibit in this frame.
    """

    arm: bool
    finger: bool
    changed: bool


@law
def two_frames(found: Array, essential: Mask, arm: Mask, prong: Mask, mode: int, count: Indices) -> Inhibit:
    """The two-frame rule over all groups.

    Args:
        found: (g, 15) of this frame.
        essential: (g,) 1 for groups that are made to touch: they are counted, and never inhibit.
        arm: (g,) 1 for groups of which a part moves with the arm; others' contacts are not its to relieve.
        prong: (g,) 1 for groups of the prong.
        mode: the report's mode, 1 to 4.
        count: (g,) in how many successive frames each group has been in contact, at most 2; brought up to date.
    """
    by_arm, by_prong, changed = False, False, False
    for g in range(len(count)):
        now = min(count[g] + 1, FRAMES) if found[g, CLEARANCE] <= CONTACT else 0
        changed = changed or now != count[g]
        count[g] = now
        if now == FRAMES and essential[g] == 0 and arm[g] != 0:
            if prong[g] != 0:
                by_prong = True
            else:
                by_arm = True
    if mode == ACQUISITION:
        return Inhibit(by_arm, by_prong, changed)
    return Inhibit(by_arm or by_prong, by_arm or by_prong, changed)


class Contact(msgspec.Struct, frozen=True):
    """Two parts in contact.

    Attributes:
        group: which, of the layout.
        a: the first part.
        b: the second part.
        depth: how far they are in each other, 0 where they merely touch [m].
        essential: made to touch: never inhibits.
        inhibits: detrimental, of the arm, and found in two successive frames.
        text: for people.
    """

    group: int
    a: str
    b: str
    depth: float
    essential: bool
    inhibits: bool
    text: str


class Contacts:
    """The contacts of a flight, frame after frame.

    Attributes:
        layout: the groups.
        essential: (g,) 1 for groups that are made to touch.
        arm: (g,) 1 for groups of which a part moves with the arm, what it holds included; the caller sets it.
        prong: (g,) 1 for groups of the prong; none, of an arm without one.
        count: (g,) in how many successive frames each group has been in contact, at most 2.
        inhibit: what the contacts of the last frame do.
    """

    def __init__(self, layout: Layout, essential: Mask, arm: Mask, prong: Mask) -> None:
        self.layout = layout
        self.essential, self.arm, self.prong = essential, arm, prong
        self.count = np.zeros(len(layout.groups), np.int64)
        self.inhibit = Inhibit(arm=False, finger=False, changed=False)

    def look(self, found: Array, mode: int) -> Inhibit:
        """Take what `Watch.look` found (g, 15) as one more frame, in one of the report's modes."""
        self.inhibit = Inhibit(*two_frames(found, self.essential, self.arm, self.prong, mode, self.count))
        return self.inhibit

    def standing(self, found: Array, units: Units) -> tuple[Contact, ...]:
        """Every contact of the frame that was looked at last, deepest first, told in the operator's units."""
        groups = np.flatnonzero(self.count)
        return tuple(
            self._contact(int(g), found, units) for g in groups[np.argsort(found[groups, CLEARANCE], kind="stable")]
        )

    def _contact(self, group: int, found: Array, units: Units) -> Contact:
        a, b = self.layout.named(group)
        depth = max(0.0, -float(found[group, CLEARANCE]))
        essential = bool(self.essential[group])
        inhibits = not essential and bool(self.arm[group]) and self.count[group] == FRAMES
        return Contact(group, a, b, depth, essential, inhibits, told(a, b, depth, essential, units))

    def save(self) -> tuple[list[int], list[bool]]:
        """Everything that the next frame depends on."""
        return self.count.tolist(), list(self.inhibit)

    def restore(self, saved: tuple[list[int], list[bool]]) -> None:
        """Go on from what `save` gave."""
        self.count[:] = saved[0]
        self.inhibit = Inhibit(*saved[1])


def told(a: str, b: str, depth: float, essential: bool, units: Units) -> str:
    """A contact as a sentence.

    Examples:
        >>> told("lower boom", "bay wall port", 0.0213, False, "ft-in")
        'lower boom touches bay wall port: 0.839 in deep'
        >>> told("prong", "receptacle", 0.0, True, "SI")
        'prong touches receptacle, as it is made to'
    """
    deep = f": {shown(depth, 'm', units)} deep" if depth >= _TOLD else ""
    return f"{a} touches {b}{', as it is made to' if essential else ''}{deep}"

"""Contacts, detrimental and essential, and the two-frame rule: which motions a collision inhibits.

Source: *Remote Manipulator Simulation*, final report, chapter IV.B, subroutine COLLIDE. A frame of the report is a
control step here. A detrimental collision raises its flag in the first frame. If it is also found in the next frame, it
inhibits motion until it is relieved. In mode 1 any collision of the end effector, including the prong (HEX 3), inhibits
the arm; a collision of the prong also inhibits the finger. In the later modes every collision inhibits both the arm and
the finger.

Essential contacts inhibit nothing. A contact of two parts is essential only while the conditions for these parts hold
(`simulation.payloads.relations`), or while the payload that the arm holds slides along a wall (`worksite.sliding`).
"""

from __future__ import annotations

from typing import NamedTuple

import msgspec
import numpy as np

from aftdeck.arrays import Array, Mask
from aftdeck.bodies.pair import CONTACT
from aftdeck.law import law
from aftdeck.state_part import StatePart
from aftdeck.worksite.conditions import Units, quantity_text
from aftdeck.worksite.watch.found import CLEARANCE
from aftdeck.worksite.watch.groups import Layout

ACQUISITION = 1
"""Number of the report's mode in which the inhibits of the arm and of the finger differ."""
FRAMES = 2
"""Number of successive steps in which a collision has to be found before it inhibits motion."""
_LEAST_DEPTH = 5e-4
"""Depth below which the text of a contact gives no depth [m]."""


class Inhibit(NamedTuple):
    """Inhibit flags of a step, set by its contacts.

    Attributes:
        arm: the arm's motion is inhibited.
        finger: the prong's motion is inhibited.
        changed: in this step a contact, essential or detrimental, began, ended, or reached its second step.
    """

    arm: bool
    finger: bool
    changed: bool


UNINHIBITED = Inhibit(arm=False, finger=False, changed=False)


class Counted(NamedTuple):
    """Result of `count_frames`.

    Attributes:
        touching: at least one group is in contact.
        changed: a count changed.
    """

    touching: bool
    changed: bool


@law
def count_frames(found: Array, near: Mask, count: Mask) -> Counted:
    """Update the number of successive steps in which each group was in contact.

    Args:
        found: (g, 14) measurements of this step, rows as in `worksite.watch.found`.
        near: (g,) 1 for groups whose clearance in `found` is finite.
        count: (g,) the number for each group, at most 2; updated.
    """
    touching, changed = False, False
    for g in range(len(count)):
        changed = count_frame(found, near, count, g) or changed
        touching = touching or count[g] != 0
    return Counted(touching, changed)


@law
def count_frame(found: Array, near: Mask, count: Mask, g: int) -> bool:
    """Update the number of successive steps in which group g was in contact, as `count_frames` does for all groups.

    Return whether the number has changed.
    """
    before = count[g]
    count[g] = min(int(before) + 1, FRAMES) if near[g] != 0 and found[g, CLEARANCE] <= CONTACT else 0
    return bool(count[g] != before)


@law
def two_frames(count: Mask, essential: Mask, arm: Mask, prong: Mask, mode: int) -> tuple[bool, bool]:
    """Return whether the arm and the finger are inhibited.

    Args:
        count: (g,) number of successive steps in which each group was in contact.
        essential: (g,) 1 for groups whose contact belongs to the task; such a contact never inhibits motion.
        arm: (g,) 1 for groups with a part that moves with the arm. Only contacts of these groups inhibit
            motion, because the arm cannot relieve contacts of other groups.
        prong: (g,) 1 for groups of the prong.
        mode: the report's mode, 1 to 4.
    """
    by_arm, by_prong = False, False
    for g in range(len(count)):
        if count[g] == FRAMES and essential[g] == 0 and arm[g] != 0:
            by_arm = True
            by_prong = by_prong or prong[g] != 0
    return by_arm, by_prong if mode == ACQUISITION else by_arm


class Contact(msgspec.Struct, frozen=True):
    """Two parts in contact.

    Attributes:
        group: index of the group in the layout.
        a: the first part.
        b: the second part.
        depth: penetration depth, 0 if the parts merely touch [m].
        essential: the contact belongs to the task and never inhibits motion.
        inhibits: the contact is detrimental, one of its parts moves with the arm, and it was found in two successive
            steps.
        text: sentence for the operator.
    """

    group: int
    a: str
    b: str
    depth: float
    essential: bool
    inhibits: bool
    text: str


class Contacts(StatePart):
    """Contact state of all groups, updated in every step.

    Attributes:
        essential: (g,) 1 for groups whose contact belongs to the task; the caller sets it.
        arm: (g,) 1 for groups with a part that moves with the arm, such as a held payload; the caller sets it.
        count: (g,) number of successive steps in which each group has been in contact, at most 2.
        inhibit: inhibit flags of the last step.
    """

    essential: Mask
    arm: Mask
    count: Mask
    inhibit: Inhibit = UNINHIBITED

    def update(self, found: Array, near: Mask, prong: Mask, mode: int) -> Inhibit:
        """Count the contacts in a step's measurements; store and return the flags.

        Args:
            found: (g, 14) measurements, those of a `ClearanceMonitor`.
            near: (g,) 1 for groups whose clearance in `found` is finite.
            prong: (g,) 1 for groups of the prong; all 0 for an arm without a prong.
            mode: the report's mode, 1 to 4.
        """
        touching, changed = count_frames(found, near, self.count)
        arm, finger = False, False
        if touching:
            arm, finger = two_frames(self.count, self.essential, self.arm, prong, mode)
        self.inhibit = Inhibit(bool(arm), bool(finger), bool(changed)) if arm or finger or changed else UNINHIBITED
        return self.inhibit

    def standing(self, layout: Layout, found: Array, units: Units) -> tuple[Contact, ...]:
        """Return all contacts of the last step, deepest first, with texts in the operator's units."""
        return tuple(self.contact(group, layout, found, units) for group in self.groups(found))

    def groups(self, found: Array) -> list[int]:
        """Return the groups that are in contact, deepest first; `found` is `ClearanceMonitor.found` (g, 14)."""
        touching: list[int] = np.flatnonzero(self.count).tolist()
        depths = found[touching, CLEARANCE].tolist()
        return [group for _, group in sorted(zip(depths, touching, strict=True))]

    def contact(self, group: int, layout: Layout, found: Array, units: Units) -> Contact:
        """Return a contact of the last step, with its text in the operator's units."""
        a, b = layout.named(group)
        depth = max(0.0, -float(found[group, CLEARANCE]))
        essential = bool(self.essential[group])
        inhibits = not essential and bool(self.arm[group]) and bool(self.count[group] == FRAMES)
        return Contact(group, a, b, depth, essential, inhibits, contact_text(a, b, depth, essential, units))


def contact_text(a: str, b: str, depth: float, essential: bool, units: Units) -> str:
    """Return a contact as a sentence.

    Examples:
        >>> contact_text("lower boom", "bay wall port", 0.0213, False, "ft-in")
        'contact of lower boom and bay wall port: 0.839 in deep'
        >>> contact_text("prong", "receptacle", 0.0, True, "SI")
        'contact of prong and receptacle, part of the task'
    """
    deep = f": {quantity_text(depth, 'm', units)} deep" if depth >= _LEAST_DEPTH else ""
    return f"contact of {a} and {b}{', part of the task' if essential else ''}{deep}"

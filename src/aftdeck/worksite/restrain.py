"""What an inhibit lets through: motion that deepens no contact and makes no new one; and which way leads out.

The report's inhibit holds all motion until the collision is relieved, and leaves open how it could be. Here each step
of an inhibited arm is tried before it is made, so that whatever leads out of a contact is flown and nobody is stranded.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from aftdeck.bodies import pair as packed
from aftdeck.bodies.pair import CONTACT
from aftdeck.law import law
from aftdeck.worksite.found import CLEARANCE, WHICH
from aftdeck.worksite.layout import Indices, Mask
from aftdeck.worksite.watch import Watch, nearest_pair, place_moved, travelled

Array = NDArray[np.float64]

DEEPER = 1e-12
"""By how much a clearance may fall in a step and count as kept [m]: clearances are right to that.

Without it, sliding along a wall would be let through or not as rounding has it. A contact that creeps in by it in
every step of 0.02 s is deeper by 0.2 micrometres after an hour.
"""
STEP = 1.0
"""What is farther apart than this [m] comes into no contact in a step."""


class Trial(NamedTuple):
    """What a motion would do to the contacts.

    Attributes:
        worst: the greatest fall of the clearance of a contact, present or new, negative; without a fall the least rise,
            inf where there is no contact [m].
        which: the group of that contact; -1 where there is none.
        gained: by how much the clearances of the present contacts rise, taken together [m].
        deeper: how much deeper in each other two parts are then than now, at most; negative or 0 where none are [m].
    """

    worst: float
    which: int
    gained: float
    deeper: float


@law
def tried(
    solids: Array,
    frame: Indices,
    pairs: Indices,
    begins: Indices,
    between: Indices,
    reach: Array,
    counts: Mask,
    after: Array,
    at: Array,
    placed: Array,
    bound: Array,
    memory: Array,
    found: Array,
) -> Trial:
    """What a motion would do to the contacts of the groups that count.

    Args:
        solids: (n, 52), frame (n,), pairs (m, 2), begins (g + 1,), between (g, 2), reach (F,): of the layout.
        frame: see solids.
        pairs: see solids.
        begins: see solids.
        between: see solids.
        reach: see solids.
        counts: (g,) 1 for groups to keep from each other; they have to be active.
        after: (F, 12) the frames after the motion, in L.
        at: (F, 12) and placed (n, 52): copies of the watch's; used up.
        placed: see at.
        bound: (g,) the watch's.
        memory: (m, 17) the watch's; nothing changes it.
        found: (g, 15) what the watch found before the motion.
    """
    ways, own = np.empty(len(after)), np.empty_like(memory)
    travelled(after, at, reach, ways)
    place_moved(solids, frame, after, at, placed)
    worst, which, gained, deeper = np.inf, -1, 0.0, -np.inf
    for g in range(len(counts)):
        if counts[g] == 0:
            continue
        before, limit = found[g, CLEARANCE], np.inf
        if before > CONTACT:
            limit = 2.0 * CONTACT
            if bound[g] - ways[between[g, 0]] - ways[between[g, 1]] >= limit:
                continue
        own[begins[g] : begins[g + 1]] = memory[begins[g] : begins[g + 1]]
        k = nearest_pair(placed, pairs, own, begins[g], begins[g + 1], int(found[g, WHICH]), limit)
        if k < 0:
            continue
        clearance = own[k, packed.CLEARANCE]
        if before <= CONTACT:
            gained += clearance - before
        if clearance - before < worst and (before <= CONTACT or clearance <= CONTACT):
            worst, which = clearance - before, g
        deeper = max(deeper, min(before, 0.0) - clearance)
    return Trial(worst, which, gained, deeper)


@law
def tried_many(
    solids: Array,
    frame: Indices,
    pairs: Indices,
    begins: Indices,
    between: Indices,
    reach: Array,
    counts: Mask,
    afters: Array,
    at: Array,
    placed: Array,
    bound: Array,
    memory: Array,
    found: Array,
    trials: Array,
) -> None:
    """`tried` for each of several motions, afters (k, F, 12), into trials (k, 4); what the watch holds is copied."""
    for k in range(len(afters)):
        t = tried(
            solids, frame, pairs, begins, between, reach, counts, afters[k],
            at.copy(), placed.copy(), bound, memory, found,
        )  # fmt: skip
        trials[k, 0], trials[k, 1], trials[k, 2], trials[k, 3] = t.worst, t.which, t.gained, t.deeper


def allowed(watch: Watch, counts: Mask, after: Array) -> bool:
    """Whether an inhibited arm may make a step's motion: it deepens no contact and makes no new one.

    Args:
        watch: as it has looked at the present frames.
        counts: (g,) 1 for the detrimental groups that move with the arm.
        after: (F, 12) the frames after the motion, in L; what does not move with the arm stands where it is.
    """
    return worsened(watch, counts, after) < 0


def worsened(watch: Watch, counts: Mask, after: Array) -> int:
    """The contact that a step deepens most, or makes; -1 where it does neither. As `allowed`."""
    worst, which, _, _ = _trials(watch, counts, after[None])[0].tolist()
    return int(which) if worst < -DEEPER else -1


def deeper(watch: Watch, counts: Mask, after: Array) -> float:
    """How much deeper in each other a step takes two parts [m]; as `allowed`, for contacts that may be there."""
    return float(_trials(watch, counts, after[None])[0, 3])


def deepened(watch: Watch, counts: Mask, before: Array, after: Array) -> int:
    """As `worsened`, where other things have moved since the watch looked.

    Args:
        watch: of which a copy looks.
        counts: (g,) 1 for the groups that matter.
        before: (F, 12) the frames without that motion, in L, with all else that has moved in the step.
        after: (F, 12) the frames with it.
    """
    copy = watch.copy()
    none = np.zeros_like(counts)
    copy.look_near(before, before, 1.0, none, STEP)
    was = copy.found[:, CLEARANCE].copy()
    copy.look_near(after, after, 1.0, none, STEP)
    now = copy.found[:, CLEARANCE]
    touched = (counts & copy.active).astype(bool) & ((was <= CONTACT) | (now <= CONTACT))
    fall = np.full(len(was), -np.inf)
    fall[touched] = was[touched] - now[touched]
    return int(fall.argmax()) if fall.max(initial=-np.inf) > DEEPER else -1


def ways_out(watch: Watch, counts: Mask, afters: Array) -> Array:
    """How fast each of several motions leads out of the present contacts.

    Args:
        watch: as it has looked at the present frames.
        counts: (g,) 1 for the detrimental groups that move with the arm.
        afters: (k, F, 12) the frames after a step of each, in L: one for each stick direction.

    Returns:
        (k,) by how much the clearances of all contacts rise together, where the step is allowed; else by how much the
        worst one falls, negative [m].
    """
    trials = _trials(watch, counts, afters)
    return np.where(trials[:, 0] >= -DEEPER, trials[:, 2], trials[:, 0])


def _trials(watch: Watch, counts: Mask, afters: Array) -> Array:
    own, trials = watch.layout, np.empty((len(afters), 4))
    tried_many(
        *own.packed,
        counts & watch.active,
        afters,
        *watch.packed,
        trials,
    )
    return trials

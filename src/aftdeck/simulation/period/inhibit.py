"""Motions that an inhibited arm may still make, and those that lead out of the contacts."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array, Mask
from aftdeck.law import large_law, law
from aftdeck.lent import lend
from aftdeck.simulation.period.predict import predicted
from aftdeck.simulation.row.now import Arrays, Flat, lent, motion_of, watch_of
from aftdeck.simulation.row.scalars import ADVISED, HELD, SLIDES, TELESCOPE
from aftdeck.simulation.row.world import world_of
from aftdeck.steering.layout import RATES
from aftdeck.worksite.watch.contact_motion import deepens, lessens, may_lead_out, relief

AHEAD = (1.0, 8.0, 64.0, 512.0)
"""Numbers of control steps after which the poses are tested, to find whether a motion leads out of the contacts."""


@large_law
def may_move(flat: Flat) -> bool:
    """Return whether an inhibited arm may make a step at the commanded rates."""
    now = motion_of(flat)
    v, rates = now.scalars, now.steering[RATES : RATES + len(now.angles)]
    counts, harmful = _kept_apart(flat, v[SLIDES] != 0.0)
    first = predicted(flat, counts, harmful, rates, v[TELESCOPE], 1.0)
    if relief(first) > 0.0:
        return True
    if may_lead_out(first) and _led_out(flat, counts, harmful, rates, v[TELESCOPE], 1.0, 0.0) > 0.0:
        return True
    # if no motion leads out, allow a step that deepens no contact, so that the arm can still move
    return bool(v[ADVISED] == 0.0 and not deepens(first))


@law
def ways_out(arrays: Arrays, rates: Array, drives: Array, steps: float, slides: bool, gains: Array) -> None:
    """Find how far each of several motions leads out of the present contacts.

    Args:
        arrays: constants of the run and row of the state.
        rates: (k, n) rates of the joints [rad/s].
        drives: (k,) drives of the telescope, in [-1, 1].
        steps: number of control steps, or share of one, for which each motion is tested first.
        slides: whether a held payload slides along walls.
        gains: (k,) output: the clearance that each motion gains [m], if it relieves the contacts. If none of them does:
            how much each lessens the depths if it is continued. 0 or less if it does not lead out.
    """
    flat, rates, drives, gains = lent(arrays), lend(rates), lend(drives), lend(gains)
    counts, harmful = _kept_apart(flat, slides)
    may, best = np.empty(len(rates), np.bool_), -np.inf
    for k in range(len(rates)):
        first = predicted(flat, counts, harmful, rates[k], drives[k], steps)
        may[k], gains[k] = may_lead_out(first), relief(first)
        best = max(best, gains[k])
    if best > 0.0:
        return
    for k in range(len(rates)):
        gains[k] = _led_out(flat, counts, harmful, rates[k], drives[k], steps, np.inf) if may[k] else 0.0


@law
def _kept_apart(flat: Flat, slides: bool) -> tuple[Mask, Mask]:
    """Return two masks (g,): pairs whose contacts an inhibited arm must not deepen, and pairs that it must relieve.

    The second result is a subset of the first. If the held payload slides along walls, the results do not contain its
    pairs with them, because sliding keeps the payload out of the walls.
    """
    world, watch = world_of(flat), watch_of(flat)
    held = int(motion_of(flat).scalars[HELD])
    counts, harmful = np.empty(len(watch.arm), np.uint8), np.zeros(len(watch.arm), np.uint8)
    for g in range(len(counts)):
        counts[g] = 0 if slides and held >= 0 and world.slides[held, g] != 0 else watch.arm[g]
        if watch.permitted[g] == 0:
            harmful[g] = counts[g]
    return counts, harmful


@large_law
def _led_out(flat: Flat, counts: Mask, harmful: Mask, rates: Array, drive: float, steps: float, enough: float) -> float:
    """Return the greatest decrease of the sum of all depths if a motion is continued [m]; 0 if it does not lead out.

    Args:
        flat: as for `predicted`.
        counts: the same.
        harmful: the same.
        rates: the same.
        drive: the same.
        steps: number of control steps, `AHEAD` times which are tested.
        enough: a decrease greater than this ends the search [m].
    """
    won = 0.0
    for ahead in AHEAD:
        won = max(won, lessens(predicted(flat, counts, harmful, rates, drive, steps * ahead)))
        if won > enough:
            break
    return won

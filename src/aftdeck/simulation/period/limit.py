"""Limit one step's commanded motion to what contacts, berths, switches and walls allow, before the arm executes it.

Source: *Remote Manipulator Simulation*, final report, chapter IV: a collision found in two successive steps inhibits
the arm until the collision is relieved. Deviation: motion that relieves the contact (`worksite.watch.contact_motion`)
is allowed, so that the operator can always back out. A held payload slides along walls (`worksite.sliding`).
"""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.law import large_law, law
from aftdeck.simulation.period.inhibit import may_move
from aftdeck.simulation.period.slide import slid_along
from aftdeck.simulation.row.now import Flat, motion_of, watch_of
from aftdeck.simulation.row.scalars import (
    AUTOMATIC,
    FIXED,
    HALT,
    HELD,
    INHIBITED,
    KEEPS_CLOCK,
    LOCKED,
    PERIOD,
    SLIDES,
    TELESCOPE,
)
from aftdeck.simulation.row.world import world_of
from aftdeck.steering.layout import CLOCK, CLOCK_RATE, RATES, RATIO, TWIST

BERTH, SWITCH, CONTACT = 1.0, 2.0, 3.0
"""What blocks a commanded motion (`scalars.HALT`)."""


@large_law
def limited(flat: Flat, rules: Array) -> None:
    """Limit the commanded rates, and the drive of the telescope in the scalars; write there what stops the arm, too.

    Mark the pairs whose contacts belong to the task.
    """
    world, now, watch = world_of(flat), motion_of(flat), watch_of(flat)
    v, held, slides = now.scalars, int(now.scalars[HELD]), now.scalars[SLIDES] != 0.0
    for g in range(len(watch.essential)):
        watch.essential[g] = watch.permitted[g] | world.slides[held, g] if slides else watch.permitted[g]
    moved = v[TELESCOPE] != 0.0
    for i in range(len(now.angles)):
        moved = moved or now.steering[RATES + i] != 0.0
    v[HALT] = 0.0
    if v[FIXED] != 0.0 or v[LOCKED] != 0.0:
        if moved:
            v[HALT] = BERTH if v[FIXED] != 0.0 else SWITCH
        _stop_arm(flat)
    elif not moved:
        v[TELESCOPE] = 0.0
    elif (slides and not slid_along(flat, rules)) or (v[INHIBITED] != 0.0 and not may_move(flat)):
        v[HALT] = CONTACT
        _stop_arm(flat)


@law
def _stop_arm(flat: Flat) -> None:
    """Stop joints and telescope; the steering of the next step starts from rest.

    Except under `strict`, the clock of modes 1 and 3 is set back by `CLOCK_RATE` periods, which is about its advance in
    this step.
    """
    now, c = motion_of(flat), world_of(flat).constants
    steering = now.steering
    now.scalars[TELESCOPE] = 0.0
    for i in range(len(now.angles)):
        steering[RATES + i] = 0.0
    for i in range(6):
        steering[TWIST + i] = 0.0
    now.report[RATIO] = 0.0
    if now.scalars[AUTOMATIC] != 0.0 and c[KEEPS_CLOCK] == 0.0:
        steering[CLOCK] -= steering[CLOCK_RATE] * c[PERIOD]
        steering[CLOCK_RATE] = 0.0

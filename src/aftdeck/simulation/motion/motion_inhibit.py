"""Limit one step's commanded motion to what contacts, berths and walls allow, before the plant executes it.

Source: *Remote Manipulator Simulation*, final report, chapter IV: a collision found in two successive steps inhibits
the arm until the collision is relieved. Deviation: motion that relieves the contact (`worksite.watch.contact_motion`)
is allowed, so that the operator can always back out. A held payload slides along walls (`worksite.sliding`).
"""

from __future__ import annotations

from aftdeck.arrays import Array, Mask
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.constants.site import Site
from aftdeck.simulation.frame_poses import frames_after
from aftdeck.simulation.motion.standstill import joint_lock_reason
from aftdeck.simulation.parts.worksite_state import WorksiteState
from aftdeck.simulation.payloads.sliding import slide_along
from aftdeck.simulation.period.steer import stop_arm
from aftdeck.simulation.state import State
from aftdeck.steering.mode import MODES
from aftdeck.worksite.watch.contact_motion import leads_out, relieves, worst_new_contact

AHEAD = (1.0, 8.0, 64.0, 512.0)
"""Numbers of control steps after which the poses are tested, to find whether a motion leads out of the contacts."""


def limit_motion(flight: Flight, state: State, rates: Array, telescope: float) -> float:
    """Limit the rates in `state.steering` and the telescope's drive to what contacts, berths and walls allow.

    Args:
        flight: constants of the run.
        state: state with the step's commanded rates.
        rates: (n,) these rates, a view of `state.steering`.
        telescope: commanded drive of the telescope, in [-1, 1].

    Returns:
        Allowed drive of the telescope, in [-1, 1].
    """
    worksite, plant, mode = state.worksite, state.plant, state.panel.mode
    worksite.halt = ""
    sliding = sliding_payload(worksite.held, mode) if flight.inhibits else None
    worksite.contacts.essential[:] = flight.site.essential_while(sliding, worksite.permitted)
    moved = telescope or any(rates.tolist())
    if worksite.arm_fixed or joint_lock_reason(state.panel):
        if moved:
            worksite.halt = "seat" if worksite.arm_fixed else "switch"
        return _stop_arm(flight, state.steering, state.report, mode)
    if not moved:
        return 0.0
    if sliding is not None:
        slides = slide_along(flight, state, telescope, sliding)
        if slides is None:
            worksite.halt = "contact"
            return _stop_arm(flight, state.steering, state.report, mode)
        telescope = slides
    if not worksite.contacts.inhibit.arm:
        return telescope
    after = frames_after(flight, worksite, plant, rates, telescope)
    apart = kept_apart(flight.site, worksite, sliding=sliding is not None)
    if relieves(worksite.watch, *apart, after):
        return telescope
    ahead = [frames_after(flight, worksite, plant, steps * rates, steps * telescope)[None] for steps in AHEAD]
    if leads_out(worksite.watch, *apart, after[None], ahead)[0] > 0.0:
        return telescope
    # if no motion leads out, allow a step that deepens no contact, so that the arm can still move
    if not worksite.advice and worst_new_contact(worksite.watch, apart[0], after) < 0:
        return telescope
    worksite.halt = "contact"
    return _stop_arm(flight, state.steering, state.report, mode)


def kept_apart(site: Site, worksite: WorksiteState, *, sliding: bool) -> tuple[Mask, Mask]:
    """Return two masks (g,): pairs whose contacts an inhibited arm must not deepen, and pairs that it must relieve.

    The second result is a subset of the first.

    Args:
        site: constants of the worksite.
        worksite: its state, with contacts that are up to date.
        sliding: True if the held payload slides along walls, as in modes 1 to 7. The results then do not contain the
            pairs of the payload and its walls, because sliding keeps the payload out of the walls.
    """
    own = worksite.contacts.arm
    if sliding and worksite.held is not None:
        own = own & (1 - site.slides[worksite.held])
    return own, own & (1 - worksite.permitted)


def sliding_payload(held: int | None, mode: str) -> int | None:
    """Return the payload that slides along walls, if contacts inhibit motion: the held one in modes 1 to 7, else None.

    If contacts do not inhibit motion, the forces of a contact keep the payload out of the walls.
    """
    return held if held is not None and MODES[mode].kind in ("automatic", "manual") else None


def _stop_arm(flight: Flight, steering: Array, report: Array, mode: str) -> float:
    """Stop the arm, and return 0.0, the drive that stops the telescope.

    Except under `strict`, the clock of modes 1 and 3 is set back.
    """
    scenario = flight.scenario
    sets_back = MODES[mode].kind == "automatic" and not scenario.strict
    stop_arm(len(scenario.arm.joints), steering, report, scenario.control_period if sets_back else 0.0)
    return 0.0

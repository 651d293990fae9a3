"""Present objective (capture, docking or berthing) and its conditions, as the panel displays them."""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.simulation.constants.hand import Bar
from aftdeck.simulation.constants.site import Site
from aftdeck.simulation.parts.worksite_state import WorksiteState
from aftdeck.simulation.payloads.grasp import NEAR, fixture_in_hand, nearest_fixture
from aftdeck.simulation.payloads.latch_command import nearest_berth
from aftdeck.simulation.payloads.seating import conditions_at
from aftdeck.worksite.capture.acquisition import AWAY, acquisition
from aftdeck.worksite.capture.grapple import in_envelope
from aftdeck.worksite.conditions import Condition
from aftdeck.worksite.payload import Cargo
from aftdeck.worksite.report import Objective

Pursued = tuple[Objective | None, tuple[Condition, ...]]


def present_objective(site: Site, worksite: WorksiteState) -> Pursued:
    """Return the present objective and its conditions; None and () if no fixture, bar or berth is within `NEAR`.

    A berth that has just released the payload is no objective until the payload has left it.
    """
    if (k := worksite.held) is not None:
        fit = None if worksite.arm_fixed else nearest_berth(site, worksite.frames, k)
        if fit is None or worksite.cargo[k].released_from == fit.berth.name:
            return None, ()
        text = f"{fit.berth.verb} in the {fit.berth.title}"
        return Objective(fit.berth.verb, text), conditions_at(site, worksite, k, fit)
    if site.bar is not None:
        return _acquisition(site.cargo, worksite.watch.placed, site.bar)
    if site.snares is not None and (near := nearest_fixture(site, worksite.frames)) is not None:
        k, fixture = near
        text = f"capture {site.cargo[k].title}"
        return Objective("capture", text), in_envelope(fixture, site.snares.envelope)
    return None, ()


def holding(site: Site, worksite: WorksiteState, k: int) -> tuple[Condition, ...]:
    """Return the conditions of capture for the present pose of payload k; () if this end effector cannot capture it."""
    if site.bar is not None and (found := site.bar.measured(worksite.watch.placed, k)) is not None:
        return acquisition(found, site.bar.tolerances)
    if site.snares is not None and (fixture := fixture_in_hand(site, worksite.frames, k)) is not None:
        return in_envelope(fixture, site.snares.envelope)
    return ()


def _acquisition(cargo: tuple[Cargo, ...], placed: Array, bar: Bar) -> Pursued:
    """Return the objective to acquire the payload whose bar is nearest to the palm, and the conditions of acquisition.

    The result is None and () if no bar is within `NEAR`. `placed` are all solids in L.
    """
    best: Pursued = (None, ())
    least = NEAR
    for k, payload in enumerate(cargo):
        found = bar.measured(placed, k)
        if found is not None and found[AWAY] < least:
            least = float(found[AWAY])
            conditions = acquisition(found, bar.tolerances)
            best = Objective("acquire", f"acquire {payload.title}"), conditions
    return best

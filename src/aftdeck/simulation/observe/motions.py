"""Mechanisms in motion, each with the time in which it reaches its end position."""

from __future__ import annotations

from aftdeck.plant.linear_actuator import Slide, Travel
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.parts.worksite_state import WorksiteState
from aftdeck.worksite.report import Motion

_LEAST = 0.05
"""Least speed at which a linear actuator counts as moving, as a fraction of its rate [1]; on a plant with masses, its
speed at rest is not exactly zero."""


def motions_of(flight: Flight, worksite: WorksiteState, stand: Slide) -> tuple[Motion, ...]:
    """Return the mechanisms in motion: latches, snares, carriage, prong, telescope.

    Latches and carriage that wait, because further motion would make a contact, are left out.
    """
    found: list[Motion] = []
    for payload in worksite.payloads:
        if payload.latches.motion and not worksite.waiting:
            closes = payload.latches.motion == "latch"
            left = 1.0 - payload.latches.closed if closes else payload.latches.closed
            found.append(
                Motion("latches close" if closes else "latches open", left * flight.site.berth(payload.berth).time)
            )
    device = flight.site.capture
    if device is not None and not worksite.waiting and (moves := device.motion(worksite.controls())) is not None:
        found.append(moves)
    _add(found, worksite.prong, flight.prong, ("prong closes", "prong opens"))
    _add(found, stand, flight.telescope, ("telescope extends", "telescope retracts"))
    return tuple(found)


def _add(found: list[Motion], slide: Slide, travel: Travel, texts: tuple[str, str]) -> None:
    """Add the motion of a linear actuator, if it moves; `texts`: its motion towards its high and its low end."""
    if abs(slide.velocity) > _LEAST * travel.rate and travel.rate > 0.0:
        left = travel.high - slide.position if slide.velocity > 0.0 else slide.position - travel.low
        if left > 0.0:
            found.append(Motion(texts[0 if slide.velocity > 0.0 else 1], left / abs(slide.velocity)))

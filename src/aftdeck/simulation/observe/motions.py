"""Mechanisms in motion, each with the time in which it reaches its end position."""

from __future__ import annotations

from aftdeck.plant.linear_actuator import Slide, Travel
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.parts.worksite_state import WorksiteState
from aftdeck.simulation.payloads.capture import snare_command
from aftdeck.worksite.capture.snare import Part, next_stage
from aftdeck.worksite.report import Motion

_SNARE_TEXTS: dict[tuple[Part, bool], str] = {
    ("ring", True): "snares close",
    ("ring", False): "snares open",
    ("carriage", True): "carriage retracts",
    ("carriage", False): "carriage extends",
    ("tension", True): "rigidizing",
    ("tension", False): "derigidizing",
}
"""Text of each part's motion, towards 1 (True) and towards 0 (False)."""
_LEAST = 0.05
"""Least speed at which a linear actuator counts as moving, as a fraction of its rate [1]; on a plant with masses, its
speed at rest is not exactly zero."""


def motions_of(flight: Flight, worksite: WorksiteState, stand: Slide) -> tuple[Motion, ...]:
    """Return the mechanisms in motion: latches, snares, carriage, prong, telescope.

    Latches and carriage that wait, because further motion would make a contact, are left out.
    """
    found: list[Motion] = []
    for payload in worksite.cargo:
        if payload.latches.motion and not worksite.waiting:
            closes = payload.latches.motion == "latch"
            left = 1.0 - payload.latches.closed if closes else payload.latches.closed
            found.append(
                Motion("latches close" if closes else "latches open", left * flight.site.berth(payload.seat).time)
            )
    snares = flight.site.snares
    if snares is not None and not worksite.waiting and (worksite.snare.motion or worksite.rigid != "off"):
        stage = next_stage(worksite.snare, snare_command(worksite, pressed=False))
        if stage is not None:
            part, target = stage
            left = abs(target - float(getattr(worksite.snare, part)))
            text = _SNARE_TEXTS[part, target == 1.0]
            found.append(Motion(text, left * float(getattr(snares.times, part))))
    _add(found, worksite.prong, flight.prong, ("prong closes", "prong opens"))
    _add(found, stand, flight.telescope, ("telescope extends", "telescope retracts"))
    return tuple(found)


def _add(found: list[Motion], slide: Slide, travel: Travel, texts: tuple[str, str]) -> None:
    """Add the motion of a linear actuator, if it moves; `texts`: its motion towards its high and its low end."""
    if abs(slide.velocity) > _LEAST * travel.rate and travel.rate > 0.0:
        left = travel.high - slide.position if slide.velocity > 0.0 else slide.position - travel.low
        if left > 0.0:
            found.append(Motion(texts[0 if slide.velocity > 0.0 else 1], left / abs(slide.velocity)))

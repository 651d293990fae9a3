"""CLEARANCE of parts that the task brings together: an alarm only where their contact would be detrimental."""

from __future__ import annotations

import math

import numpy as np
import pytest

import aftdeck
from aftdeck import Inputs
from aftdeck.simulation.frame import Frame
from tests.simulation.concept import AT_PORT, scenario
from tests.simulation.flights import Pair, srms

PROBE: Pair = ("payload probe", "CAE")
GUIDES: frozenset[Pair] = frozenset(("payload trunnions", f"latches {side}") for side in ("port", "starboard"))
DOCKING = 0.25
"""How far from the port's centre the probe's may be [ft]."""
FEW = 600
"""Steps in which a flight meets what it goes to."""


def pair(frame: Frame) -> Pair | None:
    """The pair that CLEARANCE is about."""
    near = frame.work.nearest
    return None if near is None else (near.a, near.b)


def until_contact(sim: aftdeck.Simulation, inputs: Inputs, pairs: frozenset[Pair]) -> tuple[list[Frame], Pair | None]:
    """The frames up to a contact of one of some pairs, or to a docking, and which pair that is."""
    frames: list[Frame] = []
    for _ in range(FEW):
        frames.append(sim.step(inputs))
        if frames[-1].work.cargo[0].seat:
            break
        for contact in frames[-1].work.contacts:
            if (contact.a, contact.b) in pairs:
                return frames, (contact.a, contact.b)
    return frames, None


def beside_the_port(seed: int) -> tuple[list[Frame], Pair | None]:
    """A flight of the probe towards the CAE, beside the port by more than docking allows."""
    rng = np.random.default_rng(seed)
    aside, angle = rng.uniform(1.3 * DOCKING, 1.6), rng.uniform(0.0, math.tau)
    x, y, z = AT_PORT
    # straight to the port's face, and so little aside that it stays beside the port
    way = (float(rng.uniform(0.3, 1.0)), *(0.05 * rng.uniform(-1.0, 1.0, 2)).tolist())
    sim = aftdeck.Simulation(
        scenario((x + 1.5, y + aside * math.cos(angle), z + aside * math.sin(angle)), held=True),
    )
    return until_contact(sim, Inputs(way), frozenset((PROBE,)))


@pytest.mark.parametrize("seed", range(12))
def test_clearance_warns_before_probe_touches_beside_port(seed: int) -> None:
    """Before: no word of the two until they touched."""
    frames, met = beside_the_port(seed)
    assert met == PROBE and not any(contact.essential for contact in frames[-1].work.contacts)
    levels = [frame.work.clearance_level for frame in frames[:-1] if pair(frame) == PROBE]
    assert levels[-1] == "warning" and pair(frames[-2]) == PROBE
    assert any(event.kind == "clearance" and "probe" in event.text for frame in frames for event in frame.events)


@pytest.mark.parametrize("seed", range(4))
def test_probe_approaching_port_raises_no_alarm(seed: int) -> None:
    rng = np.random.default_rng(seed)
    aside, angle = rng.uniform(0.0, 0.8 * DOCKING), rng.uniform(0.0, math.tau)
    x, y, z = AT_PORT
    made = scenario((x + 1.5, y + aside * math.cos(angle), z + aside * math.sin(angle)), held=True)
    frames, met = until_contact(aftdeck.Simulation(made), Inputs((0.5, 0.0, 0.0)), frozenset((PROBE,)))
    assert met is None and frames[-1].work.cargo[0].seat == "port"
    assert PROBE not in {pair(frame) for frame in frames}


@pytest.mark.parametrize("aside", [9.0, 12.0])
def test_clearance_warns_before_trunnions_touch_beside_guides(aside: float) -> None:
    """Before: no word of the two until they touched."""
    sim = aftdeck.Simulation(srms(26.0, aside, held=True))
    frames, met = until_contact(sim, Inputs((0.0, 0.0, 1.0)), GUIDES)
    assert met is not None
    about = [frame for frame in frames[:-1] if pair(frame) in GUIDES]
    assert about and about[-1].work.clearance_level == "warning"


def test_trunnions_above_guides_raise_no_alarm() -> None:
    frames, met = until_contact(aftdeck.Simulation(srms(4.0, held=True)), Inputs((0.0, 0.0, 1.0)), GUIDES)
    assert met is not None and all(contact.essential for contact in frames[-1].work.contacts)
    assert not GUIDES & {pair(frame) for frame in frames}


@pytest.mark.parametrize(("aside", "foreseen"), [(0.0, False), (1.0, True)])
def test_look_ahead_predicts_contact_only_beside_port(aside: float, foreseen: bool) -> None:
    x, y, z = AT_PORT
    sim = aftdeck.Simulation(scenario((x + 0.6, y + aside, z), held=True))
    for _ in range(40):
        sim.step(Inputs((0.2, 0.0, 0.0)))
    assert (sim.ahead(3.0).contact_s is not None) is foreseen

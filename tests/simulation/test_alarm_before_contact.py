"""CLEARANCE of parts that the task brings together: an alarm only if their contact would be detrimental."""

from __future__ import annotations

import math

import numpy as np
import pytest

import aftdeck
from aftdeck import Inputs
from aftdeck.simulation.frame import Frame
from tests.each import each, seeds
from tests.simulation.concept import AT_PORT, scenario
from tests.simulation.flights import Pair, srms

PROBE: Pair = ("payload probe", "CAE")
GUIDES: frozenset[Pair] = frozenset(("payload trunnions", f"latches {side}") for side in ("port", "starboard"))
DOCKING = 0.25
"""Greatest distance of the probe from the port's centre at docking [ft]."""
MAX_STEPS = 600
"""Greatest number of steps until a contact or a docking."""


def pair(frame: Frame) -> Pair | None:
    """Return the pair of minimum clearance, to which CLEARANCE refers."""
    near = frame.work.nearest
    return None if near is None else (near.a, near.b)


def until_contact(sim: aftdeck.Simulation, inputs: Inputs, pairs: frozenset[Pair]) -> tuple[list[Frame], Pair | None]:
    """Return the frames up to a contact of one of `pairs`, and this pair.

    Without a contact, return the frames up to a docking or to `MAX_STEPS`, and None.
    """
    frames: list[Frame] = []
    for _ in range(MAX_STEPS):
        frames.append(sim.step(inputs))
        if frames[-1].work.cargo[0].seat:
            break
        for contact in frames[-1].work.contacts:
            if (contact.a, contact.b) in pairs:
                return frames, (contact.a, contact.b)
    return frames, None


def beside_the_port(seed: int) -> tuple[list[Frame], Pair | None]:
    """Return `until_contact` of a run towards the CAE, with the probe too far from the port's centre to dock."""
    rng = np.random.default_rng(seed)
    aside, angle = rng.uniform(1.3 * DOCKING, 1.6), rng.uniform(0.0, math.tau)
    x, y, z = AT_PORT
    # straight towards the port's face; the sideways motion is so small that the probe stays beside the port
    sticks = (float(rng.uniform(0.3, 1.0)), *(0.05 * rng.uniform(-1.0, 1.0, 2)).tolist())
    sim = aftdeck.Simulation(
        scenario((x + 1.5, y + aside * math.cos(angle), z + aside * math.sin(angle)), held=True),
    )
    return until_contact(sim, Inputs(sticks), frozenset((PROBE,)))


@each("seed", seeds(6, 40))
def test_clearance_warns_before_probe_touches_beside_port(seed: int) -> None:
    """Previously the log did not name the two parts before their contact."""
    frames, contact_pair = beside_the_port(seed)
    assert contact_pair == PROBE and not any(contact.essential for contact in frames[-1].work.contacts)
    levels = [frame.work.clearance_level for frame in frames[:-1] if pair(frame) == PROBE]
    assert levels[-1] == "warning" and pair(frames[-2]) == PROBE
    assert any(event.kind == "clearance" and "probe" in event.text for frame in frames for event in frame.events)


@each("seed", seeds(3, 20))
def test_probe_approaching_port_raises_no_alarm(seed: int) -> None:
    rng = np.random.default_rng(seed)
    aside, angle = rng.uniform(0.0, 0.8 * DOCKING), rng.uniform(0.0, math.tau)
    x, y, z = AT_PORT
    made = scenario((x + 1.5, y + aside * math.cos(angle), z + aside * math.sin(angle)), held=True)
    frames, contact_pair = until_contact(aftdeck.Simulation(made), Inputs((0.5, 0.0, 0.0)), frozenset((PROBE,)))
    assert contact_pair is None and frames[-1].work.cargo[0].seat == "port"
    assert PROBE not in {pair(frame) for frame in frames}


@pytest.mark.slow
@pytest.mark.parametrize("aside", [9.0, 12.0])
def test_clearance_warns_before_trunnions_touch_beside_guides(aside: float) -> None:
    """Previously the log did not name the two parts before their contact."""
    sim = aftdeck.Simulation(srms(26.0, aside, held=True))
    frames, contact_pair = until_contact(sim, Inputs((0.0, 0.0, 1.0)), GUIDES)
    assert contact_pair is not None
    guide_frames = [frame for frame in frames[:-1] if pair(frame) in GUIDES]
    assert guide_frames and guide_frames[-1].work.clearance_level == "warning"


def test_trunnions_above_guides_raise_no_alarm() -> None:
    frames, contact_pair = until_contact(aftdeck.Simulation(srms(4.0, held=True)), Inputs((0.0, 0.0, 1.0)), GUIDES)
    assert contact_pair is not None and all(contact.essential for contact in frames[-1].work.contacts)
    assert not GUIDES & {pair(frame) for frame in frames}


@pytest.mark.parametrize(("aside", "foreseen"), [(0.0, False), (1.0, True)])
def test_look_ahead_predicts_contact_only_beside_port(aside: float, foreseen: bool) -> None:
    x, y, z = AT_PORT
    sim = aftdeck.Simulation(scenario((x + 0.6, y + aside, z), held=True))
    for _ in range(40):
        sim.step(Inputs((0.2, 0.0, 0.0)))
    assert (sim.ahead(3.0).contact_s is not None) is foreseen

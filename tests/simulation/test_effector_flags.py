"""The end effector's flags agree with the grasp, at the start and during any run."""

from __future__ import annotations

import functools
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import aftdeck
from aftdeck.scenario.load import built_in, load_scenario, parse_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from tests.simulation import concept
from tests.simulation.flights import flown, random_inputs, srms

FIXED = '[payload]\nmass = 1000\nposition = ["0 m", "0 m", "1 m"]\n'
AT = (28.0, 0.0, -20.0)
"""Start position of the tip, above the bay [ft]."""
HELD = {"CAPTURE", "CLOSE"}
"""Flags that are lit on either end effector while it holds a payload. A rigidized Shuttle payload also lights RIGID."""


@functools.cache
def concept_with_a_fixed_payload() -> Scenario:
    text = load_scenario("concept-1972").text
    head, _, _ = text.partition("[initial]")
    return parse_scenario(f"{head}[initial]\njoints = {concept.joints(AT)}\n{FIXED}", "fixed", "fixed.toml", Path("."))


MADE: dict[str, Callable[[], Scenario]] = {
    "loaded": lambda: load_scenario("loaded"),
    "concept with [payload]": concept_with_a_fixed_payload,
    "concept, held": lambda: concept.scenario(held=True),
    "concept, over the bar": lambda: concept.scenario(concept.ON_BAR),
    "srms, held": lambda: srms(0.0, held=True),
    "srms, over the fixture": lambda: srms(0.0),
}


def agrees(frame: Frame) -> bool:
    """Return whether the flags are consistent with the payload in the grasp and with each other."""
    flags = set(frame.work.hand.flags)
    holds = frame.payload is not None
    apart = not {"CLOSE", "OPEN"} <= flags and not {"RIGID", "DERIGID"} <= flags
    return holds == ("CAPTURE" in flags) and apart and not (holds and "OPEN" in flags)


@pytest.mark.parametrize("name", built_in())
def test_flags_agree_with_grasp_at_every_start(name: str) -> None:
    frame = aftdeck.Simulation(name).step(aftdeck.Inputs())
    assert agrees(frame), frame.work.hand
    if frame.payload is not None:
        assert set(frame.work.hand.flags) >= HELD
        assert not {"EXTEND", "OPEN", "DERIGID"} & set(frame.work.hand.flags)


@pytest.mark.slow
@pytest.mark.parametrize("made", MADE.values(), ids=MADE)
def test_flags_agree_with_grasp_under_random_switches(made: Callable[[], Scenario]) -> None:
    rng = np.random.default_rng(16)
    frames = flown(made(), random_inputs(rng, 1200, 0.1, switches=0.4))
    assert [frame.work.hand for frame in frames if not agrees(frame)] == []


@pytest.mark.parametrize("name", ["loaded", "concept with [payload]"])
def test_payload_fixed_in_grasp_is_not_released(name: str) -> None:
    sim = aftdeck.Simulation(MADE[name]())
    first = sim.step(aftdeck.Inputs())
    for inputs in (
        aftdeck.Inputs(effector="open"),
        aftdeck.Inputs(effector="close"),
        aftdeck.Inputs(effector_mode="manual", rigid="derigid"),
    ):
        frame = sim.step(inputs)
        assert [event.kind for event in frame.events].count("refused") == 1
        for _ in range(100):
            frame = sim.step(aftdeck.Inputs(rigid="off"))
        assert frame.work.hand.flags == first.work.hand.flags and frame.payload == first.payload

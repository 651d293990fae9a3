"""Impacts and presses: their forces do not depend on the control period, and a steady press is steady."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
import pytest

import aftdeck
from aftdeck.report.catalogue import named
from aftdeck.report.recorded import ReadingMetrics
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.payloads.forces import ENDED_AFTER
from aftdeck.simulation.readings.reading import Known
from aftdeck.simulation.run import Simulation
from tests.plant.multibody.test_contacts import MASS, thrown
from tests.plant.multibody.test_payloads import BOTH, bodies_of

CHOSEN = [0.005, 0.02, 0.08]
"""Control periods [s]."""


class Impact(NamedTuple):
    """Impact of a body on the payload bay's floor: metrics, greatest depth [m], velocity afterwards, and log lines."""

    peak: float
    impulse: float
    depth: float
    rebound: float
    lines: list[str]


def impact(speed: float, period: float, lasts: float) -> Impact:
    """Throw a body onto the payload bay's floor, from 2.6 m above it."""
    sim = thrown([0.0, 0.0, -speed], [7.3, 0.0, 2.0], period)
    metrics, lines, deepest = ReadingMetrics(sim.scenario), [], 0.0
    for _ in range(round(lasts / period)):
        frame = sim.step(Inputs())
        metrics.see(Known(frame, sim.scenario))
        lines += [event.text for event in frame.events if event.kind == "contact"]
        if frame.work.nearest is not None:
            deepest = min(deepest, frame.work.nearest.clearance)
    found = {metric: value.number for metric, value in metrics.found()}
    peak, impulse = found[named("peak_contact_force_n")], found[named("contact_impulse_n_s")]
    assert peak is not None
    assert impulse is not None
    return Impact(peak, impulse, -deepest, -float(bodies_of(sim).motions[0, 5]), lines)


def test_impact_has_the_same_forces_at_every_control_period() -> None:
    impacts = [impact(1.0, period, 6.0) for period in CHOSEN]
    finest = impacts[0]
    assert finest.peak > 10_000.0
    assert finest.impulse == pytest.approx(MASS * (1.0 + finest.rebound), rel=0.01)
    for other in impacts[1:]:
        assert other.peak == pytest.approx(finest.peak, rel=0.02)
        assert other.impulse == pytest.approx(finest.impulse, rel=0.01)
        assert [line.split(":")[0].split(";")[0] for line in other.lines] == [
            line.split(":")[0].split(";")[0] for line in finest.lines
        ]


def test_fast_body_is_met_by_the_floor_at_long_control_periods() -> None:
    finest, longest = impact(2.0, 0.02, 2.4), impact(2.0, 0.2, 2.4)
    assert longest.depth < 1.05 * finest.depth
    assert longest.peak == pytest.approx(finest.peak, rel=0.02)
    assert longest.impulse == pytest.approx(finest.impulse, rel=0.01)


def pressed(plant: str, seconds: float) -> tuple[Simulation, list[Frame]]:
    """Press the Shuttle's end effector against the orbiter; return the run and the frames since they touch.

    Rates are then vernier, so that the arm rolls only slowly over its edges.
    """
    changes: dict[tuple[str | int, ...], object] = {
        ("plant",): plant,
        ("phase",): [],
        ("cargo",): [],
        ("step",): [],
        ("duration",): "300 s",
    }
    sim = Simulation(aftdeck.load_scenario("srms-deploy", changes))
    frame = sim.step(Inputs(mode="ORB UNL", translation=(0.0, 0.0, 1.0)))
    while frame.dynamics is None or not frame.dynamics.contacts:
        frame = sim.step(Inputs(mode="ORB UNL", translation=(0.0, 0.0, 1.0)))
    gently = Inputs(mode="ORB UNL", rate="vernier", translation=(0.0, 0.0, 1.0))
    return sim, [frame] + [sim.step(gently) for _ in range(round(seconds / 0.02))]


@pytest.mark.slow
@BOTH
def test_steady_press_is_steady_and_has_few_log_lines(plant: str) -> None:
    _, frames = pressed(plant, 60.0)
    lines = [event for frame in frames for event in frame.events if event.kind == "contact"]
    assert 1 <= len(lines) <= 4
    sums = []
    for frame in frames[500:]:
        assert frame.dynamics is not None
        sums.append(sum(math.hypot(*force.force) for force in frame.dynamics.contacts))
    forces = np.array(sums)
    assert forces.min() > 0.5 * forces.mean()
    assert forces.std() < 0.15 * forces.mean()


@pytest.mark.slow
def test_contact_ends_once_after_the_parts_have_been_apart() -> None:
    sim, frames = pressed("rigid", 5.0)
    up, apart, ends = Inputs(mode="ORB UNL", translation=(0.0, 0.0, -1.0)), 0, []
    assert any(event.kind == "contact" for frame in frames for event in frame.events)
    while bodies_of(sim).contacts:
        frame = sim.step(up)
        assert frame.dynamics is not None
        apart = 0 if frame.dynamics.contacts or frame.work.contacts else apart + 1
        ends += [(event.text, apart) for event in frame.events if event.kind == "contact" and "clear of" in event.text]
    assert ends
    for text, steps in ends:
        assert "greatest force" in text and "impulse" in text
        assert steps * 0.02 == pytest.approx(ENDED_AFTER, abs=0.05)


def test_force_of_a_contact_grows_by_its_impulse_and_keeps_its_greatest() -> None:
    sim, frames = pressed("rigid", 1.0)
    contacts = bodies_of(sim).contacts
    for group, contact in contacts.items():
        a, b = sim._flight.site.layout.named(group)
        own = [force for f in frames if f.dynamics for force in f.dynamics.contacts if (force.a, force.b) == (a, b)]
        assert contact.greatest == pytest.approx(max(force.peak for force in own))
        assert contact.impulse == pytest.approx(0.02 * sum(math.hypot(*force.force) for force in own))
    assert contacts

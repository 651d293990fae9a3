"""Benchmarks of headless runs, of one step, and of one frame for the page."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from itertools import islice
from typing import Literal

import msgspec

from aftdeck.scenario.load import built_in, load_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation, run
from aftdeck.simulation.summary import Tally
from aftdeck.station.conversion.frame_of import Displays
from benchmarks.measure import Figure, microseconds, percentile

STEPS = 2000
"""Number of steps from which the median is taken."""
PIECE, FLIGHTS = 50, 8
"""`PIECE`: number of steps that are timed together. `FLIGHTS`: number of runs."""


def headless() -> list[Figure]:
    """Measure ``sts-400-closed`` from its first step to its summary, after a warm-up run."""
    scenario = load_scenario("sts-400-closed")
    ticks = run(scenario).frames[-1].tick
    took = []
    for _ in range(5):
        start = time.perf_counter()
        run(scenario)
        took.append(time.perf_counter() - start)
    best = min(took)
    return [
        Figure("sts-400-closed headless", best, "s", 0.5, f"{ticks} steps, best of {len(took)}, warm"),
        Figure("sts-400-closed, one step", best / ticks * 1e6, "us", None, "with the digest and the summary"),
        Figure("simulated time per wall time", ticks * scenario.control_period / best, "1", None, "times real time"),
    ]


def worksites() -> list[Figure]:
    """Measure whole missions without a screen. The steps include steering, plant, all monitored pairs and phases."""
    figures = []
    for name, promised in (("concept-1972-script", 2.5), ("srms-berth", None), ("free-flyer", None)):
        scenario = load_scenario(name)
        (ticks, bare), (_, tallied), (_, framed) = (_flown(scenario, how) for how in (_bare, _tallied, _framed))
        flown, pairs = ticks * scenario.control_period, len(Simulation(scenario).watched())
        note = f"{flown:g} s simulated, {pairs} monitored pairs, {PIECE} steps at a time, best of {FLIGHTS}"
        figures += [
            Figure(f"{name}, one step", bare / ticks * 1e6, "us", 80.0, note),
            Figure(f"{name}, with digest", tallied / ticks * 1e6, "us", None, "one step, its digest and the summary"),
            Figure(
                f"{name}, with digest and frame",
                framed / ticks * 1e6,
                "us",
                None,
                "one step, its digest, the summary and its frame",
            ),
            Figure(f"{name}, 10 simulated minutes", tallied / flown * 600.0, "s", promised, "wall time, with digests"),
        ]
    return figures


How = Callable[[Simulation, Tally], None]
"""Function that runs one step."""


def _bare(sim: Simulation, tally: Tally) -> None:
    sim.advance()


def _tallied(sim: Simulation, tally: Tally) -> None:
    """Run one step as `run` does."""
    sim.advance()
    tally.take(sim._state, sim.seal())


def _framed(sim: Simulation, tally: Tally) -> None:
    sim.step()
    tally.take(sim._state, sim.seal())


def _flown(scenario: Scenario, how: How) -> tuple[int, float]:
    """Return the number of steps of a scenario's script and their time [s].

    Every run computes the same steps, and its pieces of `PIECE` steps are timed. The time of a piece is its shortest
    time in all runs, so that other work of the machine is excluded. The returned time is the sum over all pieces.
    """
    flights = [_pieces(scenario, how) for _ in range(FLIGHTS + 1)][1:]  # the first run warms up
    return flights[0][0], sum(min(took) for took in zip(*(took for _, took in flights), strict=True))


def _pieces(scenario: Scenario, how: How) -> tuple[int, list[float]]:
    """Return the number of steps of one run, and the time of each piece of the run [s]."""
    steps, took, ticks = _steps(scenario, how), [], 0
    while True:
        start = time.perf_counter()
        flown = sum(1 for _ in islice(steps, PIECE))
        took.append(time.perf_counter() - start)
        ticks += flown
        if flown < PIECE:
            return ticks, took


def _steps(scenario: Scenario, how: How) -> Iterator[None]:
    """Run a whole scenario, one step for each `next`."""
    sim, tally = Simulation(scenario), Tally()
    while not sim.ended:
        how(sim, tally)
        yield


def with_frame() -> list[Figure]:
    """Measure the median time of a step in each built-in scenario, without and with frames.

    In a scenario without a script, a stick is deflected.
    """
    figures = []
    for name in built_in():
        scenario = load_scenario(name)
        inputs = None if scenario.phases else Inputs(translation=(0.1, 0.0, 0.0))
        bare, framed = (min(_median(scenario, inputs, how) for _ in range(3)) for how in ("advance", "step"))
        figures += [
            Figure(f"{name}, advance", bare, "us", None, f"median of {STEPS} steps, best of 3 runs"),
            Figure(f"{name}, step", framed, "us", 100.0, "the same, with the frame"),
        ]
    return figures


def _median(scenario: Scenario, inputs: Inputs | None, how: Literal["advance", "step"]) -> float:
    """Return the median time of a step [us]."""
    sim = Simulation(scenario)
    took: list[float] = []
    step = sim.advance if how == "advance" else sim.step
    while len(took) < STEPS and not sim.ended:
        start = time.perf_counter()
        step(inputs)
        took.append(time.perf_counter() - start)
    return 1e6 * percentile(took, 50)


def frame() -> list[Figure]:
    """Measure one manual step and one frame for the page."""
    scenario = load_scenario("first-flight")
    sim, displays, encoder = Simulation(scenario), Displays(scenario), msgspec.json.Encoder()
    inputs = Inputs(translation=(0.01, 0.0, 0.0))
    seen = sim.step(inputs)
    text = encoder.encode(displays.frame(seen, 0))
    step = microseconds("step(inputs)", {"step": sim.step, "inputs": inputs})
    wire = microseconds("f(seen, 0)", {"f": displays.frame, "seen": seen})
    encoding = microseconds("encode(message)", {"encode": encoder.encode, "message": displays.frame(seen, 0)})
    return [
        Figure("a step of the simulation", step, "us", None, "ORB UNL, manual"),
        Figure("its frame for the page", wire, "us", None, "poses, panel numbers, lamps"),
        Figure("the frame's encoding", encoding, "us", None, "JSON"),
        Figure("the frame's size", len(text), "bytes", None, "JSON"),
        Figure("steps per second, with frames", 1e6 / (step + wire + encoding), "1/s", None, "on one core"),
    ]

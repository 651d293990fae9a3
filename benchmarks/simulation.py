"""The simulation without a screen, and what one step and one frame for the page cost."""

from __future__ import annotations

import time

import msgspec

from aftdeck.scenario.load import load_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation, run
from aftdeck.station.wire import Translator
from benchmarks.measure import Figure, microseconds


def headless() -> list[Figure]:
    """``sts-400-closed`` from its first step to its summary, after a run to warm up."""
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
        Figure("one step of it", best / ticks * 1e6, "us", None, "with the frame's hash and the summary"),
        Figure("simulated time per time", ticks * scenario.control_period / best, "1", None, "times real time"),
    ]


def worksites() -> list[Figure]:
    """Whole missions without a screen: steering, plant, every watched pair, phases."""
    figures = []
    for name, promised in (("concept-1972-script", 2.5), ("srms-berth", None), ("free-flyer", None)):
        scenario = load_scenario(name)
        flown = run(scenario, keep_frames=False).summary.time_s
        took = []
        for _ in range(3):
            start = time.perf_counter()
            run(scenario, keep_frames=False)
            took.append(time.perf_counter() - start)
        best = min(took)
        pairs = len(Simulation(scenario).watched())
        said = f"{flown:g} s flown, {pairs} watched pairs of parts, best of {len(took)}"
        figures += [
            Figure(f"{name}, computing for 10 minutes flown", best / flown * 600.0, "s", promised, said),
            Figure(f"{name}, a whole frame", best / flown * scenario.control_period * 1e6, "us", 80.0, "with its hash"),
            Figure(
                f"{name}, the same told", _told(scenario), "us", None, "with its Frame, as for a page or a recording"
            ),
        ]
    return figures


def _told(scenario: Scenario) -> float:
    """A step and its frame, over a whole run of a scenario [us]."""
    sim = Simulation(scenario)
    start = time.perf_counter()
    while not sim.ended:
        last = sim.step()
    return (time.perf_counter() - start) / last.tick * 1e6


def frame() -> list[Figure]:
    """One step by hand and one frame made for the page."""
    scenario = load_scenario("first-flight")
    sim, translator, encoder = Simulation(scenario), Translator(scenario, demo=False), msgspec.json.Encoder()
    inputs = Inputs(translation=(0.01, 0.0, 0.0))
    seen = sim.step(inputs)
    text = encoder.encode(translator.frame(seen, 0))
    step = microseconds("step(inputs)", {"step": sim.step, "inputs": inputs})
    wire = microseconds("f(seen, 0)", {"f": translator.frame, "seen": seen})
    encoding = microseconds("encode(message)", {"encode": encoder.encode, "message": translator.frame(seen, 0)})
    return [
        Figure("a step of the simulation", step, "us", None, "ORB UNL, by hand"),
        Figure("its frame for the page", wire, "us", None, "poses, panel numbers, lamps"),
        Figure("the frame's encoding", encoding, "us", None, "JSON"),
        Figure("the frame's size", len(text), "bytes", None, "JSON"),
        Figure("steps with frames per second", 1e6 / (step + wire + encoding), "1/s", None, "on one core"),
    ]

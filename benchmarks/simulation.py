"""Benchmarks of headless runs, of one step, and of one frame for the page."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from itertools import islice
from typing import Literal, NamedTuple

import msgspec

from aftdeck.scenario.load import built_in, load_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation, run
from aftdeck.simulation.summary import Tally
from aftdeck.station.conversion.frame_of import Displays
from benchmarks.measure import SHORT, Figure, Timing, against, microseconds, percentile
from benchmarks.plain import WORK, plain_python

PIECE = 50
"""Number of steps that are timed together."""
HEADLESS, BARE, FRAMED, MASSES = 4.5, 3.0, 5.0, 8.0
"""Promised times of a step with its digest, without, and with its frame, and with its frame on a plant with masses, as
shares of the time of `plain.plain_python`: plain Python and NumPy that do the kinds of work of a control step."""
PLAIN = "plain Python in turn"
"""Name of the plain Python that was timed in turn with a figure's steps."""


class Size(NamedTuple):
    """Extent of the measurement.

    Attributes:
        timing: extent of the timing of a call.
        runs: number of runs; the shortest counts.
        worksites: scenarios with a worksite.
        flights: number of runs of each worksite.
        scenarios: scenarios whose step is measured.
        steps: number of steps from which a median is taken.
    """

    timing: Timing
    runs: int
    worksites: tuple[str, ...]
    flights: int
    scenarios: tuple[str, ...]
    steps: int


FULL = Size(Timing(), 5, ("concept-1972-script", "srms-berth", "free-flyer"), 8, tuple(built_in()), 2000)
TINY = Size(SHORT, 1, ("concept-1972-script",), 1, ("first-flight",), 20)


def headless(size: Size) -> list[Figure]:
    """Measure ``sts-400-closed`` from its first step to its summary, after a warm-up run."""
    scenario = load_scenario("sts-400-closed")
    ticks = run(scenario).frames[-1].tick
    took, used, plains = [], [], []
    for _ in range(size.runs):
        plains.append(plain_python(200, time.process_time))
        start, begin = time.perf_counter(), time.process_time()
        run(scenario)
        used.append(time.process_time() - begin)
        took.append(time.perf_counter() - start)
    best, step = min(took), min(used) / ticks * 1e6
    plain = _plain(min(plains))
    note = "processor time, with the digest and the summary"
    return [
        Figure("sts-400-closed headless", best, "s", None, f"{ticks} steps, best of {len(took)}, warm"),
        plain,
        against(plain, HEADLESS, "sts-400-closed, one step", step, "us", note),
        Figure("simulated time per wall time", ticks * scenario.control_period / best, "1", None, "times real time"),
    ]


def worksites(size: Size) -> list[Figure]:
    """Measure whole missions without a screen. The steps include steering, plant, all monitored pairs and phases."""
    figures = []
    for name in size.worksites:
        scenario = load_scenario(name)
        bare, tallied, framed = (_flown(scenario, how, size.flights) for how in (_bare, _tallied, _framed))
        ticks = bare.ticks
        flown, pairs = ticks * scenario.control_period, len(Simulation(scenario).watched())
        note = f"{flown:g} s simulated, {pairs} monitored pairs, {PIECE} steps at a time, best of {size.flights}"
        step, digested, whole = (1e6 * one.seconds / ticks for one in (bare, tallied, framed))
        sums = "one step, its digest and the summary"
        wall = tallied.seconds / flown * 600.0
        figures += [
            against(_plain(bare.plain), BARE, f"{name}, one step", step, "us", note),
            Figure(f"{name}, with digest", digested, "us", None, sums),
            against(
                _plain(framed.plain), FRAMED, f"{name}, with digest and frame", whole, "us", f"{sums}, and its frame"
            ),
            Figure(f"{name}, 10 simulated minutes", wall, "s", None, "wall time, with digests"),
        ]
    return [_plain(bare.plain), *figures]


def _plain(seconds: float) -> Figure:
    return Figure(PLAIN, 1e6 * seconds, "us", None, WORK)


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


class Flown(NamedTuple):
    """Run of a scenario's script.

    Attributes:
        ticks: number of steps.
        seconds: their time [s].
        plain: mean time of plain Python, called after each piece [s].
    """

    ticks: int
    seconds: float
    plain: float


def _flown(scenario: Scenario, how: How, runs: int) -> Flown:
    """Run a scenario's script several times.

    Every run computes the same steps, and its pieces of `PIECE` steps are timed. The time of a piece is its shortest
    time in all runs, so that other work of the machine is excluded. The returned time is the sum over all pieces. Plain
    Python is timed in the same way.
    """
    flights = [_pieces(scenario, how) for _ in range(runs + 1)][1:]  # the first run warms up
    pieces, plains = ([min(one) for one in zip(*(flight[k] for flight in flights), strict=True)] for k in (1, 2))
    return Flown(flights[0][0], sum(pieces), sum(plains) / len(plains))


def _pieces(scenario: Scenario, how: How) -> tuple[int, list[float], list[float]]:
    """Return the number of steps of one run; the time of each piece of the run, and of plain Python after it [s]."""
    steps, ticks = _steps(scenario, how), 0
    took: list[float] = []
    plains: list[float] = []
    while True:
        start = time.perf_counter()
        flown = sum(1 for _ in islice(steps, PIECE))
        took.append(time.perf_counter() - start)
        plains.append(plain_python())
        ticks += flown
        if flown < PIECE:
            return ticks, took, plains


def _steps(scenario: Scenario, how: How) -> Iterator[None]:
    """Run a whole scenario, one step for each `next`."""
    sim, tally = Simulation(scenario), Tally()
    while not sim.ended:
        how(sim, tally)
        yield


def with_frame(size: Size) -> list[Figure]:
    """Measure the median time of a step in each built-in scenario, without and with frames.

    In a scenario without a script, a stick is deflected.
    """
    figures = []
    for name in size.scenarios:
        scenario = load_scenario(name)
        inputs = None if scenario.phases else Inputs(translation=(0.1, 0.0, 0.0))
        (bare, _), (framed, plain) = (
            min(_medians(scenario, inputs, how, size.steps) for _ in range(3)) for how in ("advance", "step")
        )
        share = FRAMED if scenario.plant == "kinematic" else MASSES
        figures += [
            Figure(f"{name}, advance", 1e6 * bare, "us", None, f"median of {size.steps} steps, best of 3 runs"),
            against(_plain(plain), share, f"{name}, step", 1e6 * framed, "us", "the same, with the frame"),
        ]
    return [_plain(plain), *figures]


def _medians(
    scenario: Scenario, inputs: Inputs | None, how: Literal["advance", "step"], steps: int
) -> tuple[float, float]:
    """Return the median times of a step, and of plain Python in turn with pieces of `PIECE` steps [s]."""
    sim = Simulation(scenario)
    took: list[float] = []
    plains: list[float] = []
    step = sim.advance if how == "advance" else sim.step
    while len(took) < steps and not sim.ended:
        start = time.perf_counter()
        step(inputs)
        took.append(time.perf_counter() - start)
        if len(took) % PIECE == 1:
            plains.append(plain_python())
    return percentile(took, 50), percentile(plains, 50)


def frame(size: Size) -> list[Figure]:
    """Measure one manual step and one frame for the page."""
    scenario = load_scenario("first-flight")
    sim, displays, encoder = Simulation(scenario), Displays(scenario), msgspec.json.Encoder()
    inputs = Inputs(translation=(0.01, 0.0, 0.0))
    seen = sim.step(inputs)
    text = encoder.encode(displays.frame(seen, 0))
    step = microseconds("step(inputs)", {"step": sim.step, "inputs": inputs}, size.timing)
    wire = microseconds("f(seen, 0)", {"f": displays.frame, "seen": seen}, size.timing)
    encoding = microseconds(
        "encode(message)", {"encode": encoder.encode, "message": displays.frame(seen, 0)}, size.timing
    )
    return [
        Figure("a step of the simulation", step, "us", None, "ORB UNL, manual"),
        Figure("its frame for the page", wire, "us", None, "poses, panel numbers, lamps"),
        Figure("the frame's encoding", encoding, "us", None, "JSON"),
        Figure("the frame's size", len(text), "bytes", None, "JSON"),
        Figure("steps per second, with frames", 1e6 / (step + wire + encoding), "1/s", None, "on one core"),
    ]

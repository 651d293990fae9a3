"""Flights recorded once and flown again after the code has changed: every recorded value is compared.

``python -m tests.same_flights FOLDER`` records every flight that FOLDER does not have, and flies the others again. For
changes of structure that are to change nothing: record with the code as it was, compare with the code as it is.
"""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np

from aftdeck.recording.bundle import scenario_of
from aftdeck.recording.compare import first_difference
from aftdeck.recording.convert import inputs_of
from aftdeck.recording.reader import Recording
from aftdeck.recording.run import record
from aftdeck.scenario.load import built_in, load_scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from tests.simulation.flights import anything

STICKS, STEPS = 4, 3000
"""How many flights of random sticks are made in each worksite, and of how many steps."""
WORKSITES = ("first-flight", "srms-deploy", "srms-berth", "concept-1972", "concept-1972-script", "free-flyer")
"""Scenarios that are flown by random sticks: two dozen flights, a dozen for each arm."""


def flights() -> Iterator[tuple[str, str, int]]:
    """Yield the name of each flight, its scenario, and the seed of its sticks; -1: the script flies."""
    for name in built_in():
        if load_scenario(name).phases:
            yield name, name, -1
    for name in WORKSITES:
        for seed in range(STICKS):
            yield f"{name}-sticks-{seed}", name, seed


def operator(seed: int) -> Callable[[Simulation], Inputs | None] | None:
    """Return who flies: the script, or random sticks and switches."""
    if seed < 0:
        return None
    given = anything(np.random.default_rng(seed), STEPS)
    return lambda _: next(given, None)


def compare(path: Path) -> str:
    """Fly a recording's inputs again; return what differs, in words: in how many frames which field, and the first."""
    recording = Recording(path)
    sim = Simulation(scenario_of(recording.opening), recording.opening.seed)
    fields, first, count = Counter[str](), "", 0
    for flown, before in recording.steps():
        sim.advance(inputs_of(flown))
        count += 1
        found = first_difference(before, recording.as_recorded(sim.look()))
        fields.update(change.field for change in found.fields)
        if not first and (found.fields or before.events != recording.as_recorded(sim.look()).events):
            first = (
                "; ".join(f"{change.field} {change.before} -> {change.after}" for change in found.fields) or "events"
            )
            first = f"first at {found.time_s:g} s: {first}"
    told = ", ".join(f"{name} in {frames}" for name, frames in fields.most_common())
    return f"equal, {count} frames" if not first else f"DIFFERS, {count} frames: {told}\n    {first[:600]}"


def main(folder: Path) -> int:
    """Record or compare every flight; return how many differ."""
    different = 0
    for name, scenario, seed in flights():
        path = folder / f"{name}.mcap"
        if not path.exists():
            record(scenario, path, inputs=operator(seed))
            print(f"{name}: recorded", flush=True)
            continue
        verdict = compare(path)
        different += verdict.startswith("DIFFERS")
        print(f"{name}: {verdict}", flush=True)
    return different


if __name__ == "__main__":
    sys.exit(min(main(Path(sys.argv[1])), 1))

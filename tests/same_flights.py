"""Comparison of runs before and after a change of the code: every recorded value is compared.

``python -m tests.same_flights FOLDER`` records every run that is not in FOLDER, and re-simulates the others. Use it for
changes that should not change behaviour: record with the code before the change, and compare with the code after it.
"""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np

from aftdeck.recording.bundle import scenario_of
from aftdeck.recording.compare import first_difference
from aftdeck.recording.convert import as_recorded, inputs_of
from aftdeck.recording.reader import Recording
from aftdeck.recording.run import record
from aftdeck.scenario.load import built_in, load_scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from tests.simulation.flights import random_inputs

STICKS, STEPS = 4, 3000
"""Number of runs with random sticks for each scenario, and number of steps of each run."""
WORKSITES = ("first-flight", "srms-deploy", "srms-berth", "concept-1972", "concept-1972-script", "free-flyer")
"""Scenarios for runs with random sticks: 24 runs, 12 for each arm."""


def flights() -> Iterator[tuple[str, str, int]]:
    """Yield the name of each run, its scenario, and the seed of its sticks; seed -1 means the script."""
    for name in built_in():
        if load_scenario(name).phases:
            yield name, name, -1
    for name in WORKSITES:
        for seed in range(STICKS):
            yield f"{name}-sticks-{seed}", name, seed


def operator(seed: int) -> Callable[[Simulation], Inputs | None] | None:
    """Return the source of the inputs: None for the script, otherwise random sticks and switches."""
    if seed < 0:
        return None
    given = random_inputs(np.random.default_rng(seed), STEPS)
    return lambda _: next(given, None)


def compare(path: Path) -> str:
    """Re-simulate a recording; return the differing fields, each with its frame count, and the first difference."""
    recording = Recording(path)
    sim = Simulation(scenario_of(recording.opening), recording.opening.seed)
    fields, first, count = Counter[str](), "", 0
    for flown, before in recording.steps():
        sim.advance(inputs_of(flown))
        count += 1
        found = first_difference(before, as_recorded(sim.look()))
        fields.update(change.field for change in found.fields)
        if not first and (found.fields or before.events != as_recorded(sim.look()).events):
            first = (
                "; ".join(f"{change.field} {change.before} -> {change.after}" for change in found.fields) or "events"
            )
            first = f"first at {found.time_s:g} s: {first}"
    summary = ", ".join(f"{name} in {frames}" for name, frames in fields.most_common())
    return f"equal, {count} frames" if not first else f"DIFFERS, {count} frames: {summary}\n    {first[:600]}"


def main(folder: Path) -> int:
    """Record or compare every run; return the number of runs that differ."""
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

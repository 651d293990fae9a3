"""Program that adds one reading to the table, and prints where a run shows it.

The entry has to be there before the catalogue of metrics is made: ``python -m tests.simulation.new_reading``.
"""

from __future__ import annotations

import json
from pkgutil import resolve_name

from aftdeck.simulation.readings import motion
from aftdeck.simulation.readings.reading import Reading, Recorded, Strip

STEPS = 5
HEIGHT = Reading(
    "tip_height",
    "height of the tip above L's origin",
    lambda s: -s.frame.position[2],
    quantity="length",
    strip=Strip(),
    metrics=(Recorded("greatest", "peak_height", "Greatest height of the tip"),),
    group="tip",
    state="height",
)


def main() -> None:
    """Print the names and values of the reading in a run of some steps, as JSON."""
    vars(motion)["MOTION"] = (*motion.MOTION, HEIGHT)
    scenario = resolve_name("aftdeck.scenario.load:load_scenario")("first-flight")
    sim = resolve_name("aftdeck.simulation.run:Simulation")(scenario)
    strips = resolve_name("aftdeck.report.strips:Strips")(scenario, scenario.control_period)
    metrics = resolve_name("aftdeck.report.run_metrics:RunMetrics")(scenario)
    series = resolve_name("aftdeck.simulation.series.series:Series")(scenario, ["tip"])
    reader = resolve_name("aftdeck.export.state:StateReader")(scenario)
    heights = []
    for _ in range(STEPS):
        frame = sim.step(resolve_name("aftdeck.simulation.inputs:Inputs")(translation=(0.0, 0.0, -1.0)))
        heights.append(-frame.position[2])
        strips.add(frame, None)
        metrics.see(frame, ())
        series.see(frame, None)
    table, state = series.table(), dict(zip(reader.names, reader.of(frame, None).tolist(), strict=True))
    listed = [metric.column for metric in resolve_name("aftdeck.report.catalogue:SUBJECTS")["Path"]]
    shown = {
        "heights": heights,
        "strip": [strip.curves[0].values for strip in strips.strips() if strip.name == "Tip height"],
        "metric": {metric.column: value.number for metric, value in metrics.found().items() if metric.column in listed},
        "column": table["tip_height_m"].tolist(),
        "about": next(column.definition for column in table.columns if column.name == "tip_height_m"),
        "state": state["height"],
    }
    print(json.dumps(shown))


if __name__ == "__main__":
    main()

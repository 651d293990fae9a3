"""Names of the benchmarks and of the tables of physics, by which the command line knows them.

The function of a benchmark takes a value of its module's type `Size`, and returns figures. A module has two such
values: `FULL`, with which it measures, and `TINY`, with which each benchmark ends in seconds and only shows that it
works. The function of a table yields the lines of the table.
"""

from __future__ import annotations

from typing import NamedTuple


class Benchmark(NamedTuple):
    """Function that measures.

    Attributes:
        subject: heading under which the figures are listed.
        module: module of the function, and of `FULL` and `TINY`.
        function: name of the function.
        by_default: True if it is run when no name is given. The others take long, measure physics instead of time, or
            wait for a quiet machine to be listed in docs/figures.md.
        limit_s: time after which it is ended [s].
    """

    subject: str
    module: str
    function: str
    by_default: bool = True
    limit_s: float = 900.0


LAWS, SIMULATION, STATION = "Compiled laws", "Simulation", "Station"
RECORDINGS, STUDIES, PHYSICS = "Recordings, reports and pictures", "Studies and learning", "Physics"
DAY = 86_400.0

NAMES = {
    "rate-law": Benchmark(LAWS, "benchmarks.laws", "rate_law"),
    "steering": Benchmark(LAWS, "benchmarks.laws", "steering"),
    "inverse": Benchmark(LAWS, "benchmarks.laws", "inverse"),
    "calls": Benchmark(LAWS, "benchmarks.laws", "calls"),
    "batch": Benchmark(LAWS, "benchmarks.batch", "arm_steps"),
    "collision": Benchmark(LAWS, "benchmarks.collision", "hexahedra"),
    "headless": Benchmark(SIMULATION, "benchmarks.simulation", "headless"),
    "worksites": Benchmark(SIMULATION, "benchmarks.simulation", "worksites"),
    "frame": Benchmark(SIMULATION, "benchmarks.simulation", "frame"),
    "with-frame": Benchmark(SIMULATION, "benchmarks.simulation", "with_frame"),
    "dynamics": Benchmark(SIMULATION, "benchmarks.dynamics", "dynamics"),
    "help": Benchmark(STATION, "benchmarks.station", "help_page"),
    "first-use": Benchmark(STATION, "benchmarks.station", "first_use"),
    "start": Benchmark(STATION, "benchmarks.station", "start"),
    "newcomer": Benchmark(STATION, "benchmarks.newcomer", "newcomer", by_default=False, limit_s=1500.0),
    "latency": Benchmark(STATION, "benchmarks.station", "latency"),
    "session": Benchmark(STATION, "benchmarks.session", "session", by_default=False),
    "loaded": Benchmark(STATION, "benchmarks.loaded", "loaded"),
    "attacked": Benchmark(STATION, "benchmarks.attacked", "attacked", by_default=False),
    "console": Benchmark(STATION, "benchmarks.console", "console", by_default=False),
    "page": Benchmark(STATION, "benchmarks.page", "page"),
    "soak": Benchmark(STATION, "benchmarks.loaded", "soak", by_default=False, limit_s=DAY),
    "recording": Benchmark(RECORDINGS, "benchmarks.recording", "recording"),
    "report": Benchmark(RECORDINGS, "benchmarks.report", "report"),
    "pictures": Benchmark(RECORDINGS, "benchmarks.pictures", "pictures"),
    "reach": Benchmark(STUDIES, "benchmarks.environments", "reach"),
    "missions": Benchmark(STUDIES, "benchmarks.missions", "missions", by_default=False, limit_s=1500.0),
    "studies": Benchmark(STUDIES, "benchmarks.studies", "studies"),
    "ray": Benchmark(STUDIES, "benchmarks.studies", "on_ray"),
    "plants": Benchmark(PHYSICS, "benchmarks.plants", "table", by_default=False, limit_s=DAY),
    "ring-down": Benchmark(PHYSICS, "benchmarks.ring_down", "table", by_default=False, limit_s=DAY),
    "jets": Benchmark(PHYSICS, "benchmarks.jets", "table", by_default=False, limit_s=DAY),
    "linear-models": Benchmark(PHYSICS, "benchmarks.linear_models", "table", by_default=False, limit_s=DAY),
    "stops": Benchmark(PHYSICS, "benchmarks.stops", "table", by_default=False, limit_s=DAY),
    "strict": Benchmark(PHYSICS, "benchmarks.strict", "table", by_default=False, limit_s=DAY),
    "spread": Benchmark(PHYSICS, "benchmarks.spread", "table", by_default=False, limit_s=DAY),
    "flight-tests": Benchmark(PHYSICS, "benchmarks.flight_tests", "table", by_default=False, limit_s=DAY),
}
"""Benchmarks in the order in which they are run."""

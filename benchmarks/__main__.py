"""``python -m benchmarks [--json] [NAME...]``: measure and print. The exit code is 1 if a target is missed."""

from __future__ import annotations

import argparse
import json
import os
import platform
import sys
from importlib import import_module
from pathlib import Path
from typing import cast

import msgspec

from benchmarks.measure import Benchmark, Figure

NAMES = {
    "rate-law": "laws.rate_law",
    "steering": "laws.steering",
    "inverse": "laws.inverse",
    "calls": "laws.calls",
    "batch": "batch.arm_steps",
    "collision": "collision.hexahedra",
    "headless": "simulation.headless",
    "worksites": "simulation.worksites",
    "frame": "simulation.frame",
    "with-frame": "simulation.with_frame",
    "help": "station.help_page",
    "first-use": "station.first_use",
    "start": "station.start",
    "latency": "station.latency",
    "loaded": "loaded.loaded",
    "page": "page.page",
    "recording": "recording.recording",
    "dynamics": "dynamics.dynamics",
    "pictures": "pictures.pictures",
    "reach": "environments.reach",
    "studies": "studies.studies",
    "ray": "studies.on_ray",
    "report": "report.report",
}
"""Module and function of each benchmark."""


def machine() -> dict[str, str | int]:
    """Return a description of this machine."""
    return {
        "processor": _processor(),
        "cores": os.cpu_count() or 1,
        "system": platform.platform(),
        "python": platform.python_version(),
    }


def _processor() -> str:
    info = Path("/proc/cpuinfo")
    lines = info.read_text(encoding="utf-8").splitlines() if info.is_file() else []
    found = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return found[0] if found else platform.processor() or platform.machine()


def measure(name: str) -> list[Figure]:
    """Run one benchmark and return its figures. The libraries of the benchmark are imported only here."""
    os.environ.setdefault("MUJOCO_GL", "egl")  # MuJoCo reads it when it is imported: draw without a display
    module, _, function = NAMES[name].partition(".")
    return cast("Benchmark", getattr(import_module(f"benchmarks.{module}"), function))()


def main() -> int:
    """Run the benchmarks that the arguments name, or all benchmarks."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks", description=__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"one of {', '.join(NAMES)}; default: all")
    parser.add_argument("--json", action="store_true", help="print JSON, for scripts")
    given = parser.parse_args()
    if unknown := [name for name in given.names if name not in NAMES]:
        parser.error(f"unknown benchmark {unknown[0]!r}; available: {', '.join(NAMES)}")
    here = machine()
    if not given.json:
        print(", ".join(str(value) for value in here.values()))
    figures: list[Figure] = []
    for name in given.names or NAMES:
        measured = measure(name)
        figures += measured
        if not given.json:
            for figure in measured:
                print(_line(figure), flush=True)
    if given.json:
        rows = [{**msgspec.to_builtins(figure), "kept": figure.kept} for figure in figures]
        print(json.dumps({"machine": here, "figures": rows}, indent=2))
    return 0 if all(figure.kept for figure in figures) else 1


def _line(figure: Figure) -> str:
    promise = "" if figure.target is None else f"{'<=' if figure.kept else 'MISSED'} {figure.target:g}"
    return f"{figure.name:<30}{figure.value:>10.4g} {figure.unit:<6}{promise:<11}{figure.note}".rstrip()


if __name__ == "__main__":
    sys.exit(main())

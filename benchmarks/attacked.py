"""Benchmark of the station under allowed requests: ``python -m benchmarks.attacked --help``."""

from __future__ import annotations

import argparse
import contextlib
import itertools
import random
import re
import tempfile
import time
from collections.abc import Iterator
from typing import NamedTuple

from benchmarks.load import Wire, text
from benchmarks.loaded import P99_MS, delays, flying, loading, operator
from benchmarks.measure import Figure, percentile
from benchmarks.table import line

ATTACKS = {
    "sheets": "one client asks for one sheet of planes after another",
    "polygons": "an observer asks for other pictures of 1972, 400 times a second",
    "slow": "40 pages read 2 KiB/s",
}
"""Kinds of load of `load.py`, with their notes."""


class Size(NamedTuple):
    """Extent of the measurement.

    Attributes:
        seconds: time of each measurement [s].
    """

    seconds: float = 20.0


FULL, TINY = Size(), Size(seconds=1.0)
_STICK_SEQ = re.compile(rb'"stick_seq":(\d+)')


def attacked(size: Size) -> list[Figure]:
    """Measure the time from a stick to its frame under each kind of load, and without load before and after."""
    figures = []
    with tempfile.TemporaryDirectory() as folder:
        with flying(folder) as (address, _), operator(address) as page:
            sticks = itertools.count()
            for name, note in {"no load, before": "", **ATTACKS, "no load, after": ""}.items():
                with loading(name, address) if name in ATTACKS else contextlib.nullcontext():
                    took = latencies(page, sticks, size.seconds)
                target = P99_MS if name in ATTACKS else None
                figures += [
                    Figure(f"stick to frame, {name}, p99", percentile(took, 99), "ms", target, note),
                    Figure(f"stick to frame, {name}, worst", max(took), "ms", None, note),
                ]
        figures += delays(folder)
    return figures


def latencies(page: Wire, sticks: Iterator[int], seconds: float) -> list[float]:
    """Return the times from the sending of a stick to the arrival of the first frame that used it [ms].

    Args:
        page: connection of the operator's page.
        sticks: numbers of the messages.
        seconds: time for which to measure [s].
    """
    took, pause, end = [], random.Random(1), time.perf_counter() + seconds
    while time.perf_counter() < end:
        time.sleep(pause.uniform(0.0, 0.02))  # messages arrive at random times within a control period
        seq, sent = next(sticks), time.perf_counter()
        page.socket.sendall(
            text(
                {
                    "type": "sticks",
                    "translation": [0.01 * (seq % 2), 0, 0],
                    "rotation": [0, 0, 0],
                    "drive": 0,
                    "seq": seq,
                }
            )
        )
        while not any(int(found[1]) >= seq for message in page.messages() if (found := _STICK_SEQ.search(message))):
            pass
        took.append(1e3 * (time.perf_counter() - sent))
    return took


def main() -> None:
    """Run the benchmark, and print the figures."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.attacked", description=__doc__)
    parser.add_argument("--seconds", type=float, default=FULL.seconds, help="time to measure each load")
    for figure in attacked(FULL._replace(seconds=parser.parse_args().seconds)):
        print(line(figure))


if __name__ == "__main__":
    main()

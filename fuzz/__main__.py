"""``python -m fuzz [--minutes M] [--first N] [--seed N] [NAME...]``: run attacks, and print each seed that fails.

Without ``--minutes``, each attack runs with its number of seeds (`fuzz.attacks`); with it, all run in turns until the
time is up. The first seed is random and printed. ``--seed N`` repeats one seed and shows the whole traceback.
"""

from __future__ import annotations

import argparse
import collections
import secrets
import sys
import time
import traceback

from fuzz.attacks import ATTACKS
from fuzz.bounded import outcome

TURN_S = 10.0
"""Time of one attack before the next attack has its turn [s]."""


def main() -> int:
    """Run the attacks that the arguments name; return 1 if one of them failed."""
    parser = argparse.ArgumentParser(prog="python -m fuzz", description=__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"one of {', '.join(ATTACKS)}; default: all")
    parser.add_argument("--minutes", type=float, help="run for this time instead of the usual number of seeds")
    parser.add_argument("--first", type=int, default=secrets.randbelow(10**9), help="first seed; default: random")
    parser.add_argument("--seed", type=int, help="run this seed only")
    given = parser.parse_args()
    if unknown := [name for name in given.names if name not in ATTACKS]:
        parser.error(f"unknown attack {unknown[0]!r}; available: {', '.join(ATTACKS)}")
    names = given.names or list(ATTACKS)
    if given.seed is not None:
        for name in names:
            print(f"{name} --seed {given.seed}: {outcome(ATTACKS[name], given.seed)}")
        return 0
    return run(names, given.first, given.minutes)


def run(names: list[str], first: int, minutes: float | None) -> int:
    """Run attacks in turns; return 1 if one of them failed.

    Args:
        names: names of the attacks.
        first: first seed of each attack.
        minutes: time after which to stop; None to stop after each attack's number of seeds.
    """
    print(f"first seed {first}", flush=True)
    began = time.monotonic()
    done = dict.fromkeys(names, 0)
    outcomes: collections.Counter[str] = collections.Counter()
    failed = 0

    def left(name: str) -> bool:
        if minutes is None:
            return done[name] < ATTACKS[name].seeds
        return time.monotonic() - began < 60.0 * minutes

    while any(left(name) for name in names):
        for name in names:
            turn = time.monotonic()
            while left(name) and time.monotonic() - turn < TURN_S:
                seed = first + done[name]
                done[name] += 1
                try:
                    outcomes[f"{name}: {outcome(ATTACKS[name], seed)}"] += 1
                except Exception:
                    failed += 1
                    print(f"FAILED: python -m fuzz {name} --seed {seed}\n{traceback.format_exc()}", flush=True)
    for name, number in sorted(outcomes.items()):
        print(f"{number:8d}  {name}")
    print(f"{sum(done.values())} seeds in {time.monotonic() - began:.0f} s, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())

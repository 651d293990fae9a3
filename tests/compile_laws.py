"""``python -m tests.compile_laws``: compile the laws once, before the processes of the tests need them.

Without it, every process of the tests would compile the same laws at the same time. Two processes compile: one the laws
of the simulation, the other those of pictures and of batches of arms. The machine code is stored in the cache on disk
(`aftdeck/law.py`); a law that only a test calls is compiled by that test.
"""

from __future__ import annotations

import hashlib
import subprocess
import sys
import time
from collections.abc import Callable

import numpy as np

import aftdeck
from aftdeck.law_folder import cache_folder, state_of_the_laws
from aftdeck.steering.batch import steer_batch
from tests import loaded

SCENARIOS = ("srms-deploy", "srms-berth", "loaded", "concept-1972-script", "free-flyer")
"""Scenarios that use all laws of a simulation together: both arms, all kinds of capture and berth."""
PLANTS = ("rigid", "flexible")


def simulation() -> None:
    """Compile the laws of runs, with and without masses, and those of environments that fly them."""
    import gymnasium  # noqa: PLC0415

    from aftdeck.simulation.warm import warm_up  # noqa: PLC0415  (imports only what this process compiles)

    for name in SCENARIOS:
        warm_up(loaded.scenario(name))
    for plant in PLANTS:
        warm_up(aftdeck.load_scenario("srms-deploy", {("plant",): plant}))
    for name in ("Reach", "Capture"):
        batch = gymnasium.make_vec(f"aftdeck.gym:aftdeck/{name}-v0", num_envs=64)
        batch.reset(seed=1)
        batch.step(batch.action_space.sample())


def pictures_and_batches() -> None:
    """Compile the laws of pictures, of the single environment Reach, and of batches of arms."""
    import gymnasium  # noqa: PLC0415

    from aftdeck.visual.warm import warm_up  # noqa: PLC0415

    warm_up()
    environment = gymnasium.make("aftdeck.gym:aftdeck/Reach-v0")
    environment.reset(seed=1)
    environment.step(environment.action_space.sample())
    arm = loaded.arm()
    steer_batch(arm, np.zeros((2, 6)), arm.forward(np.zeros(6)), period=0.02, gain=1.0)


PARTS: dict[str, Callable[[], None]] = {"simulation": simulation, "pictures": pictures_and_batches}


def main() -> int:
    """Compile both parts, unless this version of the laws was compiled before, for this Python."""
    folder = cache_folder()
    here = hashlib.sha256(sys.version.encode()).hexdigest()[:16]
    if folder is None or (done := folder / f"complete-{here}-{state_of_the_laws()}").exists():
        return 0
    print("Compiling the laws that this version has changed (some minutes)", flush=True)
    begun = time.monotonic()
    processes = [subprocess.Popen([sys.executable, "-m", "tests.compile_laws", name]) for name in PARTS]
    if failed := [process.args for process in processes if process.wait()]:
        print(f"not compiled: {failed}", file=sys.stderr)
        return 1
    done.touch()
    print(f"The laws are compiled: {time.monotonic() - begun:.0f} s", flush=True)
    return 0


if __name__ == "__main__":
    if sys.argv[1:]:
        PARTS[sys.argv[1]]()
    else:
        sys.exit(main())

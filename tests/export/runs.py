"""Recorded runs for the tests of the export."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import chain, repeat
from pathlib import Path

from aftdeck.simulation.camera_drives import CameraDrive
from aftdeck.simulation.inputs import Inputs
from tests.recording.flown import bay, record_steps

STEPS = 33
"""Control steps of `by_hand`: at 10 samples a second, 6 whole samples and one of 3 steps."""


def busy() -> Iterator[Inputs]:
    """Yield inputs of a person: sticks that float32 cannot hold, switches and buttons in single steps."""
    yield Inputs(mode="ORB UNL", rate="vernier")
    yield Inputs(camera=CameraDrive("WR", 0.1, -1.0 / 3.0, slow=True), position_hold=True)
    for k in range(STEPS):
        sticks = (math.sin(0.1 * k), 0.1, -1.0 / 3.0)
        yield Inputs(
            translation=sticks,
            rotation=(0.0, 0.7 * math.cos(k), 0.0),
            rate="coarse" if k == 7 else None,
            rate_hold=k in (11, 13),
            brakes={20: True, 23: False}.get(k),
            mode="END EFF" if k == 25 else None,
        )


def by_hand(path: Path) -> Path:
    """Record a run by hand of `STEPS` control steps of 0.02 s."""
    record_steps(path, bay(), busy(), STEPS)
    return path


def by_script_then_hand(path: Path) -> Path:
    """Record a run that a person takes over from the script."""
    made = bay('[[phase]]\nmode = "ORB UNL"\nduration = 30\ntranslation = [0.5, 0, 0]\n', "script")
    record_steps(path, made, chain(repeat(None, 12), busy()), STEPS)
    return path

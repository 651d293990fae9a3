"""A run in the words of the report's own program: what it read from the operator, and sent to its scene generator.

Remote Manipulator Simulation, TABLES I and II. For the concept arm; each step gives the thirteen input channels and the
frame block of 32 words.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Final, Literal, TextIO, cast

from aftdeck.arms.model import HeadingArmFile
from aftdeck.errors import InputError
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.run import Simulation
from aftdeck.worksite.channels import OperatorInputs, encode_inputs
from aftdeck.worksite.report import Near
from aftdeck.worksite.words import ControlWord, FrameBlock, WordPlane, encode_block

STATION: Final = "A"
"""Which camera the words name: a run without a screen looks through the first (assumed)."""
FINGERS = ("palm", "fixed finger", "prong")
"""HEX 1 to 3, whose separating planes from the bar are D1 to D3."""
SAME = 1e-9
"""A stand or a prong that moves less in a step stands still [m]."""


def words_of(before: Frame | None, frame: Frame, planes: tuple[Near | None, ...]) -> tuple[int, ...]:
    """The 32 words of a frame.

    Args:
        before: the frame before; None at the first.
        frame: this one.
        planes: palm, fixed finger and prong against the bar; None where a pair is not watched.
    """
    return encode_block(FrameBlock(_control(before, frame), frame.angles, cast("_Planes", tuple(map(_plane, planes)))))


def channels_of(before: Frame | None, frame: Frame) -> tuple[float, ...]:
    """The thirteen input channels that would have commanded a frame [V], with the master arm where the arm is."""
    control = _control(before, frame)
    return encode_inputs(
        OperatorInputs(
            initialise=False,
            start="full problem",
            angles=frame.work.master or frame.angles,
            telescope=control.telescope,
            camera="none",
            zoom=0,
            station=STATION,
            prong=control.prong,
        )
    )


def check_words(scenario: Scenario, path: Path) -> None:
    """Refuse what `write_words` would refuse, before anything is flown; the file is tried and taken away again.

    Raises:
        InputError: another arm, or a file that is there already or cannot be written.
    """
    with _words_file(scenario, path):
        path.unlink()


def write_words(
    scenario: Scenario, path: Path, seed: int | None = None, *, progress: Callable[[float], None] | None = None
) -> int:
    """Fly a scenario's script and write each step's channels and words as a line of JSON.

    Args:
        scenario: of the concept arm.
        path: the file, which must not be there yet.
        seed: in place of the scenario's.
        progress: told now and then how much of the longest duration has gone, 0 to 1.

    Returns:
        How many frames were written.

    Raises:
        InputError: another arm, or a file that is there already or cannot be written.
    """
    with _words_file(scenario, path) as file:
        sim, before = Simulation(scenario, seed), cast("Frame | None", None)
        while not sim.ended:
            frame = sim.step()
            file.write(_line(before, frame, _fingers(sim)) + "\n")
            before = frame
            if progress is not None and frame.tick % 256 == 0:
                progress(frame.tick / scenario.ticks)
    return frame.tick


@contextmanager
def _words_file(scenario: Scenario, path: Path) -> Iterator[TextIO]:
    """A new file for the words of a scenario."""
    if not isinstance(scenario.arm.model.source, HeadingArmFile):
        raise InputError(
            "the report's words speak of its own arm, a heading-pitch-pitch-heading-pitch-roll one with a telescope; "
            f"{scenario.name} flies {scenario.arm.name}"
        )
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with path.open("x", encoding="ascii") as file:
            yield file
    except OSError as error:
        raise InputError(f"{path}: cannot be written: {error.strerror or error}") from None


def _line(before: Frame | None, frame: Frame, planes: tuple[Near | None, ...]) -> str:
    return json.dumps(
        {
            "time_s": frame.time_s,
            "volts": [round(volts, 9) for volts in channels_of(before, frame)],
            "words": [f"{word:08o}" for word in words_of(before, frame, planes)],
        }
    )


def _fingers(sim: Simulation) -> tuple[Near | None, ...]:
    """Palm, fixed finger and prong against the bar that is nearest to the palm; None where the pair is not watched."""
    pairs = {near.a: near for near in reversed(sim.watched()) if near.a in FINGERS and near.b.endswith("receptacle")}
    return tuple(pairs.get(name) for name in FINGERS)


_Planes = tuple[WordPlane | None, WordPlane | None, WordPlane | None]


def _control(before: Frame | None, frame: Frame) -> ControlWord:
    work, was = frame.work, (before or frame).work
    return ControlWord(
        mode=cast("Literal[1, 2, 3, 4]", work.task),
        station=STATION,
        initialise=any(event.kind == "initialise" for event in frame.events),
        telescope=_way((work.stand or 0.0) - (was.stand or 0.0)),
        prong=_way((was.hand.spacing or 0.0) - (work.hand.spacing or 0.0)),
        finger_inhibited=work.finger_inhibit,
        arm_inhibited=work.arm_inhibit,
    )


def _way(change: float) -> Literal[-1, 0, 1]:
    return 0 if abs(change) < SAME else 1 if change > 0.0 else -1


def _plane(near: Near | None) -> WordPlane | None:
    if near is None or near.normal == (0.0, 0.0, 0.0):
        return None
    return WordPlane(near.normal, near.distance)

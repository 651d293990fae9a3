"""The 1972 report's files: channels (inputs), words and VCU blocks (outputs). Commands write all, and read channels."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

from aftdeck.historical.words_file import WordsWriter, check_arm, new_words_file, operator_of, read_channels
from aftdeck.lines import print_error
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.whole_file import new_file

Stepped = Callable[[Simulation], None]
Operator = Callable[[Simulation], Inputs | None]


@contextmanager
def writing(scenario: Scenario, path: Path) -> Iterator[Stepped]:
    """Write a run's channels and words into a new file; at the end, print which inputs the channels cannot express.

    Raises:
        InputError: the arm is not the report's arm, or the file exists already or cannot be written.
    """
    with new_words_file(scenario, path) as file:
        writer = WordsWriter(file, scenario)
        yield writer.step
    if writer.unsaid:
        print_error(f"{path}: {_listed(writer.unsaid)}: the report has no channel or code for these inputs")


@contextmanager
def writing_blocks(scenario: Scenario, path: Path) -> Iterator[Stepped]:
    """Write a run's blocks for the VCU into a new file; at the end, print what the blocks cannot express.

    Raises:
        InputError: the report's priority routine does not know the scenario's arm or one of its parts, or the file
            exists already or cannot be written.
    """
    from aftdeck.mainprior.vcu_file import VcuWriter

    with new_file(path) as file:
        writer = VcuWriter(file, scenario)
        yield writer.step
    if writer.unsaid:
        print_error(f"{path}: {_listed(writer.unsaid)}: a station without a list, or a vector too long for its words")


def operator_by(scenario: Scenario, path: Path) -> tuple[Scenario, Operator]:
    """Return the changed scenario, and an operator that returns the samples of a file.

    The report's program read its channels without delay, so the scenario's command delay is set to 0.

    Raises:
        InputError: the arm is not the report's arm, or the file is not a file of channels.
    """
    check_arm(scenario)
    channels = read_channels(path, scenario.control_period)
    if channels.unsaid:
        print_error(f"{path}: {_listed(channels.unsaid)}: run without these inputs, so the result differs")
    if scenario.delay:
        scenario = replace(scenario, delay=0, changes=(*scenario.changes, "command_delay=0"))
    return scenario, operator_of(channels.samples)


def _listed(unsaid: Counter[str]) -> str:
    """Return a text such as ``latch in 1 step, rate in 300 steps``."""
    return ", ".join(f"{name} in {steps} step{'s' if steps != 1 else ''}" for name, steps in sorted(unsaid.items()))

"""File of RMS-VS's channels and words, with one line of JSON for each control step of a run.

A run can write such a file, or use one as its input. A line has ``time_s``, ``volts`` (TABLE I, thirteen numbers in
full precision) and ``words`` (TABLE II, 32 numbers in octal). If a command has no channel, or a value has no code, the
line also has ``unsaid``, a list of their names. A line of an input file needs only ``volts``; ``time_s`` and
``unsaid`` are read if present.
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Annotated, BinaryIO, NamedTuple

import msgspec

from aftdeck.errors import InputError, ScenarioError
from aftdeck.files import read
from aftdeck.historical.frame_words import encode_block
from aftdeck.historical.input_channels import CHANNELS, JOINTS, OperatorInputs, decode_inputs, encode_inputs
from aftdeck.historical.rms_vs_input import inputs_from, reading_of
from aftdeck.historical.rms_vs_output import Places, block_of, places_of
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.begin import initial_state
from aftdeck.simulation.constants.flight import Flight, run_constants
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.simulation.state import State
from aftdeck.whole_file import new_file

ON_TIME = 1e-6
"""Greatest difference between the time in a line and the time of its step [s]."""


class Line(NamedTuple):
    """Control step in the form of RMS-VS's channels and words.

    Attributes:
        volts: the thirteen channels [V].
        words: the 32 words.
        unsaid: names of commands and values that have no channel or no code.
    """

    volts: tuple[float, ...]
    words: tuple[int, ...]
    unsaid: tuple[str, ...]


class WordsWriter:
    """Writer of a file of channels and words; it must write every step of a run, beginning with the first.

    Attributes:
        steps: number of steps written so far.
        unsaid: for each name, the number of lines written so far whose ``unsaid`` contains this name.
    """

    def __init__(self, file: BinaryIO, scenario: Scenario) -> None:
        self._file = file
        self._before = places_of(initial_state(run_constants(scenario)))
        self.steps, self.unsaid = 0, Counter[str]()

    def step(self, sim: Simulation) -> None:
        """Write the line of the last step."""
        flight, state = sim._flight, sim._state
        line = line_of(flight, state, sim.flown, self._before)
        self._before = places_of(state)
        self.steps += 1
        self.unsaid.update(line.unsaid)
        time = round(state.tick * flight.scenario.control_period, 9)
        row = {"time_s": time, "volts": line.volts, "words": [f"{word:08o}" for word in line.words]}
        if line.unsaid:
            row["unsaid"] = line.unsaid
        self._file.write(json.dumps(row).encode() + b"\n")


def line_of(flight: Flight, state: State, flown: Inputs, before: Places) -> Line:
    """Return the line of the last step.

    Args:
        flight: constants of the run.
        state: state after the step.
        flown: inputs of the step.
        before: positions before the step.
    """
    reading, block = reading_of(flight, state, flown), block_of(flight, state, flown, before)
    unsaid = dict.fromkeys((*reading.unsaid, *block.unsaid))
    return Line(encode_inputs(reading.inputs), encode_block(block.block), tuple(unsaid))


@contextmanager
def new_words_file(scenario: Scenario, path: Path) -> Iterator[BinaryIO]:
    """Open a new file of channels and words for a run of a scenario; it appears at the end of a run without an error.

    Raises:
        InputError: the scenario's arm is not the report's arm, or the file already exists or cannot be written.
    """
    check_arm(scenario)
    with new_file(path) as file:
        yield file


def check_arm(scenario: Scenario) -> None:
    """Check that a scenario's arm is the report's arm.

    Raises:
        InputError: the scenario's arm has another number of joints, no telescope or no prong, so it is not the report's
            arm.
    """
    arm = scenario.arm
    if len(arm.joints) != len(JOINTS) or arm.model.telescope is None or arm.model.prong is None:
        raise InputError(
            f"{scenario.name}: the report's channels, words and priority routine are made for its arm, with "
            f"{len(JOINTS)} joints, telescope and prong; this scenario has the arm {arm.name}, with {len(arm.joints)} "
            "joints"
        )


class _Sample(msgspec.Struct, frozen=True):
    """Fields that are read from a line of a file of channels and words."""

    volts: Annotated[tuple[float, ...], msgspec.Meta(min_length=CHANNELS, max_length=CHANNELS)]
    time_s: float | None = None
    unsaid: tuple[str, ...] = ()


class Channels(NamedTuple):
    """Channels read from a file of channels and words.

    Attributes:
        samples: the operator's inputs, one for each control step.
        unsaid: for each name, the number of lines whose ``unsaid`` contains this name.
    """

    samples: tuple[OperatorInputs, ...]
    unsaid: Counter[str]


def read_channels(path: Path, period: float) -> Channels:
    """Return the channels from a file of channels and words.

    Args:
        path: the file.
        period: control period of the run, which must also be the time between successive lines of the file [s].

    Raises:
        InputError: the file cannot be read or is empty, a line is not valid, the time in a line is not the time of its
            step, or a voltage is beyond the scale. The message names the line.
    """
    try:
        text = read(path, most=None).text
    except ScenarioError as error:
        raise InputError(str(error)) from None
    samples, unsaid = [], Counter[str]()
    for number, line in enumerate(text.splitlines(), 1):
        try:
            sample = msgspec.json.decode(line, type=_Sample)
            if sample.time_s is not None and not abs(sample.time_s - number * period) <= ON_TIME:
                raise InputError(
                    f"time_s: got {sample.time_s:g}, expected {number * period:g}; a file has one line for each "
                    f"control step, every {period:g} s"
                )
            samples.append(decode_inputs(sample.volts))
        except (msgspec.DecodeError, InputError) as error:
            raise InputError(f"{path}:{number}: {error}") from None
        unsaid.update(sample.unsaid)
    if not samples:
        raise InputError(f"{path}: the file is empty; each control step needs a line with its thirteen voltages")
    return Channels(tuple(samples), unsaid)


def operator_of(samples: Sequence[OperatorInputs]) -> Callable[[Simulation], Inputs | None]:
    """Return a function that returns the inputs of the next sample at each call, and None after the last sample.

    The function raises an InputError if a sample moves a camera for which the scenario has no drive. The error names
    the sample's line.
    """
    numbered = enumerate(samples, 1)

    def inputs(sim: Simulation) -> Inputs | None:
        number, settings = next(numbered, (0, None))
        if settings is None:
            return None
        try:
            return inputs_from(settings, sim._state.worksite.switch, sim.cameras)
        except InputError as error:
            raise InputError(f"line {number} of the channels: {error}") from None

    return inputs

"""Channels of TABLE I: a run in MASTER writes them, and a run from them has the same frames, bit for bit."""

from __future__ import annotations

import io
import itertools
import json
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import aftdeck
from aftdeck import Inputs
from aftdeck.errors import InputError
from aftdeck.historical.words_file import WordsWriter, operator_of, read_channels
from aftdeck.scenario.load import load_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.camera_drives import CameraDrive
from aftdeck.simulation.frame import Frame
from tests.each import each, seeds
from tests.simulation import concept
from tests.simulation.flights import random_inputs
from tests.simulation.master_inputs import random_master_inputs

STEPS = 400


def written(scenario: Scenario, given: Iterator[Inputs]) -> tuple[list[Frame], str]:
    """Return the frames of a run, and the text of its file of channels and words."""
    file = io.BytesIO()
    sim, writer, frames = aftdeck.Simulation(scenario), WordsWriter(file, scenario), []
    for inputs in given:
        frames.append(sim.step(inputs))
        writer.step(sim)
    return frames, file.getvalue().decode()


def run_from_channels(scenario: Scenario, text: str, folder: Path) -> list[Frame]:
    path = folder / "channels.jsonl"
    path.write_text(text)
    samples = read_channels(path, scenario.control_period).samples
    return list(aftdeck.run(scenario, inputs=operator_of(samples)).frames)


SCENARIOS = {
    "the whole problem": lambda: load_scenario("concept-1972"),
    "the script's": lambda: load_scenario("concept-1972-script"),
    "the free flyer's": lambda: load_scenario("free-flyer"),
    "over the bar": lambda: concept.scenario(concept.ON_BAR),
    "held in the bay": lambda: concept.scenario(concept.ON_BAR, held=True),
    "held over the bay": lambda: concept.scenario((28.0, 0.0, -25.0), held=True),
}


QUICK, *SLOW = SCENARIOS


@each("seed", seeds(1, 20))
@pytest.mark.parametrize("name", [QUICK, *(pytest.param(name, marks=pytest.mark.slow) for name in SLOW)])
def test_run_from_written_channels_is_equal(name: str, seed: int, tmp_path: Path) -> None:
    scenario = SCENARIOS[name]()
    rng = np.random.default_rng([seed, len(name)])
    frames, text = written(scenario, random_master_inputs(rng, scenario, STEPS))
    assert all("unsaid" not in json.loads(line) for line in text.splitlines())
    assert run_from_channels(scenario, text, tmp_path) == frames
    assert {frame.mode for frame in frames} == {"MASTER"}
    assert len({frame.angles for frame in frames}) > STEPS / 20  # contacts with the bar inhibit the arm for a long time


@each("seed", seeds(3, 30))
def test_run_from_channels_is_equal_up_to_first_unsaid_command(seed: int, tmp_path: Path) -> None:
    """`unsaid` in a line names the commands without a channel. Up to the first such line, the two runs are equal."""
    rng = np.random.default_rng(seed)
    scenario = load_scenario("concept-1972")
    expressible, any_inputs = random_master_inputs(rng, scenario, 60 + 40 * seed), random_inputs(rng, 100, switches=0.5)
    frames, text = written(scenario, itertools.chain(expressible, any_inputs))
    again = run_from_channels(scenario, text, tmp_path)
    unsaid = [bool(json.loads(line).get("unsaid")) for line in text.splitlines()]
    equal = [one == other for one, other in zip(frames, again, strict=True)]
    assert unsaid.index(True) >= 60 + 40 * seed and False in equal
    assert equal.index(False) >= unsaid.index(True)


@pytest.mark.parametrize(
    ("name", "inputs"),
    [
        ("rate", Inputs(rate="vernier")),
        ("translation", Inputs(translation=(0.1, 0.0, 0.0))),
        ("drive", Inputs(drive=0.5)),
        ("latch", Inputs(latch="unlatch")),
        ("orbiter", Inputs(orbiter=(0.0, 1.0, 0.0))),
        ("mode", Inputs(mode="SINGLE")),
        ("joint", Inputs(joint=3)),
        ("brakes", Inputs(brakes=True)),
        ("safing", Inputs(safing=True)),
        ("law", Inputs(law="open loop")),
        ("rate_hold", Inputs(rate_hold=True)),
        ("proceed", Inputs(proceed=True)),
        ("stop", Inputs(stop=True)),
        ("telescope", Inputs(telescope=0.5)),
        ("camera", Inputs(camera=CameraDrive("B", 1.0, 1.0))),
        ("camera", Inputs(camera=CameraDrive("B", 0.5))),
        ("station", Inputs(camera=CameraDrive("I", 1.0))),
        ("initialise", Inputs(initialise="manoeuvring", mode="MASTER")),
        ("master", Inputs(master=(9.0, 0.0, 0.0, 0.0, 0.0, 0.0))),
    ],
)
def test_commands_without_a_channel_are_named(name: str, inputs: Inputs) -> None:
    scenario = load_scenario("concept-1972")
    _, text = written(scenario, iter([Inputs(mode="MASTER"), inputs]))
    first, second = (json.loads(line).get("unsaid", []) for line in text.splitlines())
    assert first == [] and name in second


def test_channels_contain_inputs_after_the_command_delay(tmp_path: Path) -> None:
    scenario = load_scenario("concept-1972")
    late = replace(scenario, delay=5)
    rng = np.random.default_rng(5)
    frames, text = written(late, random_master_inputs(rng, scenario, 80))
    again = run_from_channels(scenario, text, tmp_path)
    start = [json.loads(line).get("unsaid", []) for line in text.splitlines()]
    assert start[:5] == [["mode"]] * 5 and not any(start[5:])
    assert [frame.angles for frame in again] == [frame.angles for frame in frames]


GOOD = json.dumps({"volts": [0.0] * 13})


@pytest.mark.parametrize(
    ("text", "where"),
    [
        ("", "channels.jsonl: "),
        (GOOD + "\n{", "channels.jsonl:2: "),
        (GOOD + "\n" + json.dumps({"volts": [0.0] * 12}), "channels.jsonl:2: "),
        (GOOD + "\n" + json.dumps({"volts": [0.0] * 12 + ["x"]}), "channels.jsonl:2: "),
        (GOOD + "\n" + json.dumps({"volts": [0.0] * 12 + [7.0]}), "channels.jsonl:2: channel 13 is 7 V"),
        (GOOD + "\n" + json.dumps({"volts": [0.0] * 13, "time_s": 0.06}), "channels.jsonl:2: time_s: got 0.06"),
        (GOOD + "\n\n", "channels.jsonl:2: "),
    ],
)
def test_invalid_channels_file_is_rejected_with_its_line(text: str, where: str, tmp_path: Path) -> None:
    path = tmp_path / "channels.jsonl"
    path.write_text(text)
    with pytest.raises(InputError) as caught:
        read_channels(path, 0.02)
    assert where in str(caught.value)

"""Special priority from a file of words: D1 to D3 are the planes that the collision program sent."""

from __future__ import annotations

import io
import json
from pathlib import Path

import pytest

from aftdeck.cli.moments import at, source
from aftdeck.historical.frame_words import FrameBlock, WordPlane, encode_block
from aftdeck.historical.rms_vs_output import planes_of
from aftdeck.historical.scene_words import read_blocks
from aftdeck.historical.words_file import WordsWriter
from aftdeck.mainprior.received import kept, planes_in
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.run import Simulation
from tests.mainprior.flown import SCRIPT, routine

STEPS = 150
"""Number of control steps of the file; the end effector is above the bar."""


@pytest.fixture(scope="module")
def words(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """File of words of the mission's first seconds."""
    simulation, file = Simulation(load_scenario(SCRIPT)), io.BytesIO()
    writer = WordsWriter(file, simulation.scenario)
    for _ in range(STEPS):
        simulation.advance()
        writer.step(simulation)
    path = tmp_path_factory.mktemp("words") / "words.jsonl"
    path.write_bytes(file.getvalue())
    return path


def hand(path: Path, station: str) -> list[int]:
    """Return the end effector and the bar in the order of the routine, at the end of a file of words."""
    moment = at(source(str(path), SCRIPT), STEPS * 0.02)
    assert moment.received is not None
    found = routine().priority(moment.frame(), station, moment.received)
    return [k for k in found.clusters if k in (16, 17, 18, 19)]


def test_the_planes_of_the_words_decide_where_the_bar_stands(words: Path, tmp_path: Path) -> None:
    block = read_blocks(words)[-1]
    assert all(block.planes)
    for station in ("A", "H"):
        order = hand(words, station)
        lifted, lowered = ((0.0, 0.0, side) for side in (-1.0, 1.0))
        for normals, place in (
            ((lifted, lifted, lifted), 0),
            ((lowered, lowered, lowered), 3),
        ):
            # planes through R's origin, below the eye: a normal upwards (-Z) has the eye on its TRUE side
            planes = tuple(WordPlane(normal, 0.0) for normal in normals)
            changed = FrameBlock(block.control, block.angles, planes)  # type: ignore[arg-type]
            path = tmp_path / f"{station}{place}.jsonl"
            lines = words.read_text().splitlines()
            last = {**json.loads(lines[-1]), "words": [f"{word:08o}" for word in encode_block(changed)]}
            path.write_text("\n".join([*lines[:-1], json.dumps(last)]))
            moved = hand(path, station)
            assert moved.index(19) == place
            assert [k for k in moved if k != 19] == [k for k in order if k != 19]


def test_a_plane_that_is_not_sent_stays_as_it_was(words: Path) -> None:
    first, last = (read_blocks(words)[k].planes for k in (0, -1))
    assert kept(first, (None, last[1], None)) == (first[0], last[1], first[2])


def test_planes_computed_from_a_frame_have_the_bar_on_the_side_of_those_that_were_sent() -> None:
    simulation = Simulation(load_scenario(SCRIPT))
    compared = 0
    for _ in range(12):
        for _ in range(100):
            simulation.advance()
        frame = simulation.look()
        stage = routine().shapes.stage(frame)
        flight, state = simulation._flight, simulation._state
        sent = planes_of(flight.site, state.worksite, flight.scenario.control_period)
        made = planes_in(stage, frame.work.task != 1)
        for cluster, own, other in zip((17, 16, 18), sent, made, strict=True):
            if own is None or other is None:
                continue
            for plane in (own, other):
                for number, sign in ((cluster, -1.0), (19, 1.0)):
                    heights = stage.bodies[number].points @ plane.normal - plane.distance
                    assert (sign * heights).min() > -1e-6, (frame.time_s, cluster)
            compared += 1
    assert compared > 30

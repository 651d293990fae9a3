"""The block for the VCU, decoded; its file; and the commands that write and show what the routine makes."""

from __future__ import annotations

import io
import json
from pathlib import Path

import numpy as np
import pytest

from aftdeck.errors import InputError
from aftdeck.historical.frame_words import number
from aftdeck.mainprior.shapes import Shapes
from aftdeck.mainprior.tables import CODES, LISTS
from aftdeck.mainprior.vcu import L_SCALE, P_SCALE, VERTEX_SCALE, block_of, instruction_of, instruction_word
from aftdeck.mainprior.vcu_file import VcuWriter
from aftdeck.scenario.load import about, load_scenario
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.run import Simulation
from aftdeck.units import FOOT
from tests import loaded
from tests.commands import Run
from tests.each import each
from tests.mainprior.flown import frames, routine, scene


@each("frame", frames)
def test_the_words_of_a_block_hold_the_vectors_of_all_systems(frame: Frame) -> None:
    found = routine().priority(frame, "G")
    words = np.array(block_of(found).vectors).reshape(3, 4, len(CODES))
    for k, system in enumerate(CODES):
        eye = [number(word, L_SCALE) * FOOT for word in words[:, 0, k].tolist()]
        assert eye == pytest.approx(found.vectors.eye[system], abs=2.0 ** (L_SCALE - 23) * FOOT)
        display = [[number(word, P_SCALE) for word in row] for row in words[:, 1:, k].T.tolist()]
        assert np.array(display) == pytest.approx(found.vectors.display[system], abs=2.0 ** (P_SCALE - 23))


@each("frame", frames)
def test_the_program_of_a_block_is_the_priority_output_table(frame: Frame) -> None:
    for station in LISTS:
        found = routine().priority(frame, station)
        *program, end = block_of(found).program
        assert end == 0
        assert tuple(map(instruction_of, program)) == found.table
        assert all(0 < instruction_word(step) < 1 << 24 for step in found.table)


def test_the_moving_vertices_follow_telescope_and_prong() -> None:
    """The telescope ends 0.8 ft below the shoulder; the prong's inner face is at its spacing from 0.375 ft."""
    for frame in frames():
        block = block_of(routine().priority(frame, "A"))
        assert frame.work.stand is not None
        assert frame.work.hand.spacing is not None
        top = [number(word, VERTEX_SCALE) for word in block.telescope]
        assert top == pytest.approx([0.8 - frame.work.stand / FOOT] * 4, abs=0.01)
        faces = sorted({round(number(word, VERTEX_SCALE), 3) for word in block.prong})
        inner = 0.375 - frame.work.hand.spacing / FOOT
        assert len(block.prong) == 8
        assert faces == pytest.approx([inner - 0.25, inner], abs=0.01)


def test_a_file_has_a_line_for_each_step_and_names_a_station_without_a_list(tmp_path: Path) -> None:
    text = about("concept-1972").file
    (tmp_path / "short.toml").write_text(text.replace("3600 s", "0.1 s"))
    simulation, file = Simulation(load_scenario(tmp_path / "short.toml")), io.BytesIO()
    writer = VcuWriter(file, simulation.scenario)
    for camera in ("F", "P1"):
        simulation._state.panel.camera = camera
        simulation.step()
        writer.step(simulation)
    first, second = map(json.loads, file.getvalue().decode().splitlines())
    assert (first["station"], second["station"], second["unsaid"]) == ("F", "A", ["station"])
    assert "unsaid" not in first
    assert writer.unsaid == {"station": 1}
    program = [instruction_of(int(word, 8)) for word in first["program"][:-1]]
    frame = simulation.look()
    assert len(program) > len(routine().shapes.index)
    assert first["time_s"] < second["time_s"] == frame.time_s


def test_run_writes_a_file_of_blocks_only_for_the_reports_arm(run: Run, tmp_path: Path) -> None:
    scenario, out = tmp_path / "short.toml", tmp_path / "blocks.jsonl"
    scenario.write_text(about("concept-1972").file.replace("3600 s", "0.1 s"))
    assert run("run", str(scenario), "--vcu", str(out))[0] == 0
    assert len(out.read_text().splitlines()) == 5
    assert run("run", str(scenario), "--vcu", str(out))[0] == 2  # the file exists
    assert run("run", str(scenario), "--vcu", str(tmp_path / "a"), "--words", str(tmp_path / "a"))[0] == 2
    assert run("run", "sts-400-closed", "--vcu", str(tmp_path / "b"))[0] == 2
    assert not (tmp_path / "b").exists()


def test_planes_shows_the_routine_for_cameras_a_to_i_of_the_reports_arm(run: Run) -> None:
    code, out, _ = run("planes", "concept-1972", "--camera", "B", "--json")
    assert code == 0
    found = json.loads(out)["mainprior"]
    assert found["table_vii"] == ["3", "Z2", "2", "4", "6", "7", "W1", "21"]
    assert sorted(found["permanent_list"]) == sorted(found["table_vii"])
    assert {step for step in found["table"] if isinstance(step, int)} == {int(k) for k in found["parts"]}
    code, out, _ = run("planes", "concept-1972", "--camera", "P1", "--json")
    assert code == 0
    assert list(json.loads(out)["mainprior"]) == ["absent"]


def test_the_routine_rejects_an_arm_and_parts_that_it_does_not_know() -> None:
    for scenario in ("sts-400-closed", "free-flyer"):  # the scene's payload has another name
        with pytest.raises(InputError):
            Shapes(loaded.scenario(scenario), scene())

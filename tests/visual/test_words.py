"""Pictures from the report's frame words, against those of the run that wrote the words."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from aftdeck import Inputs
from aftdeck.cli.words import writing
from aftdeck.historical.scene_words import frames_from, read_blocks
from aftdeck.matrices import distance
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.run import run as run_scenario
from aftdeck.visual.scene import VisualScene
from tests.commands import Run
from tests.simulation import concept
from tests.simulation.flights import random_inputs
from tests.visual.painted_picture import painted

SCRIPT = "concept-1972-script"
STEP = 0.02 * 0.3048
"""Travel of the telescope in one step [m]: 1 ft/s for 0.02 s."""


@pytest.fixture(scope="module")
def flown(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, tuple[Frame, ...]]:
    """File of words of a run, and the frames of the run."""
    scenario, path = load_scenario(SCRIPT), tmp_path_factory.mktemp("words") / "words.jsonl"
    with writing(scenario, path) as stepped:
        done = run_scenario(scenario, stepped=stepped)
    return path, done.frames


def test_words_since_the_initialisation_give_the_scene(flown: tuple[Path, tuple[Frame, ...]]) -> None:
    """The words tell that telescope and prong move, not how far; each stop can differ by a part of a step."""
    path, frames = flown
    found = list(frames_from(load_scenario(SCRIPT), read_blocks(path)))
    assert len(found) == len(frames)
    held = 0
    for ours, theirs in zip(found[::50], frames[::50], strict=True):
        assert np.abs(np.array(ours.angles) - theirs.angles).max() < 1e-6
        assert ours.work.stand == pytest.approx(theirs.work.stand, abs=8 * STEP)
        assert ours.work.hand.spacing == pytest.approx(theirs.work.hand.spacing, abs=STEP)
        assert ours.work.cargo[0].held == theirs.work.cargo[0].held
        assert distance(ours.work.cargo[0].position, theirs.work.cargo[0].position) < 0.1
        held += theirs.work.cargo[0].held
    assert held > 10


def test_scene_obeys_the_inhibits(tmp_path: Path) -> None:
    """The end effector leans over the payload, so that the prong closes on its side; then random inputs."""
    made, path = concept.scenario((28.0, -2.7, 0.95), (-20.0, 0.0, 0.0)), tmp_path / "words.jsonl"
    rng, prong = np.random.default_rng(5), made.arm.model.prong
    given = [Inputs(effector="close"), *[Inputs()] * 200, *[Inputs(telescope=-1.0)] * 50, Inputs(effector="open")]
    each = iter([*given, *random_inputs(rng, 600, 0.3)])
    with writing(made, path) as stepped:
        frames = run_scenario(made, inputs=lambda _: next(each, None), stepped=stepped).frames
    blocks = read_blocks(path)
    assert prong is not None
    rate = prong.rate * made.control_period
    stopped, relieved = 0, 1
    found = list(frames_from(made, blocks))
    for k, block in enumerate(blocks[1:], 1):
        control, before, now, frame, earlier = block.control, found[k - 1], found[k], frames[k], frames[k - 1]
        stopped += control.finger_inhibited and control.prong != 0
        assert not control.finger_inhibited or now.work.hand.spacing == before.work.hand.spacing
        assert not control.arm_inhibited or now.work.stand == before.work.stand
        relieved += control.finger_inhibited and frame.work.hand.spacing != earlier.work.hand.spacing
        assert now.work.hand.spacing == pytest.approx(frame.work.hand.spacing, abs=relieved * rate)
    assert stopped > 20


def test_pictures_from_words_are_almost_those_of_the_run(flown: tuple[Path, tuple[Frame, ...]]) -> None:
    path, frames = flown
    scenario = load_scenario(SCRIPT)
    found, scene = list(frames_from(scenario, read_blocks(path))), VisualScene(scenario)
    for k in range(200, len(frames), 900):
        for camera in ("A", "F", "ENG"):
            shown = [
                painted(scene.polygons(frame, scene.aim(frame, camera, 4 / 3)), 160, 120)
                for frame in (found[k], frames[k])
            ]
            assert (shown[0] != shown[1]).mean() < 0.01


def test_render_draws_a_file_of_words(run: Run, tmp_path: Path, flown: tuple[Path, tuple[Frame, ...]]) -> None:
    out = tmp_path / "view.svg"
    given = ("--camera", "ENG", "--time", "30", "-o", str(out))
    assert run("render", str(flown[0]), *given)[0] == 0
    assert "30.00 s" in out.read_text()
    assert run("render", str(flown[0]), *given, "--words-of", "first-flight")[0] == 2
    assert run("render", "concept-1972", *given, "--words-of", "concept-1972")[0] == 2


def test_wrong_words_name_their_line(run: Run, tmp_path: Path, flown: tuple[Path, tuple[Frame, ...]]) -> None:
    lines = flown[0].read_text().splitlines()[:3]
    for line, part in (
        ("{}", "words.jsonl:4: "),
        (lines[0].replace('"0', '"9', 1), "expected up to eight digits from 0 to 7"),
    ):
        path = tmp_path / "words.jsonl"
        path.write_text("\n".join([*lines, line]))
        code, _, err = run("render", str(path), "--camera", "A", "-o", str(tmp_path / "a.svg"))
        assert code == 2
        assert part in err

"""SVG and PNG files, the commands that write them, and the frames that they draw."""

from __future__ import annotations

import io
import json
import xml.etree.ElementTree as ET
from itertools import islice
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from aftdeck.cli.moments import every, source
from aftdeck.recording.run import record
from aftdeck.scenario.light import conditions
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.run import Simulation
from aftdeck.visual.clusters import clusters_of
from aftdeck.visual.page import contact_sheet, single
from aftdeck.visual.picture import Look, Picture, picture_of
from aftdeck.visual.png import png
from aftdeck.visual.scene import VisualScene
from aftdeck.visual.svg import svg
from tests import loaded
from tests.commands import Run

SVG = "{http://www.w3.org/2000/svg}"
SIZE = (400, 300)


@pytest.fixture(scope="module")
def scene() -> VisualScene:
    return VisualScene(load_scenario("concept-1972"))


def picture(scene: VisualScene, camera: str, look: Look = "colour") -> Picture:
    return picture_of(scene, Simulation("concept-1972").look(), camera, SIZE, look, conditions()[0])


def polygons_in(text: str) -> list[tuple[str, np.ndarray]]:
    """Return colour and corners of all polygons in an SVG file."""
    found = []
    for path in ET.fromstring(text).iter(f"{SVG}path"):
        for shape in path.attrib["d"].split("Z")[:-1]:
            corners = [tuple(map(float, corner.split())) for corner in shape[1:].split("L")]
            found.append((path.attrib["fill"], np.array(corners)))
    return found


@pytest.mark.parametrize("camera", ["A", "F", "P2", "ENG"])
def test_an_svg_has_the_polygons_of_the_picture_in_their_order(scene: VisualScene, camera: str) -> None:
    drawn = picture(scene, camera)
    found = polygons_in(svg(single(drawn)))
    assert len(found) == len(drawn.owner) > 5
    for q, (colour, corners) in enumerate(found):
        assert colour == "#{:02x}{:02x}{:02x}".format(*drawn.colours[q])
        assert np.abs(corners - drawn.points[drawn.begins[q] : drawn.begins[q + 1]]).max() <= 0.0501


def test_the_texts_of_an_svg_are_texts(scene: VisualScene) -> None:
    texts = [text.text for text in ET.fromstring(svg(single(picture(scene, "A")))).iter(f"{SVG}text")]
    assert "0.00 s" in texts
    assert any(text is not None and text.startswith("A  Forward end of the bay") for text in texts)


def test_a_png_shows_the_colour_of_the_uppermost_polygon(scene: VisualScene) -> None:
    """Pixels inside the last polygon that contains them have its colour, apart from texts and edges."""
    drawn = picture(scene, "ENG")
    pixels = np.asarray(Image.open(io.BytesIO(png(single(drawn)))))
    right = total = 0
    for row, column in np.random.default_rng(0).integers((60, 20), (240, 380), (300, 2)).tolist():
        colour = np.zeros(3, np.int64)
        for q in range(len(drawn.owner)):
            corners = drawn.points[drawn.begins[q] : drawn.begins[q + 1]]
            away = np.roll(corners, -1, axis=0) - corners
            side = away[:, 0] * (row + 0.5 - corners[:, 1]) - away[:, 1] * (column + 0.5 - corners[:, 0])
            if (side >= 0.0).all() or (side <= 0.0).all():
                colour = drawn.colours[q]
        total += 1
        right += bool((pixels[row, column] == colour).all())
    assert right > 0.95 * total


def test_the_look_of_1972_has_few_greys(scene: VisualScene) -> None:
    colours = picture(scene, "ENG", "1972").colours
    assert (colours == colours[:, :1]).all()
    assert 2 < len(np.unique(colours)) <= 8


def test_a_contact_sheet_has_each_camera(scene: VisualScene) -> None:
    page = contact_sheet([picture(scene, camera) for camera in ("A", "C", "F")], "title & more")
    root = ET.fromstring(svg(page))
    assert len(list(root.iter(f"{SVG}svg"))) == 4
    assert Image.open(io.BytesIO(png(page))).size == (page.width, page.height)


# --- commands ---------------------------------------------------------------------------------------------


def test_render_writes_a_picture_of_a_scenario(run: Run, tmp_path: Path) -> None:
    out = tmp_path / "view.svg"
    assert run("render", "concept-1972", "--camera", "A", "-o", str(out))[0] == 0
    assert len(polygons_in(out.read_text())) > 5


@pytest.mark.slow
def test_render_draws_a_recording_as_the_run_itself(run: Run, tmp_path: Path) -> None:
    """A recording rounds poses; corners agree to a tenth of a pixel."""
    record(load_scenario("concept-1972-script"), tmp_path / "run.mcap")
    run_of, of_file = tmp_path / "a.svg", tmp_path / "b.svg"
    for given, out in (("concept-1972-script", run_of), (str(tmp_path / "run.mcap"), of_file)):
        assert run("render", given, "--camera", "ENG", "--time", "33.5", "-o", str(out))[0] == 0
    a, b = polygons_in(run_of.read_text()), polygons_in(of_file.read_text())
    assert [colour for colour, _ in a] == [colour for colour, _ in b]
    assert max(np.abs(p - q).max() for (_, p), (_, q) in zip(a, b, strict=True)) < 0.11


def test_render_writes_a_sheet_and_sequences(run: Run, tmp_path: Path) -> None:
    given = ("render", "concept-1972-script", "--size", "64x48", "--every", "20", "--camera")
    assert run(*given, "all", "-o", str(tmp_path / "sheet.png"))[0] == 0
    with Image.open(tmp_path / "sheet.png") as image:
        image.seek(4)
        with pytest.raises(EOFError):
            image.seek(5)
    assert run(*given, "F", "-o", str(tmp_path / "view-##.svg"))[0] == 0
    assert sorted(path.name for path in tmp_path.glob("view*")) == [f"view-0{k}.svg" for k in range(1, 6)]
    assert run(*given, "F", "-o", str(tmp_path / "moving.svg"))[0] == 0
    assert len(list(ET.parse(tmp_path / "moving.svg").iter(f"{SVG}animate"))) == 5


@pytest.mark.parametrize("step_s", [0.05, 0.07, 0.1])
def test_frames_of_a_sequence_do_not_drift_from_their_times(step_s: float) -> None:
    run = source("concept-1972-script")
    period = run.scenario.control_period
    times = [frame.time_s for frame in islice(every(run, step_s, None), 30)]
    assert [0.0 <= time - k * step_s + 1e-6 < period for k, time in enumerate(times)] == [True] * 30


@pytest.mark.parametrize(
    ("options", "part"),
    [
        (("--camera", "Q", "-o", "a.svg"), "no camera is called 'Q'"),
        (("--camera", "A", "-o", "a.gif"), "a.gif has to end in .svg or .png"),
        (("--camera", "A", "-o", "a.svg", "--time", "1e9"), "the run has no frame at 1e+09 s"),
        (("--camera", "A", "-o", "a.svg", "--time", "nan"), "--time: got nan"),
        (("--camera", "A", "-o", "a.svg", "--every", "0"), "--every: got 0"),
        (("--camera", "A", "-o", "a.svg", "--every", "1", "--time", "1"), "cannot be combined"),
        (("--camera", "A", "-o", "a-##.svg"), "needs --every"),
        (("--camera", "A", "-o", "a.svg", "--size", "9x9"), "each is from 16 to 8192"),
        (("--camera", "A", "-o", "a.svg", "--light", "noon"), "no light condition 'noon': there are high sun"),
        (("--camera", "A", "-o", "/dev/null/a.svg"), "/dev/null/a.svg: cannot be written: "),
    ],
)
def test_render_explains_wrong_options(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, options: tuple[str, ...], part: str
) -> None:
    monkeypatch.chdir(tmp_path)
    code, out, err = run("render", "concept-1972", *options)
    assert (code, out) == (2, "")
    assert part in err
    assert not list(tmp_path.iterdir())


def test_planes_prints_what_decides_the_order(run: Run) -> None:
    code, out, _ = run("planes", "concept-1972", "--camera", "A", "--json")
    assert code == 0
    found = json.loads(out)
    count = len(clusters_of(loaded.scenario("concept-1972")).clusters)
    assert len(found["clusters"]) == count
    listed = sorted(entry["cluster"] for entry in found["listed"] if entry["cluster"] is not None)
    assert listed == [k for k, (_, frame) in enumerate(found["clusters"]) if frame == "orbiter"]
    assert {entry["cluster"] for entry in found["table"]} <= set(range(count))
    assert found["cuts"] == 0
    code, out, _ = run("planes", "concept-1972", "--camera", "A")
    assert code == 0
    assert "Priority output table" in out

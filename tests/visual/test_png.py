"""PNG files: pictures are painted as by Pillow alone, polygon by polygon, and files hold all their pixels."""

from __future__ import annotations

import io

import numpy as np
import pytest
from PIL import Image, ImageDraw

from aftdeck.scenario.light import conditions
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.run import Simulation
from aftdeck.visual.covered import mark_uncovered
from aftdeck.visual.page import single
from aftdeck.visual.picture import Look, Picture, picture_of
from aftdeck.visual.png import _font, pixels, png
from aftdeck.visual.scene import VisualScene
from aftdeck.visual.svg import INK, RASTER, baseline, text_size


@pytest.fixture(scope="module")
def scene() -> VisualScene:
    return VisualScene(load_scenario("concept-1972"))


def drawn(scene: VisualScene, camera: str, size: tuple[int, int], look: Look) -> Picture:
    return picture_of(scene, Simulation("concept-1972").look(), camera, size, look, conditions()[0])


def painted_plainly(picture: Picture) -> Image.Image:
    """Return a picture of which every polygon and every text is painted in colour, one after the other."""
    large = Image.new("RGB", (2 * picture.width, 2 * picture.height))
    draw = ImageDraw.Draw(large)
    for q, colour in enumerate(picture.colours.tolist()):
        corners = 2 * picture.points[picture.begins[q] : picture.begins[q + 1]] - 0.5
        draw.polygon(list(map(tuple, corners.tolist())), fill=tuple(colour))
    if picture.look == "1972":
        rows = np.array(large)
        rows[np.arange(len(rows)) // 2 % RASTER == 0] = rows[np.arange(len(rows)) // 2 % RASTER == 0] * 0.55
        large = Image.fromarray(rows)
        draw = ImageDraw.Draw(large)
    font = _font(2 * text_size(picture))
    for label in picture.labels:
        x, y = baseline(picture, label)
        anchor = "rs" if label.right else "ls"
        draw.text((2 * x, 2 * y), label.text, INK, font, anchor=anchor, stroke_width=2, stroke_fill="#000")
    return large.reduce(2)


@pytest.mark.parametrize("size", [(400, 300), (61, 41)])
@pytest.mark.parametrize("look", ["colour", "1972"])
@pytest.mark.parametrize("camera", ["A", "F", "ENG"])
def test_pixels_are_those_of_all_polygons_and_texts(
    scene: VisualScene, camera: str, look: Look, size: tuple[int, int]
) -> None:
    picture = drawn(scene, camera, size, look)
    for each in (picture, picture._replace(labels=()), picture._replace(labels=picture.labels[:1])):
        assert (pixels(each) == np.asarray(painted_plainly(each))).all()


def test_a_file_has_the_pixels_of_its_picture(scene: VisualScene) -> None:
    picture = drawn(scene, "ENG", (400, 300), "1972")
    image = Image.open(io.BytesIO(png(single(picture))))
    assert (image.format, image.mode) == ("PNG", "RGB")
    assert (np.asarray(image) == pixels(picture)).all()


def test_only_polygons_inside_a_later_one_are_covered() -> None:
    def square(x: float, y: float, half: float) -> np.ndarray:
        return np.array([[x - half, y - half], [x + half, y - half], [x + half, y + half], [x - half, y + half]])

    squares = [square(50, 50, 10), square(50, 50, 47), square(50, 50, 50), square(50, 50, 49.5), square(90, 50, 20)]
    found = np.empty(len(squares), np.uint8)
    for turn in (1, -1):
        points = np.concatenate([corners[::turn] for corners in squares])
        mark_uncovered(points, np.arange(0, 4 * len(squares) + 1, 4), found)
        assert found.tolist() == [0, 0, 1, 1, 1]

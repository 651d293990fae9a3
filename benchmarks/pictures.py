"""Pictures without a GPU: the order of clusters in compiled code, SVG and PNG, and MuJoCo's renderer beside them."""

from __future__ import annotations

import io
import statistics
from functools import partial
from typing import NamedTuple

import mujoco
import numpy as np
from PIL import Image

from aftdeck.law import law
from aftdeck.scenario.light import conditions
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.run import Simulation
from aftdeck.visual.order import ordered
from aftdeck.visual.page import Page, single
from aftdeck.visual.picture import picture_of
from aftdeck.visual.png import pixels, png
from aftdeck.visual.scene import Arguments, VisualScene
from aftdeck.visual.svg import svg
from benchmarks.measure import Figure, Timing, absent, against, microseconds
from benchmarks.plain import comparisons

SIZE = (800, 600)
"""Size of the pictures [pixels]."""
REPEATS = 50
"""Number of orders in one call of `orders`."""
ORDERED, WRITTEN, PAINTED = 100.0, 5.0, 4.0
"""Promises for the slowest camera: order, as a share of a comparison of all pairs of clusters; SVG, as a share of the
writing of its numbers by plain Python; PNG, as a share of Pillow's writing of the finished pixels."""


class Size(NamedTuple):
    """Extent of the measurement.

    Attributes:
        times: time of the pictures in each scenario's script [s].
        cameras: greatest number of cameras of a scenario.
        timing: extent of the timing of an order and of an SVG.
        png: extent of the timing of a PNG.
    """

    times: dict[str, float]
    cameras: int
    timing: Timing
    png: Timing


FULL = Size({"concept-1972-script": 29.0, "srms-berth": 85.0}, 100, Timing(10), Timing(5))
TINY = Size({"concept-1972-script": 0.5}, 1, Timing(1, 0.0), Timing(1, 0.0))


@law
def orders(given: Arguments) -> int:
    """Order a picture REPEATS times."""
    count = 0
    for _ in range(REPEATS):
        count += ordered(*given)
    return count


def pictures(size: Size) -> list[Figure]:
    """Measure the order, an SVG and a PNG of each camera in both worksites."""
    figures: list[Figure] = []
    for name, time in size.times.items():
        scenario = load_scenario(name)
        simulation = Simulation(scenario)
        for _ in range(round(time / scenario.control_period)):
            simulation.advance()
        frame, scene = simulation.look(), VisualScene(scenario)
        cameras = list(scene.cameras)[: size.cameras]
        order: dict[str, float] = {}
        vector: dict[str, float] = {}
        raster: dict[str, float] = {}
        for camera in cameras:
            given: dict[str, object] = {"run": orders, "arguments": arguments(scene, frame, camera)}
            order[camera] = microseconds("run(arguments)", given, size.timing) / REPEATS
            names: dict[str, object] = {"make": partial(picture, scene, frame, camera), "svg": svg, "png": png}
            vector[camera] = microseconds("svg(make())", names, size.timing) / 1e3
            raster[camera] = microseconds("png(make())", names, size.png) / 1e3
        plain = comparisons(f"{name}, plain loop", len(scene.clusters.clusters), size.timing)
        written = _written(picture(scene, frame, _slowest(vector)), name, size)
        saved = _saved(picture(scene, frame, _slowest(raster)), name, size)
        note = f"{len(cameras)} cameras, {SIZE[0]} x {SIZE[1]}"
        figures += [
            plain,
            against(plain, ORDERED, f"{name}, order, slowest camera", max(order.values()), "us", note),
            Figure(f"{name}, order, median", statistics.median(order.values()), "us", None, note),
            written,
            against(written, WRITTEN, f"{name}, SVG, slowest camera", max(vector.values()), "ms", note),
            saved,
            against(saved, PAINTED, f"{name}, PNG, slowest camera", max(raster.values()), "ms", note),
        ]
    return [*figures, mujoco_picture(size)]


def _slowest(times: dict[str, float]) -> str:
    return max(times, key=times.__getitem__)


def _written(page: Page, name: str, size: Size) -> Figure:
    """Measure the writing of the corners of all polygons of a page, by plain Python."""
    corners = [cell.points.tolist() for _, _, cell in page.cells]

    def write() -> str:
        return " ".join(f"{x:.1f} {y:.1f}" for points in corners for x, y in points)

    time = microseconds("f()", {"f": write}, size.timing) / 1e3
    return Figure(f"{name}, numbers of its SVG", time, "ms", None, "written by plain Python")


def _saved(page: Page, name: str, size: Size) -> Figure:
    """Measure Pillow's writing of a page's finished pixels."""
    image = Image.fromarray(pixels(page.cells[0][2]))

    def save() -> None:
        image.save(io.BytesIO(), "PNG", compress_level=3)

    time = microseconds("f()", {"f": save}, size.png) / 1e3
    return Figure(f"{name}, pixels of its PNG", time, "ms", None, "written by Pillow")


def arguments(scene: VisualScene, frame: Frame, camera: str) -> Arguments:
    """Return the arguments of `ordered` for a camera, after one picture of it."""
    aim = scene.aim(frame, camera, SIZE[0] / SIZE[1])
    scene.order(frame, aim)
    return scene.arguments(frame, aim)


def picture(scene: VisualScene, frame: Frame, camera: str) -> Page:
    """Return the page of a camera's picture."""
    return single(picture_of(scene, frame, camera, SIZE, "colour", conditions()[0]))


def mujoco_picture(size: Size) -> Figure:
    """Measure MuJoCo's renderer with a scene of 27 boxes, if this machine has a GL library for it."""
    name = f"MuJoCo's renderer, {SIZE[0]} x {SIZE[1]}, no file"
    rng = np.random.default_rng(0)
    boxes = "".join(
        f'<geom type="box" size="1 .5 .3" pos="{x:.2f} {y:.2f} {z:.2f}"/>' for x, y, z in rng.uniform(-8, 8, (27, 3))
    )
    text = f'<mujoco><visual><global offwidth="800" offheight="600"/></visual><worldbody>{boxes}</worldbody></mujoco>'
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    try:
        renderer = mujoco.Renderer(model, SIZE[1], SIZE[0])
    except Exception as error:  # each GL library has its own errors
        return absent(name, "ms", f"install a GL library for EGL ({type(error).__name__}: {error})")
    renderer.update_scene(data)
    names: dict[str, object] = {"renderer": renderer, "data": data}
    time = microseconds("renderer.update_scene(data); renderer.render()", names, size.png)
    return Figure(name, time / 1e3, "ms", None, "27 boxes, EGL")

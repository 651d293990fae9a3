"""Pictures without a GPU: the order of clusters in compiled code, SVG and PNG, and MuJoCo's renderer beside them."""

from __future__ import annotations

import statistics
from functools import partial

import mujoco
import numpy as np

from aftdeck.law import law
from aftdeck.scenario.light import conditions
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.run import Simulation
from aftdeck.visual.order import ordered
from aftdeck.visual.page import Page, single
from aftdeck.visual.picture import picture_of
from aftdeck.visual.png import png
from aftdeck.visual.scene import Arguments, VisualScene
from aftdeck.visual.svg import svg
from benchmarks.measure import Figure, microseconds

SIZE = (800, 600)
"""Size of the pictures [pixels]."""
TIMES = {"concept-1972-script": 29.0, "srms-berth": 85.0}
"""Time of the pictures in each scenario's script [s]."""
REPEATS = 50
"""Number of orders in one call of `orders`."""


@law
def orders(given: Arguments) -> int:
    """Order a picture REPEATS times."""
    count = 0
    for _ in range(REPEATS):
        count += ordered(*given)
    return count


def pictures() -> list[Figure]:
    """Measure the order, an SVG and a PNG of each camera in both worksites."""
    figures: list[Figure] = []
    for name, time in TIMES.items():
        scenario = load_scenario(name)
        simulation = Simulation(scenario)
        while simulation.look().time_s < time:
            simulation.advance()
        frame, scene = simulation.look(), VisualScene(scenario)
        times: dict[str, list[float]] = {"order": [], "svg": [], "png": []}
        for camera in scene.cameras:
            times["order"].append(
                microseconds("run(arguments)", {"run": orders, "arguments": arguments(scene, frame, camera)}, repeat=10)
                / REPEATS
            )
            names: dict[str, object] = {"make": partial(picture, scene, frame, camera), "svg": svg, "png": png}
            times["svg"].append(microseconds("svg(make())", names, repeat=10) / 1e3)
            times["png"].append(microseconds("png(make())", names, repeat=5) / 1e3)
        concept = name.startswith("concept")
        note = f"{name}, {len(scene.cameras)} cameras"
        figures += [
            Figure("order of a picture, slowest camera", max(times["order"]), "us", 20.0 if concept else None, note),
            Figure("order of a picture, median", statistics.median(times["order"]), "us", None, note),
            Figure("SVG 800 x 600, slowest camera", max(times["svg"]), "ms", 10.0, note),
            Figure("PNG 800 x 600, slowest camera", max(times["png"]), "ms", 30.0, note),
        ]
    return [*figures, *mujoco_picture()]


def arguments(scene: VisualScene, frame: Frame, camera: str) -> Arguments:
    """Return the arguments of `ordered` for a camera, after one picture of it."""
    aim = scene.aim(frame, camera, SIZE[0] / SIZE[1])
    scene.order(frame, aim)
    return scene.arguments(frame, aim)


def picture(scene: VisualScene, frame: Frame, camera: str) -> Page:
    """Return the page of a camera's picture."""
    return single(picture_of(scene, frame, camera, SIZE, "colour", conditions()[0]))


def mujoco_picture() -> list[Figure]:
    """Measure MuJoCo's renderer with a scene of 27 boxes; no figure if this machine has no GL library for it."""
    try:
        rng = np.random.default_rng(0)
        boxes = "".join(
            f'<geom type="box" size="1 .5 .3" pos="{x:.2f} {y:.2f} {z:.2f}"/>'
            for x, y, z in rng.uniform(-8, 8, (27, 3))
        )
        text = (
            f'<mujoco><visual><global offwidth="800" offheight="600"/></visual><worldbody>{boxes}</worldbody></mujoco>'
        )
        model = mujoco.MjModel.from_xml_string(text)
        data = mujoco.MjData(model)
        mujoco.mj_forward(model, data)
        renderer = mujoco.Renderer(model, SIZE[1], SIZE[0])
    except Exception as error:  # each GL library has its own errors
        return [Figure("MuJoCo's renderer 800 x 600", float("nan"), "ms", None, f"not available: {error}")]
    renderer.update_scene(data)
    time = microseconds(
        "renderer.update_scene(data); renderer.render()", {"renderer": renderer, "data": data}, repeat=5
    )
    return [Figure("MuJoCo's renderer 800 x 600, without writing a file", time / 1e3, "ms", None, "27 boxes, EGL")]

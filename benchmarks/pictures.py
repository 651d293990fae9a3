"""Pictures without a GPU: the order of clusters in compiled code, SVG and PNG, and MuJoCo's renderer beside them."""

from __future__ import annotations

import io
import statistics
import time
from collections.abc import Callable, Iterator
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
from aftdeck.visual.picture import Look, picture_of
from aftdeck.visual.png import pixels, png
from aftdeck.visual.scene import Arguments, VisualScene
from aftdeck.visual.svg import svg
from benchmarks.measure import Call, Figure, Timing, absent, against, in_turn, microseconds
from benchmarks.plain import comparisons

SIZE = (800, 600)
"""Size of the pictures [pixels]."""
REPEATS = 50
"""Number of orders in one call of `orders`."""
ORDERED = {"concept-1972-script": 60.0, "srms-berth": 70.0}
WRITTEN, PAINTED = 15.0, 4.0
"""Promises for the slowest camera: order, as a share of a plain loop over all pairs of clusters; SVG, as a share of the
writing of its coordinates by plain Python; PNG, as a share of Pillow's writing of the finished pixels."""

PAINTED_AS: tuple[tuple[str, Look], ...] = ("PNG", "colour"), ("PNG, look of 1972", "1972")
"""Names of the kinds of PNG, and their looks."""


class Size(NamedTuple):
    """Extent of the measurement.

    Attributes:
        times: time of the pictures in each scenario's script [s].
        cameras: greatest number of cameras of a scenario.
        timing: extent of the timing of a call.
    """

    times: dict[str, float]
    cameras: int
    timing: Timing


FULL = Size({"concept-1972-script": 29.0, "srms-berth": 85.0}, 100, Timing(5))
TINY = Size({"concept-1972-script": 0.5}, 1, Timing(1, 0.0))


@law
def orders(given: Arguments) -> int:
    """Order a picture REPEATS times."""
    count = 0
    for _ in range(REPEATS):
        count += ordered(*given)
    return count


class Kind(NamedTuple):
    """Result that is made of each camera's picture.

    Attributes:
        name: its name.
        unit: unit of its figures.
        ours: call that makes it for a camera.
        scale: number by which the time of this call in us is divided.
        peer: call with which the slowest camera is compared.
        about: description of that call.
        share: promised time, as a share of that call's.
    """

    name: str
    unit: str
    ours: Callable[[str], Call]
    scale: float
    peer: Callable[[str], Call]
    about: str
    share: float


def pictures(size: Size) -> list[Figure]:
    """Measure the order, an SVG and a PNG of each camera in both worksites."""
    figures = [figure for name, at in size.times.items() for figure in _worksite(name, at, size)]
    return [*figures, mujoco_picture(size)]


def _worksite(name: str, at: float, size: Size) -> Iterator[Figure]:
    """Measure the pictures of a scenario at a time of its script [s]."""
    scenario = load_scenario(name)
    simulation = Simulation(scenario)
    for _ in range(round(at / scenario.control_period)):
        simulation.advance()
    frame, scene = simulation.look(), VisualScene(scenario)
    made, count = partial(picture, scene, frame), len(scene.clusters.clusters)
    kinds = (
        Kind(
            "order",
            "us",
            lambda camera: ("run(given)", {"run": orders, "given": arguments(scene, frame, camera)}),
            REPEATS,
            lambda camera: comparisons(count),
            f"compiled by Numba: whether each pair of {count} rectangles overlaps",
            ORDERED[name],
        ),
        Kind(
            "SVG",
            "ms",
            lambda camera: ("svg(make())", {"svg": svg, "make": partial(made, camera)}),
            1e3,
            lambda camera: ("write(corners)", {"write": _write, "corners": made(camera).cells[0][2].points.tolist()}),
            "coordinates of all corners, written by plain Python",
            WRITTEN,
        ),
        *(_painted(made, label, look) for label, look in PAINTED_AS),
    )
    for kind in kinds:
        yield from _measured(name, kind, list(scene.cameras)[: size.cameras], size)


def _painted(made: Callable[..., Page], label: str, look: Look) -> Kind:
    """Return the PNG of each camera in a look."""

    def finished(camera: str) -> Image.Image:
        return Image.fromarray(pixels(made(camera, look=look).cells[0][2]))

    return Kind(
        label,
        "ms",
        lambda camera: ("png(make())", {"png": png, "make": partial(made, camera, look=look)}),
        1e3,
        lambda camera: ("save(image)", {"save": _save, "image": finished(camera)}),
        "finished pixels, written by Pillow",
        PAINTED,
    )


def _measured(name: str, kind: Kind, cameras: list[str], size: Size) -> Iterator[Figure]:
    """Measure a result of all cameras, and then its slowest camera in turn with the peer."""
    times = {camera: microseconds(*kind.ours(camera), size.timing) for camera in cameras}
    slowest = max(times, key=times.__getitem__)
    ours, other = in_turn(kind.ours(slowest), kind.peer(slowest), size.timing)
    peer = Figure(f"{name}, plain work beside {kind.name}", _in(kind.unit, other), kind.unit, None, kind.about)
    note = f"{len(cameras)} cameras, {SIZE[0]} x {SIZE[1]}"
    yield peer
    yield against(peer, kind.share, f"{name}, {kind.name}, slowest camera", ours / kind.scale, kind.unit, note)
    middle = statistics.median(times.values()) / kind.scale
    yield Figure(f"{name}, {kind.name}, median", middle, kind.unit, None, note)


def _in(unit: str, microseconds: float) -> float:
    """Return a time in us in another unit."""
    return microseconds if unit == "us" else microseconds / 1e3


def _write(corners: list[list[float]]) -> str:
    """Write the coordinates of a picture's corners by plain Python."""
    return " ".join(f"{x:.1f} {y:.1f}" for x, y in corners)


def _save(image: Image.Image) -> None:
    """Write a picture's finished pixels by Pillow."""
    image.save(io.BytesIO(), "PNG", compress_level=3)


def arguments(scene: VisualScene, frame: Frame, camera: str) -> Arguments:
    """Return the arguments of `ordered` for a camera, after one picture of it."""
    aim = scene.aim(frame, camera, SIZE[0] / SIZE[1])
    scene.order(frame, aim)
    return scene.arguments(frame, aim)


def picture(scene: VisualScene, frame: Frame, camera: str, *, look: Look = "colour") -> Page:
    """Return the page of a camera's picture."""
    return single(picture_of(scene, frame, camera, SIZE, look, conditions()[0]))


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
    wall = microseconds("renderer.update_scene(data); renderer.render()", names, size.timing, time.perf_counter)
    return Figure(name, wall / 1e3, "ms", None, "27 boxes, EGL, wall time")

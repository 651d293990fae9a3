"""Pictures in the look of 1972: their content, the painter that computes them, and the pages that ask for them."""

from __future__ import annotations

import functools
import math
import os
import signal
import threading
import time
from collections.abc import Callable, Mapping

import msgspec
import numpy as np
import pytest

from aftdeck.errors import InputError
from aftdeck.law_change import Progress
from aftdeck.processes import BACKGROUND
from aftdeck.scenario.light import conditions
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.run import Simulation
from aftdeck.station.conversion.polygons_of import HALF_WIDTH, PolygonPictures, Shot, no_polygons
from aftdeck.station.messages import from_page, kinds, to_page
from aftdeck.station.messages.frame import Frame as FrameMessage
from aftdeck.station.server.pages import GATHER_S
from aftdeck.station.session.painter import AT_ONCE, ENDED, Painter
from aftdeck.station.session.painting import LitFrame, Painting, Sheet, Wanted
from aftdeck.station.session.session import Session
from aftdeck.visual.diagram import sheet
from aftdeck.visual.picture import picture_of
from aftdeck.visual.scene import Eye, VisualScene
from tests.loaded import scenario
from tests.station.pages import Page, Station, served, text_of, until
from tests.waits import WAIT_S

NAME = "concept-1972-script"
SIZE = (600, 400)
ASPECT = SIZE[0] / SIZE[1]
STEP = 70
"""Number of the frame's step in a session, after a restart."""
[LIGHT, *_] = conditions()


@functools.cache
def frame() -> Frame:
    sim = Simulation(scenario(NAME))
    for _ in range(20):
        latest = sim.step(None)
    return latest


def lit() -> LitFrame:
    return LitFrame(frame(), LIGHT, STEP)


@functools.cache
def pictures() -> PolygonPictures:
    return PolygonPictures(scenario(NAME))


# --- content ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("camera", ["A", "F", "W", "AFT"])
def test_polygons_are_those_of_the_visual_scene(camera: str) -> None:
    message = pictures().of(frame(), Shot(camera), ASPECT, LIGHT, STEP)
    drawn = picture_of(VisualScene(scenario(NAME)), frame(), camera, SIZE, "1972", LIGHT)
    corners = np.frombuffer(message.corners, np.uint8)
    assert (message.step, message.camera, message.text) == (STEP, camera, "")
    assert corners.tolist() == np.diff(drawn.begins).tolist()
    assert list(message.greys) == drawn.colours[:, 0].tolist()
    assert len(set(message.greys)) <= 8
    points = np.frombuffer(message.points, "<i2").reshape(-1, 2) / HALF_WIDTH
    middle = np.array(SIZE) / 2.0
    assert np.abs(middle + points * middle[0] - drawn.points).max() < 0.02


def test_picture_follows_the_light_condition() -> None:
    night = next(condition for condition in conditions() if condition.name == "night")
    day, dark = (sum(pictures().of(frame(), Shot("A"), ASPECT, light, STEP).greys) for light in (LIGHT, night))
    assert dark < day


def test_camera_inside_a_body_has_a_sentence(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = VisualScene(scenario(NAME))
    aim = scene.aim(frame(), "A", ASPECT)
    [cluster] = [one for one in scene.clusters.clusters if one.part == "lower boom"][:1]
    pose = scene.frames_at(frame())[scene.clusters.frames.index(cluster.frame)]
    inside = pose[:3] + pose[3:].reshape(3, 3) @ cluster.body.points.mean(axis=0)
    monkeypatch.setattr(VisualScene, "aim", lambda *_: aim._replace(position=inside, hidden=frozenset()))
    message = pictures().of(frame(), Shot("A"), ASPECT, LIGHT, STEP)
    assert message.text == "No picture: camera A is inside lower boom or touches it."
    assert (message.step, message.points, message.corners, message.greys) == (STEP, b"", b"", b"")


# --- painter ----------------------------------------------------------------------------------------------------------


class Counted(Painting):
    """Pictures without polygons, drawn here, which count how often each camera was drawn."""

    def __init__(self, _: Scenario) -> None:
        self.count: dict[str, int] = {}

    def wait(self, tell: Callable[[Progress], None]) -> None:
        """Return at once."""

    def pictures(self, wanted: Wanted) -> dict[Shot, bytes]:
        self.count |= {shot.camera: self.count.get(shot.camera, 0) + 1 for shot in wanted.aspects}
        return {
            shot: msgspec.json.encode(no_polygons(shot.camera, f"{aspect:g} {wanted.lit.light.name}", wanted.lit.step))
            for shot, aspect in wanted.aspects.items()
        }

    def close(self) -> None:
        """Do nothing."""


def drawn(painter: Painter) -> Mapping[str, to_page.Polygons]:
    decode = msgspec.json.Decoder(to_page.Polygons).decode
    return {shot.camera: decode(picture) for shot, picture in painter.drawn.items()}


def test_without_a_wanted_picture_nothing_is_computed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Painting, "__init__", lambda *_: pytest.fail("a picture is prepared"))
    session = Session(scenario())
    session.painter.want({})
    for _ in range(5):
        session.step()
    assert session.painter.drawn == {}
    session.close()


def test_painter_draws_the_wanted_cameras_of_the_newest_frame() -> None:
    painter = Painter(scenario(NAME), Counted)
    painter.want({Shot("A"): 1.5})
    painter.show(lit())
    until(lambda: drawn(painter)["A"].step == STEP, "a picture")
    assert drawn(painter)["A"].text == f"1.5 {LIGHT.name}"
    painter.want({Shot("B"): 1.0})
    painter.show(lit())
    until(lambda: set(painter.drawn) == {Shot("B")}, "a picture of the other camera")
    painter.close()


def test_the_time_until_the_first_picture_is_told() -> None:
    go_on = threading.Event()

    class Compiling(Counted):
        def wait(self, tell: Callable[[Progress], None]) -> None:
            tell(Progress(0.5, 12.0))
            go_on.wait(WAIT_S)

    painter = Painter(scenario(NAME), Compiling)
    painter.want({Shot("A"): 1.5})
    until(lambda: drawn(painter)["A"].share == 0.5, "progress")
    assert "12 s" in drawn(painter)["A"].text
    go_on.set()
    painter.show(lit())
    until(lambda: drawn(painter)["A"].share is None, "a picture")
    painter.close()


def test_more_cameras_than_are_drawn_at_once_are_drawn_in_turn() -> None:
    made: list[Counted] = []

    def make(of: Scenario) -> Counted:
        made.append(Counted(of))
        return made[0]

    painter = Painter(scenario(NAME), make)
    names = list("ABCDEFGH")[: AT_ONCE + 2]
    rounds = 0

    def notified() -> None:
        nonlocal rounds
        rounds += 1

    painter.notify = notified
    painter.want(dict.fromkeys(map(Shot, names), 1.0))
    for k in range(3):
        painter.show(lit())
        until(lambda k=k: rounds > k, "a round of pictures")  # type: ignore[misc]
    painter.close()
    assert made[0].count == dict.fromkeys(names, 2)


def test_process_draws_the_same_pictures_and_sheets() -> None:
    painting = Painting(scenario(NAME))
    painting.wait(lambda _: None)
    assert os.getpriority(os.PRIO_PROCESS, painting.pid) == os.getpriority(os.PRIO_PROCESS, 0) + BACKGROUND
    shots = {Shot("A"): ASPECT, Shot("F"): 1.0}
    there = painting.pictures(Wanted(lit(), shots))
    here = {shot: pictures().of(frame(), shot, aspect, LIGHT, STEP) for shot, aspect in shots.items()}
    assert there == {shot: msgspec.json.encode(picture) for shot, picture in here.items()}
    title = scenario(NAME).title
    svg = painting.sheet(Sheet(lit(), "A"))
    assert svg.decode() == sheet(VisualScene(scenario(NAME)), frame(), "A", LIGHT, title)
    with pytest.raises(InputError, match="no camera is called 'A9'"):
        painting.sheet(Sheet(lit(), "A9"))
    painting.close()
    with pytest.raises(EOFError):
        painting.sheet(Sheet(lit(), "A"))


def test_closing_ends_a_process_that_compiles() -> None:
    started: list[Painting] = []

    def start(of: Scenario) -> Painting:
        started.append(Painting(of))
        return started[0]

    painter = Painter(scenario(NAME), start)
    painter.want({Shot("A"): 1.5})
    until(lambda: painter._painting is not None, "the process")
    painter.close()
    assert started[0]._process._child.process.returncode is not None
    assert painter._thread is not None
    painter._thread.join(WAIT_S)
    assert not painter._thread.is_alive() and painter.failure == ""


def test_process_that_ends_is_reported() -> None:
    painter = Painter(scenario(NAME))
    painter.want({Shot("A"): 1.0})
    until(lambda: painter._painting is not None, "the process")
    assert painter._painting is not None
    os.kill(painter._painting.pid, signal.SIGKILL)
    until(lambda: drawn(painter)["A"].text == f"The look of 1972 has failed: {ENDED}", "the reason")
    painter.close()


def test_failure_of_the_painter_is_shown() -> None:
    def start(_: Scenario) -> Painting:
        raise ValueError("no clusters")

    painter = Painter(scenario(NAME), start)
    painter.want({Shot("A"): 1.0})
    until(lambda: drawn(painter)["A"].text == "The look of 1972 has failed: no clusters", "the reason")
    painter.want({Shot("B"): 1.0})
    assert set(painter.drawn) == {Shot("B")}


# --- pages ------------------------------------------------------------------------------------------------------------


def ask(page: Page, *cameras: str, aspect: float = 1.3) -> None:
    wanted = tuple(from_page.PolygonPicture(camera, aspect) for camera in cameras)
    page.send(from_page.ShowPolygons(page.next_seq(), wanted))


def test_pages_receive_the_pictures_that_they_ask_for() -> None:
    with served(Session(scenario(NAME), demo=True)) as station, station.page() as operator, station.page() as observer:
        ask(observer, "A", "F")
        ticks = [
            observer.wait_for(to_page.Polygons, lambda one, camera=camera: one.camera == camera and one.text == "").step  # type: ignore[misc]
            for camera in ("A", "F", "A")
        ]
        assert ticks == sorted(ticks)
        assert 0 < ticks[0] < ticks[2]
        with station.unannounced() as window:
            window.send(from_page.Hello(kinds.PROTOCOL, shows=True))
            ask(window, "W")
            assert window.wait_for(to_page.Polygons, lambda one: one.text == "").camera == "W"
        ask(observer)
        until(lambda: station.session.painter.drawn == {}, "no page shows a picture")
        last = operator.wait_for(FrameMessage).tick
        message: to_page.FromServer = operator.receive()
        while not (isinstance(message, FrameMessage) and message.tick > last + 5):
            assert not isinstance(message, to_page.Polygons)
            message = operator.receive()


def test_camera_is_drawn_once_for_all_pages(station: Station, monkeypatch: pytest.MonkeyPatch) -> None:
    wanted: list[Mapping[Shot, float]] = []
    monkeypatch.setattr(station.session.painter, "want", wanted.append)
    with station.page() as first:
        with station.page() as second:
            ask(first, "A", "B", aspect=1.5)
            until(lambda: wanted[-1:] == [{Shot("A"): 1.5, Shot("B"): 1.5}], "the pictures of one page")
            ask(second, "A", "C", aspect=0.7)
            until(lambda: wanted[-1] == {Shot("A"): 0.7, Shot("B"): 1.5, Shot("C"): 0.7}, "the pictures of both pages")
        until(lambda: wanted[-1] == {Shot("A"): 1.5, Shot("B"): 1.5}, "the pictures of the page that is left")
    until(lambda: wanted[-1] == {}, "no pictures")


def test_requests_of_a_flood_take_effect_together(station: Station, monkeypatch: pytest.MonkeyPatch) -> None:
    wanted: list[Mapping[Shot, float]] = []
    monkeypatch.setattr(station.session.painter, "want", wanted.append)
    begun = time.monotonic()
    with station.page() as page:
        for k in range(200):
            ask(page, "AB"[k % 2], aspect=1.0 + 0.01 * k)
        until(lambda: wanted[-1:] == [{Shot("B"): 2.99}], "the last request")
        elapsed = time.monotonic() - begun
    assert len(wanted) <= 1 + elapsed / GATHER_S


EYE = from_page.FreeEye((1.0, 2.0, -9.0), (0.0, 0.6, 0.8), (1.0, 0.0, 0.0), 1.0)
BLIND = msgspec.structs.replace(EYE, up=EYE.ahead)


@pytest.mark.slow
def test_an_engineering_view_is_drawn_from_the_eye_of_its_page(station: Station) -> None:
    """Two pages direct the same view, and each has its own picture."""
    with station.page() as first, station.page() as second:
        points = []
        for page, eye in ((first, EYE), (second, msgspec.structs.replace(EYE, field_of_view=0.5))):
            page.send(from_page.ShowPolygons(page.next_seq(), (from_page.PolygonPicture("ENG", 1.5, eye),)))
        for page in (first, second):
            points.append(page.wait_for(to_page.Polygons, lambda one: one.text == "" and one.camera == "ENG").points)
    assert points[0] != points[1]


def test_an_eye_at_the_place_of_a_camera_has_the_picture_of_the_camera() -> None:
    scene = VisualScene(scenario(NAME))
    aims = [scene.aim(frame(), camera.name, ASPECT) for camera in scene.cameras.values() if camera.pane is None]
    aim = next(one for one in aims if not one.hidden)
    eye = Eye(tuple(aim.position), tuple(aim.axes[2]), tuple(-aim.axes[1]), 2.0 * math.atan(aim.wide))
    free, fixed = (pictures().of(frame(), shot, ASPECT, LIGHT, STEP) for shot in (Shot("ENG", eye), Shot(aim.name)))
    assert len(fixed.greys) > 50
    assert (free.corners, free.greys) == (fixed.corners, fixed.greys)
    assert np.abs(np.frombuffer(free.points, "<i2") - np.frombuffer(fixed.points, "<i2").astype(int)).max() <= 1


@pytest.mark.parametrize(
    ("message", "reason"),
    [
        (from_page.ShowPolygons(0, (from_page.PolygonPicture("X9", 1.0),)), "unknown camera 'X9'"),
        (from_page.ShowPolygons(0, (from_page.PolygonPicture("A", 0.1),)), "Expected `float` >= 0.5"),
        (from_page.ShowPolygons(0, (from_page.PolygonPicture("A", 9.0),)), "Expected `float` <= 4.0"),
        (from_page.ShowPolygons(0, (from_page.PolygonPicture("A" * 65, 1.0),)), "length <= 64"),
        (from_page.ShowPolygons(0, (from_page.PolygonPicture("A", 1.0),) * 65), "length <= 64"),
        (from_page.ShowPolygons(0, (from_page.PolygonPicture("A", 1.0, EYE),)), "unknown engineering view 'A'"),
        (from_page.ShowPolygons(0, (from_page.PolygonPicture("ENG", 1.0, BLIND),)), "have to differ"),
    ],
)
def test_invalid_pictures_are_rejected(shared: Station, message: from_page.ShowPolygons, reason: str) -> None:
    with shared.page() as page:
        page.send(message)
        assert reason in page.rejection()


def test_longest_message_is_short() -> None:
    wanted = from_page.PolygonPicture("N" * 64, 1.0 / 1.7)
    assert len(text_of(from_page.ShowPolygons(2**53 - 1, (wanted,) * 4))) < 600

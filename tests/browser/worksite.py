"""A station whose worksite is as a test says: its frames pass through here, and the page's commands end here."""

from __future__ import annotations

import json
from typing import Any

import msgspec
from playwright.sync_api import Page, WebSocketRoute

from aftdeck.simulation.frame import WayOut
from aftdeck.station.messages import kinds
from aftdeck.station.messages.frame import ClosestPoints
from aftdeck.station.messages.welcome import SeatInfo, StandInfo, WorkInfo
from aftdeck.worksite.conditions import Condition, Unit
from aftdeck.worksite.report import Cargo, Hand, Near, Rows, Work
from aftdeck.worksite.watch.alarm import CLEAR, level_of
from tests.browser.flight import WAIT_MS, Flight

Message = dict[str, Any]

LOOK_MS = 20
"""Time between two looks at what the page asked for [ms]."""
HERE, THERE = (2.0, -1.2, 1.2), (2.2, -1.6, 0.9)
"""Two points over the bay that camera B sees."""
AT_REST = (0.0, 0.0, 0.0)
UPRIGHT: Rows = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))

SNARES = Hand("stop", 1.0, None, 0.0, ("EXTEND", "OPEN"), "auto", "off")
PRONG = Hand("close", 0.6, 0.3, None, (), "auto", "off")
PARTS: tuple[kinds.ProblemPart, ...] = ("full problem", "acquisition", "extraction", "manoeuvring")


def near(a: str, b: str, clearance: float, closing: float = 0.0, essential: bool = False) -> Near:
    """Two watched parts between the two points."""
    normal = (0.3714, -0.7428, -0.5571) if clearance > 0.0 else (0.0, 0.0, 0.0)
    return Near(a, b, clearance, closing, HERE, THERE, normal, 0.0, essential)


def closest_points(pair: Near) -> ClosestPoints:
    """The same pair as it is drawn: its points are given in the scene."""
    x, y, z = ((p + q) / 2.0 for p, q in zip(pair.point_a, pair.point_b, strict=True))
    return ClosestPoints(pair.point_a, pair.point_b, (x, y, z), pair.normal)


def condition(name: str, value: float, limit: float, text: str, unit: Unit = "m") -> Condition:
    """A value that is allowed up to a limit."""
    return Condition(name, value <= limit, value, limit, unit, limit - value, text)


def info(hand: Any = "snares", stand: bool = False) -> WorkInfo:
    """A worksite with two payloads and a seat."""
    telescope = StandInfo(2.4, 5.5, 0.3) if stand else None
    return WorkInfo(hand, telescope, ("payload", "free flyer"), (SeatInfo("bay", "Cargo bay"),), PARTS, 0.6, 0.15)


def work(**changes: Any) -> Work:
    """A worksite where nothing is near and nothing moves, but for the changes."""
    cargo = (
        Cargo("payload", HERE, UPRIGHT, AT_REST, False, "bay"),
        Cargo("free flyer", HERE, UPRIGHT, (0.012, 0.0, 0.0), False, ""),
    )
    still = Work(
        task=1,
        nearest=None,
        clearance_level=CLEAR,
        contacts=(),
        arm_inhibit=False,
        finger_inhibit=False,
        inhibits=(),
        objective=None,
        conditions=(),
        hand=SNARES,
        stand=None,
        orbiter=AT_REST,
        orbiter_velocity=AT_REST,
        cargo=cargo,
        master=None,
    )
    return msgspec.structs.replace(still, **changes)


class Worksite:
    """What the page is told of the worksite, and what it asked for.

    Attributes:
        work: of every frame from now on.
        mode: of every frame from now on; empty: the station's own.
        ways_out: of every frame from now on.
        asked: every message of the page but its measurements, as decoded JSON.
    """

    def __init__(self, told: WorkInfo, now: Work) -> None:
        self.info, self.work = told, now
        self.mode = ""
        self.ways_out: tuple[WayOut, ...] = ()
        self.asked: list[Message] = []

    def stand_between(self, page: Page) -> None:
        """Passes everything between the page and its station, as changed."""
        page.route_web_socket("**/ws", self._connect)

    def last(self, kind: str) -> Message:
        """The page's last message of that type; empty where there is none."""
        return next((message for message in reversed(self.asked) if message["type"] == kind), {})

    def until_asked(self, flight: Flight, kind: str, **fields: Any) -> None:
        """Waits until the page's last message of that type has these fields."""
        for _ in range(WAIT_MS // LOOK_MS):
            if fields.items() <= self.last(kind).items():
                return
            flight.page.wait_for_timeout(LOOK_MS)
        raise AssertionError(f"the page asked for {self.last(kind)}, not for {fields}")

    def _connect(self, socket: WebSocketRoute) -> None:
        server = socket.connect_to_server()

        def asked(text: str | bytes) -> None:
            message = json.loads(text)
            if message["type"] not in ("hello", "shown"):
                self.asked.append(message)
            if message["type"] in ("hello", "sticks", "restart"):
                server.send(text)

        socket.on_message(asked)
        server.on_message(lambda text: socket.send(self._changed(json.loads(text))))

    def _changed(self, message: Message) -> str:
        if message["type"] == "welcome":
            message["work"] = msgspec.to_builtins(self.info)
        if message["type"] == "frame":
            self._put_work(message)
            message["mode"] = self.mode or message["mode"]
        return json.dumps(message)

    def _put_work(self, frame: Message) -> None:
        """The worksite, and the lamp of its clearance as the station lights it."""
        near = self.work.nearest
        level = level_of(near.clearance, self.info.caution, self.info.warning) if near else CLEAR
        frame["work"] = msgspec.to_builtins(msgspec.structs.replace(self.work, clearance_level=level))
        frame["ways_out"] = msgspec.to_builtins(self.ways_out)
        display = frame["display"]
        display["gap"] = None if near is None else msgspec.to_builtins(closest_points(near))
        display["contacts"] = [msgspec.to_builtins(closest_points(pair)) for pair in self.work.contacts]
        display["orbiter"], display["orbiter_velocity"] = self.work.orbiter, self.work.orbiter_velocity
        display["fixture"] = display["to_fixture"] = None
        display["lamps"] = [lamp for lamp in display["lamps"] if lamp["name"] != "CLEARANCE"]
        if near and level != CLEAR:
            display["lamps"].append({"name": "CLEARANCE", "level": level, "text": f"{near.a} to {near.b}"})

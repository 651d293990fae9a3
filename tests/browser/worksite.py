"""The worksite of a test: it replaces the worksite in the frames for the page, and stores the messages of the page."""

from __future__ import annotations

import json
from typing import Any

import msgspec
from playwright.sync_api import Page, WebSocketRoute

from aftdeck.simulation.frame import WayOut
from aftdeck.station.messages import kinds
from aftdeck.station.messages.frame import ClosestPoints
from aftdeck.station.messages.welcome import SeatInfo, StandInfo, WorkInfo
from aftdeck.tuples import Rows
from aftdeck.worksite.conditions import Condition, Unit
from aftdeck.worksite.report import Cargo, Hand, Near, Work
from aftdeck.worksite.watch.alarm import CLEAR, level_of
from tests.browser.flight import WAIT_MS, Flight

Message = dict[str, Any]

POLL_MS = 20
"""Time between two checks of the messages of the page [ms]."""
POINT_A, POINT_B = (2.0, -1.2, 1.2), (2.2, -1.6, 0.9)
"""Two points above the bay that camera B sees."""
AT_REST = (0.0, 0.0, 0.0)
UPRIGHT: Rows = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))

SNARES = Hand("stop", 1.0, None, 0.0, ("EXTEND", "OPEN"), "auto", "off")
PRONG = Hand("close", 0.6, 0.3, None, (), "auto", "off")
PARTS: tuple[kinds.ProblemPart, ...] = ("full problem", "acquisition", "extraction", "manoeuvring")


def near(a: str, b: str, clearance: float, closing: float = 0.0, essential: bool = False) -> Near:
    """Return a monitored pair whose closest points are POINT_A and POINT_B."""
    normal = (0.3714, -0.7428, -0.5571) if clearance > 0.0 else (0.0, 0.0, 0.0)
    return Near(a, b, clearance, closing, POINT_A, POINT_B, normal, 0.0, essential)


def closest_points(pair: Near) -> ClosestPoints:
    """Return the closest points of a pair in the form that the page draws."""
    x, y, z = ((p + q) / 2.0 for p, q in zip(pair.point_a, pair.point_b, strict=True))
    return ClosestPoints(pair.point_a, pair.point_b, (x, y, z), pair.normal)


def condition(name: str, value: float, limit: float, text: str, unit: Unit = "m") -> Condition:
    """Return a condition that holds if `value` is at most `limit`."""
    return Condition(name, value <= limit, value, limit, unit, limit - value, text)


def info(hand: Any = "snares", stand: bool = False) -> WorkInfo:
    """Return a worksite with two payloads and a berth."""
    telescope = StandInfo(2.4, 5.5, 0.3) if stand else None
    return WorkInfo(
        hand,
        ("arm.wrist_roll",),
        telescope,
        ("payload", "free flyer"),
        (SeatInfo("bay", "Cargo bay"),),
        PARTS,
        0.6,
        0.15,
    )


def work(**changes: Any) -> Work:
    """Return a worksite with these fields changed. No parts are close to each other; only the free flyer moves."""
    cargo = (
        Cargo("payload", POINT_A, UPRIGHT, AT_REST, False, "bay"),
        Cargo("free flyer", POINT_A, UPRIGHT, (0.012, 0.0, 0.0), False, ""),
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
    """Worksite that the page receives, and the messages that the page sends.

    Attributes:
        work: worksite of every later frame.
        mode: mode of every later frame; if empty, the mode of the station.
        ways_out: escape directions of every later frame.
        sent: all messages of the page except `hello` and `shown`, as decoded JSON.
    """

    def __init__(self, info: WorkInfo, now: Work) -> None:
        self.info, self.work = info, now
        self.mode = ""
        self.ways_out: tuple[WayOut, ...] = ()
        self.sent: list[Message] = []

    def intercept(self, page: Page) -> None:
        """Route all messages between the page and the station through this worksite."""
        page.route_web_socket("**/ws", self._connect)

    def last(self, kind: str) -> Message:
        """Return the page's last message of this type, or an empty one."""
        return next((message for message in reversed(self.sent) if message["type"] == kind), {})

    def until_sent(self, flight: Flight, kind: str, **fields: Any) -> None:
        """Wait until the page's last message of this type has these fields."""
        for _ in range(WAIT_MS // POLL_MS):
            if fields.items() <= self.last(kind).items():
                return
            flight.page.wait_for_timeout(POLL_MS)
        raise AssertionError(f"the page sent {self.last(kind)}, not {fields}")

    def _connect(self, socket: WebSocketRoute) -> None:
        server = socket.connect_to_server()

        def receive(text: str | bytes) -> None:
            message = json.loads(text)
            if message["type"] not in ("hello", "shown"):
                self.sent.append(message)
            if message["type"] in ("hello", "sticks", "restart"):
                server.send(text)

        socket.on_message(receive)
        server.on_message(lambda text: socket.send(self._changed(json.loads(text))))

    def _changed(self, message: Message) -> str:
        if message["type"] == "welcome":
            message["work"] = msgspec.to_builtins(self.info)
        if message["type"] == "frame":
            self._put_work(message)
            message["mode"] = self.mode or message["mode"]
        return json.dumps(message)

    def _put_work(self, frame: Message) -> None:
        """Put the worksite into a frame, with the CLEARANCE lamp that the station would light."""
        near = self.work.nearest
        level = level_of(near.clearance, self.info.caution, self.info.warning) if near else CLEAR
        frame["work"] = msgspec.to_builtins(msgspec.structs.replace(self.work, clearance_level=level))
        frame["ways_out"] = msgspec.to_builtins(self.ways_out)
        display = frame["display"]
        display["gap"] = None if near is None else msgspec.to_builtins(closest_points(near))
        display["contacts"] = [msgspec.to_builtins(closest_points(pair)) for pair in self.work.contacts]
        display["orbiter"], display["orbiter_velocity"] = self.work.orbiter, self.work.orbiter_velocity
        display["to_go"] = display["task"] = None
        display["lamps"] = [lamp for lamp in display["lamps"] if lamp["name"] != "CLEARANCE"]
        if near and level != CLEAR:
            display["lamps"].append({"name": "CLEARANCE", "level": level, "text": f"{near.a} to {near.b}"})

"""The page with another number of joints than the built-in arms have: a station's messages are changed on their way."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from typing import Any

import pytest
from playwright.sync_api import Page, WebSocketRoute, expect

from aftdeck.tuples import MOST_JOINTS
from tests.browser.conftest import NARROW, SIZES, OpenPage
from tests.joints import BY_JOINT

OVERFULL = """() => [...document.querySelectorAll('.desk > *')]
    .filter((group) => group.scrollHeight > group.clientHeight + 1).map((group) => group.className)"""
"""Names of the groups of the desk whose content does not fit."""


def with_joints(joints: int) -> Callable[[Page], None]:
    """Return a function that lets a page show an arm with this number of joints."""

    def fit(values: list[Any]) -> list[Any]:
        return (values * 2)[:joints]

    def changed(text: str) -> str:
        message = json.loads(text)
        if message["type"] == "welcome":
            infos = [dict(info, label=f"Joint {k}") for k, info in enumerate(fit(message["joints"]))]
            message["joints"] = [dict(info, stick=None) if k >= 6 else info for k, info in enumerate(infos)]
            for payload in message["payloads"]:
                payload |= {name: fit(payload[name]) for name in ("coarse", "vernier")}
        if message["type"] == "frame":
            message |= {name: fit(message[name]) for name in BY_JOINT}
            if message["work"]["master"] is not None:
                message["work"]["master"] = fit(message["work"]["master"])
        return json.dumps(message)

    def route(page_end: WebSocketRoute) -> None:
        server = page_end.connect_to_server()
        page_end.on_message(server.send)
        server.on_message(lambda message: page_end.send(changed(message) if isinstance(message, str) else message))

    return lambda page: page.route_web_socket("**/*", route)


@pytest.mark.slow
@pytest.mark.parametrize("joints", [1, 5, 7, MOST_JOINTS])
def test_joints_and_their_switches_fit_the_page(open_page: OpenPage, joints: int) -> None:
    flight = open_page(prepare=with_joints(joints)).from_the_start()
    for mode, group in (("SINGLE", ".joints"), ("MASTER", ".master-arm")):
        flight.enter(mode)
        rows = flight.page.locator(f"{group} tbody tr")
        expect(rows).to_have_count(joints)
        expect(rows.last.locator("th")).to_have_text(f"Joint {joints - 1}")
        expect(rows.last.locator(".angle")).to_have_text(re.compile(r"[+−]\d+\.\d"))
        for width, height in [*SIZES, *NARROW]:
            flight.resize(width, height)
            assert flight.page.evaluate(OVERFULL) == [], (mode, width, height)
        flight.resize(*SIZES[0])

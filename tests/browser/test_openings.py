"""Opening pictures: each shows the hand or the target, and the sticks are not crossed."""

from __future__ import annotations

import math
from typing import Any

import pytest

from aftdeck.scenario.load import built_in, load_scenario
from aftdeck.task.step_cameras import CROSSED
from tests.browser.conftest import OpenPage
from tests.browser.flight import FLIES, Flight, shows

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.long]

SCENARIO = "concept-1972"

MOST = CROSSED + 0.01
"""Greatest angle between sticks and picture [rad]; the page rounds it."""

MONITORS = "[...document.querySelectorAll('.monitor .picture .name b')].map((name) => name.textContent).join()"
"""JavaScript: names of the cameras on the monitors."""


def opened(flight: Flight, label: str) -> list[str]:
    """Check both monitors' pictures; return the names of their cameras."""
    views: dict[str, Any] = flight.script("window.__aftdeck.views")
    shown = [names[0] for names in views["monitors"]]
    assert len(set(shown)) == 2, label
    surveyed = {view["camera"]: view for view in views["cameras"]}
    for name in shown:
        shows_at = surveyed[name]["shows"]
        assert max(shows_at[subject] for subject in ("tip", "payload", "target")) > 0, f"{label}: {name} {shows_at}"
        assert surveyed[name]["turned"] <= MOST, f"{label}: {name} {math.degrees(surveyed[name]['turned']):.0f}°"
    return shown


def test_every_scenario_opens_on_hand_or_target_with_sticks_that_are_not_crossed(open_page: OpenPage) -> None:
    flight = open_page()
    flight.until(f"{FLIES} && window.__aftdeck.frames > 2")
    opened(flight, SCENARIO)
    for name in built_in():
        if name != SCENARIO:
            flight.choose(load_scenario(name).title)
            opened(flight, name)


def test_initialisation_shows_the_best_pair_and_restart_offers_one(open_page: OpenPage) -> None:
    flight = open_page()
    flight.choose(load_scenario(SCENARIO).title)
    for part, task in (("manoeuvring", 3), ("extraction", 2)):
        before = flight.script(MONITORS)
        flight.press_key("Initialise")
        flight.press_key(part)
        flight.until(f"frame.work.task === {task} && {MONITORS} !== '{before}'")
        opened(flight, part)
    flight.press("6", "x", "8", "x")
    flight.until(shows(1, "H"))
    flight.press_key("Restart")  # the payload is in its berth again, and the monitors keep their cameras
    flight.page.locator(".pair-offer").wait_for(state="visible")
    assert flight.script(MONITORS) == "F,H"
    flight.press("NumpadAdd")
    flight.page.locator(".pair-offer").wait_for(state="hidden")
    opened(flight, "restart")

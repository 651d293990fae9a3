"""A policy flies in the station, the page shows it, and a key takes over."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.browser.conftest import OpenPage, running_station
from tests.browser.flight import FLIES

pytestmark = [pytest.mark.browser, pytest.mark.slow]

POLICY = Path(__file__).resolve().parents[2] / "examples" / "learn" / "reach.npz"


@pytest.fixture(scope="module")
def station() -> Iterator[str]:
    with running_station("--policy", str(POLICY)) as address:
        yield address


def test_policy_flies_until_a_key_moves_a_stick(open_page: OpenPage) -> None:
    flight = open_page()
    start = flight.until(f"{FLIES} && frame.display.autopilot === 'policy'").display
    assert start.to_go is not None and start.task is not None
    flight.until("frame.translation.some((deflection) => Math.abs(deflection) > 0.1)")
    flight.until("document.querySelector('.desk').textContent.includes('policy flies')")
    nearer = f"frame.display.to_go.distance < {start.to_go.distance - 0.3}"
    flight.until(f"{nearer} || frame.display.task.at > {start.task.at}")
    flight.hold("s")
    flight.until("frame.display.autopilot === null && frame.translation[0] < -0.9")
    flight.until("!document.querySelector('.desk').textContent.includes('policy flies')")
    flight.release("s")

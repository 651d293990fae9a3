"""Fixtures of the tests of the station."""

from __future__ import annotations

import math
from collections.abc import Iterator

import pytest

from aftdeck.station.core import page_inputs
from aftdeck.station.server import guard, page
from aftdeck.station.session.session import Session
from tests.loaded import scenario
from tests.station.direct_pages import DirectStation
from tests.station.pages import Station, served


@pytest.fixture(autouse=True)
def patient_station(monkeypatch: pytest.MonkeyPatch) -> None:
    """Disable the time limits for sticks and hello, so that a slow machine fails no test; shorten the penalty.

    Tests of these limits set them themselves.
    """
    monkeypatch.setattr(page_inputs, "SILENCE", math.inf)
    monkeypatch.setattr(page, "HELLO_WITHIN", 1000.0)
    monkeypatch.setattr(guard, "PENALTY", 0.1)


@pytest.fixture
def station() -> Iterator[Station]:
    with served(Session(scenario())) as station:
        yield station


@pytest.fixture(scope="module")
def shared() -> Iterator[Station]:
    """Station shared by all tests that do not move the arm."""
    with served(Session(scenario())) as station:
        yield station


@pytest.fixture
def direct() -> DirectStation:
    """Station without a server, for tests that need no socket."""
    return DirectStation()

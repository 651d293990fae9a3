"""What the tests of the station share."""

from __future__ import annotations

import math
from collections.abc import Iterator

import pytest

from aftdeck.station.server import page
from aftdeck.station.session import page_inputs
from aftdeck.station.session.session import Session
from tests.station.pages import Station, scenario, served


@pytest.fixture(autouse=True)
def patient_station(monkeypatch: pytest.MonkeyPatch) -> None:
    """A station that waits for its pages: sticks stand where a test last put them, however slowly it goes on.

    The tests of silent sticks and of pages that say no hello set how long the station waits.
    """
    monkeypatch.setattr(page_inputs, "SILENCE", math.inf)
    monkeypatch.setattr(page, "HELLO_WITHIN", 1000.0)


@pytest.fixture
def station() -> Iterator[Station]:
    with served(Session(scenario())) as station:
        yield station


@pytest.fixture(scope="module")
def shared() -> Iterator[Station]:
    """One station for all the tests that leave the arm where it stands."""
    with served(Session(scenario())) as station:
        yield station

"""What the tests of the station share."""

from __future__ import annotations

import math

import pytest

from aftdeck.station.server import page
from aftdeck.station.session import session


@pytest.fixture(autouse=True)
def patient_station(monkeypatch: pytest.MonkeyPatch) -> None:
    """A station that waits for its pages: sticks stand where a test last put them, however slowly it goes on.

    The tests of silent sticks and of pages that say no hello set how long the station waits.
    """
    monkeypatch.setattr(session, "SILENCE", math.inf)
    monkeypatch.setattr(page, "HELLO_WITHIN", 1000.0)

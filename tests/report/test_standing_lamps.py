"""Lamps that are lit since the start of a run, which raise no alarm."""

from __future__ import annotations

import msgspec
import pytest

from aftdeck.report.lamps import Lamp, StandingLamps
from aftdeck.station.messages.frame import Frame
from aftdeck.station.session.session import Session
from tests.loaded import scenario

NEAR, FAR = Lamp("CLEARANCE", "caution", "a to b"), Lamp("CLEARANCE", "warning", "a to b")
SOFT = Lamp("SOFT STOP", "caution", "elbow")


def test_a_lamp_stands_until_it_is_off_or_rises() -> None:
    standing = StandingLamps()
    shown = [standing.marked(lamps) for lamps in ((NEAR, SOFT), (NEAR,), (FAR, SOFT), (NEAR,))]
    assert [[lamp.standing for lamp in lamps] for lamps in shown] == [[True, True], [True], [False, False], [False]]


def test_a_lamp_with_another_cause_does_not_stand() -> None:
    standing = StandingLamps()
    texts = ("elbow 0.12, wrist 0.20", "elbow 0.10", "elbow 0.09, shoulder 0.3", "wrist 0.2")
    shown = [standing.marked((Lamp("SINGULAR", "caution", text),))[0].standing for text in texts]
    assert shown == [True, True, False, False]


@pytest.mark.parametrize("name", ["uncradle", "singular", "sts-400-closed", "srms-berth"])
def test_no_run_begins_with_an_alarm(name: str) -> None:
    """Some scenarios begin near parts, stops or singularities: their lamps are lit, but all of them stand."""
    session = Session(scenario(name))
    lit = 0
    for _ in range(5):
        session.step()
        lamps = msgspec.json.decode(session.newest, type=Frame).display.lamps
        assert all(lamp.standing for lamp in lamps if lamp.level != "info")
        lit += len(lamps)
    assert (lit > 0) == (name != "srms-berth")
    session.close()

"""Lighting: the page in control sets it, all pages get it, and recordings and playback keep it."""

from __future__ import annotations

import itertools
from pathlib import Path

import msgspec
import pytest

from aftdeck.errors import CommandError
from aftdeck.recording.reader import Recording
from aftdeck.recording.records import LightRecord
from aftdeck.recording.replay import verify
from aftdeck.scenario.light import Lighting, LockedExposure
from aftdeck.station.messages import from_page
from aftdeck.station.playback.store import PlaybackStore
from tests.loaded import scenario
from tests.station.flying import flying, shown, step_until, steps
from tests.station.pages import text_of

NIGHT = Lighting("night", ("end effector",), (LockedExposure("B", 1.25),))

_from_page: msgspec.json.Decoder[from_page.FromPage] = msgspec.json.Decoder(from_page.FromPage)


def test_restart_sets_the_scenarios_lighting_again() -> None:
    own = scenario().lighting
    with flying() as session:
        assert shown(session).display.lighting == own
        session.accept(from_page.SetLight(0, NIGHT))
        step_until(session, lambda frame: frame.display.lighting == NIGHT, "night")
        (line,) = [event.text for event in session.log.since(0) if event.kind == "light"]
        assert "night" in line and "end effector" in line
        session.accept(from_page.Restart(1))
        assert step_until(session, lambda frame: frame.tick == 1, "the first instant again").display.lighting == own


def test_lighting_can_be_set_while_the_script_runs() -> None:
    with flying(demo=True) as session:
        session.accept(from_page.SetLight(0, NIGHT))
        assert step_until(session, lambda frame: frame.display.lighting == NIGHT, "night").by == "script"


@pytest.mark.parametrize(
    ("wrong", "part"),
    [
        (Lighting("noon", ()), "condition 'noon'.* high sun"),
        (Lighting("night", ("bow",)), "lamp 'bow'.* fwd floods"),
        (Lighting("night", (), (LockedExposure("Q", 0.0),)), "camera 'Q'.* A, B"),
    ],
)
def test_unknown_condition_lamp_or_camera_is_rejected(wrong: Lighting, part: str) -> None:
    with flying() as session:
        with pytest.raises(CommandError, match=part):
            session.accept(from_page.SetLight(0, wrong))
        assert steps(session, 5).display.lighting == scenario().lighting


@pytest.mark.parametrize("stops", ["1e9", "-21", "NaN", '"much"'])
def test_exposure_out_of_range_is_rejected(stops: str) -> None:
    text = text_of(from_page.SetLight(0, NIGHT)).replace("1.25", stops)
    with pytest.raises(msgspec.DecodeError):
        _from_page.decode(text)


def test_recording_keeps_changes_of_the_lighting_for_playback(tmp_path: Path) -> None:
    own = scenario().lighting
    with flying(record=tmp_path) as session:
        steps(session, 20)
        session.accept(from_page.SetLight(0, NIGHT))
        first = step_until(session, lambda frame: frame.display.lighting == NIGHT, "night").tick
        session.accept(from_page.SetLight(1, NIGHT))
        steps(session, 300)  # into the recording's next block
        session.accept(from_page.SetLight(2, own))
        last = step_until(session, lambda frame: frame.display.lighting == own, "day").tick
        steps(session, 5)
    (path,) = tmp_path.glob("*.mcap")
    records = [message for message in Recording(path).messages() if isinstance(message, LightRecord)]
    assert [(record.condition, record.lamps) for record in records] == [
        ("high sun", own.lamps),
        ("night", ("end effector",)),
        ("high sun", own.lamps),
    ]
    assert [(lock.camera, lock.stops) for lock in records[1].locked] == [("B", 1.25)]
    assert verify(path).equal, "lighting is not an input"
    with PlaybackStore(path) as store:
        moments = itertools.chain.from_iterable(store.block(n) for n in range(store.blocks))
        lights = {moment.frame.tick: moment.frame.display.lighting for moment in moments}
    assert {tick for tick, light in lights.items() if light == NIGHT} == set(range(first, last))
    assert all(light == own for tick, light in lights.items() if not first <= tick < last)

"""Messages of a page about cameras: drive switches, and cameras on its monitors."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from pathlib import Path

import msgspec
import pytest

from aftdeck.errors import CommandError
from aftdeck.recording.reader import Recording
from aftdeck.recording.records import FrameRecord, Shown
from aftdeck.recording.replay import verify
from aftdeck.station.core import page_inputs
from aftdeck.station.core.page_inputs import SILENCE
from aftdeck.station.messages import from_page, kinds
from aftdeck.station.playback.store import PlaybackStore
from aftdeck.station.playback.verdict import CHECKING
from tests.station.flying import Flown, flying, shown, step_until, steps
from tests.station.pages import STILL, text_of

_from_page: msgspec.json.Decoder[from_page.FromPage] = msgspec.json.Decoder(from_page.FromPage)


def turn(seq: int, camera: str = "B", pan: float = 0.0, tilt: float = 0.0, zoom: float = 0.0) -> from_page.DriveCamera:
    return from_page.DriveCamera(seq, camera, pan, tilt, zoom, slow=False)


@pytest.fixture
def session() -> Iterator[Flown]:
    with flying() as flown:
        yield flown


def test_camera_pans_while_its_switch_is_set(session: Flown) -> None:
    before = shown(session).views
    session.accept(turn(0, pan=1.0))
    step_until(session, lambda frame: frame.views[1][0] > before[1][0] + 0.01, "B pans to the right")
    session.accept(turn(1))
    steps(session, 2)
    still = shown(session).views
    assert steps(session, 5).views == still
    assert [view for i, view in enumerate(still) if i != 1] == [view for i, view in enumerate(before) if i != 1]


def test_camera_stops_when_its_page_is_silent_too_long(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(page_inputs, "SILENCE", SILENCE)
    with flying() as session:
        session.accept(turn(0, tilt=1.0))
        session.now += 0.99 * SILENCE
        before = steps(session, 5).views[1][1]
        assert steps(session, 5).views[1][1] > before
        session.now += 0.02 * SILENCE
        still = steps(session, 2).views
        assert steps(session, 5).views == still


def test_camera_stops_when_its_page_leaves(session: Flown) -> None:
    session.accept(turn(0, zoom=1.0))
    steps(session, 2)
    session.set_unattended()
    frame = steps(session, 2)
    assert steps(session, 5).views == frame.views


def test_stop_stops_the_camera(session: Flown) -> None:
    session.accept(turn(0, zoom=1.0))
    steps(session, 2)
    session.accept(from_page.Stop(1))
    frame = steps(session, 2)
    assert steps(session, 5).views == frame.views


@pytest.mark.parametrize(
    ("message", "part"),
    [
        (turn(0, camera="Z", pan=1.0), r"'Z'.* A, B, C, D, KEEL, ELB, WR$"),
        (turn(0, camera="ENG", pan=1.0), r"'ENG'.* A, B, C, D, KEEL, ELB, WR$"),
        (turn(0, pan=1.5), r"pan.* -1 and 1"),
        (turn(0, tilt=math.nan), r"tilt.* -1 and 1"),
    ],
)
def test_invalid_camera_or_rate_is_rejected_with_what_is_allowed(
    session: Flown, message: from_page.DriveCamera, part: str
) -> None:
    with pytest.raises(CommandError, match=part):
        session.accept(message)


def test_camera_is_not_moved_while_the_script_runs() -> None:
    with flying(demo=True) as session:
        with pytest.raises(CommandError):
            session.accept(turn(0, pan=1.0))
        session.accept(from_page.Sticks(1, (0.5, 0.0, 0.0), STILL, 0.0))
        step_until(session, lambda frame: frame.by == "hand", "manual control")
        session.accept(turn(2, pan=1.0))


def test_unknown_camera_on_a_monitor_is_rejected(session: Flown) -> None:
    with pytest.raises(CommandError, match=r"'Q'.* A, B, C, D, KEEL, ELB, WR, AFT P"):
        session.accept(from_page.Shown(0, None, (("B",), ("A", "Q"))))


@pytest.mark.parametrize(
    "monitors",
    ['[["A"],["B"],["C"]]', '[["A","B","C"]]', "[[]]", f'[["{"A" * 65}"]]', '[["A"],[1]]', '"A"'],
)
def test_monitors_of_the_wrong_form_are_rejected(monitors: str) -> None:
    text = f'{{"type":"shown","seq":0,"latency_ms":null,"monitors":{monitors}}}'
    with pytest.raises(msgspec.ValidationError):
        _from_page.decode(text)


def test_longest_valid_messages_are_accepted() -> None:
    name = "A" * 64
    for message in (
        from_page.Shown(2**53 - 1, 1e6, ((name, name), (name, name))),
        turn(2**53 - 1, name, -1.0, -1.0, -1.0),
    ):
        text = text_of(message)
        assert len(text) < kinds.MAX_MESSAGE_BYTES / 4
        assert _from_page.decode(text) == message


def test_recording_keeps_changes_of_cameras_and_monitors_and_verifies(tmp_path: Path) -> None:
    with flying(record=tmp_path) as session:
        for seq, monitors in enumerate([(("B",), ("WR",)), (("B",), ("WR",)), (("A", "C"), ("WR",))]):
            session.accept(from_page.Shown(seq, 40.0, monitors))
            session.accept(turn(seq, pan=0.5, zoom=0.25))
            steps(session, 10)
        session.set_unattended()
        steps(session, 5)
    (path,) = tmp_path.glob("*.mcap")
    messages = list(Recording(path).messages())
    changes = [(m.mon_1, m.mon_2) for m in messages if isinstance(m, Shown)]
    assert changes == [(("B",), ("WR",)), (("A", "C"), ("WR",)), ((), ())]
    views = [m.views for m in messages if isinstance(m, FrameRecord)]
    assert len(views[0]) == 7
    assert views[-1][1].pan > views[0][1].pan
    assert verify(path).equal
    with PlaybackStore(path) as store:
        index = store.index(CHECKING)
        lanes = {lane.name: [stretch.label for stretch in lane.stretches] for lane in index.lanes}
        assert [pictured.monitors for pictured in index.pictures] == changes
        assert [label for label in lanes["MON 1"] if label] == ["B", "A | C"]
        assert [label for label in lanes["MON 2"] if label] == ["WR"]
        played = [
            moment.frame.views for moment in itertools.chain.from_iterable(store.block(n) for n in range(store.blocks))
        ]
        assert played[-1][1][0] > played[0][1][0]

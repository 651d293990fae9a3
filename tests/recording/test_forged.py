"""Forged recordings: no changed message passes as equal and unchanged."""

from __future__ import annotations

import functools
import itertools
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import msgspec
import pytest
from msgspec.structs import replace

import aftdeck
from aftdeck.errors import AftdeckError, RecordingError
from aftdeck.recording.chain import Chain, Declared, without_head
from aftdeck.recording.channels import DECLARED, VIEWED
from aftdeck.recording.codec import encode
from aftdeck.recording.index import Index
from aftdeck.recording.reader import Recording
from aftdeck.recording.records import CHANNELS, Closing, FrameRecord, Opening
from aftdeck.recording.replay import Verdict, verify
from aftdeck.recording.run import record
from aftdeck.recording.writer import Recorder
from aftdeck.simulation.inputs import Inputs
from tests.recording.flown import STEPS, bay, copied, messages, rewritten

pytestmark = pytest.mark.usefixtures("scenarios_built_once")
WALL = {"wall_s", "latency_ms"}
"""Fields of a frame that the simulation does not produce."""


def refused(path: Path) -> bool:
    """Return whether a file is damaged, or whether its verdict says that it differs or was changed."""
    try:
        return not verify(path).equal
    except AftdeckError:
        return True


def leaves(value: Any, where: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """Yield the place of every number, text, flag, null and empty list in a JSON value."""
    parts: list[tuple[Any, Any]] = []
    if isinstance(value, dict | list):
        parts = list(value.items() if isinstance(value, dict) else enumerate(value))
    if not parts:
        yield where
    for key, item in parts:
        yield from leaves(item, (*where, key))


def forged(value: Any, where: tuple[Any, ...]) -> Any:
    """Return a JSON value with another value at a place."""
    if where:
        key, rest = where[0], where[1:]
        if isinstance(value, dict):
            return {**value, key: forged(value[key], rest)}
        return [forged(item, rest) if k == key else item for k, item in enumerate(value)]
    match value:
        case bool():
            return not value
        case int():
            return value + 1
        case float():
            return value + 1e-6
        case str():
            return f"{value}x"
        case _:
            return [] if value is None else None


def with_one(source: Path, out: Path, topic: str, number: int, new: Callable[[bytes], bytes], rechained: bool) -> None:
    """Write a copy in which message `number` of a topic is changed."""
    seen = itertools.count()

    def edit(found: str, data: bytes) -> Iterator[bytes]:
        yield new(data) if found == topic and next(seen) == number else data

    copied(source, out, edit, rechained=rechained)


def as_json(change: Callable[[Any], Any]) -> Callable[[bytes], bytes]:
    return lambda data: msgspec.json.encode(change(msgspec.json.decode(data)))


def _constant(new: bytes, _: bytes) -> bytes:
    return new


def test_unchanged_copy_is_equal_and_unchanged(whole: Path, tmp_path: Path) -> None:
    copied(whole, tmp_path / "copy.mcap", lambda _, data: iter([data]))
    for path in (whole, tmp_path / "copy.mcap"):
        verdict = verify(path)
        assert verdict.equal and verdict.chain == "unbroken" and verdict.not_covered == ()
        assert {"/frames", "/closing", *VIEWED} == set(verdict.recomputed)
        assert set(CHANNELS) <= {*verdict.recomputed, *verdict.unchanged}


@pytest.mark.slow
@pytest.mark.parametrize("number", [0, STEPS - 1])
def test_every_changed_value_of_a_frame_is_found_even_with_a_new_chain(
    whole: Path, tmp_path: Path, number: int
) -> None:
    frames = [msgspec.json.decode(e.data) for e in Recording(whole).entries() if e.channel.topic == "/frames"]
    places = [where for where in leaves(frames[number]) if where[0] not in WALL]
    assert len(places) > 150
    passed = []
    for where in places[number % 2 :: 2]:  # one half in each of the two frames
        change = as_json(functools.partial(forged, where=where))
        with_one(whole, tmp_path / "forged.mcap", "/frames", number, change, rechained=True)
        if not refused(tmp_path / "forged.mcap"):
            passed.append(where)
    assert passed == []


@pytest.mark.slow
@pytest.mark.parametrize("topic", [topic for topic in CHANNELS if topic != "/frames"])
def test_every_changed_value_of_another_message_is_found(whole: Path, tmp_path: Path, topic: str) -> None:
    first = next(e.data for e in Recording(whole).entries() if e.channel.topic == topic)
    passed = []
    for where in leaves(msgspec.json.decode(first)):
        change = as_json(functools.partial(forged, where=where))
        with_one(whole, tmp_path / "forged.mcap", topic, 0, change, rechained=False)
        if not refused(tmp_path / "forged.mcap"):
            passed.append(where)
    assert passed == []


@pytest.mark.parametrize("field", sorted(WALL))
def test_changed_wall_clock_breaks_the_chain(whole: Path, tmp_path: Path, field: str) -> None:
    change = as_json(lambda frame: {**frame, field: 3.0})
    with_one(whole, tmp_path / "forged.mcap", "/frames", 5, change, rechained=False)
    verdict = verify(tmp_path / "forged.mcap")
    assert (verdict.equal, verdict.chain, verdict.different) == (False, "broken", 0)


@pytest.mark.slow
@pytest.mark.parametrize("topic", list(VIEWED))
def test_every_changed_message_for_viewers_is_found_even_with_a_new_chain(
    whole: Path, tmp_path: Path, topic: str
) -> None:
    first = next(e.data for e in Recording(whole).entries() if e.channel.topic == topic)
    for at in range(0, len(first), max(1, len(first) // 8)):
        flipped = bytearray(first)
        flipped[at] ^= 4
        with_one(
            whole, tmp_path / "forged.mcap", topic, 0, functools.partial(_constant, bytes(flipped)), rechained=True
        )
        verdict = verify(tmp_path / "forged.mcap")
        assert not verdict.equal and [change.channel for change in verdict.changes] == [topic]


@pytest.mark.parametrize("topic", ["/tf", "/log", "/scene", "/notes", "/shown"])
@pytest.mark.parametrize("copies", [0, 2])
def test_missing_and_additional_messages_are_found(whole: Path, tmp_path: Path, topic: str, copies: int) -> None:
    seen = itertools.count()

    def edit(found: str, data: bytes) -> Iterator[bytes]:
        yield from [data] * (copies if found == topic and next(seen) == 0 else 1)

    copied(whole, tmp_path / "forged.mcap", edit)
    verdict = verify(tmp_path / "forged.mcap")
    assert not verdict.equal and verdict.chain == "broken"


def test_moved_messages_and_other_times_break_the_chain(whole: Path) -> None:
    entries = list(Recording(whole).entries())
    *others, last = entries
    assert isinstance(last.message, Closing)

    def head(chosen: list[Any], delay: int = 0) -> str:
        chain = Chain()
        for entry in chosen:
            chain.add(entry.channel, entry.log_time + delay, entry.publish_time + delay, entry.data)
        footer = without_head(last.data, last.message.chain)  # type: ignore[union-attr]
        chain.add(last.channel, last.log_time, last.publish_time, footer)
        return chain.head()

    assert head(others) == last.message.chain
    assert head([*others[:-2], others[-1], others[-2]]) != last.message.chain
    assert head(others, 1) != last.message.chain
    assert head([e._replace(channel=e.channel._replace(schema_data=b"{}")) for e in others]) != last.message.chain


def test_removed_chain_is_found(whole: Path, tmp_path: Path) -> None:
    with_one(whole, tmp_path / "forged.mcap", "/closing", 0, as_json(lambda c: {**c, "chain": ""}), rechained=False)
    verdict = verify(tmp_path / "forged.mcap")
    assert (verdict.equal, verdict.chain) == (False, "removed")


def earlier(whole: Path, out: Path) -> None:
    """Write the recording as an earlier version did: without the chain and the environment."""

    def edit(topic: str, data: bytes) -> Iterator[bytes]:
        without = {"/opening": "environment", "/closing": "chain"}.get(topic)
        yield as_json(lambda m: {k: v for k, v in m.items() if k != without})(data) if without else data

    copied(whole, out, edit)


def test_file_without_a_chain_is_verified_and_says_what_is_not_covered(whole: Path, tmp_path: Path) -> None:
    earlier(whole, tmp_path / "old.mcap")
    verdict = verify(tmp_path / "old.mcap")
    assert verdict.equal and verdict.chain == "none" and verdict.unchanged == ()
    assert {"/opening", "/notes", "/controllers", "/shown", "/light"} <= set(verdict.not_covered)
    forged_frame = as_json(lambda frame: {**frame, "position": [99.0, 99.0, 99.0]})
    with_one(tmp_path / "old.mcap", tmp_path / "forged.mcap", "/frames", 4, forged_frame, rechained=False)
    verdict = verify(tmp_path / "forged.mcap")
    assert (verdict.equal, verdict.different) == (False, 1) and verdict.first is not None
    assert [change.field for change in verdict.first.fields] == [f"position[{axis}]" for axis in range(3)]


def test_file_that_was_cut_short_says_what_is_not_covered(whole: Path, tmp_path: Path) -> None:
    rewritten(whole, tmp_path / "cut.mcap", {}, leave_out=("/closing",))
    verdict = verify(tmp_path / "cut.mcap")
    assert verdict.cut and verdict.chain == "none" and "/notes" in verdict.not_covered
    assert verify(tmp_path / "cut.mcap", listed="0" * 64).chain == "removed"


def test_summary_and_end_of_a_script_are_computed_again(tmp_path: Path) -> None:
    path = tmp_path / "run.mcap"
    record(
        bay(extra='duration = "0.4 s"\n[[phase]]\nmode = "ORB UNL"\ntranslation = [0.5, 0, 0]\nduration = "0.2 s"\n'),
        path,
    )
    assert verify(path).equal
    closing = messages(path)[-1]
    assert isinstance(closing, Closing) and closing.summary
    summary = msgspec.json.decode(closing.summary)
    for where in leaves(summary):
        text = msgspec.json.encode(forged(summary, where)).decode()
        rewritten(path, tmp_path / "forged.mcap", {"/closing": encode(replace(closing, summary=text))}, rechained=True)
        verdict = verify(tmp_path / "forged.mcap")
        assert [change.channel for change in verdict.changes] == ["/closing"], where
    other = replace(closing, ended="fault")
    rewritten(path, tmp_path / "forged.mcap", {"/closing": encode(other)}, rechained=True)
    assert not verify(tmp_path / "forged.mcap").equal


def test_rewritten_file_differs_from_the_list_of_recordings(whole: Path, tmp_path: Path) -> None:
    made, index, path = bay(), Index(tmp_path / "list.sqlite"), tmp_path / "listed.mcap"
    sim = aftdeck.Simulation(made)
    recorder = Recorder(path, made, 0, index=index)
    recorder.step(Inputs(), sim.step(Inputs()))
    recorder.close("stopped")
    assert index.chain_of(path) == recorder.chain != ""
    assert verify(path, listed=index.chain_of(path)).equal
    start = replace(Recording(path).opening, participant="another")
    rewritten(path, tmp_path / "forged.mcap", {"/opening": encode(start)}, rechained=True)
    assert verify(tmp_path / "forged.mcap").equal, "the chain is no signature"
    verdict = verify(tmp_path / "forged.mcap", listed=index.chain_of(path))
    assert (verdict.equal, verdict.chain) == (False, "unlisted")


@pytest.mark.parametrize(
    ("field", "value"),
    [("title", "another"), ("joints", ["a"] * 6), ("control_period_s", 0.04), ("shapes_file", "/etc/passwd")],
)
def test_header_that_contradicts_its_texts_is_damage(whole: Path, tmp_path: Path, field: str, value: Any) -> None:
    change = as_json(lambda start: {**start, field: value})
    with_one(whole, tmp_path / "forged.mcap", "/opening", 0, change, rechained=True)
    with pytest.raises(RecordingError) as caught:
        verify(tmp_path / "forged.mcap")
    assert caught.value.fault == "damaged"


def check_apart(verdict: Verdict, metres: float, radians: float, tick: int) -> None:
    assert verdict.apart is not None and verdict.apart.tick == tick
    assert verdict.apart.metres == pytest.approx(metres, abs=3e-9)
    assert verdict.apart.radians == pytest.approx(radians, abs=9e-9)


def test_differences_are_given_in_metres_and_radians(whole: Path, tmp_path: Path) -> None:
    frames = [m for m in messages(whole) if isinstance(m, FrameRecord)]
    x, y, z = frames[6].position
    other = encode(
        replace(frames[6], position=(x + 3e-6, y, z), angles=(frames[6].angles[0] - 2e-5, *frames[6].angles[1:]))
    )
    with_one(whole, tmp_path / "forged.mcap", "/frames", 6, lambda _: other, rechained=True)
    check_apart(verify(tmp_path / "forged.mcap"), 3e-6, 2e-5, 7)
    c, s = 0.99999995, 3.16227765e-4  # a turn of 0.000316 rad about z
    turned = tuple(
        tuple(float(v) for v in row)
        for row in _product(((c, -s, 0.0), (s, c, 0.0), (0.0, 0.0, 1.0)), frames[2].orientation)
    )
    other = encode(replace(frames[2], orientation=turned))
    with_one(whole, tmp_path / "forged.mcap", "/frames", 2, lambda _: other, rechained=True)
    check_apart(verify(tmp_path / "forged.mcap"), 0.0, 3.16227765e-4, 3)


def _product(a: Any, b: Any) -> Any:
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def test_verdict_names_what_computes_differently(whole: Path, tmp_path: Path) -> None:
    start = Recording(whole).opening
    assert start.environment is not None and start.environment.target and start.environment.llvmlite
    there = replace(start.environment, target="generic", numpy="1.0", features=("+sse2",))
    rewritten(whole, tmp_path / "other.mcap", {"/opening": encode(replace(start, environment=there))}, rechained=True)
    verdict = verify(tmp_path / "other.mcap")
    assert not verdict.same_machine
    changes = {change.field: (change.before, change.after) for change in verdict.environment}
    assert {"target", "numpy"} <= set(changes) <= {"target", "numpy", "features"}
    assert changes["target"] == ("generic", start.environment.target)


def test_every_channel_is_declared_as_it_is_written(whole: Path) -> None:
    found: dict[str, Declared] = {entry.channel.topic: entry.channel for entry in Recording(whole).entries()}
    assert found == DECLARED
    assert isinstance(Recording(whole).opening, Opening)

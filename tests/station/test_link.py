"""The link of a session: which steps its pages show, and when log and last minutes arrive."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from typing import NamedTuple

import msgspec
import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from aftdeck.station.core.direct import Direct, DirectPage
from aftdeck.station.core.link import Link, LinkDelays
from aftdeck.station.messages import from_page, to_page
from aftdeck.station.messages.frame import Frame, LinkSteps
from tests.each import each, seeds
from tests.loaded import scenario

PERIOD = 0.02
NONE = LinkDelays(0.0, 0.0)
STEPS, RESTART = 120, 50
PRESSES: dict[int, from_page.FromPage] = {
    5: from_page.SelectRate(1, "vernier"),
    20: from_page.EnterMode(2, "END EFF"),
    RESTART: from_page.Restart(3),
    70: from_page.EnterMode(4, "END EFF"),
}

times = st.floats(0.0, 2.0)
delays = st.builds(LinkDelays, times, times, st.dictionaries(st.sampled_from("ABC"), times))


def periods(delay: float) -> int:
    return round(delay / PERIOD)


# --- named steps ------------------------------------------------------------------------------------------------------


@given(delays)
def test_link_names_the_steps_before_its_delays(of: LinkDelays) -> None:
    link = Link(PERIOD, of)
    step = 250
    last = [link.next() for _ in range(step)][-1]
    assert (last.step, last.telemetry, last.pictures) == (step, step - periods(of.telemetry), step - periods(of.camera))
    assert {camera: last.of(camera) for camera in of.cameras} == {
        camera: step - periods(delay) for camera, delay in of.cameras.items()
    }


@given(st.lists(st.tuples(delays, st.integers(1, 60)), min_size=1, max_size=8))
@settings(max_examples=50)
def test_page_never_goes_back_when_delays_change(changes: list[tuple[LinkDelays, int]]) -> None:
    link = Link(PERIOD, changes[0][0])
    before = link.next()
    for link.delays, count in changes:
        for _ in range(count):
            named = link.next()
            assert named.step == before.step + 1
            assert all(own != named.pictures for _, own in named.cameras)
            assert before.telemetry <= named.telemetry <= named.step
            assert all(before.of(camera) <= named.of(camera) <= named.step for camera in "ABCD")
            before = named


def test_link_without_delays_names_each_step_itself() -> None:
    link = Link(PERIOD, NONE)
    assert [link.next() for _ in range(3)] == [LinkSteps(step, step, step, ()) for step in (1, 2, 3)]


# --- pages ------------------------------------------------------------------------------------------------------------


class Flown(NamedTuple):
    """What two pages have received after each step: all frames and lines, and the samples of the strips."""

    frames: list[Frame]
    lines: list[list[str]]
    samples: list[list[tuple[bool, float]]]


def flown(changes: Mapping[int, LinkDelays]) -> Flown:
    """Fly `PRESSES`, with delays that change before some steps."""
    host = Direct(scenario())
    page, strips = host.join(), host.join(may_fly=False, strips=True)
    found = Flown([], [], [])
    for k in range(STEPS):
        host.core.link.delays = changes.get(k, host.core.link.delays)
        if k in PRESSES:
            page.send(PRESSES[k])
        if k in (RESTART - 1, RESTART + 20):
            host.core.note("page", f"before step {k}")
        host.step()
        lines, samples = [], []
        for message in page.receive():
            if isinstance(message, Frame):
                found.frames.append(message)
            elif isinstance(message, to_page.Events):
                lines += [f"{event.time_s:.2f} {event.text}" for event in message.events]
        for message in strips.receive():
            if isinstance(message, to_page.Recent):
                begins = [bool(message.strips), *[False] * len(message.samples)]
                samples += [(new, each.time_s) for new, each in zip(begins, message.samples, strict=False)]
        found.lines.append(lines)
        found.samples.append(samples)
    return found


def random_changes(seed: int) -> dict[int, LinkDelays]:
    """Return random delays from the beginning on, which change twice."""
    rng = np.random.default_rng(seed)
    when = (0, *rng.integers(1, STEPS, size=2).tolist())
    return {k: LinkDelays(*rng.uniform(0.0, 1.0, size=2).tolist()) for k in when}


def arrived(found: list[list[object]], until: int) -> list[object]:
    return [news for step in found[: max(0, until)] for news in step]


@each("seed", seeds(4, 100))
def test_lines_and_samples_arrive_with_the_step_that_the_page_shows(seed: int) -> None:
    at_once, late = flown({}), flown(random_changes(seed))
    for k, frame in enumerate(late.frames):
        link = frame.display.link
        assert link is not None and link.step == k + 1
        assert without_link(frame) == without_link(at_once.frames[k])
        for kind in ("lines", "samples"):
            assert arrived(getattr(late, kind), k + 1) == arrived(getattr(at_once, kind), link.telemetry)


def without_link(frame: Frame) -> Frame:
    return msgspec.structs.replace(frame, display=msgspec.structs.replace(frame.display, link=None))


def test_a_page_shows_the_old_run_until_the_delay_has_passed() -> None:
    late = 30
    frames = flown({0: LinkDelays(late * PERIOD, 0.0)}).frames
    named = [frame.display.link.telemetry for frame in frames if frame.display.link is not None]
    shown = [frames[step - 1].tick for step in named if step > 0]
    assert shown == [*range(1, RESTART + 1), *range(1, STEPS - RESTART - late + 1)]
    assert frames[RESTART].tick == 1


def late_host() -> tuple[Direct, DirectPage]:
    host = Direct(dataclasses.replace(scenario(), telemetry_delay=0.5, camera_delay=1.0))
    page = host.join()
    host.step()
    page.receive()
    return host, page


def test_link_of_a_session_has_the_delays_of_the_scenario() -> None:
    host, page = late_host()
    host.step()
    [frame] = page.receive()
    assert isinstance(frame, Frame)
    assert frame.display.link == LinkSteps(2, 2 - 25, 2 - 50, ())


def test_link_has_the_delays_that_changes_in_flight_set_until_a_restart() -> None:
    host, page = late_host()
    page.send(from_page.TypeLine(1, "set telemetry_delay = 0.1 s; camera_delay = 2 s"))
    delays = []
    for k in range(150):
        if k == 120:
            page.send(from_page.Restart(2))
        link = host.step().link
        delays.append((link.step - link.telemetry, link.step - link.pictures))
    assert delays[0] == (25, 50)
    assert delays[119] == (5, 100)
    assert delays[-1] == (25, 50)


def test_answers_to_a_page_have_no_delay() -> None:
    host, page = late_host()
    other = host.join()
    other.receive()
    other.send(from_page.SelectRate(1, "vernier"))
    assert [type(message) for message in other.receive()] == [to_page.Refused]
    other.send(from_page.AskSticks(2))
    assert to_page.Role in [type(message) for message in page.receive()]


def test_a_page_that_joins_late_receives_no_line_that_others_do_not_show() -> None:
    host, _ = late_host()
    for _ in range(24):
        host.step()
    host.core.note("page", "a line")
    seen = []
    for _ in range(30):
        host.step()
        seen.append("a line" in lines(host.join(may_fly=False)))
    assert seen == [False] * 25 + [True] * 5


def lines(page: DirectPage) -> list[str]:
    """Return the new lines of the log that a page receives."""
    messages = [message for message in page.receive() if isinstance(message, to_page.Events)]
    return [event.text for message in messages for event in message.events]


def test_lines_of_the_end_of_a_run_arrive_with_its_last_step() -> None:
    host, page = late_host()
    host.core.note("page", "before the restart")
    page.send(from_page.Restart(1))
    found = []
    for _ in range(30):
        host.step()
        found.append(lines(page))
    assert found[24][-1] == "before the restart"  # step 26 shows step 1
    assert found[25][-1].endswith(": restarted")
    assert not any(found[26:])

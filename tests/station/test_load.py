"""Station under load: floods of messages, pages that never read, and many connections."""

from __future__ import annotations

import socket
import time
from contextlib import ExitStack
from threading import Event, Thread

import pytest
from websockets.exceptions import ConnectionClosed

from aftdeck.simulation.frame import Frame as Flown
from aftdeck.simulation.inputs import Inputs
from aftdeck.station.core.page_inputs import MAX_WAITING
from aftdeck.station.messages import from_page
from aftdeck.station.messages.frame import Frame
from tests.station.pages import STILL, Page, Station, closing, until
from tests.waits import WAIT_S


@pytest.mark.slow
def test_flood_of_commands_ends_its_page_and_not_the_run(station: Station) -> None:
    with station.page() as page:
        try:
            for seq in range(10_000):
                page.send(from_page.SelectJoint(seq, seq % 6))
        except ConnectionClosed:
            pass  # the server closes the connection during the flood
        closing(page)
    station.check_running()


@pytest.mark.slow
def test_flood_of_sticks_ends_its_page_and_not_the_run(shared: Station) -> None:
    with shared.page() as page:
        try:
            for _ in range(10_000):
                page.push()
        except ConnectionClosed:
            pass  # the server closes the connection during the flood
        closing(page)
    shared.check_running()


def test_sticks_of_a_fast_screen_are_all_used(shared: Station) -> None:
    with shared.page() as page:
        for _ in range(240):  # as many as a screen with 240 pictures a second sends in a second
            page.push()
        page.wait_for(Frame, lambda frame: frame.display.stick_seq == 239)


def test_stop_is_never_rejected_and_overtakes_waiting_commands(
    station: Station, monkeypatch: pytest.MonkeyPatch
) -> None:
    simulation, queue = station.session._sim, station.session.desk._inputs._commands
    step, waits, released = simulation.step, Event(), Event()

    def wait(inputs: Inputs | None = None) -> Flown:
        waits.set()
        assert released.wait(WAIT_S)
        return step(inputs)

    with station.page() as page, ExitStack() as held:
        held.callback(released.set)
        monkeypatch.setattr(simulation, "step", wait)
        assert waits.wait(WAIT_S)
        for _ in range(MAX_WAITING):
            page.send(from_page.SelectJoint(page.next_seq(), 5))
        page.push(translation=(0.5, 0.0, 0.0))
        until(lambda: len(queue) == MAX_WAITING, "the queue is full")
        page.send(from_page.Stop(page.next_seq()))
        page.send(from_page.SelectRate(page.next_seq(), "vernier"))
        until(lambda: len(queue) == 2, "only STOP and the command after it wait")
        released.set()
        frame = page.wait_for(Frame, lambda frame: frame.rate == "vernier")
        assert (frame.joint, frame.translation) == (0, STILL)


@pytest.mark.slow
def test_page_that_never_reads_delays_no_other(station: Station) -> None:
    with station.page() as operator, station.unannounced(buffered=1) as silent:
        silent.socket.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        silent.greet()
        until(lambda: operator.is_answered(150), "150 frames at the control period")
    station.check_running()


@pytest.mark.slow
def test_many_observers_that_never_read_delay_no_page(station: Station) -> None:
    with ExitStack() as silent_pages:
        for _ in range(10):
            silent_pages.enter_context(station.unannounced(buffered=1)).greet()
        station.check_running()


def test_stick_is_answered_by_the_next_frame(shared: Station) -> None:
    def most_are(page: Page) -> bool:
        took = []
        for _ in range(40):
            begun = time.monotonic()
            page.flown(page.push())
            took.append(time.monotonic() - begun)
        return sorted(took)[20] < 0.04

    with shared.page() as page:
        until(lambda: most_are(page), "half of 40 sticks are answered within 0.04 s")


def test_pages_connect_and_disconnect_at_once(shared: Station) -> None:
    def connect_often() -> None:
        for _ in range(5):
            with shared.page() as page:
                page.push(translation=(0.0, 0.0, 0.0))
                page.wait_for(Frame)

    threads = [Thread(target=connect_often) for _ in range(6)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(WAIT_S)
    until(lambda: not any(thread.is_alive() for thread in threads), "all threads have ended")
    shared.check_running()

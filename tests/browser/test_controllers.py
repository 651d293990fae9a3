"""Devices of the hand controllers: assignments, changed assignments, and lost devices."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Locator, Page, expect

from aftdeck.recording.reader import Recording
from tests.browser.conftest import SIZES, OpenPage, running_station
from tests.browser.flight import FLIES, WAIT_MS, Flight
from tests.browser.layout_checks import assert_readable

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.long]
expect.set_options(timeout=WAIT_MS)

STICKS_AT_ZERO = "[...frame.translation, ...frame.rotation, frame.drive].every((value) => value === 0)"
GONE = "[...document.querySelectorAll('.stick .gone')].map((words) => words.textContent)"
CROSSED = "getComputedStyle(document.querySelector('.thc .crossed')).visibility === 'visible'"

CAP = """
    window.cap = Object.assign(new EventTarget(), {
        vendorId: 0x256f, productName: 'Test SpaceMouse', opened: false, axes: [0, 0, 0, 0, 0, 0],
        collections: [{ usagePage: 1, usage: 8 }], open: async () => { window.cap.opened = true; },
    });
    const hid = Object.assign(new EventTarget(), {
        getDevices: async () => [], requestDevice: async ({ filters }) =>
            filters.some(({ vendorId }) => vendorId === window.cap.vendorId) ? [window.cap] : [],
    });
    Object.defineProperty(navigator, 'hid', { value: hid });
    window.unplugCap = () => hid.dispatchEvent(Object.assign(new Event('disconnect'), { device: window.cap }));
    setInterval(() => {
        const data = new DataView(new ArrayBuffer(12));
        window.cap.axes.forEach((value, i) => data.setInt16(2 * i, value, true));
        window.cap.dispatchEvent(Object.assign(new Event('inputreport'), { reportId: 1, data }));
    }, 16);
"""
"""A SpaceMouse that sends all six axes in one report while it is connected; a test sets them."""


@pytest.fixture(scope="module")
def recordings(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Folder of the recordings."""
    return tmp_path_factory.mktemp("flights")


@pytest.fixture(scope="module")
def station(recordings: Path) -> Iterator[str]:
    """Address of a station that records."""
    with running_station("first-flight", "--record", str(recordings)) as address:
        yield address


@pytest.fixture
def padded(open_page: OpenPage) -> Flight:
    """A page with a pad."""
    return open_page(pad=True).from_the_start()


def open_sheet(flight: Flight, device: str | None = None) -> None:
    """Open the sheet; if a device is given, show the part of the sheet for this device."""
    flight.page.get_by_role("button", name="Controllers", exact=True).click()
    sheet(flight.page).wait_for(state="visible")
    if device:
        sheet(flight.page).get_by_role("button", name=device, exact=True).click()


def sheet(page: Page) -> Locator:
    """Return the sheet *Controllers*."""
    return page.get_by_role("dialog", name="Controllers")


def close_sheet(flight: Flight) -> None:
    """Close the sheet, and wait until the page has read the devices as centred; only then can they move the arm."""
    flight.press("Escape")
    sheet(flight.page).wait_for(state="hidden")
    flight.polled()


def request_assignment(flight: Flight, use: str) -> None:
    """Press the button of a function, such as +X; the sheet then waits for a key, button or axis."""
    flight.page.locator(f'[data-use="{use}"]').click()
    expect(flight.page.locator(f'[data-use="{use}"]')).to_contain_class("asked")


def message(flight: Flight) -> str:
    """Return the message of the sheet."""
    return str(flight.page.locator(".controllers .told").inner_text())


def test_reassigned_key_flies_and_is_stored_and_recorded(flight: Flight, recordings: Path) -> None:
    open_sheet(flight, "Keyboard")
    request_assignment(flight, "+X")
    flight.press("s")
    assert "“THC −X”" in message(flight)  # S is already assigned to THC −X
    flight.press("Tab")
    assert "belongs to the browser" in message(flight)
    flight.press("Space")
    assert "Space" in message(flight)
    flight.press("Numpad5")
    expect(flight.page.locator('[data-use="+X"]')).to_have_text("Num 5")
    flight.hold("Numpad5")
    expect(flight.page.locator('[data-use="+X"]')).to_contain_class("held")
    tick = flight.frame().tick
    assert flight.until(f"frame.tick > {tick + 25}").translation == (0, 0, 0), (
        "the arm does not move while the sheet is open"
    )
    flight.release("Numpad5")
    close_sheet(flight)

    for _ in range(2):
        flight.hold("Numpad5")
        flight.until("frame.translation[0] === 1")
        flight.release("Numpad5")
        flight.until(STICKS_AT_ZERO)
        flight.hold("w")
        tick = flight.frame().tick
        assert flight.until(f"frame.tick > {tick + 25}").translation == (0, 0, 0)
        flight.release("w")
        flight.page.reload()
        flight.until(FLIES)

    newest = max(recordings.glob("*.mcap"), key=lambda path: path.stat().st_mtime)
    flown_with = [used for record in Recording(newest).controllers() for used in record.controllers]
    assert any("Numpad5 +X" in used.bindings and "KeyW +X" not in used.bindings for used in flown_with)


def test_stick_axis_is_reassigned_by_moving_it(padded: Flight) -> None:
    padded.enter("ORB UNL")
    open_sheet(padded, "Pad")
    request_assignment(padded, "+pitch")
    padded.press("Delete")
    expect(padded.page.locator('[data-use="+pitch"]')).to_have_text("·")
    request_assignment(padded, "+X")
    padded.pad_axes(0, 0, 0, -1)
    expect(padded.page.locator('[data-use="+X"]')).to_have_text("R stick ↑")
    padded.pad_axes(0, 0, 0, 0)
    padded.polled()
    close_sheet(padded)
    padded.pad_axes(0, -1, 0, -1)
    flown = padded.until("frame.translation[0] === 1")
    assert flown.rotation == (0.0, 0.0, 0.0)
    padded.pad_axes(0, 0, 0, 0)
    padded.until(STICKS_AT_ZERO)


def test_deadband_and_expo_are_set_by_keys(padded: Flight) -> None:
    open_sheet(padded, "Pad")
    padded.page.get_by_label("Deadband").press("End")
    padded.page.get_by_label("Expo", exact=True).press("Home")
    padded.pad_axes(0, -0.75, 0, 0)
    row = padded.page.locator(".axes-live tr", has_text="THC X")
    expect(row.locator(".number").first).to_have_text("+0.75")
    expect(row.locator(".number.after")).to_have_text("+0.50")
    padded.page.get_by_role("button", name="Defaults").click()
    expect(padded.page.locator(".range output").first).to_have_text("8 %")


def test_lost_device_zeroes_the_sticks_and_is_named(padded: Flight) -> None:
    padded.pad_axes(0, -1, 0, 0)
    padded.until("frame.translation[0] === 1")
    padded.press("h")
    padded.until("frame.rate_hold")
    padded.script("window.kept = window.testPad; window.testPad = null")
    padded.until(f"{STICKS_AT_ZERO} && frame.position_hold && !frame.rate_hold")
    padded.until(f"{GONE}.every((words) => words === 'Test pad lost') && {CROSSED}")
    padded.until_lit("CONTROLLER")
    padded.press("m")
    padded.until(f"{GONE}.every((words) => words === '') && !({CROSSED})")


def test_hidden_page_zeroes_a_pad_until_it_was_centred(padded: Flight) -> None:
    hide = (
        "Object.defineProperty(document, 'hidden', {{ value: {0}, configurable: true }});"
        "document.dispatchEvent(new Event('visibilitychange'))"
    )
    padded.pad_axes(0, -1, 0, 0)
    padded.until("frame.translation[0] === 1")
    padded.press("h")
    padded.until("frame.rate_hold")
    padded.script(hide.format("true"))
    padded.until(f"{STICKS_AT_ZERO} && frame.position_hold && !frame.rate_hold")
    padded.script(hide.format("false"))
    padded.until("/^Centre: /.test(document.querySelector('.device').textContent)")
    assert padded.frame().translation == (0, 0, 0)
    padded.pad_axes(0, 0, 0, 0)
    padded.until("/keyboard in use/.test(document.querySelector('.device').textContent)")
    padded.pad_axes(0, -1, 0, 0)
    padded.until("frame.translation[0] === 1")


def test_pad_off_centre_is_zeroed_only_on_request(open_page: OpenPage) -> None:
    def off_centre(page: Page) -> None:
        page.add_init_script("window.testPad.axes = [0, 0.2, 0, 0]")

    flight = open_page(pad=True, prepare=off_centre).from_the_start()
    flight.until("/Off centre/.test(document.querySelector('.device').textContent)")
    assert flight.frame().translation == (0, 0, 0)
    open_sheet(flight, "Pad")
    flight.page.get_by_role("button", name="Set zero").click()
    expect(flight.page.locator(".controllers .state")).to_have_text("Test pad: ready")
    close_sheet(flight)
    flight.pad_axes(0, -1, 0, 0)
    flight.until("frame.translation[0] === 1")


def test_first_moved_of_two_pads_is_the_thc_until_swapped(padded: Flight) -> None:
    padded.script(
        "window.second = { ...window.testPad, id: 'Other pad', index: 1, axes: [0, 0, 0, 0] };"
        "navigator.getGamepads = () => [window.testPad, window.second]"
    )
    padded.polled()
    padded.script("window.second.axes = [0, -1, 0, 0]")
    padded.page.get_by_text(re.compile("Test pad is the THC.*Other pad is the RHC")).wait_for()
    padded.script("window.second.axes = [0, 0, 0, 0]")
    flies = "/^Test pad, Other pad and/.test(document.querySelector('.device').textContent)"
    padded.until(flies)
    padded.script("window.second.axes = [0, -1, 0, 0]")
    padded.until("frame.rotation[1] === 1 && frame.translation[0] === 0")
    padded.script("window.second.axes = [0, 0, 0, 0]")
    padded.until(STICKS_AT_ZERO)
    padded.page.get_by_role("button", name="Swap", exact=True).click()
    padded.until("/^Other pad, Test pad and/.test(document.querySelector('.device').textContent)")
    padded.until("!document.querySelector('.lamp.caution')")
    padded.script("window.second.axes = [0, -1, 0, 0]")
    padded.until("frame.translation[0] === 1 && frame.rotation[1] === 0")


def test_touch_sticks_fly_with_two_fingers(flight: Flight) -> None:
    page = flight.page
    cdp = page.context.new_cdp_session(page)
    cdp.send("Emulation.setTouchEmulationEnabled", {"enabled": True, "maxTouchPoints": 2})

    def touch(kind: str, *points: tuple[float, float]) -> None:
        fingers = [{"x": x, "y": y, "id": i} for i, (x, y) in enumerate(points)]
        cdp.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": fingers})

    touch("touchStart", (640, 200))
    touch("touchEnd")
    page.get_by_role("group", name="Touch sticks").wait_for(state="visible")
    (left, right) = (centre(page, ".touch .left .knob.round"), centre(page, ".touch .right .knob.round"))
    touch("touchStart", left, right)
    tick = flight.frame().tick
    assert flight.until(f"frame.tick > {tick + 25}").translation == (0, 0, 0), "a touch alone moves nothing"
    touch("touchMove", (left[0], left[1] - 60), (right[0] + 60, right[1]))
    flight.until("frame.translation[0] === 1 && frame.rotation[2] === 1")
    assert flight.script("[scrollX, scrollY, visualViewport.scale]") == [0, 0, 1]
    touch("touchEnd")
    flight.until(STICKS_AT_ZERO)
    page.get_by_role("button", name="Hide the touch sticks").click()
    page.get_by_role("group", name="Touch sticks").wait_for(state="hidden")
    flight.until("!document.querySelector('.lamp.caution')")


def centre(page: Page, selector: str) -> tuple[float, float]:
    """Return the centre of an element [px]."""
    box = page.locator(selector).bounding_box()
    assert box is not None
    return (box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)


def test_spacemouse_flies_and_its_loss_is_shown(open_page: OpenPage) -> None:
    flight = open_page(prepare=lambda page: page.add_init_script(CAP)).from_the_start()
    open_sheet(flight, "SpaceMouse")
    flight.page.get_by_role("button", name="Connect", exact=True).click()
    expect(flight.page.locator(".controllers .state")).to_have_text("Test SpaceMouse: ready")
    close_sheet(flight)
    flight.until("/^Test SpaceMouse and/.test(document.querySelector('.device').textContent)")
    flight.script("window.cap.axes = [0, -350, 0, 0, 0, 175]")
    flown = flight.until("frame.translation[0] === 1 && frame.rotation[2] > 0")
    assert 0 < flown.rotation[2] < 0.5
    flight.script("window.unplugCap()")
    flight.until(f"{STICKS_AT_ZERO} && {GONE}.every((words) => words === 'Test SpaceMouse lost')")


def test_missing_webhid_is_reported(open_page: OpenPage) -> None:
    without = "Object.defineProperty(navigator, 'hid', { value: undefined })"
    flight = open_page(prepare=lambda page: page.add_init_script(without)).from_the_start()
    open_sheet(flight, "SpaceMouse")
    expect(flight.page.locator(".controllers .state")).to_contain_text("This browser has no WebHID")
    expect(flight.page.get_by_role("button", name="Connect", exact=True)).to_be_hidden()


@pytest.mark.parametrize(("width", "height"), SIZES)
def test_controllers_sheet_fits_and_is_readable(open_page: OpenPage, width: int, height: int) -> None:
    flight = open_page(width, height, pad=True).from_the_start()
    open_sheet(flight)
    for device in ("Pad", "Keyboard", "SpaceMouse", "Touch sticks"):
        sheet(flight.page).get_by_role("button", name=device, exact=True).click()
        assert flight.script(
            "(() => { const s = document.querySelector('.controllers'), p = s.getBoundingClientRect();"
            "return p.left >= 0 && p.top >= 0 && p.right <= innerWidth && p.bottom <= innerHeight"
            " && s.scrollHeight <= s.clientHeight && s.scrollWidth <= s.clientWidth; })()"
        )
        cut = "[...document.querySelectorAll('.controllers button')].filter((b) => b.scrollWidth > b.clientWidth + 1)"
        assert flight.script(f"{cut}.map((b) => b.textContent)") == []
    request_assignment(flight, "+X")
    assert_readable(flight)

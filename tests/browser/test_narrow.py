"""Windows narrower than 1280 px have MON 2 in a corner of MON 1; below 720 px the page only observes."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from tests.browser.conftest import NARROW, OpenPage, running_station
from tests.browser.flight import FLIES, OBSERVES, Flight, shows
from tests.browser.layout_checks import assert_readable, assert_tidy

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.long]

SCENARIO = "srms-deploy"
ENDS = [(1279, 800), (720, 1024)]
"""Widest narrow window, and narrowest window in which the arm can be flown [px]."""
PHONE = (390, 844)
TABLET = (768, 1024)

GROUPS = ["thc", "rhc", "mode", "resolution", "joints", "clearance", "effector", "look-ahead", "events", "singularity"]
RAIL_KEYS = ["Restart", "Light", "Dim", "Tutorial", "Controllers"]
IS_TOO_NARROW = "document.querySelector('.too-narrow').checkVisibility()"
SCROLLS = "((desk) => desk.scrollHeight > desk.clientHeight)(document.querySelector('.desk'))"
FORWARD = "frame.translation[0] > 0.9"

COVERED = """() => {
    const box = (node) => node.getBoundingClientRect();
    const meet = (a, b) => {
        const [p, q] = [box(a), box(b)];
        return p.right > q.left + .5 && q.right > p.left + .5 && p.bottom > q.top + .5 && q.bottom > p.top + .5;
    };
    const name = (node) => node.textContent || node.getAttribute('class');
    const [first, second] = document.querySelectorAll('.monitor');
    const [host, inset] = [first.querySelector('.bezel'), second.querySelector('.bezel')];
    const [p, q] = [box(inset), box(host)];
    const found = [];
    if (p.left < q.left || p.top < q.top || p.right > q.right || p.bottom > q.bottom)
        found.push('the inset leaves MON 1');
    if (p.width * p.height < 0.15 * q.width * q.height) found.push('the inset is less than a quarter');
    for (const monitor of [first, second]) {
        const texts = [...monitor.querySelectorAll('.burned, .frame-axes, .round')]
            .filter((node) => node.checkVisibility({ visibilityProperty: true }) && box(node).width > 0);
        for (const [i, text] of texts.entries()) {
            for (const other of texts.slice(i + 1))
                if (meet(text, other)) found.push(`“${name(text)}” lies on “${name(other)}”`);
            if (monitor === first && meet(text, inset)) found.push(`MON 2 covers “${name(text)}”`);
        }
    }
    for (const stick of document.querySelectorAll('.touch:not([hidden]) .knob'))
        for (const text of [inset, ...document.querySelectorAll('.monitor:first-child .burned, .frame-axes, .spine')])
            if (text.checkVisibility() && meet(stick, text)) found.push(`a touch stick covers “${name(text)}”`);
    return found;
}"""
"""Texts in the pictures that overlap each other, or that are covered by MON 2 or a touch stick."""


@pytest.fixture(scope="module")
def station(request: pytest.FixtureRequest) -> Iterator[str]:
    """Address of a station that runs SCENARIO, or the scenario of the test's parameter."""
    with running_station(getattr(request, "param", SCENARIO)) as address:
        yield address


@pytest.mark.parametrize(("width", "height"), [*NARROW, *ENDS])
def test_narrow_page_shows_all_controls(open_page: OpenPage, width: int, height: int) -> None:
    flight = open_page(width, height).from_the_start()
    for name in GROUPS:
        assert flight.page.locator(f".group.{name}").is_visible(), name
    for name in RAIL_KEYS:
        assert flight.page.get_by_role("button", name=name, exact=True).is_visible(), name
    assert not flight.script(IS_TOO_NARROW)
    _assert_looks(flight)
    flight.press("z")
    flight.until(shows(0, "A", "A").replace("=== 'A,A'", ".includes(',')"))
    _assert_looks(flight)
    flight.press("z")
    flight.turn_to("AUTO 1")
    flight.until("document.querySelector('.target').checkVisibility()")
    _assert_looks(flight)


@pytest.mark.parametrize("station", ["free-flyer"], indirect=True)
def test_narrow_page_of_the_concept_arm_is_tidy(open_page: OpenPage) -> None:
    flight = open_page().from_the_start()
    for width, height in NARROW:
        flight.page.set_viewport_size({"width": width, "height": height})
        flight.until(f"innerWidth === {width} && innerHeight === {height}")
        _assert_looks(flight)


def test_inset_mon_2_can_be_selected_and_changes_its_camera(open_page: OpenPage) -> None:
    flight = open_page(*TABLET).from_the_start()
    flight.press("x", "4")
    flight.until(shows(1, "D"))
    flight.press("x", "1")
    flight.until(f"{shows(0, 'A')} && {shows(1, 'D')}")
    flight.page.locator(".monitor").nth(1).locator(".picture").click()
    flight.page.get_by_role("group", name="Camera of MON 2").get_by_role("button", name="B", exact=True).click()
    flight.until(f"{shows(0, 'A')} && {shows(1, 'B')}")
    flight.page.get_by_role("button", name="MON 1", exact=False).first.click()
    flight.page.get_by_role("group", name="Camera of MON 1").get_by_role("button", name="C", exact=True).click()
    flight.until(f"{shows(0, 'C')} && {shows(1, 'B')}")


def test_touch_sticks_cover_no_text(open_page: OpenPage) -> None:
    flight = open_page(*TABLET).from_the_start()
    flight.script("document.dispatchEvent(new PointerEvent('pointerdown', { pointerType: 'touch' }))")
    flight.page.get_by_role("group", name="Touch sticks").wait_for(state="visible")
    assert flight.script(COVERED) == []
    assert_tidy(flight)


def test_page_scrolls_in_a_low_window_and_its_desk_does_not(open_page: OpenPage) -> None:
    flight = open_page(1024, 600).from_the_start()
    assert not flight.script(SCROLLS)
    assert flight.script("document.scrollingElement.scrollHeight > innerHeight")
    assert flight.script(COVERED) == []
    flight.page.locator(".events .more").scroll_into_view_if_needed()
    flight.page.locator(".events .more").click()
    flight.until("document.querySelector('.events.open .log').children.length > 1")


def test_phone_observes_and_never_gets_the_sticks(open_page: OpenPage) -> None:
    phone = open_page(*PHONE)
    phone.until(f"{OBSERVES} && {IS_TOO_NARROW} && frame.time_s > 0.5")
    assert phone.script("document.querySelector('.who').textContent") == "Observing · unattended"
    assert phone.page.locator(".too-narrow").is_visible()
    for shown in (".monitor .picture", ".clearance .gap-value", ".master", ".lamp", ".rail .met"):
        assert phone.page.locator(shown).first.is_visible(), shown
    assert not phone.page.locator(".thc").is_visible()
    assert_readable(phone, least=30)
    assert phone.script("document.scrollingElement.scrollWidth <= innerWidth")
    before = phone.frame()
    phone.hold("w")
    phone.press("b")
    after = phone.until(f"frame.tick > {before.tick + 40}")
    phone.release("w")
    assert after.translation == (0.0, 0.0, 0.0) and after.brakes == before.brakes
    other = open_page()
    other.until(FLIES)  # the phone came first, but cannot get control
    phone.until("document.querySelector('.who').textContent === 'Observing · page 1 flies'")
    assert not phone.page.get_by_role("button", name="Ask for the sticks").is_visible()


def test_page_made_too_narrow_loses_the_sticks_until_it_is_wide(open_page: OpenPage) -> None:
    flight = open_page(*TABLET).from_the_start()
    flight.hold("w")
    flight.until(FORWARD)
    with flight.logs("hands off"):
        _resize(flight, PHONE)
        flight.until(f"{OBSERVES} && {IS_TOO_NARROW} && frame.translation[0] === 0 && frame.position_hold")
    flight.release("w")
    _resize(flight, TABLET)
    flight.until(FLIES)
    flight.hold("w")
    flight.until(FORWARD)
    flight.release("w")
    flight.until("frame.translation[0] === 0")


def test_observer_keeps_control_after_the_operator_page_was_too_narrow(open_page: OpenPage) -> None:
    first = open_page(*TABLET).from_the_start()
    second = open_page()
    second.until(OBSERVES)
    _resize(first, PHONE)
    second.until(FLIES)
    _resize(first, TABLET)
    first.until(f"{OBSERVES} && !({IS_TOO_NARROW})")
    assert second.script(FLIES)
    first.page.get_by_role("button", name="Ask for the sticks").wait_for(state="visible")


def _resize(flight: Flight, size: tuple[int, int]) -> None:
    width, height = size
    flight.page.set_viewport_size({"width": width, "height": height})


def _assert_looks(flight: Flight) -> None:
    """Assert that the page, including the pictures, is tidy and readable and does not scroll."""
    drawn = flight.script("window.__aftdeck.frames")
    flight.until(f"window.__aftdeck.frames > {drawn + 4}")
    assert not flight.script(SCROLLS)
    assert_tidy(flight)
    assert_readable(flight)
    assert flight.script(COVERED) == []

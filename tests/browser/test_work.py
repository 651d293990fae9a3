"""The worksite on the page: clearance, contacts, capture conditions, and commands of the end effector."""

from __future__ import annotations

import math
from collections.abc import Callable

import msgspec
import pytest

from aftdeck.simulation.frame import WayOut
from aftdeck.worksite.report import Objective
from tests.browser.conftest import SIZES, OpenPage
from tests.browser.flight import Flight
from tests.browser.layout_checks import assert_readable, assert_tidy
from tests.browser.worksite import PRONG, SNARES, Worksite, condition, info, near, work

pytestmark = pytest.mark.browser

OpenWorksite = Callable[..., tuple[Flight, Worksite]]

BEFORE_CAPTURE = (
    condition("off axis", 0.124, 0.1016, "4.9 in off the axis, at most 4 in allowed"),
    condition("distance", 1.14, 0.1, "fixture 45 in away, at most 4 in allowed"),
    condition("tilt", 0.07, 0.26, "4.2° tilted, at most 15° allowed", "rad"),
    condition("roll", 0.05, 0.17, "2.9° rolled, at most 10° allowed", "rad"),
)
BEFORE_ACQUISITION = (
    condition("palm over bar", 0.0, 0.1, "bar clear of the palm"),
    condition("fixed finger beside bar", 0.3, 0.1, "bar past the fixed finger's face"),
    condition("prong beside bar", 0.05, 0.1, "bar clear of the prong"),
    condition("prong closed", 0.3, 0.244, "fingers 11.8 in apart, at most 9.6 in allowed"),
    condition("palm height", 0.0635, 0.019, "palm 2.5 in above the bar, 0 to 0.75 in allowed"),
    condition("palm along bar", 0.1, 0.3, "palm 3.9 in from the bar's middle to its rear"),
)
DETRIMENTAL = near("palm", "payload top", -0.0102)
ESSENTIAL = near("prong", "receptacle", 0.0, essential=True)
GRASPING = work(
    nearest=DETRIMENTAL,
    contacts=(DETRIMENTAL, ESSENTIAL),
    arm_inhibit=True,
    inhibits=("palm touches payload top: 0.402 in deep",),
    objective=Objective("acquire", "acquire payload"),
    conditions=BEFORE_ACQUISITION,
    hand=PRONG,
    stand=3.6,
)


@pytest.fixture
def open_worksite(open_page: OpenPage) -> OpenWorksite:
    """Function that opens a page of a station with the worksite of the test."""

    def open_one(worksite: Worksite) -> tuple[Flight, Worksite]:
        return open_page(prepare=worksite.intercept).from_the_start(), worksite

    return open_one


def test_pair_of_minimum_clearance_is_named_lit_and_drawn(open_worksite: OpenWorksite) -> None:
    flight, _ = open_worksite(Worksite(info(), work(nearest=near("lower boom", "bay wall port", 0.38, 0.021))))
    flight.until("document.querySelector('.clearance .number').textContent.trim() === '15 in'")
    group = flight.page.locator(".clearance").inner_text()
    assert "Lower boom to bay wall port" in group
    assert "closing 0.8 in/s" in group
    assert "contact in 18 s" in group
    flight.page.locator(".lamp.caution", has_text="CLEARANCE").wait_for()
    flight.until("document.querySelector('.gap-label').textContent === 'clearance 15 in'")
    flight.until("document.querySelector('.gap').getAttribute('visibility') === 'visible'")


def test_contact_is_marked_and_shows_its_escape(open_worksite: OpenWorksite) -> None:
    flight, site = open_worksite(Worksite(info("prong", stand=True), GRASPING))
    site.ways_out = (WayOut("contact", "telescope longer", "telescope", 0, 1),)
    flight.page.locator(".flag.lit", has_text="Arm inhibit").wait_for()
    flight.page.locator(".lamp.warning", has_text="CLEARANCE").wait_for()
    flight.page.locator(".touching", has_text="Escape").wait_for()
    lines = flight.page.locator(".touching").inner_text()
    assert "Palm touches payload top, 0.4 in deep" in lines
    assert "Escape: telescope longer" in lines
    marks = "[...document.querySelector('.gaps').querySelectorAll('.touch[visibility=visible]')]"
    flight.until(f"{marks}.length === 2 && {marks}.filter((mark) => mark.matches('.essential')).length === 1")
    site.work = msgspec.structs.replace(GRASPING, contacts=(), arm_inhibit=False, inhibits=())
    site.ways_out = ()
    flight.until(f"{marks}.length === 0 && !document.querySelector('.inhibits .lit')")


def test_capture_and_release_act_only_when_held(open_worksite: OpenWorksite) -> None:
    flight, site = open_worksite(Worksite(info(), work()))
    full = "document.querySelectorAll('.grips .fill')[{}].style.transform === 'scaleX(1)'"
    flight.press("r")
    flight.hold("g")
    flight.until(full.format(0))
    flight.release("g")
    assert [m["switch"] for m in site.sent if m["type"] == "effector"] == ["close"]
    release = flight.page.get_by_role("button", name="Release R, hold 1 s")
    release.focus()
    flight.hold("Enter")
    flight.until(full.format(1))
    flight.release("Enter")
    assert [m["switch"] for m in site.sent if m["type"] == "effector"] == ["close", "open"]


@pytest.mark.slow
def test_telescope_has_a_row_and_keys(open_worksite: OpenWorksite) -> None:
    flight, site = open_worksite(Worksite(info("prong", stand=True), work(hand=SNARES, stand=3.6)))
    flight.until("document.querySelector('.stand .angle').textContent === '141.7'")
    flight.hold("y")
    site.until_sent(flight, "sticks", telescope=1)
    flight.release("y")


def test_master_slider_sends_one_changed_angle(open_worksite: OpenWorksite) -> None:
    site = Worksite(info(), work())
    site.mode = "MASTER"
    flight, _ = open_worksite(site)
    joints = flight.frame().angles
    elbow = flight.page.get_by_role("slider", name="Master Elbow")
    elbow.wait_for()
    elbow.focus()
    flight.press("PageUp")
    site.until_sent(flight, "master")
    angles = site.last("master")["angles"]
    assert angles[2] - joints[2] == pytest.approx(math.radians(5.0), abs=1e-3)
    assert [*angles[:2], *angles[3:]] == pytest.approx([*joints[:2], *joints[3:]], abs=1e-3)
    flight.press("Space")
    site.until_sent(flight, "stop")


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.parametrize("mode", ["ORB UNL", "OPR CMD", "SINGLE", "MASTER"])
def test_page_with_contacts_and_conditions_is_tidy_and_readable(open_worksite: OpenWorksite, mode: str) -> None:
    site = Worksite(info("prong", stand=True), GRASPING)
    site.mode = mode
    flight, _ = open_worksite(site)
    flight.until("document.querySelector('.inhibits .lit') && frame.work.contacts.length === 2")
    _assert_looks(flight)
    site.work = work(
        objective=Objective("capture", "capture payload"), conditions=BEFORE_CAPTURE, hand=PRONG, stand=3.6
    )
    flight.until(
        "document.querySelectorAll('.cells .holds:not([hidden])').length === 2"
        " && !document.querySelector('.inhibits .lit')"
    )
    _assert_looks(flight)


def test_page_with_snares_and_payloads_is_tidy_and_readable(open_worksite: OpenWorksite) -> None:
    flight, _ = open_worksite(Worksite(info(), work(nearest=near("lower boom", "bay wall port", 0.38, 0.02))))
    flight.until("document.querySelector('.cargo td').textContent !== ''")
    _assert_looks(flight)
    flight.press("`")
    flight.until("document.querySelector('.orbiter').checkVisibility()")
    _assert_looks(flight)


def _assert_looks(flight: Flight) -> None:
    """Assert that the page is tidy and readable at each size."""
    for width, height in SIZES:
        flight.page.set_viewport_size({"width": width, "height": height})
        drawn = flight.script("window.__aftdeck.frames")
        flight.until(f"window.__aftdeck.frames > {drawn + 1}")
        assert_tidy(flight)
        assert_readable(flight)

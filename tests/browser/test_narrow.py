"""Windows narrower than 1100 px: flown with MON 2 in a corner of MON 1; below 720 px, watched only."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from tests.browser.conftest import OpenPage, flown
from tests.browser.flight import Flight
from tests.browser.looks import assert_readable, assert_tidy
from tests.browser.test_cameras import shows

pytestmark = [pytest.mark.browser, pytest.mark.slow]

SCENARIO = "srms-deploy"
SIZES = [(960, 900), (1024, 768), (768, 1024), (1099, 800), (720, 1024)]
"""A window at half a laptop's width, an old screen, a tablet upright, and the ends of the range [px]."""
PHONE = {"width": 390, "height": 844}
TABLET = {"width": 768, "height": 1024}

GROUPS = ["THC", "RHC", "Mode", "Point of resolution", "Joints", "Clearance", "End effector", "Look ahead"]
FLIES = "document.querySelector('.who').textContent.startsWith('You fly')"
WATCHES = "document.querySelector('.who').textContent.startsWith('You watch')"
SAYS_SO = "document.querySelector('.too-narrow').checkVisibility()"
LOW = "document.querySelector('.desk').scrollHeight > document.querySelector('.desk').clientHeight"

BURNED_IN = """() => {
    const box = (node) => node.getBoundingClientRect();
    const apart = (p, q) =>
        p.right <= q.left + .5 || q.right <= p.left + .5 || p.bottom <= q.top + .5 || q.bottom <= p.top + .5;
    const [first, second] = document.querySelectorAll('.monitor');
    const inset = second.querySelector('.bezel');
    const marks = (monitor) => [...monitor.querySelectorAll('.burned, .frame-axes, .round')]
        .filter((node) => node.checkVisibility({ visibilityProperty: true }) && box(node).width > 0);
    const name = (node) => node.textContent || node.getAttribute('class');
    const found = [];
    const outer = box(first.querySelector('.bezel'));
    const [p, reticle] = [box(inset), box(first.querySelector('.reticle'))];
    if (p.left < outer.left || p.top < outer.top || p.right > outer.right || p.bottom > outer.bottom)
        found.push('the inset leaves MON 1');
    if (p.width * p.height < 0.15 * outer.width * outer.height) found.push('the inset is small');
    for (const node of marks(first)) if (!apart(p, box(node))) found.push(`the inset covers “${name(node)}”`);
    for (const monitor of [first, second]) {
        const all = marks(monitor);
        for (const [i, a] of all.entries())
            for (const b of all.slice(i + 1))
                if (!apart(box(a), box(b))) found.push(`“${name(a)}” lies on “${name(b)}”`);
    }
    return found;
}"""
"""Where a text that is burned into a picture lies on another one or under MON 2."""


@pytest.mark.parametrize(("width", "height"), SIZES)
def test_all_that_is_flown_with_is_there_and_tidy(open_page: OpenPage, width: int, height: int) -> None:
    flight = open_page(width, height).from_the_start()
    _everything_is_there(flight)
    assert not flight.script(SAYS_SO)
    flight.turn_to("AUTO 1")
    flight.until("document.querySelector('.target').checkVisibility()")
    assert_tidy(flight)
    assert flight.script(BURNED_IN) == []
    flight.press("z")
    flight.until("document.querySelectorAll('.monitor:first-child .picture').length === 2")
    assert_tidy(flight)
    assert flight.script(BURNED_IN) == []


@pytest.mark.parametrize("scenario", ["first-flight", "free-flyer", "loaded", "sequence"])
def test_other_work_is_tidy_too(scenario: str, open_page: OpenPage, station: str) -> None:
    pass


def _everything_is_there(flight: Flight) -> None:
    for name in GROUPS:
        assert flight.page.get_by_role("region", name=name, exact=False).first.is_visible(), name
    for name in ("Restart", "Light", "Tutorial", "Controllers", "Keys ?"):
        assert flight.page.get_by_role("button", name=name, exact=True).is_visible(), name
    assert not flight.script(LOW)
    assert_tidy(flight)
    assert_readable(flight)
    assert flight.script(BURNED_IN) == []

"""Texts are inside their boxes at all sizes of the window; from 1440 x 900 on, no advice is cut."""

from __future__ import annotations

import pytest

from tests.browser.conftest import OpenPage
from tests.browser.layout_checks import assert_tidy, collisions

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.long]

SCENARIO = "tutorial"
SIZES = [(1024, 768), (1180, 820), (1440, 900), (1920, 1080), (2560, 1440)]
"""An old screen, a tablet, and three screens of desks [px]."""
ZOOMED = [(1280, 720), (960, 540), (720, 450)]
"""The same three screens of desks if the browser enlarges all texts to 200 % [px]."""

CAUSE = "Upper boom to sill fittings port 23.6 in"
"""The longest cause of a lamp at this worksite."""
LIGHT = f"""document.querySelectorAll('.lamp').forEach((lamp) => {{
    lamp.classList.add('caution');
    lamp.querySelector('small').textContent = '{CAUSE}';
}})"""

CUT = """() => {
    const found = [];
    // The newest line of the log, its hints, the state of each group, causes of lamps, conditions, the guide.
    const advice = '.log .whole:not(.unseen), .about, .lamp small, .pair, .cells .name, .task .words';
    const texts = [...document.querySelectorAll(advice)].filter(({ textContent }) => textContent);
    for (const node of texts.filter((text) => text.checkVisibility({ visibilityProperty: true }))) {
        const wide = node.scrollWidth > node.clientWidth + 1 && getComputedStyle(node).display !== 'inline';
        if (wide || node.scrollHeight > node.clientHeight + 3) found.push(`“${node.textContent}” is cut off`);
    }
    return found;
}"""


def test_texts_are_inside_their_boxes_at_all_sizes(open_page: OpenPage) -> None:
    flight = open_page(*SIZES[0]).from_the_start()
    with flight.logs("missed"):
        flight.hold("g")
        flight.until("frame.work.hand.switch === 'close'")
        flight.release("g")
    for width, height in SIZES:
        flight.resize(width, height)
        assert_tidy(flight)
        if width >= 1440:
            flight.script(LIGHT)
            assert flight.script(CUT) == [], f"at {width} x {height}"
    for width, height in ZOOMED:
        flight.resize(width, height)
        assert collisions(flight) == [], f"at {width} x {height}, 200 %"

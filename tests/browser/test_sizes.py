"""In windows of all sizes nothing is cut off or overlaps, the arm's tip is in a picture, and the desk leaves room."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from aftdeck.scenario.load import load_scenario
from tests.browser.conftest import OpenPage, running_station
from tests.browser.flight import Flight
from tests.browser.layout_checks import DESK_SHARE, collisions

pytestmark = [pytest.mark.browser, pytest.mark.slow]

CALM = True
SIZES = [(1440, 900), (1280, 720), (1024, 768), (1920, 1080), (844, 390), (390, 844), (720, 450)]
"""Laptop, small laptop, old screen, large screen, phone on its side, phone, and a laptop's page at 200 % [px]."""
SCENARIOS = ["srms-deploy", "tutorial", "concept-1972"]
LEAST = (1280, 720)
"""Smallest window in which the calm desk has at most `DESK_SHARE` of the height [px]."""

PROBLEMS = """() => {
    const shown = (node) => node.checkVisibility({ visibilityProperty: true });
    const box = (node) => node.getBoundingClientRect();
    const found = [];
    const parts = [...document.querySelectorAll('.rail, .task-line, .monitor, .spine, .desk')].filter(shown);
    for (const [i, a] of parts.entries()) {
        const p = box(a);
        if (p.left < 0 || p.right > document.documentElement.clientWidth + .5)
            found.push(`${a.className} leaves the page`);
        for (const b of parts.slice(i + 1)) {
            if (a.matches('.monitor') && b.matches('.monitor') && innerWidth < 1280) continue; // one inside the other
            if (a.matches('.task-line') && b.matches('.spine')) continue; // the lamps are in the gap of this line
            const q = box(b);
            if (p.right > q.left + .5 && q.right > p.left + .5 && p.bottom > q.top + .5 && q.bottom > p.top + .5)
                found.push(`${a.className} overlaps ${b.className}`);
        }
    }
    const texts = '.task-line p, .task .words, .task h2, button, .group td, .group th';
    for (const node of document.querySelectorAll(texts)) {
        if (!shown(node) || !node.textContent || node.closest('.unseen, .picture')) continue;
        if (node.matches('button') && node.title?.startsWith(node.textContent)) continue; // the tooltip has it all
        const [wide, high] = [node.scrollWidth - node.clientWidth, node.scrollHeight - node.clientHeight];
        if (wide > 1 || (node.matches('p') && high > 1)) found.push(`“${node.textContent}” is cut off`);
    }
    const desk = document.querySelector('.desk');
    const page = document.scrollingElement;
    if (page.scrollWidth > page.clientWidth) found.push('the page scrolls sideways');
    if (scrollY + box(desk).bottom > page.scrollHeight + .5) found.push('the page ends before the desk');
    if (desk.scrollHeight > desk.clientHeight + 1) found.push('the desk scrolls');
    return found;
}"""
"""Sentences about parts that overlap or leave the page, and about texts that are cut off."""

LONGEST = """text => {
    for (const node of document.querySelectorAll('.task .words, .task-line .words')) node.textContent = text;
}"""
"""Shows a text in place of the present step's."""

TIP = """() => {
    const { monitors, cameras } = window.__aftdeck.views;
    return monitors.flat().some((name) => cameras.find(({ camera }) => camera === name).shows.tip > 0);
}"""
"""Whether a picture on the monitors shows the end effector."""


@pytest.fixture(scope="module", params=SCENARIOS)
def station(request: pytest.FixtureRequest) -> Iterator[str]:
    """Address of a station that runs one of the scenarios."""
    with running_station(request.param) as address:
        yield address


@pytest.mark.parametrize("panel", ["calm", "full"])
def test_page_has_room_for_everything_in_all_sizes(open_page: OpenPage, panel: str) -> None:
    flight = open_page().from_the_start()
    flight.page.evaluate(LONGEST, longest_text())
    if panel == "full":
        flight.page.get_by_role("button", name="Full panel", exact=True).click()
    problems = {}
    for width, height in SIZES:
        flight.resize(width, height)
        problems[f"{width} x {height}"] = [*flight.script(PROBLEMS), *collisions(flight), *_of_size(flight, panel)]
    assert longest_text() in flight.script("document.querySelector('.task .words').textContent"), "the text has changed"
    assert not any(problems.values()), problems


def longest_text() -> str:
    """Return the longest text of a step, with its marks."""
    steps = [step for name in SCENARIOS for step in load_scenario(name).steps]
    return max((text for step in steps for text in (step.text, *(hint.text for hint in step.hints))), key=len)


def _of_size(flight: Flight, panel: str) -> Iterator[str]:
    """Yield a sentence for each problem with the sizes of pictures and desk in the present window."""
    width, height = flight.script("[innerWidth, innerHeight]")
    if not flight.script(TIP):
        yield "no picture shows the end effector"
    if width < LEAST[0] or height < LEAST[1]:
        return
    desk = flight.script("document.querySelector('.desk').getBoundingClientRect().height")
    if panel == "calm" and desk > DESK_SHARE * height:
        yield f"the desk has {100 * desk / height:.0f} % of the height"
    if flight.script("document.scrollingElement.scrollHeight") > height:
        yield "the page scrolls"

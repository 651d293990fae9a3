"""Pictures of the documents: each shows today's page, by the list of the page's parts beside it."""

from __future__ import annotations

from pathlib import Path

import pytest
from page_parts import Part, differences, parts_of, read
from picture_pages import PICTURES, open_page, scenario_file
from pictures import FOLDER, MOST_BYTES
from playwright.sync_api import Browser

from tests.browser.conftest import running_station
from tests.pages import PAGES

LISTED = [Part("Restart", 900, 10), Part("Steady", 20, 700), Part("# in", 60, 700)]

TRIES = 3
"""Number of tries: on a busy machine a page has one more lamp, which says that it is late."""


@pytest.mark.browser
@pytest.mark.slow
@pytest.mark.parametrize("name", PICTURES)
def test_picture_shows_todays_page(name: str, browser: Browser, tmp_path: Path) -> None:
    picture, found = PICTURES[name], ["not compared"]
    for _ in range(TRIES):
        if not found:
            break
        with running_station(scenario_file(picture, tmp_path)) as address:
            page = open_page(browser, address, picture)
            found = [*differences(read(FOLDER / f"{name}.json"), parts_of(page))]
            page.close()
    again = f"the page has changed since its picture; `python scripts/pictures.py {name}` makes the picture again"
    assert not found, "\n".join([again, *found])


def test_documents_show_all_pictures_and_each_has_a_list() -> None:
    assert {path.stem for path in FOLDER.glob("*.jpg")} == set(PICTURES)
    assert {path.stem for path in FOLDER.glob("*.json")} == set(PICTURES)
    texts = "".join(page.read_text(encoding="utf-8") for page in PAGES)
    assert [name for name in PICTURES if f"pictures/{name}.jpg)" not in texts] == []
    assert max(path.stat().st_size for path in FOLDER.glob("*.jpg")) <= MOST_BYTES


@pytest.mark.parametrize(
    ("present", "found"),
    [
        ([*LISTED[:2], Part("# in", 68, 704)], []),
        ([LISTED[0], LISTED[2]], ["“Steady” at 20, 700 px is missing"]),
        ([*LISTED, Part("Pulse", 5, 6)], ["“Pulse” at 5, 6 px is new"]),
        ([Part("Again", 900, 10), *LISTED[1:]], ["“Restart” at 900, 10 px is now “Again”"]),
        ([Part("Restart", 870, 10), *LISTED[1:]], ["“Restart” at 900, 10 px is now at 870, 10 px"]),
    ],
)
def test_differences_name_the_part_that_has_changed(present: list[Part], found: list[str]) -> None:
    assert [*differences(LISTED, present)] == found

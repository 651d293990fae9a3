"""Every built-in scenario has a small picture in the page's list of scenarios."""

from __future__ import annotations

from pathlib import Path

from aftdeck.scenario.load import built_in

FOLDER = Path(__file__).parents[2] / "web" / "src" / "panel" / "rail" / "thumbnails"
MOST_BYTES = 60_000
"""Greatest size of all thumbnails in the page, which contains them in base64 [bytes]."""


def test_each_built_in_scenario_has_a_thumbnail_and_no_other_exists() -> None:
    assert sorted(path.stem for path in FOLDER.glob("*.webp")) == list(built_in())


def test_thumbnails_are_pictures_and_small_together() -> None:
    files = [path.read_bytes() for path in FOLDER.glob("*.webp")]
    assert all(file[:4] == b"RIFF" and file[8:12] == b"WEBP" for file in files)
    assert sum(4 * len(file) / 3 for file in files) < MOST_BYTES
    assert len(set(files)) == len(files)

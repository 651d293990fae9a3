"""Files of the built page."""

from __future__ import annotations

from pathlib import Path

from aftdeck.errors import AftdeckError

STATIC = Path(__file__).parent / "static"


class StationError(AftdeckError):
    """Error: the station cannot start, or its page was not built."""


def built_page() -> str:
    """Return the HTML of the built page.

    Raises:
        StationError: the page was not built.
    """
    page = STATIC / "index.html"
    if not page.is_file():
        raise StationError(
            f"the station's page is missing ({page}): build it with `make fly` in the source tree, or install "
            "Aftdeck from a wheel, which includes it"
        )
    return page.read_text(encoding="utf-8")

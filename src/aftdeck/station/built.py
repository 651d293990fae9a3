"""The page as it was built."""

from __future__ import annotations

from pathlib import Path

from aftdeck.errors import AftdeckError

STATIC = Path(__file__).parent / "static"


class StationError(AftdeckError):
    """The station cannot be started."""


def built_page() -> str:
    """The page's HTML as built.

    Raises:
        StationError: it was not built.
    """
    page = STATIC / "index.html"
    if not page.is_file():
        raise StationError(
            f"the station's page is missing ({page}): build it with `make fly` in the source tree, or install "
            "Aftdeck from a wheel, which brings it"
        )
    return page.read_text(encoding="utf-8")

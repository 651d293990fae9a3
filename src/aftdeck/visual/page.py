"""Page of pictures: a single picture, or a contact sheet of several cameras."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

from aftdeck.visual.picture import Picture

GAP = 8
"""Distance between the pictures of a contact sheet, and from its edges [pixels]."""
HEADER = 30
"""Height of a contact sheet's title [pixels]."""


class Page(NamedTuple):
    """Pictures at their places.

    Attributes:
        width: width [pixels].
        height: height [pixels].
        title: title at the upper edge; empty on a page of one picture.
        cells: each picture, with the position of its upper left corner [pixels].
    """

    width: int
    height: int
    title: str
    cells: tuple[tuple[int, int, Picture], ...]


def single(picture: Picture) -> Page:
    """Return a page of one picture."""
    return Page(picture.width, picture.height, "", ((0, 0, picture),))


def contact_sheet(pictures: Sequence[Picture], title: str) -> Page:
    """Return a page of pictures of the same size, in rows; there are about as many rows as columns."""
    columns = math.ceil(math.sqrt(len(pictures)))
    rows = math.ceil(len(pictures) / columns)
    width, height = pictures[0].width + GAP, pictures[0].height + GAP
    cells = tuple(
        (GAP + k % columns * width, HEADER + k // columns * height, picture) for k, picture in enumerate(pictures)
    )
    return Page(GAP + columns * width, HEADER + rows * height, title, cells)

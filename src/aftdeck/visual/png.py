"""Pages as PNG, painted by Pillow. Edges are smoothed: the picture is painted in double size and then reduced."""

from __future__ import annotations

import io
from collections.abc import Sequence
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont

from aftdeck.visual.page import GAP, HEADER, Page
from aftdeck.visual.picture import Picture
from aftdeck.visual.svg import BACKGROUND, INK, PAPER, RASTER, baseline, text_size

Font = ImageFont.FreeTypeFont | ImageFont.ImageFont

_FINER = 2
"""Number of painted pixels for each pixel of the file, across and down."""


def png(page: Page) -> bytes:
    """Return a page as the bytes of a PNG file."""
    stream = io.BytesIO()
    _painted(page).save(stream, "PNG", compress_level=3)
    return stream.getvalue()


def animated_png(pages: Sequence[Page], step_s: float) -> bytes:
    """Return pages of one size as the bytes of a PNG file that shows each for `step_s` seconds, again and again."""
    images, stream = [_painted(page) for page in pages], io.BytesIO()
    images[0].save(
        stream, "PNG", save_all=True, append_images=images[1:], duration=1000.0 * step_s, loop=0, compress_level=3
    )
    return stream.getvalue()


def pixels(picture: Picture) -> NDArray[np.uint8]:
    """Return a picture as an array (height, width, 3) of its colours."""
    return np.array(_picture(picture), dtype=np.uint8)


def _painted(page: Page) -> Image.Image:
    image = Image.new("RGB", (page.width, page.height), PAPER if page.title else BACKGROUND)
    if page.title:
        ImageDraw.Draw(image).text((GAP, HEADER - 10), page.title, INK, _font(15.0), anchor="ls")
    for x, y, picture in page.cells:
        image.paste(_picture(picture), (x, y))
    return image


def _picture(picture: Picture) -> Image.Image:
    width, height = picture.width, picture.height
    large = Image.new("RGB", (_FINER * width, _FINER * height), BACKGROUND)
    draw = ImageDraw.Draw(large)
    corners = list(map(tuple, (_FINER * picture.points - 0.5).tolist()))
    begins, colours = picture.begins.tolist(), list(map(tuple, picture.colours.tolist()))
    for q, colour in enumerate(colours):
        draw.polygon(corners[begins[q] : begins[q + 1]], fill=colour)
    if picture.look == "1972":
        rows = np.asarray(large).copy()
        for k in range(_FINER):
            rows[k :: _FINER * RASTER] = (rows[k :: _FINER * RASTER] * 0.55).astype(np.uint8)
        large = Image.fromarray(rows)
        draw = ImageDraw.Draw(large)
    _write(draw, picture)
    return large.reduce(_FINER)


def _write(draw: ImageDraw.ImageDraw, picture: Picture) -> None:
    """Write the texts of a picture that is painted in greater size."""
    font = _font(_FINER * text_size(picture))
    for label in picture.labels:
        x, y = baseline(picture, label)
        _outlined(draw, (_FINER * x, _FINER * y), label.text, font, "rs" if label.right else "ls")
    middle = 0.5 * _FINER * picture.width, 0.5 * _FINER * picture.height
    _outlined(draw, middle, picture.failure, font, "ms")


def _outlined(draw: ImageDraw.ImageDraw, at: tuple[float, float], text: str, font: Font, anchor: str) -> None:
    draw.text(at, text, INK, font, anchor=anchor, stroke_width=_FINER, stroke_fill=BACKGROUND)


@lru_cache(maxsize=8)
def _font(size: float) -> Font:
    """Return the font that Pillow brings with it; every machine has it."""
    return ImageFont.load_default(size)

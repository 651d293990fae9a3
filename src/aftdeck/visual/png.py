"""Pages as PNG, painted by Pillow. Edges are smoothed: the picture is painted in double size and then reduced."""

from __future__ import annotations

import io
from collections.abc import Sequence
from functools import lru_cache

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from aftdeck.visual.page import GAP, HEADER, Page
from aftdeck.visual.picture import Picture
from aftdeck.visual.svg import BACKGROUND, INK, PAPER, RASTER, baseline, text_size

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
    image = large.reduce(_FINER)
    if picture.look == "1972":
        rows = np.asarray(image).copy()
        rows[::RASTER] = (rows[::RASTER] * 0.55).astype(np.uint8)
        image = Image.fromarray(rows)
    _write(ImageDraw.Draw(image), picture)
    return image


def _write(draw: ImageDraw.ImageDraw, picture: Picture) -> None:
    """Write the texts of a picture."""
    font = _font(text_size(picture))
    for label in picture.labels:
        anchor = "rs" if label.right else "ls"
        draw.text(
            baseline(picture, label), label.text, INK, font, anchor=anchor, stroke_width=1, stroke_fill=BACKGROUND
        )
    draw.text((picture.width / 2, picture.height / 2), picture.failure, INK, font, anchor="ms")


@lru_cache(maxsize=8)
def _font(size: float) -> ImageFont.FreeTypeFont | ImageFont.ImageFont:
    """Return the font that Pillow brings with it; every machine has it."""
    return ImageFont.load_default(size)

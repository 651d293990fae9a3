"""Pages as PNG, painted by Pillow. Edges are smoothed: the picture is painted in double size and then reduced.

A picture in the look of 1972 is painted in one channel, of greys; only its texts are not grey.
"""

from __future__ import annotations

import io
import math
import struct
import zlib
from collections.abc import Sequence
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont

from aftdeck.visual.covered import mark_uncovered
from aftdeck.visual.page import GAP, HEADER, Page
from aftdeck.visual.picture import Picture
from aftdeck.visual.svg import BACKGROUND, INK, PAPER, RASTER, baseline, text_size

Font = ImageFont.FreeTypeFont | ImageFont.ImageFont

_FINER = 2
"""Number of painted pixels for each pixel of the file, across and down."""
_DIMMED = bytes(int(0.55 * grey) for grey in range(256))
"""Greys of the raster lines, for the greys of the picture."""
_ROOM = 2
"""Room for a text above and below its base line, in heights of the text."""
_LEVEL = 2
"""Level of compression."""


def png(page: Page) -> bytes:
    """Return a page as the bytes of a PNG file."""
    image = np.asarray(_painted(page))
    height, width, channels = image.shape
    # Pillow's writer would try five filters for each row, for three quarters of its time. Pictures of few flat colours
    # are smaller without a filter, which is the 0 at the beginning of each row.
    rows = np.zeros((height, 1 + channels * width), np.uint8)
    rows[:, 1:] = image.reshape(height, -1)
    header = struct.pack(">2I5B", width, height, 8, 2, 0, 0, 0)  # 8 bits, colours are RGB, no interlace
    chunks = ((b"IHDR", header), (b"IDAT", zlib.compress(rows.data, _LEVEL)), (b"IEND", b""))
    return b"\x89PNG\r\n\x1a\n" + b"".join(_chunk(name, content) for name, content in chunks)


def _chunk(name: bytes, content: bytes) -> bytes:
    return struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))


def animated_png(pages: Sequence[Page], step_s: float) -> bytes:
    """Return pages of one size as the bytes of a PNG file that shows each for `step_s` seconds, again and again."""
    images, stream = [_painted(page) for page in pages], io.BytesIO()
    images[0].save(
        stream, "PNG", save_all=True, append_images=images[1:], duration=1000.0 * step_s, loop=0, compress_level=_LEVEL
    )
    return stream.getvalue()


def pixels(picture: Picture) -> NDArray[np.uint8]:
    """Return a picture as an array (height, width, 3) of its colours."""
    return np.array(_picture(picture), dtype=np.uint8)


def _painted(page: Page) -> Image.Image:
    if not page.title:
        return _picture(page.cells[0][2])
    image = Image.new("RGB", (page.width, page.height), PAPER)
    ImageDraw.Draw(image).text((GAP, HEADER - 10), page.title, INK, _font(15.0), anchor="ls")
    for x, y, picture in page.cells:
        image.paste(_picture(picture), (x, y))
    return image


def _picture(picture: Picture) -> Image.Image:
    width, height = picture.width, picture.height
    grey = picture.look == "1972"
    rows = np.zeros((_FINER * height, _FINER * width), np.uint8)
    large = Image.fromarray(rows) if grey else Image.new("RGB", rows.shape[::-1], BACKGROUND)
    large.readonly = False  # greys are painted into `rows`
    draw = ImageDraw.Draw(large)
    seen = np.empty(len(picture.begins) - 1, np.uint8)
    mark_uncovered(picture.points, picture.begins, seen)
    corners, begins = (_FINER * picture.points - 0.5).ravel().tolist(), (2 * picture.begins).tolist()
    colours = picture.colours[:, 0].tolist() if grey else list(map(tuple, picture.colours.tolist()))
    for q in np.flatnonzero(seen).tolist():
        draw.polygon(corners[begins[q] : begins[q + 1]], fill=colours[q])
    if not grey:
        _write(large, picture, 0, large.height)
        return large.reduce(_FINER)
    for k in range(_FINER):
        lines = rows[k :: _FINER * RASTER]
        lines[:] = np.frombuffer(lines.tobytes().translate(_DIMMED), np.uint8).reshape(lines.shape)
    small = large.reduce(_FINER).convert("RGB")
    for top, bottom in _bands(picture):
        band = large.crop((0, top, large.width, bottom)).convert("RGB")
        _write(band, picture, top, bottom)
        small.paste(band.reduce(_FINER), (0, top // _FINER))
    return small


def _bands(picture: Picture) -> list[tuple[int, int]]:
    """Return the first row and the end of the bands with the texts of a picture that is painted in greater size."""
    height, room = _FINER * picture.height, _ROOM * text_size(picture)
    lines = [baseline(picture, label)[1] for label in picture.labels]
    upper = [y + room for y in lines if 2.0 * y < picture.height]
    lower = [y - room for y in lines if 2.0 * y >= picture.height]
    end, begin = (_FINER * round(y) for y in (max(upper, default=0.0), min(lower, default=picture.height)))
    bands = [(0, height)] if picture.failure or end >= begin else [(0, end), (begin, height)]
    return [(top, bottom) for top, bottom in bands if top < bottom]


def _write(image: Image.Image, picture: Picture, top: int, bottom: int) -> None:
    """Write the texts of a band of a picture that is painted in greater size; `top` and `bottom` are rows of it."""
    size = _FINER * text_size(picture)
    for label in picture.labels:
        x, y = baseline(picture, label)
        if top <= _FINER * y < bottom:
            _outlined(image, (_FINER * x, _FINER * y - top), label.text, size, "rs" if label.right else "ls")
    if picture.failure:
        middle = 0.5 * _FINER * picture.width, 0.5 * _FINER * picture.height
        _outlined(image, middle, picture.failure, size, "ms")


def _outlined(image: Image.Image, at: tuple[float, float], text: str, size: float, anchor: str) -> None:
    """Write a text with a border."""
    x, y = int(at[0]), int(at[1])
    left, top, border, letters = _masks(text, size, anchor, at[0] - x, at[1] - y)
    image.paste(BACKGROUND, (x + left, y + top), border)
    image.paste(INK, (x + left, y + top), letters)


@lru_cache(maxsize=64)
def _masks(text: str, size: float, anchor: str, x: float, y: float) -> tuple[int, int, Image.Image, Image.Image]:
    """Return a text's left and upper edge, and the masks of its border and of its letters, for a base line at x and y.

    Most texts are the same in picture after picture, and drawing them takes longer than drawing the polygons.
    """
    font = _font(size)
    box = font.getbbox(text, anchor=anchor, stroke_width=_FINER)
    left, top = (math.floor(edge) - _FINER for edge in box[:2])
    extent = math.ceil(box[2]) + 2 * _FINER - left, math.ceil(box[3]) + 2 * _FINER - top
    border, letters = Image.new("L", extent), Image.new("L", extent)
    at = x - left, y - top
    ImageDraw.Draw(border).text(at, text, 255, font, anchor=anchor, stroke_width=_FINER)
    ImageDraw.Draw(letters).text(at, text, 255, font, anchor=anchor)
    return left, top, border, letters


@lru_cache(maxsize=8)
def _font(size: float) -> Font:
    """Return the font that Pillow brings with it; every machine has it."""
    return ImageFont.load_default(size)

"""Pages as SVG: polygons as paths, texts as texts."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from xml.sax.saxutils import escape

from aftdeck.visual.page import GAP, HEADER, Page
from aftdeck.visual.picture import Label, Picture

BACKGROUND = "#000"
PAPER = "#16181b"
INK = "#d8dcd6"
TEXT_SHARE = 0.033
"""Height of a picture's texts, as a fraction of the picture's height."""
LEAST_TEXT = 9.0
"""Least height of a text [pixels]."""
RASTER = 3
"""Distance of the raster lines of the look of 1972 [pixels]."""
FONT = 'font-family="ui-monospace, Menlo, Consolas, monospace"'
"""Attribute of all texts."""
DEFINITIONS = (
    f'<defs><pattern id="raster" width="{RASTER}" height="{RASTER}" patternUnits="userSpaceOnUse">'
    f'<rect width="{RASTER}" height="1" fill="#000" fill-opacity="0.45"/></pattern></defs>'
)
"""Definitions that a file with pictures needs: the raster lines."""


def svg(page: Page, description: str = "") -> str:
    """Return a page as the text of an SVG file."""
    return "\n".join([_opening(page), *_head(description), _paper(page), *_contents(page), "</svg>"]) + "\n"


def animated_svg(pages: Sequence[Page], step_s: float, description: str = "") -> str:
    """Return several pages of one size as an SVG file that shows each for `step_s` seconds, again and again."""
    total = step_s * len(pages)
    lines = [_opening(pages[0]), *_head(description), _paper(pages[0])]
    for k, page in enumerate(pages):
        begin, end = k / len(pages), (k + 1) / len(pages)
        lines.append(f'<g visibility="{"hidden" if k else "visible"}">')
        times = f"0;{begin:.6f};{end:.6f}" if k else f"0;{end:.6f}"
        values = "hidden;visible;hidden" if k else "visible;hidden"
        lines.append(
            f'<animate attributeName="visibility" calcMode="discrete" values="{values}" keyTimes="{times}" '
            f'dur="{total:g}s" repeatCount="indefinite"/>'
        )
        lines += [*_contents(page), "</g>"]
    return "\n".join([*lines, "</svg>"]) + "\n"


def text_size(picture: Picture) -> float:
    """Return the height of a picture's texts [pixels]."""
    return max(LEAST_TEXT, TEXT_SHARE * picture.height)


def baseline(picture: Picture, label: Label) -> tuple[float, float]:
    """Return the position of a text's outer end on its base line [pixels]."""
    size = text_size(picture)
    x = picture.width - 0.7 * size if label.right else 0.7 * size
    return x, (1.4 * (label.row + 1)) * size if label.row >= 0 else picture.height + (
        1.4 * (label.row + 1) - 0.7
    ) * size


def text_element(x: float, y: float, text: str, *, size: float = 12, anchor: str = "start", fill: str = INK) -> str:
    """Return a text; x and y are the end, the beginning or the middle of its base line, as `anchor` says [pixels]."""
    place = f'x="{x:.1f}" y="{y:.1f}" font-size="{size:g}" text-anchor="{anchor}" fill="{fill}"'
    return f'<text {place} xml:space="preserve">{escape(text)}</text>'


def _opening(page: Page) -> str:
    size = f'width="{page.width}" height="{page.height}" viewBox="0 0 {page.width} {page.height}"'
    return f'<svg xmlns="http://www.w3.org/2000/svg" {size} {FONT}>'


def _head(description: str) -> Iterator[str]:
    if description:
        yield f"<title>{escape(description)}</title>"
    yield DEFINITIONS


def _paper(page: Page) -> str:
    return f'<rect width="{page.width}" height="{page.height}" fill="{PAPER if page.title else BACKGROUND}"/>'


def _contents(page: Page) -> Iterator[str]:
    if page.title:
        yield text_element(GAP, HEADER - 10, page.title, size=15)
    for x, y, picture in page.cells:
        yield f'<svg x="{x}" y="{y}" width="{picture.width}" height="{picture.height}">'
        yield from elements(picture)
        yield "</svg>"


def elements(picture: Picture) -> Iterator[str]:
    """Yield the elements of a picture; its upper left corner is the origin."""
    width, height = picture.width, picture.height
    yield f'<rect width="{width}" height="{height}" fill="{BACKGROUND}"/>'
    yield '<g stroke-width="0.7" stroke-linejoin="round">'
    yield from _paths(picture)
    yield "</g>"
    if picture.look == "1972":
        yield f'<rect width="{width}" height="{height}" fill="url(#raster)"/>'
    size = text_size(picture)
    yield f'<g fill="{INK}" font-size="{size:.1f}" stroke="#000" stroke-width="2.5" paint-order="stroke">'
    for label in picture.labels:
        (x, y), anchor = baseline(picture, label), "end" if label.right else "start"
        yield f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}">{escape(label.text)}</text>'
    if picture.failure:
        yield f'<text x="{width / 2:g}" y="{height / 2:g}" text-anchor="middle">{escape(picture.failure)}</text>'
    yield "</g>"


def _paths(picture: Picture) -> Iterator[str]:
    """Yield a path for each polygon; polygons of the same colour that are painted one after the other share a path.

    Each path has a thin stroke of its own colour, which closes the gaps between neighbouring polygons.
    """
    corners = [f"{x:.1f} {y:.1f}" for x, y in picture.points.tolist()]
    begins = picture.begins.tolist()
    colours = [f"#{r:02x}{g:02x}{b:02x}" for r, g, b in picture.colours.tolist()]
    shape = ""
    for q, colour in enumerate(colours):
        shape += "M" + "L".join(corners[begins[q] : begins[q + 1]]) + "Z"
        if q + 1 == len(colours) or colours[q + 1] != colour:
            yield f'<path d="{shape}" fill="{colour}" stroke="{colour}"/>'
            shape = ""

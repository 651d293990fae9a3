"""Report pages from templates: the document, and what its tables and charts consist of.

A template is an HTML file of the package, beside the module that fills it. Jinja escapes every text that it shows; only
the style and the charts, which are written by `axes` and by matplotlib, are HTML already.
"""

from __future__ import annotations

import functools
from collections.abc import Sequence
from typing import Any, NamedTuple

from aftdeck.extra import needed
from aftdeck.report.page.policy import content_policy, hash_source

COLOURS = ("#1f5fa8", "#c2571a", "#2e7d4f", "#7a4aa0", "#a8322f", "#5b6770", "#8a7a12", "#0e7c86")
"""Colours of lines in charts, in the order of their use."""
_STYLE = "report/page/style.css"


class Link(NamedTuple):
    """Link to a file beside the page."""

    text: str
    path: str


class Line(NamedTuple):
    """Row of a table.

    Attributes:
        cells: its cells.
        kind: its class in the style: ``subject``, ``caution``, ``warning``, or empty.
    """

    cells: Sequence[str | Link]
    kind: str = ""


class Chart(NamedTuple):
    """Drawing of values.

    Attributes:
        svg: the drawing as an SVG element, without the first characters ``<svg``: the template opens it, to add `what`.
        what: what it shows, for a reader who cannot see it.
        caption: text below it.
    """

    svg: str
    what: str
    caption: str = ""


def document(template: str, **values: object) -> str:
    """Return a whole page.

    The page runs no script and requests nothing. Its style element is the only one; the charts have style attributes.

    Args:
        template: path in the package of the template, which extends ``report/page/document.html``.
        values: what the template shows, by name; one without a value is an error.

    Raises:
        InputError: Jinja is not installed.
    """
    templates = _templates()
    style, _, _ = templates.loader.get_source(templates, _STYLE)
    policy = content_policy("style-src 'unsafe-inline'", f"style-src-elem {hash_source(style)}")
    return str(templates.get_template(template).render(style=style, policy=policy, **values))


@functools.cache
def _templates() -> Any:
    jinja: Any = needed("jinja2")
    return jinja.Environment(
        loader=jinja.PackageLoader("aftdeck", ""),
        autoescape=True,
        undefined=jinja.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )

"""Parts of a report page as HTML: the document, facts, tables, charts."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape
from typing import NamedTuple

from aftdeck.report.page.policy import hash_source, policy_element

_STYLE = """
:root { color-scheme: light; }
body { font: 15px/1.5 system-ui, sans-serif; color: #22282e; background: #fff; max-width: 72rem; margin: 2rem auto;
  padding: 0 1.25rem; }
h1 { font-size: 1.6rem; margin: 0 0 .25rem; } h2 { font-size: 1.15rem; margin: 2.2rem 0 .6rem; }
h3 { font-size: 1rem; margin: 1.2rem 0 .4rem; }
p { max-width: 46rem; } .note { color: #5b6770; font-size: .9rem; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { text-align: left; padding: .25rem .9rem .25rem 0; border-bottom: 1px solid #e3e7ea; vertical-align: top; }
th { font-weight: 600; color: #4a525a; font-size: .88rem; } td.n, th.n { text-align: right; }
tr.subject td { font-weight: 600; padding-top: .9rem; }
tr.warning td { color: #a8322f; } tr.caution td { color: #8a5a00; }
.wide { overflow-x: auto; }
.charts { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 28rem), 1fr)); gap: 1rem 1.5rem; }
.pair { display: grid; grid-template-columns: 1fr 1fr; gap: 3px; }
.charts.whole { grid-template-columns: 1fr; }
figure { margin: 0; } figure svg, figure img { width: 100%; height: auto; display: block; }
figure svg * { stroke-linejoin: round; stroke-linecap: butt; }
figcaption { font-size: .88rem; color: #4a525a; margin: .2rem 0 .6rem; }
.facts { display: flex; flex-wrap: wrap; gap: .6rem 2.4rem; margin: 1rem 0; } .facts div { min-width: 7rem; }
.facts b { display: block; font-size: 1.25rem; font-weight: 600; } .facts span { color: #5b6770; font-size: .88rem; }
pre { background: #f5f7f8; padding: .8rem; overflow-x: auto; font-size: .85rem; } code { font-size: .9em; }
summary { cursor: pointer; margin: .6rem 0; }
"""


def document(title: str, body: Iterable[str]) -> str:
    """Return a whole page; `body` is HTML, the title a text.

    The page runs no script and requests nothing. Its style element is the only one; the charts have style attributes.
    """
    name, parts = escape(title), "\n".join(body)
    policy = policy_element("style-src 'unsafe-inline'", f"style-src-elem {hash_source(_STYLE)}")
    return (
        f'<!doctype html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n{policy}\n'
        f'<meta name="viewport" content="width=device-width, initial-scale=1">\n<title>{name}</title>\n'
        f"<style>{_STYLE}</style>\n</head>\n<body>\n{parts}\n</body>\n</html>\n"
    )


def facts(pairs: Iterable[tuple[str, str]]) -> str:
    """Return values in large type, each with what it is."""
    shown = "".join(f"<div><b>{escape(value)}</b><span>{escape(what)}</span></div>" for value, what in pairs)
    return f'<div class="facts">{shown}</div>'


def charts(figures: Iterable[str], *, whole: bool = False) -> str:
    """Return figures side by side, or below each other over the whole width."""
    return f'<div class="charts{" whole" if whole else ""}">{"".join(figures)}</div>'


def figure(content: str, caption: str = "") -> str:
    """Return a figure of HTML content with a caption, which is a text."""
    below = f"<figcaption>{escape(caption)}</figcaption>" if caption else ""
    return f"<figure>{content}{below}</figure>"


class Line(NamedTuple):
    """Row of a table.

    Attributes:
        cells: its cells.
        kind: its class in the style: ``subject``, ``caution``, ``warning``, or empty.
    """

    cells: Sequence[str]
    kind: str = ""


def table(heads: Sequence[str], lines: Iterable[Line], *, numbers: Sequence[int] = (), escaped: bool = False) -> str:
    """Return a table.

    Args:
        heads: heads of the columns.
        lines: rows.
        numbers: columns of numbers, which stand at the right.
        escaped: whether the cells are HTML already.
    """
    marks = ['class="n"' if i in numbers else "" for i in range(len(heads))]
    head = "".join(f"<th {mark}>{escape(name)}</th>" for name, mark in zip(heads, marks, strict=True))
    body = "".join(_row(line, marks, escaped=escaped) for line in lines)
    return f'<div class="wide"><table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table></div>'


def _row(line: Line, marks: Sequence[str], *, escaped: bool) -> str:
    cells = "".join(
        f"<td {mark}>{cell if escaped else escape(cell)}</td>" for cell, mark in zip(line.cells, marks, strict=False)
    )
    return f'<tr class="{line.kind}">{cells}</tr>'

"""List of a page's visible parts, texts and places, which is kept beside each picture of the documents.

Numbers are replaced by a mark, because they change while the page is open. Left out are parts that show nothing but a
number, what is drawn into a camera's picture except its name, the log, and what depends on the machine's load: the
rail's note about low detail, and the latency on the calm page, which appears there only while it is large.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Sequence
from difflib import SequenceMatcher
from pathlib import Path
from typing import NamedTuple

from playwright.sync_api import Page

NUMBER = re.compile(r"[+−-]?(?<![\w.])\d+(?:[.,:/]\d+)*")
"""A number or a time. The digit of a name such as P2 is none."""
MARK = "#"
"""Text in place of a number."""
NEAR_PX = 12
"""Greatest distance of a part from its place in the list [px]. A number with one more digit moves its neighbours by up
to 8 px, and another machine's fonts draw the few signs that the page's own font lacks."""

PARTS = """async () => {
    await document.fonts.ready;
    const shown = (node) => node.checkVisibility({ visibilityProperty: true, opacityProperty: true });
    const leftOut = '.unseen, .log, .rail .note, .calm .rail .lag, .picture :not(.name, .name *)';
    const found = [];
    for (const node of document.body.querySelectorAll('*')) {
        if (node.closest(leftOut) || !shown(node)) continue;
        const own = [...node.childNodes].filter(({ nodeType }) => nodeType === Node.TEXT_NODE);
        const region = node.matches('section, header, dialog, [role=group]') && node.getAttribute('aria-label');
        const text = own.map(({ textContent }) => textContent).join(' ') || region || '';
        const { left, top, right, bottom } = node.getBoundingClientRect();
        const inside = right > Math.max(left, 0) && bottom > Math.max(top, 0) && left < innerWidth && top < innerHeight;
        if (inside) found.push([text.replace(/\\s+/g, ' ').trim(), Math.round(left), Math.round(top)]);
    }
    return found;
}"""
"""Own text of each visible element, or the name of a region without one, with the distances from the window's left and
upper edge [px]."""


class Part(NamedTuple):
    """Visible part of a page.

    Attributes:
        text: its own text, with a mark for each number; the accessible name of a region without a text.
        left: distance of its left edge from that of the window [px].
        top: distance of its upper edge from that of the window [px].
    """

    text: str
    left: int
    top: int


def parts_of(page: Page) -> list[Part]:
    """Return the visible parts of a page, in the order of the document."""
    listed = [Part(NUMBER.sub(MARK, text), left, top) for text, left, top in page.evaluate(PARTS)]
    return [part for part in listed if re.search(r"[^\W\d_]", part.text)]


def write(parts: Sequence[Part], path: Path) -> None:
    """Write a list of parts: a JSON array with one part in each line."""
    lines = ",\n".join(f"  {json.dumps(part, ensure_ascii=False)}" for part in parts)
    path.write_text(f"[\n{lines}\n]\n", encoding="utf-8")


def read(path: Path) -> list[Part]:
    """Return the parts of a list that `write` has written."""
    return [Part(*part) for part in json.loads(path.read_text(encoding="utf-8"))]


def differences(listed: Sequence[Part], present: Sequence[Part]) -> Iterator[str]:
    """Yield a sentence for each part that is new or missing, has another text, or is not near its place."""
    texts = [part.text for part in listed], [part.text for part in present]
    for kind, a, b, c, d in SequenceMatcher(None, *texts, autojunk=False).get_opcodes():
        if kind == "equal":
            yield from (_moved(was, now) for was, now in zip(listed[a:b], present[c:d], strict=True) if _far(was, now))
        elif b - a == d - c:
            for was, now in zip(listed[a:b], present[c:d], strict=True):
                yield f"“{was.text}” at {was.left}, {was.top} px is now “{now.text}”"
        else:
            yield from (f"“{was.text}” at {was.left}, {was.top} px is missing" for was in listed[a:b])
            yield from (f"“{now.text}” at {now.left}, {now.top} px is new" for now in present[c:d])


def _far(was: Part, now: Part) -> bool:
    return max(abs(was.left - now.left), abs(was.top - now.top)) > NEAR_PX


def _moved(was: Part, now: Part) -> str:
    return f"“{was.text}” at {was.left}, {was.top} px is now at {now.left}, {now.top} px"

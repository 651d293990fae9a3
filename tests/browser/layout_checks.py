"""Checks of the layout: nothing scrolls, overlaps or is cut off, and every text is readable."""

from __future__ import annotations

from typing import Any, Protocol

DESK_SHARE = 0.22
"""Greatest share of the page's height that the calm desk has in a window of at least 1280 x 720 px."""


class Scripted(Protocol):
    """A page in any browser."""

    def script(self, text: str) -> Any:  # a result of JavaScript has no type
        """Evaluate JavaScript in the page."""


_CLASHES = """async () => {
    await document.fonts.ready;
    const box = (node) => node.getBoundingClientRect();
    const parts = [...document.querySelectorAll('.rail, .monitor, .spine, .group, .transport, .timeline')];
    const name = (node) => node.className;
    const clashes = [];
    for (const [i, a] of parts.entries()) {
        const p = box(a);
        if (p.left < 0 || p.top < 0 || p.right > innerWidth + .5 || p.bottom > innerHeight + .5)
            clashes.push(`${name(a)} leaves the page`);
        for (const b of parts.slice(i + 1)) {
            if (a.contains(b)) continue;
            if (innerWidth < 1280 && a.matches('.monitor') && b.matches('.monitor')) continue; // MON 2 is inside MON 1
            const q = box(b);
            const apart = p.right <= q.left + .5 || q.right <= p.left + .5
                || p.bottom <= q.top + .5 || q.bottom <= p.top + .5;
            if (!apart) clashes.push(`${name(a)} overlaps ${name(b)}`);
        }
        for (const node of a.querySelectorAll('button, input, td, th, h2, p, small, time')) {
            const q = box(node);
            if (q.width === 0 || node.closest('.unseen')) continue;
            if (q.left < p.left - 1 || q.right > p.right + 1 || q.top < p.top - 1 || q.bottom > p.bottom + 1)
                clashes.push(`“${node.textContent}” leaves ${name(a)}`);
            // A shortened name has a tooltip with the whole text.
            const hasTooltip = node.title && node.title.startsWith(node.textContent);
            if (node.matches('button') && (node.scrollWidth > node.clientWidth + 1) && !hasTooltip)
                clashes.push(`“${node.textContent}” is cut off`);
        }
        const cells = [...a.querySelectorAll('td, th')].filter((cell) => cell.textContent);
        for (const cell of cells) {
            const range = document.createRange();
            range.selectNodeContents(cell);
            if (range.getBoundingClientRect().width > box(cell).width + 1)
                clashes.push(`“${cell.textContent}” is wider than its column`);
        }
    }
    const { scrollHeight, scrollWidth } = document.documentElement;
    if (scrollHeight > innerHeight || scrollWidth > innerWidth) clashes.push('the page scrolls');
    return clashes;
}"""

_TEXTS = """async () => {
    await document.fonts.ready;
    const parse = (colour) => {
        const [r, g, b, a = 1] = colour.match(/[\\d.]+/g).map(Number);
        return { r, g, b, a };
    };
    const over = (top, under) => ({
        r: top.r * top.a + under.r * (1 - top.a),
        g: top.g * top.a + under.g * (1 - top.a),
        b: top.b * top.a + under.b * (1 - top.a),
        a: 1,
    });
    const light = ({ r, g, b }) => [r, g, b]
        .map((v) => v / 255)
        .map((v) => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4))
        .reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i], 0);
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    const texts = [];
    for (let node = walker.nextNode(); node; node = walker.nextNode()) {
        const element = node.parentElement;
        if (!node.textContent.trim() || !element.checkVisibility({ visibilityProperty: true })) continue;
        if (element.closest('.picture, .unseen') || !element.closest('WITHIN')) continue;
        texts.push(appearance(element, node.textContent.trim()));
    }
    for (const field of document.querySelectorAll('input')) {
        if (field.value && field.closest('WITHIN') && field.type === 'text' && field.checkVisibility())
            texts.push(appearance(field, field.value));
    }
    return texts;

    function appearance(element, text) {
        const chain = [];
        for (let up = element; up; up = up.parentElement) chain.unshift(getComputedStyle(up));
        let under = { r: 12, g: 13, b: 14, a: 1 };
        let opacity = 1;
        for (const style of chain) {
            under = over(parse(style.backgroundColor), under);
            opacity *= Number(style.opacity);
        }
        const drawn = element instanceof SVGElement;
        const style = getComputedStyle(element);
        const own = parse(drawn ? style.fill : style.color);
        const ink = light(over({ ...own, a: own.a * opacity }, under));
        const ground = light(under);
        return {
            text,
            contrast: (Math.max(ink, ground) + 0.05) / (Math.min(ink, ground) + 0.05),
            size: parseFloat(style.fontSize) * (drawn ? Math.abs(element.getScreenCTM().d) : 1),
        };
    }
}"""

_COLLISIONS = """async () => {
    await document.fonts.ready;
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    const found = [];
    const texts = [];
    for (let node = walker.nextNode(); node; node = walker.nextNode()) {
        const element = node.parentElement;
        if (!node.textContent.trim() || !element.checkVisibility({ visibilityProperty: true })) continue;
        if (element.closest('.picture, .unseen, svg') || !element.closest('WITHIN')) continue;
        const range = document.createRange();
        range.selectNodeContents(node);
        // The box of a text is higher than its letters: the parts above and below them are empty.
        const room = 0.18 * parseFloat(getComputedStyle(element).fontSize);
        for (const { left, top, right, bottom } of range.getClientRects()) {
            const box = { left, top: top + room, right, bottom: bottom - room };
            let shortened = false;
            for (let up = element; up && up !== document.body; up = up.parentElement) {
                const style = getComputedStyle(up);
                shortened ||= style.textOverflow === 'ellipsis' || style.webkitLineClamp !== 'none';
                if (style.overflowX === 'visible') continue;
                const edge = up.getBoundingClientRect();
                if (box.right > edge.right + 1 && !shortened) found.push(`“${node.textContent}” is cut off`);
                box.left = Math.max(box.left, edge.left);
                box.right = Math.min(box.right, edge.right);
                box.top = Math.max(box.top, edge.top);
                box.bottom = Math.min(box.bottom, edge.bottom);
            }
            if (box.right - box.left > 1 && box.bottom - box.top > 1)
                texts.push({ node, element, text: node.textContent.trim(), box });
        }
    }
    const sheet = [...document.querySelectorAll('dialog[open]')].at(-1);
    for (const [i, a] of texts.entries()) {
        for (const b of texts.slice(i + 1)) {
            if (a.node === b.node) continue;
            if (sheet && sheet.contains(a.element) !== sheet.contains(b.element)) continue; // the sheet covers the page
            const wide = Math.min(a.box.right, b.box.right) - Math.max(a.box.left, b.box.left);
            const high = Math.min(a.box.bottom, b.box.bottom) - Math.max(a.box.top, b.box.top);
            if (wide > 1 && high > 1) found.push(`“${a.text}” lies on “${b.text}”`);
        }
    }
    return found;
}"""


def assert_tidy(page: Scripted) -> None:
    """Assert that nothing scrolls, overlaps, leaves its group or is cut off without an ellipsis."""
    found = clashes(page)
    assert found == [], found


def clashes(page: Scripted) -> list[str]:
    """Return a sentence for each text or part that `assert_tidy` rejects."""
    return list(page.script(_CLASHES)) + collisions(page)


def collisions(page: Scripted, within: str = "body") -> list[str]:
    """Return a sentence for each text that overlaps another one or is cut off without an ellipsis."""
    return list(page.script(_COLLISIONS.replace("WITHIN", within)))


def assert_readable(page: Scripted, within: str = "body", least: int = 80) -> None:
    """Assert that there are more than `least` texts, and that each of them is readable.

    A text is readable if its contrast is at least 4.5 and its font size is at least 10 px. `within` is the
    selector of the part that is checked.
    """
    texts = page.script(_TEXTS.replace("WITHIN", within))
    assert len(texts) > least
    assert [text for text in texts if text["contrast"] < 4.5] == []
    assert [text for text in texts if text["size"] < 10] == []

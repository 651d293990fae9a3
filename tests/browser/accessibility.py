"""The rules of axe, checked in a page."""

from __future__ import annotations

from pathlib import Path

from playwright.sync_api import Page

AXE = Path(__file__).parents[2] / "web/node_modules/axe-core/axe.min.js"
"""axe-core, a development package of the page."""

_RUN = """async () => {
    const { violations } = await axe.run(document, { resultTypes: ['violations'], elementRef: true });
    return violations.flatMap(({ id, help, nodes }) => nodes
        .filter(({ element }) => id !== 'color-contrast' || !isInactive(element))
        .map(({ target }) => `${id}: ${help}: ${target.join(' ')}`));

    // Parts that are not in use are dimmed: WCAG 2.2 (1.4.3) has no least contrast for them.
    function isInactive(element) {
        for (let up = element; up; up = up.parentElement) if (getComputedStyle(up).opacity < 1) return true;
        return false;
    }
}"""


def violations(page: Page) -> list[str]:
    """Return a sentence for each element of the page that violates a rule of axe."""
    if not page.evaluate("'axe' in window"):
        page.evaluate(AXE.read_text(encoding="utf-8"))
    return list(page.evaluate(_RUN))

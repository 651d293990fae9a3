"""Light in the pictures: light conditions, lamps, and the lock of the exposure."""

from __future__ import annotations

from base64 import b64encode

import pytest

from tests.browser.flight import Flight
from tests.browser.layout_checks import assert_readable

pytestmark = [pytest.mark.browser, pytest.mark.slow]

SCENARIO = "loaded"  # without a ghost, which no lamp lights

_BRIGHTNESS = """() => {
    const scene = document.querySelector('canvas.scene');
    const [over, box] = [scene, document.querySelector('.picture')].map((node) => node.getBoundingClientRect());
    const scale = scene.width / over.width;
    const small = new OffscreenCanvas(60, 45).getContext('2d');
    const [left, top] = [box.left - over.left, box.top - over.top].map((at) => at * scale);
    small.drawImage(scene, left, top, box.width * scale, box.height * scale, 0, 0, 60, 45);
    const { data } = small.getImageData(0, 0, 60, 45);
    return data.reduce((sum, value, i) => sum + (i % 4 === 3 ? 0 : value), 0) / (data.length * 0.75);
}"""
"""Mean value of all colours in MON 1's picture, 0 to 255."""


def brightness(flight: Flight) -> float:
    """Return the mean value of MON 1's picture after some pictures."""
    count = flight.script("window.__aftdeck.frames")
    flight.until(f"window.__aftdeck.frames > {count + 6}")
    return float(flight.script(_BRIGHTNESS))


def switch(flight: Flight, *names: str) -> None:
    """Press buttons of the open list. Each press waits until the previous press has had its effect."""
    for name in names:
        key = flight.page.locator(".choices.light").get_by_role("button", name=name, exact=True)
        before = key.get_attribute("aria-pressed")
        key.click()
        flight.page.locator(f".choices.light button:text-is('{name}'):not([aria-pressed={before}])").wait_for()


def test_locked_exposure_darkens_at_night_and_adapts_after_unlock(flight: Flight) -> None:
    flight.until("frame.time_s > 2.4")  # three time constants of the exposure
    day = brightness(flight)
    flight.press("End")
    flight.until("document.querySelector('.monitor .burned.time').textContent.includes('EXP LOCK')")
    assert len(flight.frame().display.lighting.locked) == 1
    flight.press("Home")
    flight.press("Tab", "Tab", "Enter")
    flight.until("frame.display.lighting.condition === 'night'")
    night = brightness(flight)
    assert night < 0.5 * day
    floods = ("fwd floods", "mid floods", "aft floods")
    switch(flight, *floods)
    dark = brightness(flight)
    assert dark < 0.92 * night  # the cameras also see the Earth
    assert_readable(flight, ".choices.light", least=8)
    switch(flight, *floods)
    assert brightness(flight) == pytest.approx(night, rel=0.05)
    flight.press("Escape", "End")
    flight.until("!document.querySelector('.monitor .burned.time').textContent.includes('EXP LOCK')")
    flight.until(f"({_BRIGHTNESS})() > {1.3 * night}")


_COLOURED = """() => {
    const scene = document.querySelector('canvas.scene').getContext('2d');
    const over = scene.canvas.getBoundingClientRect();
    const scale = scene.canvas.width / over.width;
    return [...document.querySelectorAll('.picture')].map((node) => {
        const box = node.getBoundingClientRect();
        const sides = [box.left - over.left, box.top - over.top, box.width, box.height];
        const { data } = scene.getImageData(...sides.map((side) => Math.round(side * scale)));
        let most = 0;
        for (let i = 0; i < data.length; i += 4)
            most = Math.max(most, Math.abs(data[i] - data[i + 1]), Math.abs(data[i] - data[i + 2]));
        return most;
    });
}"""
"""Greatest difference between two colour components of one pixel, for each picture."""


def test_early_flights_make_television_but_not_windows_grey(flight: Flight) -> None:
    assert min(flight.script(_COLOURED)) > 10
    flight.page.locator(".monitor").first.get_by_role("button", name="AFT P", exact=True).click()
    flight.press("Home")
    switch(flight, "early flights")
    count = flight.script("window.__aftdeck.frames")
    flight.until(f"window.__aftdeck.frames > {count + 4}")
    window, television = flight.script(_COLOURED)
    assert window > 10
    assert television < 4  # the edge of the picture contains the background of the page


_BRIGHTEST = """async (png) => {
    const image = new Image();  // not `fetch`, which the page's content policy forbids
    image.src = `data:image/png;base64,${png}`;
    await image.decode();
    const pen = new OffscreenCanvas(image.width, image.height).getContext('2d');
    pen.drawImage(image, 0, 0);
    const { data } = pen.getImageData(0, 0, image.width, image.height);
    return data.reduce((most, value, i) => (i % 4 === 3 ? most : Math.max(most, value)), 0);
}"""


def brightest(flight: Flight, selector: str) -> int:
    """Return the brightest colour value of a part of the page, 0 to 255."""
    png = flight.page.locator(selector).first.screenshot()
    return int(flight.page.evaluate(_BRIGHTEST, b64encode(png).decode()))


def test_dim_reduces_page_and_picture_brightness_and_is_stored(flight: Flight) -> None:
    parts = (
        ".rail h1",
        ".group.mode",
        ".joints thead",
        ".selector [aria-pressed='true']",
        ".burned.name",
    )  # no lamps: they may light up
    lit = [brightest(flight, part) for part in parts]
    flight.page.get_by_role("button", name="Dim", exact=True).click()
    flight.page.reload()
    flight.until("window.__aftdeck?.lastFrame && document.documentElement.matches('.night')")
    dimmed = [brightest(flight, part) / was for part, was in zip(parts, lit, strict=True)]
    assert dimmed == pytest.approx([0.55, 0.55, 0.55, 0.55, 0.75], abs=0.02)
    assert_readable(flight)

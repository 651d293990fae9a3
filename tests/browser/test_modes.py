"""The switches of the modes: MODE rotary, law, RATE HOLD, POSITION HOLD, TEST, and rejected commands."""

from __future__ import annotations

import pytest

from tests.browser.conftest import OpenPage
from tests.browser.flight import ENTERED, LOGGED, TURNED, Flight
from tests.browser.layout_checks import assert_tidy

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.long]

HIDDEN = "document.querySelector('{}').checkVisibility() === false"
SHOWN = "document.querySelector('{}').checkVisibility()"
TO_THE_STOP_MS = 180_000
"""Longest wait until a joint reaches its stop [ms]; the motion takes 20 s."""
CHECK_CRT = "[...document.querySelectorAll('.lamp.caution')].some((lamp) => lamp.textContent.includes('CHECK CRT'))"
"""JavaScript condition: the lamp CHECK CRT is lit. A rejected command lights it for 5 s."""
FILTERED_AND_COMPLETE = f"""() => {{
    const buttons = [...document.querySelectorAll('button')];
    const click = (name) => buttons.find((b) => b.checkVisibility() && b.textContent.includes(name)).click();
    click('CHECK CRT');
    const filtered = {LOGGED};
    click('show all');
    return [filtered, {LOGGED}];
}}"""
"""Press the lamp CHECK CRT and *show all*, and return the kinds of the lines after each press.

One script does both, because a line of another kind ends the filter, and a slow computer can add a line about lost time
at any moment.
"""


def test_brackets_turn_the_rotary_and_enter_enters_the_mode(flight: Flight) -> None:
    flight.enter("ORB UNL")
    for mode in ("END EFF", "ORB LD", "PL", "SINGLE"):
        flight.press("]")
        flight.until(f"{TURNED} === '{mode}'")
    assert flight.frame().mode == "ORB UNL", "turning the rotary does not enter the mode"
    flight.press("[", "[", "[")
    flight.until(f"{TURNED} === 'END EFF'")
    flight.press("Enter")
    flight.until(f"frame.mode === 'END EFF' && {ENTERED} === 'END EFF' && !{TURNED}")


def test_first_click_turns_the_rotary_and_the_second_enters(flight: Flight) -> None:
    flight.enter("ORB UNL")
    flight.turn_to("SINGLE")
    flight.turn_to("DIRECT")
    assert flight.frame().mode == "ORB UNL"
    flight.enter("DIRECT")
    assert flight.frame().law == 9


def test_pl_without_a_payload_is_rejected_when_entered(flight: Flight) -> None:
    before = flight.frame().mode
    flight.turn_to("PL")
    with flight.logs("refused"), flight.shows(CHECK_CRT):
        flight.press("Enter")
    assert flight.frame().mode == before
    flight.until(f"{TURNED} === 'PL'")


def test_desk_shows_only_the_switches_of_the_selected_mode(flight: Flight) -> None:
    flight.enter("ORB UNL")
    flight.until(f"{HIDDEN.format('[aria-label=Law]')} && {HIDDEN.format('.joint-rotary')}")
    flight.turn_to("SINGLE")
    flight.until(f"{SHOWN.format('.joint-rotary')} && {HIDDEN.format('.sequence')}")
    flight.turn_to("OPR CMD")
    flight.until(f"{SHOWN.format('[aria-label=Law]')} && {SHOWN.format('.sequence')}")
    flight.turn_to("ORB LD")
    flight.until(f"{SHOWN.format('.axes')} && {HIDDEN.format('[aria-label=Law]')}")


@pytest.mark.parametrize(("law", "number"), [("position", 1), ("open loop", 3), ("closed loop", 2)])
def test_law_switch_selects_the_law_of_opr_cmd(flight: Flight, law: str, number: int) -> None:
    flight.enter("OPR CMD")
    flight.press_key(law)
    flight.until(f"frame.law === {number} && frame.law_choice === '{law}'")
    flight.until(f"document.querySelector('[aria-label=Law] [aria-pressed=true]').ariaLabel === '{law}'")


def test_cmd_ck_shows_good_or_fail(flight: Flight) -> None:
    flight.enter("OPR CMD")
    flight.press_key("Present")
    flight.press_key("Key in")
    flight.until("/GOOD/.test(document.querySelector('.check.good')?.textContent ?? '')")
    flight.until("document.querySelector('.sequence small').matches('.lit')")
    flight.page.get_by_label("Target X", exact=True).fill("5000")
    flight.press("Enter")
    flight.until("/FAIL/.test(document.querySelector('.check.caution')?.textContent ?? '')")
    assert_tidy(flight)


def test_rate_hold_keeps_the_rates_until_it_is_cancelled(flight: Flight) -> None:
    flight.enter("ORB UNL")
    flight.hold("w")
    flight.until("frame.translation[0] === 1")
    flight.press("h")
    flight.until("frame.rate_hold")
    flight.release("w")
    held = "document.querySelector('.thc .held .mark')"
    flight.until(f"document.querySelector('.thc').matches('.holding') && Number({held}.getAttribute('cy')) < -30")
    own_mark = "document.querySelector('.thc g:not(.held) > .mark')"
    flight.until(f"Number({own_mark}.getAttribute('cy')) === 0")
    assert flight.frame().translation == (1, 0, 0)
    flight.press_key("Rate hold")
    flight.until("!frame.rate_hold && frame.translation[0] === 0")


def test_rate_hold_with_centred_sticks_is_rejected(flight: Flight) -> None:
    flight.enter("ORB UNL")
    with flight.logs("refused"):
        flight.press("h")
    assert not flight.frame().rate_hold


def test_west_button_of_a_pad_sets_rate_hold(open_page: OpenPage) -> None:
    flight = open_page(pad=True).from_the_start()
    flight.enter("ORB UNL")
    flight.pad_axes(0, -1, 0, 0)
    flight.until("frame.translation[0] === 1")
    flight.script("window.testPad.buttons[2].pressed = true")
    flight.until("frame.rate_hold")
    flight.press("Space")
    flight.until("!frame.rate_hold && frame.translation[0] === 0")


def test_position_hold_is_switched_on_and_off(flight: Flight) -> None:
    flight.enter("ORB UNL")
    flight.press_key("Pos hold Ins")
    flight.until("frame.position_hold")
    flight.press_key("Pos hold Ins")
    flight.until("!frame.position_hold")


def test_brakes_safing_and_position_hold_work_in_automatic_modes(flight: Flight) -> None:
    flight.turn_to("AUTO 1")
    flight.page.get_by_label("Brakes", exact=False).wait_for(state="visible")
    flight.enter("OPR CMD")
    for name in ("Safing Del", "Pos hold Ins"):
        flight.page.get_by_role("button", name=name, exact=True).wait_for(state="visible")
    assert_tidy(flight)
    flight.press("Delete")
    flight.until("frame.safing")
    flight.press("Delete", "Insert")
    flight.until("!frame.safing && frame.position_hold")
    flight.press("b")
    flight.until("frame.brakes && document.querySelector('.standing .caution')")


def test_test_lights_every_lamp_and_segment_while_entered(flight: Flight) -> None:
    dark = "[...document.querySelectorAll('.lamp')].filter((lamp) => !lamp.matches('.caution')).length"
    angle = "document.querySelector('.joints .angle').textContent"
    flight.enter("TEST")
    flight.until(f"{dark} === 0 && {angle} === '±888.8'")
    flight.until("document.querySelectorAll('.sequence small.lit').length === 2")
    flight.enter("ORB UNL")
    flight.until(f"{dark} > 3 && !{angle}.includes('888')")


def test_lamp_filters_the_log_and_outlines_its_group(flight: Flight) -> None:
    flight.turn_to("PL")
    with flight.logs("refused"), flight.shows(CHECK_CRT):
        flight.press("Enter")
    with flight.logs("mode"):
        flight.enter("END EFF")
    filtered, complete = flight.script(FILTERED_AND_COMPLETE)
    assert set(filtered) == {"refused"}
    assert "mode" in complete
    with flight.shows("document.querySelector('.events').matches('.concerned')"):
        flight.page.get_by_role("button", name="CHECK CRT").click()
    flight.until("!document.querySelector('.concerned')")


def test_joint_past_its_soft_stop_in_direct_is_amber(flight: Flight) -> None:
    wrist_pitch = 3
    row = f"document.querySelectorAll('.joints tbody tr')[{wrist_pitch}]"
    flight.enter("DIRECT")
    flight.page.get_by_role("group", name="Joint").get_by_role("button").nth(wrist_pitch).click()
    flight.until(f"frame.joint === {wrist_pitch} && {row}.matches('.selected')")
    flight.hold("s")
    flight.until(f"frame.zones[{wrist_pitch}] === 2", TO_THE_STOP_MS)
    flight.until_lit("SOFT STOP")
    amber = "'rgb(255, 181, 52)'"
    name, angle, pointer = (f"{row}.querySelector('{part}')" for part in ("th", ".angle", ".pointer"))
    flight.until(f"[{name}, {angle}].every((each) => getComputedStyle(each).color === {amber})")
    flight.until(f"getComputedStyle({pointer}).fill === {amber}")
    flight.until(f"frame.zones[{wrist_pitch}] === 3", TO_THE_STOP_MS)
    flight.release("s")
    flight.until("document.querySelector('.acting')?.textContent.includes('hard stop')")

"""The text pilot: what it reads and decides, and a scenario that it completes by text and keys alone."""

from __future__ import annotations

import pytest

from tests.browser.conftest import OpenPage
from tests.browser.text_pilot.decide import Fly, Go, Lost, Press, Wait, decide
from tests.browser.text_pilot.pilot import Pilot
from tests.browser.text_pilot.reading import Part, Reading, read

SCENARIO = "tutorial"
CALM = True
LIMIT_S = 600.0
"""Longest flight [s]; it takes about three minutes on a machine that is not busy."""

GUIDE = """\
- banner:
  - text: MET 000/00:01:04
- group "Rate":
  - button "Coarse"
  - button "Vernier" [pressed]
- button "Capture G, hold 0.3 s": Capture G
- region "End effector latches open, 7 s SPEC 94":
  - heading "End effector latches open, 7 s SPEC 94" [level=2]
- region "Clearance":
  - list:
    - listitem "Palm touches receptacle, 0.3 in deep"
    - 'listitem "Escape: THC −Z (Q)"'
- region "Guide":
  - text: 2 of 6
  - 'group "To over pin: 6.7 ft, 0.0°; +X (W) 6.6 ft, −Y (A) 12 in."':
    - paragraph: to over pin 6.7 ft, 0.0°
    - list:
      - listitem "+X": W 6.6 ft
      - listitem "−Y": A 12 in
      - listitem "Z, within tolerance": 0.0 in
      - listitem "+pitch, within tolerance": I 1.5°
  - heading "Move it" [level=2]
  - paragraph:
    - img "full stop"
    - text: "moves it: hold"
    - emphasis: WR
    - text: "."
  - list "Controls of this step":
    - listitem: W closer
    - listitem:
      - img "full stop"
      - text: next camera
  - paragraph: "Next: Close in"
  - button "Enter END EFF"
"""


def test_reading_has_the_step_its_keys_and_the_motion_left() -> None:
    now = read(GUIDE)
    assert (now.count, now.title, now.text) == ("2 of 6", "Move it", "full stop moves it: hold WR.")
    assert now.keys == (("W", "closer"), ("full stop", "next camera"))
    assert [(part.stick, part.key, part.near) for part in now.parts] == [
        ("+X", "W", False),
        ("−Y", "A", False),
        ("Z", "", True),
        ("+pitch", "I", True),
    ]
    assert [part.size for part in now.parts] == pytest.approx([2.01168, 0.3048, 0.0, 1.5])
    assert (now.clock, now.rate, now.enter, now.busy) == (64.0, "Vernier", "Enter END EFF", "latches open, 7 s")
    assert (now.holds, now.escape) == ((("G", 0.3),), "Q")


def test_pilot_does_the_one_thing_of_the_opening_shot() -> None:
    opening = '- region "Welcome":\n  - heading "This is a robot arm."\n  - paragraph: "Now hold Q: up."\n'
    assert decide(read(opening)) == Press("Q", 0.4)
    assert isinstance(decide(read("- banner")), Wait)


def step(text: str = "", keys: str = "WSADQE", sizes: dict[str, float] | None = None, **other: object) -> Reading:
    sticks = {"W": "+X", "A": "−Y", "E": "+Z", "I": "+pitch"}
    parts = tuple(Part(sticks[key], key, size, near=False) for key, size in (sizes or {}).items())
    caps = tuple((key, "") for key in keys)
    return Reading(count="1 of 2", text=text, keys=caps, parts=parts, **other)  # type: ignore[arg-type]


def flown(text: str, keys: str, **sizes: float) -> str:
    act = decide(step(text, keys, sizes))
    assert isinstance(act, Fly)
    return act.part.key


def test_pilot_lines_up_before_it_goes_where_the_text_points() -> None:
    assert flown("Move it.", "WAE", W=2.0, A=0.3) == "W"
    assert flown("Hold W until it is there.", "WAE", W=2.0, A=0.3) == "A"
    assert flown("Hold W until it is there.", "WAEI", W=2.0, A=0.3, I=4.0) == "I"
    assert flown("Move it first to port, A, then on.", "WAE", W=2.0, A=0.3) == "A"
    assert flown("Move it sideways.", "A", W=2.0, A=0.3) == "A"


def test_pilot_does_what_the_text_says() -> None:
    assert decide(step("Hold G until its bar is full.", holds=(("G", 0.3),))) == Press("G", 0.8)
    assert isinstance(decide(step("Hold G until its bar is full."), frozenset("G")), Wait)
    assert isinstance(decide(step("Keep still.", sizes={"W": 1.0})), Wait)
    assert decide(step(enter="Enter ORB LD", sizes={"W": 1.0})) == Go("Enter ORB LD")
    assert decide(step("V for slow rates.", sizes={"W": 0.2}, rate="Coarse")) == Press("V")
    assert decide(step("Hold W.", sizes={"W": 1.0}, escape="S")) == Press("S", 0.4)
    assert isinstance(decide(step("Turn it.", sizes={"I": 5.0})), Lost)


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.browser
def test_scenario_is_completed_by_text_and_keys_alone(open_page: OpenPage) -> None:
    page = open_page(1440, 900).from_the_start().page
    report = Pilot(page).fly(LIMIT_S)
    assert (report.complete, report.lost) == (True, [])

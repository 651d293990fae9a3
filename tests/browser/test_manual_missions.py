"""Whole missions flown manually: keys and keyed-in targets on the page replace the phases of the script."""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from aftdeck import Simulation
from aftdeck.recording.reader import Recording
from aftdeck.recording.replay import verify
from aftdeck.scenario.load import load_scenario
from aftdeck.scenario.model import PhasePlan
from aftdeck.station.conversion.frame_of import Displays
from aftdeck.station.messages.frame import Aim
from tests.browser.conftest import OpenPage, running_station
from tests.browser.flight import Flight
from tests.scenario.missions import EXPECTED_KINDS, TURNING_POINTS

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.long]

MISSIONS = ("concept-1972-script", "srms-berth")
"""One mission for each worksite."""
INCH = 0.0254
LEG_MS = 400_000
"""Longest wait for the end of a phase [ms]; a station on a busy machine may run slower than the clock."""
KEYS = {(0, 1.0): "w", (0, -1.0): "s", (2, 1.0): "e", (2, -1.0): "q"}
"""Key for each axis and sign of the THC."""
AT_REST = "Math.hypot(...frame.display.actual.velocity) < 1e-4"
SEAT = "frame.work.cargo[0].seat"
UNTIL = {
    "captured": "frame.work.cargo[0].held",
    "released": "!frame.work.cargo[0].held",
    "latched": f"{SEAT} !== '' && document.querySelector('.log :is([data-kind=latched], [data-kind=docked])')",
    "unlatched": f"{SEAT} === ''",
}


@pytest.fixture(scope="module", params=MISSIONS)
def mission(request: pytest.FixtureRequest) -> str:
    """Name of the scenario."""
    return str(request.param)


@pytest.fixture(scope="module")
def recordings(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Folder of the recordings."""
    return tmp_path_factory.mktemp("by-hand")


@pytest.fixture(scope="module")
def station(mission: str, recordings: Path) -> Iterator[str]:
    """Address of a station that records."""
    with running_station(mission, "--record", str(recordings)) as address:
        yield address


def test_mission_of_a_script_is_flown_manually(open_page: OpenPage, mission: str, recordings: Path) -> None:
    aims = _aims(mission)
    flight = open_page().from_the_start()
    for phase in load_scenario(mission).phases:
        _fly(flight, phase, aims.get(phase.name))
    flight.press_key("Restart")
    flight.until("frame.time_s < 5")
    newest = sorted(recordings.glob("*.mcap"), key=lambda path: path.stat().st_mtime)[-2]
    events = [event for _, record in Recording(newest).steps() for event in record.events]
    assert [event.kind for event in events if event.kind in TURNING_POINTS] == EXPECTED_KINDS[mission]
    assert not {event.kind for event in events} & {"fault", "inhibit", "missed"}
    assert {record.by for _, record in Recording(newest).steps()} == {"hand"}
    assert verify(newest).equal


def _aims(mission: str) -> dict[str, Aim]:
    """Return the target of each phase of the script, in panel components."""
    sim = Simulation(mission)
    displays, aims = Displays(sim.scenario), {}
    while not sim.ended:
        sim.advance()
        if sim.look().goal is not None and sim.look().phase not in aims:
            aim = displays.frame(sim.look(), 0).display.aim
            assert aim is not None
            aims[sim.look().phase] = aim
    return aims


def _fly(flight: Flight, phase: PhasePlan, aim: Aim | None) -> None:
    """Fly a phase manually."""
    if flight.frame().rate != phase.rate:
        flight.press("v")
        flight.until(f"frame.rate === '{phase.rate}'")
    flight.enter(phase.mode)
    if phase.mode == "OPR CMD":
        assert aim is not None
        _key_in(flight, aim)
        flight.press("p")
        flight.until("frame.sequence === 'in progress'")
    if phase.until is not None:
        with _held(flight, {"close": "g", "open": "r"}.get(phase.effector or "") or ("t" if phase.latch else None)):
            flight.until(UNTIL[phase.until], LEG_MS)
    elif phase.mode == "OPR CMD":
        flight.until(f"frame.sequence === 'idle' && {AT_REST}", LEG_MS)
    else:
        ((axis, value),) = [(i, value) for i, value in enumerate(phase.translation) if value]
        assert phase.duration is not None
        until = flight.frame().time_s + abs(value) * phase.duration
        with _held(flight, KEYS[axis, math.copysign(1.0, value)]):
            flight.until(f"frame.time_s > {until}", LEG_MS)
        flight.until(AT_REST)


@contextmanager
def _held(flight: Flight, key: str | None) -> Iterator[None]:
    """Hold a key during the `with` block; without a key, do nothing."""
    if key is not None:
        flight.hold(key)
    yield
    if key is not None:
        flight.release(key)


def _key_in(flight: Flight, aim: Aim) -> None:
    """Key in a target in the units of the page, and wait until CMD CK is GOOD."""
    unit = flight.script("document.querySelector('.keyed i').textContent")
    metre = {"in": 1.0 / INCH, "m": 1.0}[unit]
    shown = [*(value * metre for value in aim.position), *(math.degrees(angle) for angle in aim.attitude)]
    for name, value in zip(("X", "Y", "Z", "pitch", "yaw", "roll"), shown, strict=True):
        flight.page.get_by_label(f"Target {name}", exact=True).fill(f"{value:.4f}")
    flight.press_key("Key in")
    flight.until(
        f"frame.display.aim && Math.abs(frame.display.aim.position[0] - {aim.position[0]}) < 1e-4 && frame.check?.good"
    )
    flight.script("document.activeElement.blur()")

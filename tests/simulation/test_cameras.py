"""Camera drives: rates, limits, rejected commands, and independence of everything else."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterable
from pathlib import Path

import msgspec
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import aftdeck
from aftdeck.bodies.cameras import Camera, Drive, Setting, Travel, setting
from aftdeck.errors import InputError
from aftdeck.scenario.all_cameras import cameras_of
from aftdeck.scenario.load import built_in, load_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.camera_drives import CameraDrive, Cameras, driven_setting
from aftdeck.simulation.run import SavedSimulation
from aftdeck.station.conversion.welcome_of import welcome_of
from tests import loaded

PERIOD = 0.02
switch = st.floats(-1.0, 1.0)
commands = st.deferred(
    lambda: st.builds(
        CameraDrive,
        camera=st.sampled_from([camera.name for camera in driven()]),
        pan=switch,
        tilt=switch,
        zoom=switch,
        slow=st.booleans(),
    )
)


def deploy() -> Scenario:
    return loaded.scenario("srms-deploy")


def driven() -> list[Camera]:
    return [camera for camera in cameras_of(deploy()) if camera.drive is not None]


def travels(drive: Drive | None) -> tuple[Travel | None, ...]:
    assert drive is not None
    return drive.pan, drive.tilt, drive.zoom


def flown(given: Iterable[CameraDrive | None]) -> list[tuple[Setting, ...]]:
    """Return the drive settings after each step."""
    sim = aftdeck.Simulation(deploy())
    return [sim.step(aftdeck.Inputs(camera=command)).views for command in given]


@given(st.lists(commands, min_size=1, max_size=60), st.floats(0.001, 3.0))
def test_camera_drive_keeps_its_limits_and_rates(given_commands: list[CameraDrive], period: float) -> None:
    cameras = Cameras(deploy())
    views = cameras.first
    for command in given_commands:
        before, views = views, cameras.driven(views, command, period)
        for camera, was, now in zip(driven(), before, views, strict=True):
            pushed = (command.pan, command.tilt, -command.zoom) if camera.name == command.camera else (0.0, 0.0, 0.0)
            for travel, a, b, push in zip(travels(camera.drive), was, now, pushed, strict=True):
                if travel is None or push == 0.0:
                    assert b == a
                    continue
                rate = travel.slow if command.slow and travel.slow is not None else travel.rate
                assert travel.least <= b <= travel.greatest
                assert abs(b - a) <= abs(push) * rate * period * (1.0 + 1e-12) + 1e-15
                assert (b - a) * push >= 0.0


@given(st.deferred(lambda: st.sampled_from(driven())), st.sampled_from([-1.0, 1.0]), st.floats(0.005, 0.1))
def test_camera_drive_ends_exactly_at_its_stop(camera: Camera, push: float, period: float) -> None:
    at = setting(camera)
    for _ in range(math.ceil(40.0 / period)):
        at = driven_setting(camera, at, CameraDrive(camera.name, push, push, push), period)
    for travel, angle, way in zip(travels(camera.drive), at, (push, push, -push), strict=True):
        if travel is not None:
            assert angle == (travel.greatest if way > 0.0 else travel.least)


def test_shuttle_camera_drives_take_the_published_times() -> None:
    """340 deg at 12 deg/s is 28.3 s, at 1.2 deg/s ten times as long; the zoom takes 8 s from end to end."""
    for slow, seconds in ((False, 340.0 / 12.0), (True, 340.0 / 1.2)):
        at, steps = Setting(math.radians(-170.0), 0.0, 1.0), 0
        while at.pan < math.radians(170.0):
            at, steps = driven_setting(driven()[0], at, CameraDrive("A", pan=1.0, slow=slow), PERIOD), steps + 1
        assert steps * PERIOD == pytest.approx(seconds, abs=2 * PERIOD)
    at, steps = Setting(0.0, 0.0, math.radians(77.0)), 0
    while at.zoom > math.radians(9.0):
        at, steps = driven_setting(driven()[0], at, CameraDrive("A", zoom=1.0), PERIOD), steps + 1
    assert steps * PERIOD == pytest.approx(8.0, abs=2 * PERIOD)


def test_released_camera_stops_at_once_and_keeps_its_settings() -> None:
    push = CameraDrive("B", pan=1.0, tilt=-0.5)
    views = flown([push] * 5 + [None] * 5)
    rate = math.radians(12.0)
    assert views[4][1].pan - views[3][1].pan == pytest.approx(rate * PERIOD)
    assert views[4][1].tilt - views[3][1].tilt == pytest.approx(-0.5 * rate * PERIOD)
    assert all(after is views[4] for after in views[5:])


def test_camera_motion_changes_no_other_value() -> None:
    still, turned = aftdeck.Simulation(deploy()), aftdeck.Simulation(deploy())
    for _ in range(20):
        one = still.step(aftdeck.Inputs())
        two = turned.step(aftdeck.Inputs(camera=CameraDrive("ELB", tilt=1.0)))
        assert two.views != one.views and two.sha256 != one.sha256
        assert msgspec.structs.replace(two, views=one.views, sha256=one.sha256) == one


def test_camera_command_has_the_command_delay() -> None:
    delayed = aftdeck.Simulation(dataclasses.replace(deploy(), delay=3))
    frames = [delayed.step(aftdeck.Inputs(camera=CameraDrive("A", pan=1.0) if k == 0 else None)) for k in range(6)]
    moving = [k for k in range(1, 6) if frames[k].views != frames[k - 1].views]
    assert moving == [3]


@settings(max_examples=5, deadline=None)
@given(st.lists(st.none() | commands, min_size=4, max_size=40), st.data())
def test_restored_state_continues_bit_for_bit(given_commands: list[CameraDrive | None], data: st.DataObject) -> None:
    at = data.draw(st.integers(0, len(given_commands) - 1))
    sim = aftdeck.Simulation(deploy())
    frames, saved = [], sim.save()
    for k, command in enumerate(given_commands):
        if k == at:
            saved = sim.save()
        frames.append(sim.step(aftdeck.Inputs(camera=command)))
    packed = msgspec.msgpack.decode(msgspec.msgpack.encode(saved), type=SavedSimulation)
    other = aftdeck.Simulation(deploy())
    other.step(aftdeck.Inputs(camera=CameraDrive("A", pan=1.0)))
    other.restore(packed)
    rest = [other.step(aftdeck.Inputs(camera=command)) for command in given_commands[at:]]
    assert msgspec.msgpack.encode(rest) == msgspec.msgpack.encode(frames[at:])


@pytest.mark.parametrize(
    ("command", "message"),
    [
        (CameraDrive("Q", pan=1.0), r"'Q' .* A, B, C, D, KEEL, ELB, WR$"),
        (CameraDrive("ENG", pan=1.0), r"'ENG'"),
        (CameraDrive("A", pan=1.01), r"^camera\.pan: got 1\.01\b"),
        (CameraDrive("A", tilt=math.nan), r"^camera\.tilt: got nan\b"),
        (CameraDrive("A", zoom=-math.inf), r"^camera\.zoom: got -inf\b"),
    ],
)
def test_invalid_camera_command_is_rejected_without_effect(command: CameraDrive, message: str) -> None:
    sim = aftdeck.Simulation(deploy())
    sim.step(aftdeck.Inputs())
    before = sim.save()
    with pytest.raises(InputError, match=message):
        sim.step(aftdeck.Inputs(camera=command))
    assert sim.save() == before


def test_run_begins_with_the_scenario_s_settings_and_returns_to_them() -> None:
    aimed = load_scenario("concept-1972", {"cameras.A": {"pan": 0.3, "zoom": 0.7}})
    sim, plain = aftdeck.Simulation(aimed), aftdeck.Simulation("concept-1972")
    first, own = sim.step(aftdeck.Inputs()).views, plain.step(aftdeck.Inputs()).views
    assert first == (Setting(0.3, own[0].tilt, 0.7), *own[1:])
    turned = sim.step(aftdeck.Inputs(camera=CameraDrive("A", pan=1.0))).views
    assert turned[0].pan > 0.3
    assert sim.step(aftdeck.Inputs(initialise="full problem")).views == first


def test_cameras_are_listed_before_windows_and_engineering_view() -> None:
    for name in ("srms-deploy", "concept-1972"):
        kinds = [camera.kind for camera in cameras_of(load_scenario(name))]
        assert kinds == sorted(kinds, key=["camera", "window", "engineering"].index)
        assert set(kinds) == {"camera", "window", "engineering"}


@pytest.mark.parametrize("name", built_in())
def test_every_camera_is_on_an_existing_body(name: str) -> None:
    shown = welcome_of(load_scenario(name), demo=False)
    assert {camera.body for camera in shown.cameras} <= {body.name for body in shown.bodies}


def test_payload_cameras_exist_only_with_the_payload() -> None:
    on_payload = {"P1", "P2"}
    for name, expected in (("concept-1972", on_payload), ("free-flyer", set())):
        assert on_payload & {camera.name for camera in cameras_of(load_scenario(name))} == expected


def test_arm_cameras_exist_only_with_their_frame(tmp_path: Path) -> None:
    """The Shuttle's arm at the concept's bay carries the cameras of the frames that it has."""
    file = tmp_path / "mixed.toml"
    joints = [f"{angle} deg" for angle in (-31, 79, -103, -77, 17, -128)]
    file.write_text(f'title = "t"\narm = "srms"\nworksite = "concept-1972"\n[initial]\njoints = {joints}\n')
    mixed = load_scenario(file)
    there = {camera.name for camera in cameras_of(mixed)}
    listed = {camera.name: camera.body for camera in mixed.worksite.cameras if camera.body.startswith("arm.")}
    assert "arm.base" in listed.values()
    frames = mixed.arm.model.frames
    assert {name for name, body in listed.items() if body not in frames} & there == set()
    assert {name for name, body in listed.items() if body in frames} <= there

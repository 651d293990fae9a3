"""L and P vectors of V.B, against the poses of eye and systems in the scene, and the report's rule for the payload."""

from __future__ import annotations

import msgspec
import numpy as np
import pytest

from aftdeck.arrays import Array
from aftdeck.mainprior.systems import Placed
from aftdeck.mainprior.tables import LISTS
from aftdeck.simulation.frame import Frame
from tests.each import each
from tests.mainprior.flown import frames, routine, scene

ASPECT = 4 / 3


def eye_in_reference(frame: Frame, camera: str, orbiter: Placed) -> tuple[Array, Array]:
    """Return the eye (3,) and the directions right, down and ahead (3, 3) of a camera in R."""
    aim = scene().aim(frame, camera, ASPECT)
    return orbiter.outside(aim.position), aim.axes @ orbiter.axes.T


@each("frame", frames)
def test_l_vectors_lead_from_the_eye_to_the_origin_of_each_system(frame: Frame) -> None:
    for camera in LISTS:
        found = routine().priority(frame, camera)
        eye, _ = eye_in_reference(frame, camera, found.stage.frames["orbiter"])
        assert set(found.vectors.eye) == set(found.stage.systems)
        for system, pose in found.stage.systems.items():
            expected = pose.axes.T @ (pose.origin - eye)
            assert found.vectors.eye[system] == pytest.approx(expected, abs=1e-9), (camera, system)


def test_an_orbiter_that_moved_has_left_the_cae_behind() -> None:
    frame = frames()[0]
    travel = (3.0, -4.0, 12.0)
    moved = msgspec.structs.replace(frame, work=msgspec.structs.replace(frame.work, orbiter=travel))
    for camera in ("A", "G", "H"):
        found = routine().priority(moved, camera)
        eye, _ = eye_in_reference(moved, camera, found.stage.frames["orbiter"])
        assert found.vectors.eye["LS"] == pytest.approx(found.stage.systems["LS"].origin - eye, abs=1e-9)
        assert np.linalg.norm(found.vectors.eye["LS"] - found.vectors.eye["LR"]) == pytest.approx(13.0)
        assert found.stage.systems["LS"].origin == pytest.approx(-np.array(travel), abs=1e-9)


@each("frame", frames)
def test_p_vectors_are_the_display_plane_in_each_system(frame: Frame) -> None:
    for camera in LISTS:
        found = routine().priority(frame, camera)
        _, axes = eye_in_reference(frame, camera, found.stage.frames["orbiter"])
        wide = scene().aim(frame, camera, ASPECT).wide
        rows = np.array([axes[2] / wide, axes[1], axes[0]])
        for system, pose in found.stage.systems.items():
            assert found.vectors.display[system] == pytest.approx(rows @ pose.axes, abs=1e-9), (camera, system)


def test_the_payload_at_rest_in_the_bay_has_the_axes_of_r() -> None:
    """Mode 1 of V.B: LP = LR + TP."""
    frame = next(frame for frame in frames() if frame.work.task == 1 and frame.work.cargo[0].seat == "bay")
    found = routine().priority(frame, "A")
    expected = found.vectors.eye["LR"] + found.stage.systems["LP"].origin
    assert found.vectors.eye["LP"] == pytest.approx(expected, abs=1e-9)


def test_a_held_payload_has_the_axes_that_the_report_gives_it_in_system_2() -> None:
    """Other modes, acquired in line with cos R2 > 0: LP = (-(L2Z + T2Z), L2Y + T2Y, L2X + T2X)."""
    frame = next(frame for frame in frames() if frame.work.task > 1)
    found = routine().priority(frame, "G")
    hand, payload = found.stage.systems["L2"], found.stage.systems["LP"]
    x, y, z = found.vectors.eye["L2"] + hand.within(payload.origin)
    assert found.vectors.eye["LP"] == pytest.approx(np.array([-z, y, x]), abs=0.02 * float(np.hypot(x, z)))

"""Frames from the report's words: what the visual scene program knew of a run.

The 32 words of a step (TABLE II) give the six joint angles. All else follows from the words since the initialisation:
the control word shows in which direction the switches of telescope, prong and the selected camera drive, but not how
far; these parts move at their rates. The task phase shows when the payload was acquired and released. While the arm is
inhibited (bit 19), the arm with its telescope and its payload stay as in the last frame; while the finger is inhibited
(bit 18), the prong stays (Figure 11). Source: the final report of the Remote Manipulator Simulation, TABLE II and the
visual scene program.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Annotated

import msgspec
import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.pose import POSE, compose, inverse, row_of, rows, vec3
from aftdeck.errors import InputError, ScenarioError
from aftdeck.files import read
from aftdeck.frames import Pose
from aftdeck.historical.frame_words import WORDS, FrameBlock, decode_block
from aftdeck.historical.words_file import check_arm
from aftdeck.kinematics.frames import frames_of, place_frames
from aftdeck.matrices import distance
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.camera_drives import CameraDrive, Cameras
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.payloads.task_phases import ACQUISITION
from aftdeck.simulation.run import Simulation
from aftdeck.units import short
from aftdeck.worksite.report import Cargo


class _Line(msgspec.Struct, frozen=True):
    """Field that is read from a line of a file of words."""

    words: Annotated[tuple[str, ...], msgspec.Meta(min_length=WORDS, max_length=WORDS)]


def read_blocks(path: Path) -> tuple[FrameBlock, ...]:
    """Return the frame blocks of a file of words, one for each control step.

    Raises:
        InputError: the file cannot be read or is empty, or a line has no valid block; the message names the line.
    """
    try:
        text = read(path, most=None).text
    except ScenarioError as error:
        raise InputError(str(error)) from None
    found = []
    for number, line in enumerate(text.splitlines(), 1):
        try:
            words = msgspec.json.decode(line, type=_Line).words
            found.append(decode_block([_octal(word) for word in words]))
        except (msgspec.DecodeError, InputError) as error:
            raise InputError(f"{path}:{number}: {error}") from None
    if not found:
        raise InputError(f"{path}: the file is empty; each control step needs a line with its {WORDS} words")
    return tuple(found)


def _octal(word: str) -> int:
    if not re.fullmatch(r"[0-7]{1,8}", word):
        raise InputError(f"got the word {short(word)}, expected up to eight digits from 0 to 7")
    return int(word, 8)


def frames_from(scenario: Scenario, blocks: Iterable[FrameBlock]) -> Iterator[Frame]:
    """Yield a frame for each block; its other fields are those of the scenario's start.

    Raises:
        InputError: the scenario's arm is not the report's arm.
    """
    check_arm(scenario)
    program = _SceneProgram(scenario)
    for block in blocks:
        yield program.step(block)


class _SceneProgram:
    """State of the scene: what the words have changed since the initialisation."""

    def __init__(self, scenario: Scenario) -> None:
        model = scenario.arm.model
        telescope, prong = model.telescope, model.prong
        if telescope is None or prong is None:
            raise InputError(f"{scenario.arm.name} has no telescope or no prong; frame words describe an arm with both")
        self._telescope, self._prong, self._period = telescope, prong, scenario.control_period
        self._cameras = Cameras(scenario)
        self._start = self._last = Simulation(scenario).look()
        self._arm = frames_of(model)
        self._hand = self._arm.names.index(model.linkage.frames[-1])
        self._rows = self._arm.rows()
        self._held: tuple[int, Array] | None = None
        self._tick = 0

    def step(self, block: FrameBlock) -> Frame:
        """Return the frame after the next block."""
        control = block.control
        if control.initialise:
            self._last, self._held = self._start, None
        self._tick += 1
        now, work = self._last, self._last.work
        command = CameraDrive(control.station, float(control.pan), float(control.tilt), float(control.zoom))
        views = self._cameras.driven(now.views, command, self._period)
        spacing = work.hand.spacing or 0.0
        stand = work.stand or 0.0
        if not control.arm_inhibited:
            at = stand + control.telescope * self._telescope.rate * self._period
            stand = min(max(at, self._telescope.least), self._telescope.greatest)
        widest, closest = (self._prong.facing - end for end in (self._prong.least, self._prong.greatest))
        if not control.finger_inhibited:
            spacing = min(max(spacing - control.prong * self._prong.rate * self._period, closest), widest)
        angles = now.angles if control.arm_inhibited else block.angles
        payloads = self._carried(work.cargo, angles, stand, held=control.mode != ACQUISITION)
        self._last = msgspec.structs.replace(
            now,
            tick=self._tick,
            mode=f"MODE {control.mode}",
            time_s=round(self._tick * self._period, 9),
            angles=angles,
            views=views,
            work=msgspec.structs.replace(
                work,
                task=control.mode,
                nearest=None,
                stand=stand,
                hand=msgspec.structs.replace(work.hand, spacing=spacing),
                cargo=payloads,
            ),
        )
        return self._last

    def _carried(
        self, payloads: tuple[Cargo, ...], angles: tuple[float, ...], stand: float, *, held: bool
    ) -> tuple[Cargo, ...]:
        """Return the payloads; the held one moves with the end effector.

        In the step in which the task phase leaves 1, the payload that is nearest to the end effector is acquired.
        """
        place_frames(self._arm.joints, np.array(angles), stand, 0.0, self._rows)
        hand = self._rows[self._hand]
        if not held or not payloads:
            self._held = None
            return tuple(msgspec.structs.replace(one, held=False) if one.held else one for one in payloads)
        if self._held is None:
            point = vec3(hand, 0)
            nearest = min(range(len(payloads)), key=lambda k: distance(payloads[k].position, point))
            payload = row_of(Pose(np.array(payloads[nearest].position), np.array(payloads[nearest].orientation)))
            relative = np.empty(POSE)
            compose(inverse(hand), payload, relative)
            self._held = nearest, relative
        k, relative = self._held
        at = np.empty(POSE)
        compose(hand, relative, at)
        moved = msgspec.structs.replace(payloads[k], position=vec3(at, 0), orientation=rows(at, 3), held=True)
        return (*payloads[:k], moved, *payloads[k + 1 :])

"""File of the blocks for the VCU, with one line of JSON for each control step of a run.

A line has ``time_s``, ``station`` and the words of the block in octal: ``vectors``, ``program``, ``telescope``,
``prong``. If the commanded camera has no permanent list, or a vector is too long for its scale, the line also has
``unsaid``, a list of their names.
"""

from __future__ import annotations

import json
from collections import Counter
from typing import BinaryIO

from aftdeck.historical.rms_vs_output import NO_CODE, planes_of
from aftdeck.historical.words_file import check_arm
from aftdeck.mainprior.received import NONE, kept
from aftdeck.mainprior.routine import PriorityRoutine
from aftdeck.mainprior.tables import LISTS
from aftdeck.mainprior.vcu import block_of
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.run import Simulation
from aftdeck.visual.scene import VisualScene


class VcuWriter:
    """Writer of a file of blocks.

    Attributes:
        unsaid: for each name, the number of lines written so far whose ``unsaid`` contains this name.
    """

    def __init__(self, file: BinaryIO, scenario: Scenario) -> None:
        """Make the trees and lists.

        Raises:
            InputError: the routine does not know the scenario's arm or one of its parts.
        """
        check_arm(scenario)  # before the clusters are made, which takes longer
        self._file = file
        self._scene = VisualScene(scenario)
        self._routine = PriorityRoutine(scenario, self._scene)
        self._received = NONE
        self.unsaid = Counter[str]()

    def step(self, sim: Simulation) -> None:
        """Write the line of the last step, with the planes of the collision program."""
        flight, state = sim._flight, sim._state
        camera = state.panel.camera or NO_CODE
        listed = camera in LISTS and camera in self._scene.cameras
        station = camera if listed else NO_CODE
        frame = sim.look()
        self._received = kept(self._received, planes_of(flight.site, state.worksite, flight.scenario.control_period))
        block = block_of(self._routine.priority(frame, station, self._received))
        unsaid = [*([] if listed else ["station"]), *block.unsaid]
        self.unsaid.update(unsaid)
        row: dict[str, object] = {"time_s": frame.time_s, "station": station}
        for name in ("vectors", "program", "telescope", "prong"):
            row[name] = [f"{word:08o}" for word in getattr(block, name)]
        if unsaid:
            row["unsaid"] = unsaid
        self._file.write(json.dumps(row).encode() + b"\n")

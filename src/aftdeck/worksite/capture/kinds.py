"""Kinds of end effectors for which a worksite's file may have a table. Each has a module of this package."""

from __future__ import annotations

from aftdeck.worksite.capture.bar import BarFile
from aftdeck.worksite.capture.snares import SnareFile

CaptureFile = BarFile | SnareFile
"""Table of an end effector."""

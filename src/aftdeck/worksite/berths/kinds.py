"""Kinds of berths that a worksite's file may have. Each has a module of this package."""

from __future__ import annotations

from aftdeck.worksite.berths.bay import RetentionFile
from aftdeck.worksite.berths.port import PortFile

BerthFile = PortFile | RetentionFile
"""Table of a berth."""

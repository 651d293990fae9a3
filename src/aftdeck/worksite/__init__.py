"""The worksite: the bodies around the arm, their solids for collision, the berths of payloads, and the cameras."""

from aftdeck.worksite.file.load import load_worksite, worksites
from aftdeck.worksite.model import Body, Cargo, Seat, Worksite

__all__ = ["Body", "Cargo", "Seat", "Worksite", "load_worksite", "worksites"]

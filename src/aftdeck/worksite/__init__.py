"""The worksite: what stands round the arm, what it collides as, where cargo is kept, and the cameras."""

from aftdeck.worksite.load import load_worksite, worksites
from aftdeck.worksite.model import Body, Cargo, Seat, Worksite

__all__ = ["Body", "Cargo", "Seat", "Worksite", "load_worksite", "worksites"]

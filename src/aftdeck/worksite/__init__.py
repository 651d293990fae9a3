"""The worksite: what stands round the arm."""

from aftdeck.worksite.load import load_worksite, worksites
from aftdeck.worksite.model import Body, Worksite

__all__ = ["Body", "Worksite", "load_worksite", "worksites"]

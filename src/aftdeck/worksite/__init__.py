"""The worksite: the bodies around the arm, their solids for collision, the berths of payloads, and the cameras."""

from aftdeck.worksite.berths.berth import Berth
from aftdeck.worksite.body import Body
from aftdeck.worksite.file.load import load_worksite, worksites
from aftdeck.worksite.model import Worksite
from aftdeck.worksite.payload import Payload

__all__ = ["Berth", "Body", "Payload", "Worksite", "load_worksite", "worksites"]

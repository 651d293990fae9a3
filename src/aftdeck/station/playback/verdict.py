"""Verdict for the page: result of re-simulating a recording and comparing its frames."""

from __future__ import annotations

from pathlib import Path

from aftdeck.errors import AftdeckError
from aftdeck.recording.replay import verify
from aftdeck.station.messages.playback import Verdict

CHECKING = Verdict("checking", "checking")


def verdict(path: Path) -> Verdict:
    """Re-simulate a recording and compare all frames. Slow. An `AftdeckError` is returned as ``impossible``."""
    try:
        found = verify(path)
    except AftdeckError as error:
        return Verdict("impossible", str(error))
    if found.equal:
        scope = "" if found.whole else " in every recorded value"
        return Verdict("equal", f"all {found.frames} frames equal{scope}")
    where = f", the first at {found.first.time_s:.2f} s" if found.first else ""
    reason = "" if found.same_laws else "; the laws have changed since the recording"
    if found.recorded_by != found.version:
        reason = f"; recorded by Aftdeck {found.recorded_by}"
    return Verdict("different", f"{found.different} of {found.frames} frames differ{where}{reason}")

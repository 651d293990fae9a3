"""Verdict for the page: result of re-simulating a recording and comparing its frames."""

from __future__ import annotations

from pathlib import Path

from aftdeck.errors import AftdeckError
from aftdeck.recording.replay import verify
from aftdeck.station.messages.playback import Verdict

CHECKING = Verdict("checking", "checking")


def verdict(path: Path) -> Verdict:
    """Re-simulate a recording and compare all frames. Slow. After an `AftdeckError` the verdict is ``impossible``."""
    try:
        result = verify(path)
    except AftdeckError as error:
        return Verdict("impossible", str(error))
    if result.equal:
        scope = "" if result.whole else " in every recorded value"
        return Verdict("equal", f"all {result.frames} frames equal{scope}")
    where = f", the first at {result.first.time_s:.2f} s" if result.first else ""
    reason = "" if result.same_laws else "; the laws have changed since the recording"
    if result.recorded_by != result.version:
        reason = f"; recorded by Aftdeck {result.recorded_by}"
    return Verdict("different", f"{result.different} of {result.frames} frames differ{where}{reason}")

"""Verdict for the page: result of re-simulating a recording and comparing its messages."""

from __future__ import annotations

from pathlib import Path

from aftdeck.errors import AftdeckError
from aftdeck.recording.replay import Verdict as Result
from aftdeck.recording.replay import verify
from aftdeck.station.messages.playback import Verdict

CHECKING = Verdict("checking", "checking")


def verdict(path: Path) -> Verdict:
    """Re-simulate a recording and compare it. Slow. After an `AftdeckError` the verdict is ``impossible``."""
    try:
        result = verify(path)
    except AftdeckError as error:
        return Verdict("impossible", str(error))
    if result.equal:
        scope = "" if result.whole else " in every recorded value"
        others = "all other data unchanged" if result.unchanged else "other data not covered"
        return Verdict("equal", f"all {result.frames} frames equal{scope}; {others}")
    reasons = "; ".join(_reasons(result))
    if result.agrees:
        return Verdict("equal", f"equal within the tolerance for another environment; {reasons}")
    return Verdict("different", reasons)


def _reasons(result: Result) -> list[str]:
    reasons = []
    if result.different:
        where = f", the first at {result.first.time_s:.2f} s" if result.first else ""
        reasons.append(f"{result.different} of {result.frames} frames differ{where}")
        if result.apart and result.apart.metres is not None and result.apart.radians is not None:
            reasons.append(f"by at most {result.apart.metres:.1g} m and {result.apart.radians:.1g} rad")
        if result.recorded_by != result.version:
            reasons.append(f"recorded by Aftdeck {result.recorded_by}")
        elif not result.same_laws:
            reasons.append("the laws have changed since the recording")
        elif not result.same_machine:
            reasons.append(f"computed with another {', '.join(c.field for c in result.environment) or 'machine'}")
    if result.changes:
        reasons.append(f"{', '.join(change.channel for change in result.changes)} differ from the re-simulation")
    if result.chain not in ("unbroken", "none"):
        reasons.append("data changed after the recording (hash chain)")
    return reasons

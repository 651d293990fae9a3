"""Run a built-in scenario without a screen, and read its events and frames."""

import numpy as np

import aftdeck

run = aftdeck.run("sts-400-closed")

for event in run.events:
    print(f"{event.time_s:8.2f} s  {event.text}")

summary = run.summary
assert summary.position_error_m is not None
print(f"ended: {summary.ended} at {summary.time_s:.2f} s, {1e3 * summary.position_error_m:.3f} mm from the target")

positions = np.array([frame.position for frame in run.frames])
along = positions[-1] - positions[0]
along /= np.linalg.norm(along)
offsets = positions - positions[0]
sideways = offsets - np.outer(offsets @ along, along)
print(f"the path deviates from the straight line by at most {1e3 * np.linalg.norm(sideways, axis=1).max():.3f} mm")

slowed = sum(any(limit.kind == "joint rate" for limit in frame.limits) for frame in run.frames)
print(f"a joint rate limit was active in {slowed} of {len(run.frames)} steps")

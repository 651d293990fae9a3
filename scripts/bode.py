"""Draw the frequency response of a joint's servo for docs/dynamics-python.md: ``python scripts/bode.py``."""

from __future__ import annotations

from pathlib import Path

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

import aftdeck
from aftdeck.units import POUND

PICTURE = Path(__file__).parent.parent / "docs" / "pictures" / "bode-servo.svg"
POSE = np.radians([0.0, 60.0, -80.0, -20.0, 0.0, 0.0])
SERVO = "rate.shoulder_pitch"
PAYLOADS = {"no payload": (None, "#1f5fa8"), "32,000 lb": (32_000 * POUND, "#c2571a")}


def draw() -> Figure:
    """Return the drawing: gain above, phase below, over the frequency."""
    figure = Figure(figsize=(7.2, 4.8), layout="constrained")
    gain, phase = figure.subplots(2, 1, sharex=True)
    for payload, (mass, colour) in PAYLOADS.items():
        for flexible, line, width in ((True, "-", 1.6), (False, "--", 1.0)):
            model = aftdeck.dynamics("srms", payload=mass, flexible=flexible).linear(POSE)
            bode = model.bode(SERVO, SERVO, np.geomspace(0.01, 10.0, 1000))
            label = f"{payload}, {'flexible' if flexible else 'rigid'}"
            gain.plot(bode.frequencies, 20.0 * np.log10(bode.gain), line, color=colour, lw=width, label=label)
            phase.plot(bode.frequencies, np.degrees(bode.phase), line, color=colour, lw=width)
    gain.set_xscale("log")
    gain.set_ylabel("gain, dB")
    phase.set_ylabel("phase, °")
    phase.set_xlabel("frequency, Hz")
    phase.set_yticks(range(-90, 91, 45))
    phase.xaxis.set_major_formatter("{x:g}")
    gain.legend(frameon=False, loc="lower left")
    for axes in (gain, phase):
        axes.grid(alpha=0.3)
        axes.spines[["top", "right"]].set_visible(False)
    return figure


if __name__ == "__main__":
    with mpl.rc_context({"svg.hashsalt": "aftdeck"}):  # the same file for the same curves
        draw().savefig(PICTURE, metadata={"Date": None})

"""Write a scenario, print its errors, correct it and run it."""

import math
import tempfile
from pathlib import Path

import aftdeck
from aftdeck.errors import ScenarioError

TEXT = """
title = "A loaded swing"
arm = "srms"
duration = "{duration}"

[initial]
joints = [0, "60 deg", "-90 deg", "30 deg", 0, 0]

[payload]
{mass} = "15000 lb"
position = ["2 m", 0, 0]

[[phase]]
mode = "ORB UNL"
translation = [0, 0, -1]
duration = "20 s"
"""

with tempfile.TemporaryDirectory() as folder:
    file = Path(folder, "swing.toml")

    file.write_text(TEXT.format(duration="60 kg", mass="weight"))
    try:
        aftdeck.load_scenario(file)
    except ScenarioError as error:
        print(*error.problems, sep="\n")

    file.write_text(TEXT.format(duration="60 s", mass="mass"))
    run = aftdeck.run(file)

speed = math.hypot(*run.frames[-1].twist[3:])
print(f"{run.scenario.title}: {run.summary.ended}; with a payload of 15 000 lb the tip lifts at {speed:.3f} m/s")

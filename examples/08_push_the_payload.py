"""Push a payload that the arm holds, with a plan in the scenario and with an input of your own."""

import math

import aftdeck

push = {"on": "payload", "begin": "1 s", "duration": "0.5 s", "force": ["20 lbf", 0.0, 0.0], "frame": "orbiter"}
planned = aftdeck.load_scenario("loaded", {"plant": "flexible", "phase": [], "disturbance": [push]})
SECONDS, BEGIN, END = 20.0, 1.0, 1.5  # length of a run, times of the push [s]
steps_per_second = round(1.0 / planned.control_period)


def swing(sim: aftdeck.Simulation, disturbances: list[aftdeck.Disturbance]) -> float:
    """Return the greatest distance of the true tip from its first place, with disturbances from BEGIN to END [m]."""
    tips = []
    for tick in range(round(SECONDS * steps_per_second)):
        acting = BEGIN <= tick / steps_per_second < END
        frame = sim.step(aftdeck.Inputs(brakes=True, disturbances=tuple(disturbances) if acting else ()))
        tips.append(frame.dynamics.position)
    return max(math.dist(tip, tips[0]) for tip in tips)


print(f"pushed by its scenario, the braked arm swings by {1000.0 * swing(aftdeck.Simulation(planned), []):.2f} mm")
calm = aftdeck.load_scenario("loaded", {"plant": "flexible", "phase": []})
same = aftdeck.Disturbance("payload", force=(20.0 * 4.4482216152605, 0.0, 0.0))
print(f"by the same force as an input: {1000.0 * swing(aftdeck.Simulation(calm), [same]):.2f} mm")
beside = aftdeck.Disturbance("payload", force=same.force, at=(0.0, 2.0, 0.0))
print(f"by a force 2 m beside the centre of mass: {1000.0 * swing(aftdeck.Simulation(calm), [beside]):.2f} mm")

"""Fly with your own inputs, step by step, then restore an earlier state and fly differently."""

import aftdeck

sim = aftdeck.Simulation("first-flight")
steps_per_second = round(1.0 / sim.scenario.control_period)


def fly(inputs: aftdeck.Inputs, duration: int) -> aftdeck.Frame:
    """Hold the sticks for `duration` seconds; return the last frame."""
    frames = [sim.step(inputs) for _ in range(duration * steps_per_second)]
    return frames[-1]


frame = fly(aftdeck.Inputs(translation=(1.0, 0.0, 0.0)), 4)
print(f"{frame.time_s:.0f} s of full stick forward in {frame.mode}: active limits {[x.text for x in frame.limits]}")
saved = sim.save()

sim.step(aftdeck.Inputs(mode="END EFF"))  # turn the MODE rotary, press ENTER
frame = fly(aftdeck.Inputs(translation=(0.3, 0.0, 0.0)), 4)
print(f"then 4 s along the end effector: tip at {tuple(round(x, 3) for x in frame.position)} m in L")

sim.restore(saved)
sim.step(aftdeck.Inputs(mode="SINGLE", joint=5, rate="vernier"))
frame = fly(aftdeck.Inputs(drive=1.0), 4)
print(f"or 4 s of wrist roll instead: joint angles {tuple(round(x, 3) for x in frame.angles)} rad")

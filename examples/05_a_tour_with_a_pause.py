"""Fly stored points as the operator of AUTO 1 does: check, PROCEED, wait at a pause point, PROCEED; then refuse one."""

import aftdeck

sim = aftdeck.Simulation("sequence")
frame = sim.step(aftdeck.Inputs())  # the scenario begins in AUTO 1: the way to its first point is rehearsed
print(f"{frame.mode}, {frame.points} points; CMD CK {frame.check.text if frame.check else 'none'}")

pauses = 0
frame = sim.step(aftdeck.Inputs(proceed=True))
while frame.sequence != "idle":
    waiting = frame.sequence == "ready"  # at a pause point
    pauses += waiting
    frame = sim.step(aftdeck.Inputs(proceed=waiting))
    for event in frame.events:
        print(f"{event.time_s:6.2f} s  {event.text}")
print(f"{pauses} pause on the way")

frame = sim.step(aftdeck.Inputs(mode="PL"))  # a switch that cannot be obeyed changes nothing
print(f"still in {frame.mode}: {frame.events[-1].text}")

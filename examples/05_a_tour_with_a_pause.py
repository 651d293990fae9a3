"""Fly the sequence of AUTO 1: CMD CK, PROCEED, a pause point, PROCEED; then send a command that is rejected."""

import aftdeck

sim = aftdeck.Simulation("sequence")
frame = sim.step(aftdeck.Inputs())  # the scenario starts in AUTO 1 with a rehearsal of the motion to its first point
print(f"{frame.mode}, {frame.points} points; CMD CK {frame.check.text if frame.check else 'none'}")

pauses = 0
frame = sim.step(aftdeck.Inputs(proceed=True))
while frame.sequence != "idle":
    waiting = frame.sequence == "ready"  # at a pause point
    pauses += waiting
    frame = sim.step(aftdeck.Inputs(proceed=waiting))
    for event in frame.events:
        print(f"{event.time_s:6.2f} s  {event.text}")
print(f"{pauses} pause before the last point")

frame = sim.step(aftdeck.Inputs(mode="PL"))  # a rejected command changes nothing
print(f"still in {frame.mode}: {frame.events[-1].text}")

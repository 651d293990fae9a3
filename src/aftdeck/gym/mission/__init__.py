"""Capture, Extract and Dock: steps of a scenario's task, flown in a `Simulation`."""

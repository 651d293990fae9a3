"""Synthetic operators, which fly the steps of a scenario's task through the sticks and switches that a person uses."""

"""Capture: the concept arm's acquisition, and the Shuttle arm's snares."""

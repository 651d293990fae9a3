"""Metrics of a recorded run: each is defined once, with its unit and its source."""

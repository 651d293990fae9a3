"""Readings: every number that is shown of a step, once, with its name, title, unit, definition, source and value."""

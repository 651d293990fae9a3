"""Conversion of a scenario and its frames to what a page displays."""

"""Conversion of a scenario and its frames to messages for a page."""

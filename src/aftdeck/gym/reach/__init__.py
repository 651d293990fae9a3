"""Reach: move the tip of the Shuttle's arm to a random pose."""

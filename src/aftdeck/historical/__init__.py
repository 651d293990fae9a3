"""Formats of the reports: the words of each frame, and the operator's input channels."""

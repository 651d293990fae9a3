"""Formats of RMS-VS: input channels (TABLE I), words for the scene generator (TABLE II) and the typewriter's (III)."""

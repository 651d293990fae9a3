"""Formats of RMS-VS: the operator's input channels (TABLE I), and the words for the scene generator (TABLE II)."""

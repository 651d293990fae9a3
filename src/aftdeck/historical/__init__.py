"""The reports' own formats: the words of each frame, and the operator's input channels."""

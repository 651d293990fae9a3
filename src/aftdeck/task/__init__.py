"""Task of the operator: progress through its steps, and the motion that is left, both from the frames of a run."""

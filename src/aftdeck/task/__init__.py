"""Task of the operator: progress through its steps, and the remaining motion, both from the frames of a run."""

"""Time histories of a run."""

"""Data of a recording for its playback in the page; strips and lanes also for a live run."""

"""Row of the state and constants of a run as flat arrays, which the compiled parts of a step take."""

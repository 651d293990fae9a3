"""Studies: one scenario run many times, with factors that change from run to run."""

"""Report page of recorded runs: one HTML file, which requests nothing from a network."""

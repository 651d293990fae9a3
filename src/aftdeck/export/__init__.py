"""Export of recorded runs to learners' datasets, LeRobotDataset and Minari, and the way back to the flight."""

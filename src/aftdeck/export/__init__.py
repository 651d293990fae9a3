"""Export of recorded runs to learners' datasets: LeRobotDataset and Minari ([docs/export.md])."""

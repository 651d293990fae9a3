"""What a step reports: the frame, events and the look-ahead."""

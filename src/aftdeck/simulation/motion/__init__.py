"""What keeps the arm from moving, and the commands that lead out of it."""

"""What stays constant in a run: the arm and worksite as the step needs them."""

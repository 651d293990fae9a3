"""The session: one run that pages share."""

"""Recordings as the page plays them."""

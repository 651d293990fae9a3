"""Parts of the state, and caches."""

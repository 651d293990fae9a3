"""Tests of `aftdeck.mainprior`."""

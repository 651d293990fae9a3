"""Survey of an arm at a worksite over sampled poses, for `aftdeck check`."""

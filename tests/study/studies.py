"""Small studies for tests."""

from __future__ import annotations

from pathlib import Path

from aftdeck.study.file import Study, load_study

SHORT = """
title = "Short"
arm = "srms"
duration = "2 s"

[initial]
joints = ["-31 deg", "79 deg", "-103 deg", "-77 deg", "17 deg", "-128 deg"]

[[phase]]
mode = "ORB UNL"
translation = [1.0, 0.0, 0.0]
duration = "0.5 s"
"""
"""Scenario whose script moves the arm for half a second."""

FOUR = """
title = "Four runs"
scenario = "short.toml"
repeats = 2

[[factor]]
name = "speed"
key = "limits.por.translation"
levels = ["1 ft/s", "2 ft/s"]

[report]
recordings = 0
"""
"""Study with four short runs."""


def written(folder: Path, text: str = FOUR) -> Path:
    """Write a study and its short scenario into a folder; return the path of the study file."""
    (folder / "short.toml").write_text(SHORT, encoding="utf-8")
    path = folder / "study.toml"
    path.write_text(text, encoding="utf-8")
    return path


def loaded(folder: Path, text: str = FOUR) -> Study:
    """Return the study of a text, with the short scenario beside it."""
    return load_study(written(folder, text))

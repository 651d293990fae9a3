"""Fixtures of tests of recordings."""

from __future__ import annotations

import functools
from pathlib import Path

import pytest

from aftdeck.recording.bundle import scenario_of
from tests.recording.flown import record_every_channel

_scenario = functools.lru_cache(scenario_of)


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Recording of `record_every_channel`."""
    path = tmp_path_factory.mktemp("every-channel") / "whole.mcap"
    record_every_channel(path)
    return path


@pytest.fixture
def scenarios_built_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Build the scenario of equal headers only once, for tests that verify many files."""
    monkeypatch.setattr("aftdeck.recording.replay.scenario_of", _scenario)

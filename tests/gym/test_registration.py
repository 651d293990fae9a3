"""Registration with Gymnasium, and imports."""

from __future__ import annotations

import subprocess
import sys

import gymnasium
import pytest

import aftdeck.gym  # noqa: F401  (registers the environments)

NAMES = ("Reach", "Capture", "Extract", "Dock")


def test_all_environments_are_registered_with_a_time_limit() -> None:
    for name in NAMES:
        spec = gymnasium.spec(f"aftdeck/{name}-v0")
        assert spec.max_episode_steps
        assert not spec.nondeterministic


@pytest.mark.parametrize(
    "code",
    [
        "import aftdeck; aftdeck.load_arm, aftdeck.Simulation; import sys; assert 'gymnasium' not in sys.modules",
        "import gymnasium; gymnasium.make('aftdeck.gym:aftdeck/Reach-v0').close()",
        "import gymnasium, aftdeck.gym, sys; gymnasium.spec('aftdeck/Dock-v0'); assert 'numba' not in sys.modules",
    ],
)
def test_import(code: str) -> None:
    done = subprocess.run([sys.executable, "-c", code], check=False, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr

"""Laws run as plain Python give the same results as compiled laws."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from tests.kinematics.plain import results
from tests.kinematics.poses import apart


@pytest.mark.slow
def test_uncompiled_laws_agree_with_the_compiled_ones() -> None:
    root = Path(__file__).parents[2]
    done = subprocess.run(
        [sys.executable, "-m", "tests.kinematics.plain"],
        cwd=root,
        env={**os.environ, "NUMBA_DISABLE_JIT": "1"},
        capture_output=True,
        text=True,
        timeout=400,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    plain = json.loads(done.stdout)
    compiled = results()
    assert plain.keys() == compiled.keys()
    for name, values in compiled.items():
        if name.endswith("inverse"):
            for ours, theirs in zip(values, plain[name], strict=True):
                assert np.abs(apart(np.array(ours), np.array(theirs))).max() < 1e-12
        else:
            assert np.array(values) == pytest.approx(np.array(plain[name]), abs=1e-12), name

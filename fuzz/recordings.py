"""Attack on the reader of recordings: a damaged file is rejected, or gets a verdict."""

from __future__ import annotations

import atexit
import functools
import random
import tempfile
from pathlib import Path
from typing import Any

from mcap.writer import CompressionType

from aftdeck.errors import RecordingError, ScenarioError
from aftdeck.recording.replay import verify
from aftdeck.recording.run import record
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from tests.recording.writings import written

STEPS = 20
"""Number of control steps of the recording."""


@functools.cache
def _whole() -> bytes:
    """Return the bytes of a short, undamaged recording."""

    def inputs(sim: Simulation) -> Inputs | None:
        done = sim.frame
        return None if done is not None and done.tick >= STEPS else Inputs(translation=(0.5, 0.0, 0.0))

    path = _folder() / "whole.mcap"
    record("free-flyer", path, inputs=inputs)
    return path.read_bytes()


@functools.cache
def _layouts() -> tuple[bytes, ...]:
    """Return the recording as the recorder writes it, and as other programs do."""
    others: tuple[dict[str, Any], ...] = (
        {"compression": CompressionType.LZ4, "chunk_size": 20_000},
        {"use_chunking": False},
        {"use_chunking": False, "enable_data_crcs": True},
    )
    whole = _whole()
    return whole, *(
        written(_folder() / "whole.mcap", _folder() / "copy.mcap", settings).read_bytes() for settings in others
    )


@functools.cache
def _folder() -> Path:
    folder = tempfile.TemporaryDirectory()
    atexit.register(folder.cleanup)
    return Path(folder.name)


def attack(seed: int) -> str:
    """Verify a recording whose bytes were flipped, cut, inserted, repeated or moved; return the result in a word.

    Three of four recordings were written again by another program.

    Every fifth seed leaves the file undamaged, and its verdict has to be equal.

    Raises:
        Exception: the reader raised something other than a `RecordingError` or a `ScenarioError`.
    """
    rng = random.Random(seed)
    whole = rng.choice(_layouts())
    data = bytearray(whole)
    for _ in range(rng.choice((1, 1, 2, 5)) if seed % 5 else 0):
        _damage(data, rng)
    path = _folder() / f"{seed}.mcap"
    path.write_bytes(data)
    try:
        found = verify(path)
    except RecordingError as error:
        assert "\n" not in str(error), str(error)
        return f"rejected: {error.fault}"
    except ScenarioError:  # a copy without CRCs shows damage to a text of its header only by what the text says
        return "rejected: scenario"
    finally:
        path.unlink()
    assert found.equal or data != whole, "an undamaged recording differs"
    return "equal" if found.equal else "different"


def _damage(data: bytearray, rng: random.Random) -> None:
    """Change the bytes of a file in one random way."""
    at, size = rng.randrange(len(data)), min(rng.choice((1, 1, 4, 8, 100, 4000)), len(data))
    match rng.randrange(6):
        case 0:
            data[at] ^= 1 << rng.randrange(8)
        case 1:
            del data[at:]
            data += b"" if data else b"\x00"
        case 2:
            data[at:at] = rng.randbytes(size)
        case 3:
            del data[at : at + size]
            data += b"" if data else b"\x00"
        case 4:
            data[at:at] = data[at : at + size]
        case _:
            data[at : at + 8] = rng.choice((b"\xff" * 8, b"\x00" * 8, (2**40).to_bytes(8, "little")))

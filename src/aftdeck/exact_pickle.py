"""Pickles that keep whether an array is read-only.

Numba makes different machine code for read-only arrays. From an ordinary pickle, in which all arrays can be written,
every law would be compiled again.
"""

from __future__ import annotations

import io
import pickle
from typing import Any

import numpy as np


def pickled(what: object) -> bytes:
    """Return an object as bytes for `pickle.loads`."""
    file = io.BytesIO()
    _Pickler(file).dump(what)
    return file.getvalue()


class _Pickler(pickle.Pickler):
    def reducer_override(self, what: Any) -> Any:
        if type(what) is np.ndarray and not what.flags.writeable:
            return _read_only, (what.copy(),)
        return NotImplemented


def _read_only(array: np.ndarray) -> np.ndarray:
    array.flags.writeable = False
    return array

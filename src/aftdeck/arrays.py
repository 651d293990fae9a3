"""The kinds of arrays that are passed about; a docstring gives the shape and the unit of each."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Indices = NDArray[np.int64]
Mask = NDArray[np.uint8]

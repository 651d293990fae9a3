"""Policy file: an ``.npz`` file of NumPy with the arrays of a `Policy`; docs/learning.md lists them.

Objects of Python (pickles) are neither written nor read: a policy file from a stranger cannot run code.
"""

from __future__ import annotations

import json
import zipfile
from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType
from typing import cast

import numpy as np
from numpy.typing import NDArray

from aftdeck.arrays import Array
from aftdeck.errors import InputError
from aftdeck.gym.policy import Activation, Layer, Policy, check_policy
from aftdeck.units import short
from aftdeck.whole_file import whole_file

VERSION = 1
"""Version of the file format."""
MAX_BYTES = 64 * 2**20
"""Greatest size of all arrays of a file [bytes]; assumed: perceptrons for these environments have less than 1 MB."""

Arrays = dict[str, NDArray[np.generic]]


def save_policy(policy: Policy, path: Path | str) -> None:
    """Write a policy file; the numbers are stored in single precision.

    Raises:
        InputError: the policy has an unknown environment, or arrays whose shapes do not fit, or the file cannot be
            written.
    """
    path = Path(path)
    check_policy(policy, path.name)
    texts = {
        "environment": policy.environment,
        "activation": policy.activation,
        "keywords": json.dumps(dict(policy.keywords), sort_keys=True),
    }
    numbers = {"mean": policy.mean, "std": policy.std}
    for k, layer in enumerate(policy.layers):
        numbers[f"weight_{k}"], numbers[f"bias_{k}"] = layer
    arrays: Arrays = {"version": np.array(VERSION)}
    arrays |= {name: np.array(text) for name, text in texts.items()}
    arrays |= {name: array.astype(np.float32) for name, array in numbers.items()}
    with whole_file(path) as file:  # an open file: NumPy would append ".npz" to a path without it
        np.savez_compressed(file, allow_pickle=False, **arrays)


def load_policy(path: Path | str) -> Policy:
    """Read and check a policy file.

    Raises:
        InputError: the file cannot be read, or has other contents; the message states the file, what was found, and
            what is expected.
    """
    path = Path(path)
    try:
        return _checked(_arrays(path), path)
    except InputError:
        raise
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror or error}") from None
    except Exception as error:  # libraries raise errors of many kinds for a damaged file
        raise InputError(f"{path.name}: is not a policy file, or is damaged: {error}") from None


def _checked(arrays: Arrays, path: Path) -> Policy:
    version = arrays.pop("version", None)
    if version is None or version.tolist() != VERSION:
        found = "missing" if version is None else short(version.tolist())
        raise InputError(f"{path.name}: version is {found}, expected {VERSION}, as `save_policy` writes it")
    environment, activation, keywords = (_text(arrays, n, path.name) for n in ("environment", "activation", "keywords"))
    mean, std = _numbers(arrays, "mean", path.name), _numbers(arrays, "std", path.name)
    count = sum(name.startswith("weight_") for name in arrays)
    layers = tuple(
        Layer(_numbers(arrays, f"weight_{k}", path.name), _numbers(arrays, f"bias_{k}", path.name))
        for k in range(count)
    )
    if arrays:
        raise InputError(f"{path.name}: got the unknown arrays {short(sorted(arrays))}")
    policy = Policy(environment, cast("Activation", activation), mean, std, layers, _keywords(keywords, path.name))
    check_policy(policy, path.name)
    return policy


def _arrays(path: Path) -> Arrays:
    """Return all arrays of a file."""
    with path.open("rb") as file:
        if not zipfile.is_zipfile(file):
            raise InputError(f"{path.name}: is not an .npz file, expected a file that `save_policy` has written")
        with zipfile.ZipFile(file) as archive:
            size = sum(entry.file_size for entry in archive.infolist())
        if size > MAX_BYTES:
            raise InputError(f"{path.name}: has arrays of {size} bytes, expected at most {MAX_BYTES}")
        file.seek(0)
        with np.load(file, allow_pickle=False) as found:
            return {name: found[name] for name in found.files}


def _text(arrays: Arrays, name: str, file: str) -> str:
    array = arrays.pop(name, None)
    if array is None or array.shape != () or array.dtype.kind != "U":
        raise InputError(f"{file}: {name} is {_kind(array)}, expected one text")
    return str(array)


def _numbers(arrays: Arrays, name: str, file: str) -> Array:
    array = arrays.pop(name, None)
    if array is None or array.dtype.kind != "f" or not np.isfinite(array.astype(np.float64)).all():
        raise InputError(f"{file}: {name} is {_kind(array)}, expected finite floating-point numbers")
    numbers = array.astype(np.float64)
    numbers.flags.writeable = False
    return numbers


def _kind(array: NDArray[np.generic] | None) -> str:
    return "missing" if array is None else f"an array of {array.dtype} with shape {array.shape}"


def _keywords(text: str, file: str) -> Mapping[str, str]:
    try:
        found = json.loads(text)
    except ValueError:
        found = None
    if not isinstance(found, dict) or not all(isinstance(value, str) for value in found.values()):
        raise InputError(f"{file}: keywords is {short(text)}, expected a JSON object with texts")
    return MappingProxyType({str(name): str(value) for name, value in found.items()})

"""Everything on this machine that computes a run: processor, libraries, and the target of the compiler."""

from __future__ import annotations

import os
import platform
from importlib import import_module
from importlib.metadata import version
from typing import Annotated, Any

import msgspec

from aftdeck.field_meta import field_meta
from aftdeck.scenario.schema import Plant


class Environment(msgspec.Struct, frozen=True):
    """Environment that computed a run; the last digits of a frame may depend on each of its fields."""

    processor: Annotated[str, field_meta("the processor's architecture and name")]
    system: Annotated[str, field_meta("operating system")]
    c_library: Annotated[str, field_meta("C library with its version; empty if unknown")]
    python: Annotated[str, field_meta("Python's implementation and version")]
    numpy: Annotated[str, field_meta("NumPy's version")]
    numba: Annotated[str, field_meta("Numba's version")]
    llvmlite: Annotated[str, field_meta("llvmlite's version, which determines LLVM's version")]
    target: Annotated[
        str,
        field_meta("processor for which Numba compiled, by LLVM's name; `interpreted` if the laws were not compiled"),
    ]
    features: Annotated[
        tuple[str, ...],
        field_meta("instructions that Numba used, by LLVM's names (`+fma`, `+avx2`), in alphabetical order"),
    ]
    mujoco: Annotated[str, field_meta("MuJoCo's version; empty if the run has the kinematic plant")] = ""


def environment(plant: Plant = "kinematic") -> Environment:
    """Return the environment of this process for runs with a plant; it imports Numba, if Numba compiles the laws."""
    target, features = _target()
    return Environment(
        processor=f"{platform.machine()} {platform.processor()}".strip(),
        system=platform.system(),
        c_library=" ".join(platform.libc_ver()).strip(),
        python=f"{platform.python_implementation()} {platform.python_version()}",
        numpy=version("numpy"),
        numba=version("numba"),
        llvmlite=version("llvmlite"),
        target=target,
        features=features,
        mujoco="" if plant == "kinematic" else version("mujoco-core"),
    )


def machine() -> str:
    """Return the names that files without an `Environment` have: processor, system, Python, NumPy, Numba."""
    here = environment()
    return (
        f"{here.processor}, {here.system}, Python {platform.python_version()}, NumPy {here.numpy}, Numba {here.numba}"
    )


def _target() -> tuple[str, tuple[str, ...]]:
    """Return name and features of the processor for which Numba compiles, with the user's settings for Numba."""
    if os.environ.get("NUMBA_DISABLE_JIT", "0") not in ("", "0"):
        return "interpreted", ()
    config: Any = import_module("numba.core.config")
    codegen: Any = import_module("numba.core.codegen")
    llvm: Any = import_module("llvmlite.binding")
    name = llvm.get_host_cpu_name() if config.CPU_NAME is None else config.CPU_NAME
    features = codegen.get_host_cpu_features() if config.CPU_FEATURES is None else config.CPU_FEATURES
    return name, tuple(sorted(feature for feature in features.split(",") if feature.startswith("+")))

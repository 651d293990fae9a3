"""The machine code of the laws: no fused operation, no sum in another order, and no function of a library."""

from __future__ import annotations

import importlib
import re
import sys
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

import aftdeck
from aftdeck import law
from aftdeck.gym.reach.vector import ReachVectorEnv
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.run import Simulation
from aftdeck.steering.batch import steer_batch

ALLOWED = re.compile(
    r"Py\w+|_Py\w+|NRT_\w+|numba_\w+|memset|memcpy|memmove"  # arguments, memory and errors
    r"|_ZN7aftdeck.*"  # large laws
    r"|llvm\.(memset|memcpy|memmove|assume|lifetime|smin|smax|umin|umax|abs|ctpop|cttz|ctlz|\wadd|\wsub|\wmul|x86)\b.*"
    r"|llvm\.(masked|vector\.reduce\.(and|or|xor|add|smax|smin))\b.*"  # integers only
    r"|(llvm\.)?(sqrt|fabs|copysign)\b.*"  # IEEE 754 defines them to the last bit
    r"|llvm\.(log10|floor)\.f64"  # for the number of digits in the text of Numba's errors, see below
)
"""External functions that a law may call."""
FUSED = re.compile(r"\bvfn?m(?:add|sub)\w*|\bfn?m(?:add|sub)\b|\bfmla\b|llvm\.fma\b|llvm\.fmuladd")
"""Fused products and sums: instructions of x86-64 and ARM, and LLVM's functions."""
LOOSE = re.compile(
    r"\b(?:fadd|fsub|fmul|fdiv|fneg|call|fcmp|select)\s+(?:fast|reassoc|contract|arcp|afn|nsz|ninf|nnan)\b"
)
"""Operations whose order or rounding the compiler may change."""


def compiled() -> Iterator[tuple[str, Any]]:
    """Yield the name and the compiled library of each law that a module has called from Python."""
    for module in list(sys.modules.values()):
        if getattr(module, "__name__", "").startswith("aftdeck"):
            for name, value in list(vars(module).items()):
                function = getattr(value, "py_func", None)
                if function is not None and function.__module__ == module.__name__:
                    yield from ((f"{module.__name__}.{name}", one.library) for one in value.overloads.values())


def code_of(library: Any) -> Any:
    """Return the optimised LLVM code of a library, also of a large law, which gives its callers none."""
    if not hasattr(library, "need"):
        return library._get_module_for_linking()
    llvm: Any = importlib.import_module("llvmlite.binding")
    return llvm.parse_bitcode(library._bitcode) if hasattr(library, "_bitcode") else library._final_module


@pytest.fixture(scope="module")
def laws() -> dict[str, str]:
    """Return the optimised code of every law that flights of both arms and a batch call, in LLVM's language."""
    for name in ("srms-berth", "concept-1972-script", "free-flyer"):
        sim = Simulation(load_scenario(name))
        sim.advance()
        sim.look()
    arm = aftdeck.load_arm("srms")
    pose = arm.forward([0.1, 0.2, -0.3, 0.1, 0.2, 0.3])
    arm.inverse(pose)
    steer_batch(arm, [[0.1, 0.2, -0.3, 0.1, 0.2, 0.3]], pose, period=0.08, gain=0.5)
    reach = ReachVectorEnv()
    reach.reset(seed=0)
    reach.step(np.zeros((1, 6), dtype=np.float32))
    return {name: str(code_of(library)) for name, library in compiled()}


def test_laws_that_are_searched_include_those_of_a_step(laws: dict[str, str]) -> None:
    called = {name.rpartition(".")[2] for name in laws}
    assert called >= {"advance", "rehearsed", "frame_numbers", "steer_blocks", "solve", "step_all"}, called


def test_laws_call_no_function_of_a_library(laws: dict[str, str]) -> None:
    called = {
        name: [
            one for one in re.findall(r'^declare [^@]*@"?([^"(]+)', code, re.MULTILINE) if not ALLOWED.fullmatch(one)
        ]
        for name, code in laws.items()
    }
    assert {name: found for name, found in called.items() if found} == {}


def test_no_law_needs_a_logarithm_except_in_the_text_of_an_error(laws: dict[str, str]) -> None:
    for name, code in laws.items():
        assert "llvm.log10" not in code or "PyUnicode_FromKindAndData" in code, name


@pytest.mark.slow
def test_laws_have_neither_fused_nor_reordered_operations(laws: dict[str, str]) -> None:
    for name, code in laws.items():
        if name.startswith("aftdeck.steering.blocks."):  # has a fast setting; `test_batch.py` tests the exact one
            continue
        assert not LOOSE.findall(code), name
        assert not FUSED.findall(code), name
        assert not FUSED.findall(assembly(code)), name


def test_search_finds_a_fused_operation() -> None:
    numba: Any = importlib.import_module("numba")
    law.load()

    @numba.njit(fastmath={"contract"})  # type: ignore[untyped-decorator]
    def fused(a: float, b: float, c: float) -> float:
        return a * b + c

    assert fused(2.0, 3.0, 4.0) == 10.0
    (one,) = fused.overloads.values()
    code = str(one.library._get_module_for_linking())
    assert LOOSE.search(code)
    features = importlib.import_module("llvmlite.binding").get_host_cpu_features()
    if features.get("fma", True):
        assert FUSED.search(assembly(code))


def assembly(code: str) -> str:
    """Return the assembly text that Numba's compiler makes of optimised code for this processor."""
    llvm: Any = importlib.import_module("llvmlite.binding")
    target: Any = importlib.import_module("numba.core.registry").cpu_target.target_context.codegen()._tm
    text: str = target.emit_assembly(llvm.parse_assembly(code))
    return text

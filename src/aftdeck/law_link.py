"""Machine code of large laws, which other laws call where it is instead of containing a copy of it.

Numba links the code of every called function into its caller, optimises all of it again, and writes all of it into the
caller's machine code. A *separate* library gives its callers nothing to link; its function is then found by its name,
which a caller's file contains. The name therefore has to be the same in every process (`named`), and the library has to
be loaded before its callers run (`needs_of`).
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from importlib import import_module
from typing import Any, NamedTuple

from aftdeck.law_digest import Options, digest_of

_llvm: Any = import_module("llvmlite.binding")
_identity: Any = import_module("numba.core.bytecode").FunctionIdentity
_compiler: Any = import_module("numba.core.compiler")


class Need(NamedTuple):
    """A separate library that a law calls.

    Attributes:
        module: name of the module of the called law.
        law: its name.
        signature: its signature.
        symbol: name of its function in the machine code.
    """

    module: str
    law: str
    signature: Any
    symbol: str


@cache
def named(options: Options) -> type:
    """Return Numba's compiler for laws with these options, which gives a function the same name in every process."""

    class Named(_compiler.Compiler):  # type: ignore[misc]
        def compile_extra(self, func: Callable[..., Any]) -> Any:
            """Compile a function."""
            self.state.func_id = identity = _identity.from_function(func)
            identity.unique_id = int(digest_of(func)[:15], 16) * 4 + options.fused * 2 + options.inlined
            identity.unique_name = f"{identity.func_qualname}${identity.unique_id}"
            _compiler.ExtractByteCode().run_pass(self.state)
            self.state.lifted, self.state.lifted_from = (), None
            return self._compile_bytecode()

    return Named


def separate(library: Any, law: Callable[..., Any], signature: Any, symbol: str) -> None:
    """Let other laws call the function of a library where it is."""
    library.need = Need(law.__module__, law.__name__, signature, symbol)
    library._shared_module = _llvm.parse_assembly("")


def needs_of(library: Any) -> tuple[Need, ...]:
    """Return the separate libraries that a library calls, directly or through laws whose copies it contains."""
    found: dict[Need, None] = dict.fromkeys(getattr(library, "needs", ()))
    for linked in getattr(library, "_linking_libraries", ()):
        found |= dict.fromkeys([linked.need] if hasattr(linked, "need") else needs_of(linked))
    return tuple(found)


def are_met(needs: tuple[Need, ...]) -> bool:
    """Load the libraries that a law needs, or compile them; return whether their functions have the expected names."""
    for need in needs:
        law = getattr(import_module(need.module), need.law)
        law = getattr(law, "compiled", law)
        law.compile(need.signature)
        if law.overloads[need.signature].fndesc.llvm_func_name != need.symbol:
            return False
    return True

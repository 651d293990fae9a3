"""Machine code of a law from a file, without what only a compilation needs.

Numba's own loader first declares everything that compiled code could call, which imports SciPy if it is installed, and
parses the LLVM code of the law, although only the compilation of another law needs either. That takes longer than all
else. Here a compilation does it when it begins, or never.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any

_llvm: Any = import_module("llvmlite.binding")
_compiler: Any = import_module("numba.core.compiler")
_runtime: Any = import_module("numba.core.runtime")
_Library: Any = import_module("numba.core.codegen").JITCodeLibrary


class KeptLibrary(_Library):  # type: ignore[misc]
    """Numba's library with the machine code of one law, whose LLVM code is parsed when another law links it."""

    def __init__(self, codegen: Any, name: str, machine_code: bytes, bitcode: bytes) -> None:
        """Load the machine code.

        Args:
            codegen: Numba's generator of machine code.
            name: name of the library.
            machine_code: object file.
            bitcode: LLVM code.
        """
        super().__init__(codegen, name)
        self._bitcode, self._shared_module = bitcode, None
        self.enable_object_caching()
        self._set_compiled_object(machine_code)
        self._finalize_final_module()

    def _get_module_for_linking(self) -> Any:
        """Return the LLVM code."""
        if self._shared_module is None:
            self._shared_module = _llvm.parse_bitcode(self._bitcode)
        return self._shared_module


def rebuilt(target: Any, reduced: tuple[Any, ...]) -> Any:
    """Return Numba's result of a compilation from what its method `_reduce` returned.

    Args:
        target: Numba's context of the processor.
        reduced: that value.
    """
    (name, _, (machine_code, bitcode)), law, environment, signature, objects, lifted, text, inits, others = reduced
    _runtime.rtsys.initialize(target)
    for init in inits:
        init()
    codegen = target.codegen()
    library = KeptLibrary(codegen, name, machine_code, bitcode)
    codegen._engine._defined_symbols |= {law.llvm_func_name, law.llvm_cpython_wrapper_name}
    for one in others:
        codegen.set_env(one.env_name, one)
    return _compiler.compile_result(
        target_context=target,
        typing_context=target.typing_context,
        library=library,
        environment=environment,
        entry_point=target.get_executable(library, law, environment),
        fndesc=law,
        type_annotation=text,
        signature=signature,
        objectmode=objects,
        lifted=lifted,
        reload_init=inits,
        referenced_envs=others,
    )

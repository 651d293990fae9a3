"""Arrays that compiled code uses without counting references to them.

Numba counts the references to each array, in each call and each assignment, with an atomic operation. In laws that pass
dozens of arrays on, this takes a third of the time. A law that Python calls may lend its arguments to the laws that it
calls: they live until it returns. What is lent, and its parts, may be used only until then.
"""

from __future__ import annotations

import functools
from collections.abc import Callable
from importlib import import_module
from typing import Any, Generic, ParamSpec, TypeVar

from numpy.typing import NDArray

from aftdeck.law_digest import Options

_P = ParamSpec("_P")
_R = TypeVar("_R")
_A = TypeVar("_A")
_Array = TypeVar("_Array", bound=NDArray[Any])


class _Own(Generic[_P, _R]):
    """A function that plain Python calls as it is, and compiled code as the code that `make` emits."""

    options = Options(fused=False, inlined=True)

    def __init__(self, function: Callable[_P, _R], make: Callable[..., Any]) -> None:
        functools.update_wrapper(self, function)
        self.function, self._make = function, make

    def __call__(self, *given: _P.args, **named: _P.kwargs) -> _R:
        """Call the function as plain Python."""
        return self.function(*given, **named)

    @functools.cached_property
    def _numba_type_(self) -> Any:
        """Numba's type of this function."""
        from numba.core.registry import cpu_target  # noqa: PLC0415  (takes 0.6 s; only laws need it)
        from numba.extending import intrinsic  # noqa: PLC0415

        code = intrinsic(self._make)
        cpu_target.typing_context.refresh()
        return cpu_target.typing_context.resolve_value_type(code)


def _lend(array: _A) -> _A:
    """Return the same array. In compiled code, the result and its parts have no count of references."""
    return array


def _lend_line(flat: _Array, begin: int, count: int) -> _Array:
    """Return a part of an array with one axis, as a view that is lent; compiled code does not test the limits."""
    return flat[begin : begin + count]  # type: ignore[return-value]


def _lend_block(flat: _Array, begin: int, rows: int, columns: int) -> _Array:
    """Return a part of an array with one axis as a view with two axes, as `lend_line` does."""
    return flat[begin : begin + rows * columns].reshape(rows, columns)  # type: ignore[return-value]


def _code_of_lend(context: Any, array: Any) -> Any:
    del context

    def code(target: Any, builder: Any, signature: Any, given: Any) -> Any:
        view = target.make_array(signature.args[0])(target, builder, value=given[0])
        view.meminfo, view.parent = view.meminfo.type(None), view.parent.type(None)
        return view._getvalue()

    return array(array), code


def _code_of_line(context: Any, array: Any, begin: Any, count: Any) -> Any:
    del context
    return array(array, begin, count), _part


def _code_of_block(context: Any, array: Any, begin: Any, rows: Any, columns: Any) -> Any:
    del context
    return array.copy(ndim=2)(array, begin, rows, columns), _part


def _part(target: Any, builder: Any, signature: Any, given: Any) -> Any:
    """Emit the code of a view of consecutive elements, in the order of C."""
    populate: Any = import_module("numba.np.arrayobj").populate_array

    flat, begin, *shape = given
    own = target.make_array(signature.args[0])(target, builder, value=flat)
    view = target.make_array(signature.return_type)(target, builder)
    strides = [own.itemsize]
    for length in shape[:0:-1]:
        strides.insert(0, builder.mul(strides[0], length))
    populate(view, builder.gep(own.data, [begin]), shape, strides, own.itemsize, None)
    return view._getvalue()


lend = _Own(_lend, _code_of_lend)
lend_line = _Own(_lend_line, _code_of_line)
lend_block = _Own(_lend_block, _code_of_block)

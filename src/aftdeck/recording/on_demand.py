"""Messages decoded at once from their JSON, whose attitudes and named tuples are converted when they are read.

A class is made for each type of message: a subclass, whose fields are the file's. A field that has another form in the
file (`codec`) is a property that converts it. Such a message is for programs that read a few fields of each of many
frames. It is pickled as a message of the declared type; it cannot be encoded, and not be compared with another.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Annotated, Any, NamedTuple, TypeVar, get_args, get_origin, get_type_hints

import msgspec

from aftdeck.frames import rotation_of
from aftdeck.recording.codec import LIMIT
from aftdeck.recording.hints import apart, is_object, names, without_none
from aftdeck.tuples import Rows

S = TypeVar("S", bound=msgspec.Struct)
_Quaternion = tuple[float, float, float, float]
_Nine = tuple[float, float, float, float, float, float, float, float, float]
_Int = Annotated[int, msgspec.Meta(ge=-LIMIT, le=LIMIT - 1)]
"""Whole number of at most 64 bits."""


class _Form(NamedTuple):
    """Form of a type in the file.

    Attributes:
        hint: the type as which it is decoded.
        change: returns the value; None if the decoded one is the value.
        check: raises ValueError for a decoded value that has none; None if every one has a value.
    """

    hint: Any
    change: Callable[[Any], Any] | None = None
    check: Callable[[Any], None] | None = None


def decode(kind: type[S], data: bytes) -> S:
    """Convert JSON to a message of the type `kind`, as `codec.decode` does.

    Raises:
        msgspec.MsgspecError: `data` is not a message of this type.
    """
    message: S = _decoder(kind)(data)
    return message


@cache
def _decoder(kind: type) -> Callable[[bytes], Any]:
    return msgspec.json.Decoder(_class_of(kind, None)).decode


@cache
def _class_of(kind: type, decimals: int | None) -> type:
    """Return the class for a struct or named tuple; `decimals` applies to fields that do not declare their own."""
    hints = get_type_hints(kind, include_extras=True)
    forms = {name: _form(hints[name], decimals) for name in names(kind)}
    if issubclass(kind, msgspec.Struct) and all(forms[name].hint is hints[name] for name in forms):
        return kind
    checks = [(name, form.check) for name, form in forms.items() if form.check is not None]

    def check(self: Any) -> None:
        for get, check_value in checked:
            check_value(get(self))

    namespace: dict[str, Any] = {"__post_init__": check} if checks else {}
    bases: tuple[type, ...] = ()
    fields: list[Any] = [(name, form.hint) for name, form in forms.items()]
    if issubclass(kind, msgspec.Struct):
        bases = (kind,)
        fields = [
            (field.name, forms[field.name].hint, *_default(field))
            for field in msgspec.structs.fields(kind)
            if forms[field.name].hint is not hints[field.name]
        ]
        namespace["__reduce__"] = lambda self: (_whole, (kind, {name: getattr(self, name) for name in forms}))
    made: Any = msgspec.defstruct(
        kind.__name__, fields, bases=bases, namespace=namespace, frozen=True, gc=False, kw_only=bool(bases)
    )
    stored = {name: getattr(made, name).__get__ for name in forms}
    checked = [(stored[name], check_value) for name, check_value in checks]
    for name, form in forms.items():
        if form.change is not None:
            setattr(made, name, _property(stored[name], form.change))
    kind_made: type = made
    return kind_made


def _default(field: msgspec.structs.FieldInfo) -> tuple[Any, ...]:
    """Return a field's default value; () for none."""
    if field.default_factory is not msgspec.NODEFAULT:
        return (msgspec.field(default_factory=field.default_factory),)
    return () if field.default is msgspec.NODEFAULT else (field.default,)


def _property(stored: Callable[[Any], Any], change: Callable[[Any], Any]) -> property:
    return property(lambda self: change(stored(self)))


def _form(hint: Any, decimals: int | None) -> _Form:
    """Return the form of a type."""
    inner, meta = apart(hint)
    if meta is not None and meta.extra:
        decimals = meta.extra.get("decimals", decimals)
    if (kind := without_none(inner)) is not inner:
        form = _form(kind, decimals)
        if form.hint is kind:
            return _Form(hint)
        return _Form(form.hint | None, _unless_none(form.change), _unless_none(form.check))
    if inner == Rows:
        return _Form(_Nine, _rows) if decimals is None else _Form(_Quaternion, rotation_of, _check_length)
    if inner is int:
        return _Form(_Int)
    if get_origin(inner) is tuple:
        return _tuple_form(hint, get_args(inner), decimals)
    if is_object(inner):
        made: Any = _class_of(inner, None if issubclass(inner, msgspec.Struct) else decimals)
        if issubclass(inner, msgspec.Struct):
            return _Form(hint if made is inner else made)
        fields = names(inner)
        return _Form(made, lambda value: inner(*[getattr(value, name) for name in fields]))
    return _Form(hint)


def _tuple_form(hint: Any, items: tuple[Any, ...], decimals: int | None) -> _Form:
    """Return the form of a tuple, all of whose items have one type."""
    form = _form(items[0], decimals)
    if form.hint is items[0]:
        return _Form(hint)
    kind: Any = tuple
    each = tuple(item if item is Ellipsis else form.hint for item in items)
    return _Form(kind[each], _for_each(form.change), _for_each(form.check))


def _unless_none(change: Callable[[Any], Any] | None) -> Callable[[Any], Any] | None:
    return None if change is None else lambda value: None if value is None else change(value)


def _for_each(change: Callable[[Any], Any] | None) -> Callable[[Any], Any] | None:
    return None if change is None else lambda values: tuple([change(value) for value in values])


def _whole(kind: Any, values: dict[str, Any]) -> Any:
    return kind(**values)


def _rows(flat: _Nine) -> Rows:
    """Return the rows of a matrix."""
    return flat[:3], flat[3:6], flat[6:]


def _check_length(quaternion: _Quaternion) -> None:
    """Raise ValueError for a quaternion without a length, which is no attitude."""
    w, x, y, z = quaternion
    if not (w * w or x * x or y * y or z * z):
        raise ValueError("a quaternion is zero")

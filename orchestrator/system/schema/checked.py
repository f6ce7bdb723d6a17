"""A table of a file against the declaration of its keys, with errors that name the nearest key, the line, the mend."""

from __future__ import annotations

from collections.abc import Callable, Collection
from functools import cache
from typing import Any, TypeVar, get_type_hints

import msgspec
from msgspec import inspect

from ...clock import duration
from ...errors import InputError, nearest, shown
from ...toml.file import TomlFile
from .words import in_words, said, stripped

T = TypeVar("T")
Fail = Callable[[str, str], InputError]  # from a message and the key that it is about


def fields_of(kind: Any) -> dict[str, tuple[inspect.Field, Any]]:
    """The keys of a Struct or dataclass: what is declared of each, and its type."""
    return _fields(kind)


@cache
def _fields(kind: Any) -> dict[str, tuple[inspect.Field, Any]]:
    hints = get_type_hints(kind, include_extras=True)
    info = inspect.type_info(kind)
    assert isinstance(info, inspect.StructType | inspect.DataclassType)
    return {field.encode_name: (field, hints[field.name]) for field in info.fields}


def checked(
    kind: type[T], table: dict[str, Any], label: str, file: TomlFile | None = None, heading: str = "", where: str = "",
    further: Collection[str] = (),
) -> T:  # fmt: skip
    """The table as an object of `kind`; tables within it stay as they are, to be checked by themselves.

    `label` begins the messages; `heading` is where the table stands in the file, or `where` its line; `further` keys
    are allowed and checked elsewhere. Raises InputError for a key that is unknown or missing, for a value of another
    type or out of range, and for values that do not fit each other.
    """
    fail, known = _failing(label, file, heading, where), fields_of(kind)
    for key in table:
        if key not in known and key not in further:
            raise fail(f"unknown key '{key}'{nearest(key, (*known, *further))}", key)
    values = _values(kind, table, label, fail)
    for key, (field, _) in known.items():
        if field.required and key not in table:
            if file is not None and not heading:
                raise InputError(f"{file.path.name}: '{key}' is missing")
            raise fail(f"'{key}' is missing", f"[{heading}]")
    try:
        return kind(**values)
    except InputError as error:  # values that do not fit each other
        raise fail(str(error).removeprefix(f"{label}: "), f"[{heading}]") from None


def checked_value(kind: Any, value: Any, label: str, place: str) -> None:
    """Raise InputError, between `label` and `place`, for a value that is not of a declared kind."""
    try:
        msgspec.convert(value, kind)
    except msgspec.ValidationError:
        raise InputError(f"{label} must be {in_words(inspect.type_info(kind))} {place}") from None


def _failing(label: str, file: TomlFile | None, heading: str, where: str) -> Fail:
    """How errors are made: with the label before and the place behind."""

    def fail(message: str, key: str) -> InputError:
        begun = f"{label}: {message}" if label else message
        if file is None or where:
            return InputError(f"{begun} {where}".rstrip())
        return file.fail(begun, key, heading)

    return fail


def _values(kind: type[Any], table: dict[str, Any], label: str, fail: Fail) -> dict[str, Any]:
    """The values of a table by the attributes of `kind`."""
    return {
        field.name: _converted(field, type_, key, table[key], label, fail)
        for key, (field, type_) in fields_of(kind).items()
        if key in table
    }


def _converted(field: inspect.Field, type_: Any, key: str, value: Any, label: str, fail: Fail) -> Any:
    plain = stripped(field.type)
    if isinstance(plain, inspect.CustomType):  # an exact time
        try:
            return duration(value, f"{label}: {key}" if label else key)
        except InputError as error:
            raise fail(str(error).removeprefix(f"{label}: "), key) from None
    try:
        found = msgspec.convert(value, _shallow(plain) or type_)
        if _allowed(field.type, found):
            return found
    except msgspec.ValidationError:
        pass
    stated, quoted = said(field.type, "says"), shown(repr(value))
    if stated:
        raise fail(stated.format(key=key, value=quoted), key) from None
    if isinstance(plain, inspect.LiteralType):
        raise fail(f"unknown {key} '{shown(value)}'{nearest(str(value), map(str, plain.values))}", key) from None
    number = isinstance(plain, inspect.FloatType | inspect.IntType)
    raise fail(f"{key}{f' = {quoted}' if number else ''} must be {in_words(field.type)}", key) from None


def _shallow(plain: Any) -> Any:
    """Of what is within a table only that it is a table, where it has a reader of its own."""
    if isinstance(plain, inspect.StructType | inspect.DataclassType):
        return dict[str, Any]
    if isinstance(plain, inspect.DictType):
        several = isinstance(stripped(plain.value_type), inspect.UnionType)
        return dict[str, Any] if several or _holds_tables(plain.value_type) else None
    if isinstance(plain, inspect.ListType) and _holds_tables(plain.item_type):
        return list[dict[str, Any]]
    return None


def _holds_tables(type_: Any) -> bool:
    return isinstance(stripped(type_), inspect.StructType | inspect.DataclassType)


def _allowed(type_: Any, value: Any) -> bool:
    """Whether a value is among those that the declaration lists."""
    while isinstance(type_, inspect.Metadata):
        listed = (type_.extra_json_schema or {}).get("enum")
        if listed and value not in listed:
            return False
        type_ = type_.type
    return True

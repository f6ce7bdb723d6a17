"""Declared types in words, for messages and for the reference page."""

from __future__ import annotations

from typing import Any

from msgspec import inspect

from .keys.values import LARGEST


def stripped(type_: Any) -> Any:
    """A type without what is said about it, and without the None that stands for a key that may be left out."""
    while isinstance(type_, inspect.Metadata):
        type_ = type_.type
    if isinstance(type_, inspect.UnionType):
        parts = [part for part in type_.types if not isinstance(part, inspect.NoneType)]
        return stripped(parts[0]) if len(parts) == 1 else type_
    return type_


def said(type_: Any, key: str) -> str:
    """What a declaration says under a key of its `extra`, itself or within; empty where it says nothing."""
    while True:
        if isinstance(type_, inspect.Metadata):
            text = (type_.extra or {}).get(key)
            if text:
                return str(text)
            type_ = type_.type
        elif isinstance(type_, inspect.UnionType) and any(isinstance(p, inspect.NoneType) for p in type_.types):
            parts = [part for part in type_.types if not isinstance(part, inspect.NoneType)]
            if len(parts) != 1:
                return ""
            type_ = parts[0]
        else:
            return ""


def in_words(type_: Any) -> str:
    """`a number above 0`, `text`, `a list, each entry a table`."""
    stated = said(type_, "must")
    if stated:
        return stated
    plain = stripped(type_)
    if isinstance(plain, inspect.UnionType):
        words = [in_words(part) for part in plain.types if not isinstance(part, inspect.NoneType)]
        if {"true or false", "a whole number", "a number", "text"} <= set(words):
            words = ["a number, text, true or false", *(w for w in words if w.startswith(("a list", "a table")))]
        return ", or ".join(dict.fromkeys(words))
    if isinstance(plain, inspect.LiteralType):
        *first, last = [f'"{value}"' for value in plain.values]
        return f"{', '.join(first)} or {last}"
    if isinstance(plain, inspect.ListType):
        entry = "" if isinstance(plain.item_type, inspect.AnyType) else f", each entry {in_words(plain.item_type)}"
        return f"a list{entry}"
    if isinstance(plain, inspect.FloatType):
        return f"a number{_bounds(plain)}"
    if isinstance(plain, inspect.IntType):
        return f"a whole number{' above 0' if plain.ge == 1 else ', 0 or more' if plain.ge == 0 else ''}"
    names = {inspect.StrType: "text", inspect.BoolType: "true or false", inspect.CustomType: "a time"}
    return next((words for kind, words in names.items() if isinstance(plain, kind)), "a table")


def _bounds(number: inspect.FloatType) -> str:
    if number.gt is not None:
        return f" above {number.gt:g}"
    if number.ge is not None and number.ge > -LARGEST:
        return f", {number.ge:g} or more"
    return ""

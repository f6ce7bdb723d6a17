"""Functions that take numbers and texts, or nothing at all."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Mapping

from ...isolated.memory import texts_at
from ...lifecycle import ERROR
from ..functions import Shape
from .remote import Passed, Remote


def _plain(remote: Remote, name: str) -> Passed:
    return lambda _instance: remote.call(name)


def _free(remote: Remote, name: str) -> Passed:
    def free(_instance: int) -> None:
        remote.call(name)

    return free


def _numbers(remote: Remote, name: str) -> Passed:
    def numbers(_instance: int, *values: int | float) -> int:
        remote.memory.put_words(*(v if isinstance(v, float) else int(v) & 0xFFFFFFFF for v in values))
        return remote.call(name)

    return numbers


def _logging(remote: Remote, name: str) -> Passed:
    def logging(_instance: int, on: int, count: int, categories: int) -> int:
        if not remote.memory.put_texts(texts_at(categories, count) if count else []):
            return ERROR
        remote.memory.put_words(int(on), count)
        return remote.call(name)

    return logging


def _status_number(remote: Remote, name: str) -> Passed:
    size = 8 if "Real" in name else 1 if "Boolean" in name and remote.version == 1 else 4

    def status(_instance: int, kind: int, value: int) -> int:
        remote.memory.put_words(kind)
        found = remote.call(name)
        ctypes.memmove(value, remote.memory.values, size)
        return found

    return status


def _status_text(remote: Remote, name: str) -> Passed:
    def status(_instance: int, kind: int, value: int) -> int:
        remote.memory.put_words(kind)
        found = remote.call(name)
        ctypes.c_void_p.from_address(value).value = _keep(remote)
        return found

    return status


def _text(remote: Remote, name: str) -> Passed:
    def text() -> int:
        return _keep(remote) if remote.call(name) < ERROR else 0

    return text


def _keep(remote: Remote) -> int:
    """The address of a copy of the text of an answer."""
    copy = ctypes.create_string_buffer(remote.memory.texts(1)[0])
    remote.kept.append(copy)
    return ctypes.addressof(copy)


PASSED: Mapping[Shape, Callable[[Remote, str], Passed]] = {
    Shape.PLAIN: _plain, Shape.FREE: _free, Shape.EXPERIMENT: _numbers, Shape.INITIALIZE1: _numbers,
    Shape.LOGGING1: _numbers, Shape.LOGGING: _logging, Shape.STATUS_NUMBER: _status_number,
    Shape.STATUS_TEXT: _status_text, Shape.TEXT: _text, Shape.ACTIVATE: _numbers, Shape.TIME: _numbers,
}  # fmt: skip

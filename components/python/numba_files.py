"""Numba's files in the cache of kernels, each with the hash of its content: what is damaged is compiled anew."""

# mypy: disable-error-code="no-untyped-call"
# Numba's cache has no types.

from __future__ import annotations

import hashlib
import io
import uuid
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from numba.core.caching import FunctionCache, IndexDataCacheFile

from .kernel_cache import kept


class _CheckedFile(IndexDataCacheFile):
    """Numba's files, each with the hash of its content behind it: what is damaged is compiled anew.

    Numba numbers the files of a function: two processes that compile it at one time for different types could take the
    same number, each believing the file its own. Here no two files have the same name.
    """

    def _load_index(self) -> Any:
        return super()._load_index() if _whole(self._index_path) else {}

    def _load_data(self, name: str) -> Any:
        if not _whole(self._data_path(name)):
            raise FileNotFoundError(name)  # which Numba takes for a file that somebody has removed
        return super()._load_data(name)

    def _data_name(self, number: int) -> str:
        return str(super()._data_name(number)).replace(".nbc", f"_{uuid.uuid4().hex[:12]}.nbc")

    @contextmanager
    def _open_for_write(self, filepath: str) -> Iterator[io.BytesIO]:
        content = io.BytesIO()
        yield content
        with super()._open_for_write(filepath) as file:
            file.write(content.getvalue() + hashlib.sha256(content.getvalue()).digest())


def _whole(path: str) -> bool:
    """Is a file there, and the hash at its end that of what stands before it?"""
    return kept(Path(path)) is not None


class CheckedCache(FunctionCache):
    """Numba's cache of one function, by `_CheckedFile`."""

    def __init__(self, function: Callable[..., Any]) -> None:
        super().__init__(function)
        self._cache_file = _CheckedFile(
            cache_path=self._cache_path,
            filename_base=self._impl.filename_base,
            source_stamp=self._impl.locator.get_source_stamp(),
        )

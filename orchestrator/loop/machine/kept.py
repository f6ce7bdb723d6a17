"""Numba's files of the compiled loop, each with the hash of its content behind it: what is damaged is compiled anew.

`components/python/kernel_cache.py` keeps compiled kernels in the same way; neither side imports from the other.
"""

from __future__ import annotations

# mypy: disable-error-code="no-untyped-call"
# Numba's cache has no types.
import hashlib
import io
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from numba.core.caching import FunctionCache, IndexDataCacheFile

DIGEST = hashlib.sha256().digest_size


class _CheckedFile(IndexDataCacheFile):
    def _load_index(self) -> Any:
        return super()._load_index() if _whole(self._index_path) else {}

    def _load_data(self, name: str) -> Any:
        if not _whole(self._data_path(name)):
            raise FileNotFoundError(name)  # which Numba takes for a file that somebody has removed
        return super()._load_data(name)

    @contextmanager
    def _open_for_write(self, filepath: str) -> Iterator[io.BytesIO]:
        content = io.BytesIO()
        yield content
        with super()._open_for_write(filepath) as file:
            file.write(content.getvalue() + hashlib.sha256(content.getvalue()).digest())


def _whole(path: str) -> bool:
    """Is a file there, and the hash at its end that of what stands before it?"""
    try:
        content = Path(path).read_bytes()
    except OSError:
        return False
    return hashlib.sha256(content[:-DIGEST]).digest() == content[-DIGEST:]


class CheckedCache(FunctionCache):
    """Numba's cache of one function, by `_CheckedFile`."""

    def __init__(self, function: Callable[..., Any]) -> None:
        super().__init__(function)
        self._cache_file = _CheckedFile(
            cache_path=self._cache_path,
            filename_base=self._impl.filename_base,
            source_stamp=self._impl.locator.get_source_stamp(),
        )

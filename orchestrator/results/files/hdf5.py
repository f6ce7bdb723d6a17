"""The parts of a netCDF-4 file as HDF5 has them: variables along `time`, and texts about them.

Written with HDF5's own calls: ten thousand variables of a hundred rows cost a second, and half as much room again as
their numbers. A variable names the dimension that it lies along; the dimension does not list its variables
(REFERENCE_LIST, which readers do without): each further one would cost a list as long as all before.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any

import h5py  # type: ignore[import-untyped]
import numpy as np
from h5py import h5a, h5d, h5ds, h5p, h5r, h5s, h5t

OWN_NAME = "recorded_name"  # an attribute: what a variable is called whose name netCDF forbids
EVENTS = "events"  # the group of what happened in a run
COMPACT = 8192  # bytes of values that lie in the variable's own header
LONGEST = 60_000  # bytes of a text that an attribute holds itself
IN_HEADER = 32  # attributes of a variable that lie in its header
ORDER = h5p.CRT_ORDER_TRACKED | h5p.CRT_ORDER_INDEXED
REFERENCES = h5py.vlen_dtype(h5py.ref_dtype)
WRITTEN_AS, HEX = "written_as", "hexadecimal"  # an attribute of bytes, which netCDF has only of one length
BOOLEAN = {"dtype": "bool"}  # how netCDF, which has no truth values, says that bytes are such


class Tables:
    """A group of variables that share the dimension `time`; one that grows lies in chunks of so many rows."""

    def __init__(self, group: Any, chunk: int = 0) -> None:
        self.group, self.chunk = group, chunk
        self._time: Any = None

    def add(self, name: str, values: np.ndarray, texts: Mapping[str, str]) -> None:
        """Another variable with its attributes; the first is `time` itself."""
        stored = raw(values)
        space = h5s.create_simple(stored.shape, (h5s.UNLIMITED,) if self.chunk else None)
        kind = h5t.py_create(stored.dtype, logical=True)
        made = h5d.create(self.group.id, name.encode(), kind, space, _layout(stored, self.chunk), _utf8())
        if len(stored):
            made.write(h5s.ALL, h5s.ALL, stored)
        if self._time is None:
            h5ds.set_scale(made, name.encode())
            self._time = np.empty(1, dtype=REFERENCES)
            self._time[0] = np.array([h5r.create(made, b".", h5r.OBJECT)], dtype=h5py.ref_dtype)
        else:
            h5a.create(made, b"DIMENSION_LIST", _references(), h5s.create_simple((1,))).write(self._time)
        for key, text in {**texts, **(BOOLEAN if values.dtype == bool else {})}.items():
            set_text(made, key, text)


def raw(values: np.ndarray) -> np.ndarray:
    """Values of a variable as the file holds them: truth values as bytes, texts as UTF-8 of any length,
    bytes as hexadecimal texts."""
    if values.dtype == bool:
        return values.astype(np.int8)
    if values.dtype.kind == "O" and len(values) and isinstance(values[0], bytes):
        values = np.array([value.hex() for value in values.tolist()], dtype=object)
    return np.ascontiguousarray(values, dtype=h5py.string_dtype() if values.dtype.kind == "O" else None)


def values_of(dataset: Any) -> np.ndarray:
    """The other way round: all values of a variable as they were given."""
    found: np.ndarray = dataset.asstr()[:].astype(object) if dataset.dtype.kind == "O" else dataset[:]
    if dataset.dtype.kind == "O" and texts_of(dataset).get(WRITTEN_AS) == HEX:
        content = np.empty(len(found), dtype=object)
        content[:] = [bytes.fromhex(text) for text in found.tolist()]
        return content
    return found.astype(bool) if texts_of(dataset).get("dtype") == "bool" else found


def set_text(place: Any, name: str, text: str) -> None:
    """An attribute of a variable or group, by its identifier."""
    encoded = text.encode()
    if len(encoded) > LONGEST:
        kind = h5t.py_create(h5py.string_dtype(), logical=True)
        h5a.create(place, name.encode(), kind, _scalar()).write(np.array(text, dtype=h5py.string_dtype()))
        return
    size = max(len(encoded), 2)  # a text of one byte would be read as bytes
    h5a.create(place, name.encode(), _text(size), _scalar()).write(
        np.array(encoded, dtype=f"S{size}"), mtype=_text(size)
    )


def texts_of(place: Any) -> dict[str, str]:
    """The attributes of a variable or group that are texts."""
    found = {key: place.attrs[key] for key in place.attrs if key not in ("DIMENSION_LIST", "REFERENCE_LIST")}
    plain = {key: value.decode() if isinstance(value, bytes) else value for key, value in found.items()}
    return {key: value for key, value in plain.items() if isinstance(value, str) and key not in ("CLASS", "NAME")}


def _layout(values: np.ndarray, chunk: int) -> Any:
    """How a variable lies in the file."""
    found = h5p.create(h5p.DATASET_CREATE)
    found.set_attr_creation_order(ORDER)
    found.set_attr_phase_change(IN_HEADER, IN_HEADER - 1)
    found.set_obj_track_times(False)
    if chunk:
        found.set_chunk((chunk,))
    elif values.nbytes <= COMPACT:
        found.set_layout(h5d.COMPACT)
    return found


@cache
def _utf8() -> Any:
    found = h5p.create(h5p.LINK_CREATE)
    found.set_char_encoding(h5t.CSET_UTF8)
    return found


@cache
def _text(size: int) -> Any:
    kind = h5t.C_S1.copy()
    kind.set_size(size)
    kind.set_cset(h5t.CSET_UTF8)
    kind.set_strpad(h5t.STR_NULLPAD)
    return kind


@cache
def _references() -> Any:
    return h5t.py_create(REFERENCES, logical=True)


@cache
def _scalar() -> Any:
    return h5s.create(h5s.SCALAR)

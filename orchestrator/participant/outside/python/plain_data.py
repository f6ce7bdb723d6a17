"""Plain data as bytes and back, exactly: numbers, texts, None, lists, tuples, dicts, arrays of numbers. No pickle."""

from __future__ import annotations

import json
from typing import Any

import numpy as np

PLAIN = (bool, int, float, str, type(None))
KINDS = "biufc"  # of arrays


def as_bytes(data: Any) -> bytes:
    """Raises TypeError that names what is no plain data."""
    return json.dumps(_out(data, "self")).encode()


def from_bytes(content: bytes) -> Any:
    """What was written. Raises ValueError if it is none of that."""
    try:
        return _in(json.loads(content))
    except (KeyError, TypeError) as error:
        raise ValueError(f"it is no state that was written: {error}") from None


def _out(data: Any, label: str) -> Any:
    if type(data) in PLAIN:
        return data
    if type(data) is list:
        return [_out(each, f"{label}[{k}]") for k, each in enumerate(data)]
    if type(data) is tuple:
        return {"tuple": [_out(each, f"{label}[{k}]") for k, each in enumerate(data)]}
    if type(data) is dict:
        pairs = [[_out(k, label), _out(v, f"{label}.{k}")] for k, v in data.items()]
        return {"dict": pairs}
    if isinstance(data, np.ndarray | np.generic) and data.dtype.kind in KINDS:
        array = np.asarray(data)
        single = isinstance(data, np.generic)
        return {"array": array.tobytes().hex(), "dtype": array.dtype.str, "shape": list(array.shape), "single": single}
    raise TypeError(
        f"{label.replace('self.self', 'self')} is a {type(data).__name__}, and a checkpoint holds numbers, texts, "
        f"lists, tuples, dicts and arrays of numbers"
    )


def _in(data: Any) -> Any:
    if isinstance(data, list):
        return [_in(each) for each in data]
    if not isinstance(data, dict):
        return data
    if "tuple" in data:
        return tuple(_in(each) for each in data["tuple"])
    if "dict" in data:
        return {_in(key): _in(value) for key, value in data["dict"]}
    if np.dtype(data["dtype"]).kind not in KINDS:
        raise ValueError(f"there are no arrays of {data['dtype']}")
    array = np.frombuffer(bytes.fromhex(data["array"]), dtype=data["dtype"]).reshape(data["shape"]).copy()
    return array[()] if data["single"] else array

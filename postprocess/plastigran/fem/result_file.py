# SPDX-License-Identifier: GPL-2.0-or-later
"""Conversion of finite-element results to bytes and back.

Arrays are stored in numpy's format, all other data as JSON. Reading a file does not execute code
from the file.
"""

from __future__ import annotations

import json
import zlib
from importlib import import_module
from io import BytesIO
from typing import Any
from zipfile import BadZipFile

import attrs
import numpy as np
import pandas as pd

PACKAGE = "plastigran."
TREE = "tree"  # name of the entry that contains the JSON text
#: Errors that numpy, zip, JSON and attrs classes raise if a file does not contain a result.
NOT_A_RESULT = (
    AttributeError,
    BadZipFile,
    EOFError,
    ImportError,
    LookupError,
    RecursionError,
    TypeError,
    ValueError,
    zlib.error,
)


def numbers(result: Any) -> dict[str, float | str]:
    """Return those fields of an attrs object that are numbers or texts, by name."""
    return attrs.asdict(
        result, recurse=False, filter=lambda _, value: isinstance(value, float | int | str)
    )


def to_bytes(result: object) -> bytes:
    """Convert a result to bytes; equal results give equal bytes.

    Args:
        result: Numbers, texts, arrays, tables, or lists, tuples, dictionaries and attrs classes of
            this package that contain them.

    Raises:
        TypeError: The result contains another type.
    """
    arrays: dict[str, np.ndarray] = {}
    tree = json.dumps(_to_tree(result, arrays)).encode()
    file = BytesIO()
    np.savez(file, **arrays, **{TREE: np.frombuffer(tree, np.uint8)})
    return file.getvalue()


def from_bytes(content: bytes) -> Any:
    """Return the result that `to_bytes` has written.

    Raises:
        ValueError: `content` was not written by `to_bytes`.
    """
    try:
        with np.load(BytesIO(content), allow_pickle=False) as arrays:
            return _from_tree(json.loads(arrays[TREE].tobytes()), arrays)
    except NOT_A_RESULT as error:
        raise ValueError(f"not a result: {error!r}") from error


def _to_tree(value: Any, arrays: dict[str, np.ndarray]) -> Any:
    if isinstance(value, np.generic):
        return value.item()
    if value is None or isinstance(value, bool | int | float | str):
        return value
    if isinstance(value, np.ndarray) and value.dtype != object:
        name = str(len(arrays))
        arrays[name] = value
        return {"array": name}
    if isinstance(value, pd.DataFrame):
        columns = [[name, _column(value[name])] for name in value]
        return {"table": _to_tree([_column(value.index), columns], arrays)}
    if isinstance(value, list | tuple):
        return {type(value).__name__: [_to_tree(entry, arrays) for entry in value]}
    if isinstance(value, dict):
        return {"dict": [[_to_tree(entry, arrays) for entry in pair] for pair in value.items()]}
    cls = type(value)
    if attrs.has(cls) and cls.__module__.startswith(PACKAGE):
        fields = {
            field.alias: _to_tree(getattr(value, field.name), arrays) for field in attrs.fields(cls)
        }
        return {"class": [cls.__module__, cls.__qualname__], "fields": fields}
    raise TypeError(
        f"a result with a {cls.__name__} cannot be stored. Use numbers, texts, arrays, tables, or "
        "attrs classes of this package"
    )


def _column(values: pd.Series | pd.Index) -> np.ndarray | list:
    numeric = isinstance(values.dtype, np.dtype) and values.dtype != object
    return values.to_numpy() if numeric else list(values)


def _from_tree(tree: Any, arrays: Any) -> Any:
    if not isinstance(tree, dict):
        return tree
    if "class" in tree:
        fields = {name: _from_tree(field, arrays) for name, field in tree["fields"].items()}
        return _attrs_class(*tree["class"])(**fields)
    ((type_name, content),) = tree.items()
    if type_name == "array":
        return arrays[content]
    if type_name == "table":
        index, columns = _from_tree(content, arrays)
        return pd.DataFrame(dict(columns), index=index)
    if type_name == "dict":
        return {_from_tree(key, arrays): _from_tree(value, arrays) for key, value in content}
    entries = [_from_tree(entry, arrays) for entry in content]
    return tuple(entries) if type_name == "tuple" else entries


def _attrs_class(module: str, name: str) -> type:
    cls = getattr(import_module(module), name, None) if module.startswith(PACKAGE) else None
    if not (isinstance(cls, type) and attrs.has(cls)):
        raise ValueError(f"{module}.{name} is not an attrs class of this package")
    return cls

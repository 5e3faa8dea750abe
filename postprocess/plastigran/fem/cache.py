# SPDX-License-Identifier: GPL-2.0-or-later
"""Keep finite-element results on disk.

A result is valid for the same material, numbers and settings until a file of this package or a
library changes. The folder is `$PLASTIGRAN_CACHE`, or `~/.cache/plastigran`.
"""

from __future__ import annotations

import os
import warnings
from collections.abc import Callable
from contextlib import suppress
from functools import cache
from hashlib import sha256
from importlib.metadata import version
from pathlib import Path
from tempfile import NamedTemporaryFile
from typing import TypeVar

import attrs
import numpy as np

from plastigran.fem.result_file import from_bytes, to_bytes
from plastigran.fem.settings import Settings

Result = TypeVar("Result")
DIGEST = 32  # bytes of the checksum at the start of a file
# libraries whose versions matter; pandas, because of the file format
LIBRARIES = ("numpy", "scipy", "scikit-fem", "pandas")


class CacheWarning(UserWarning):
    """A result could not be written to disk."""


def folder() -> Path:
    """Return the folder of the results."""
    return Path(os.environ.get("PLASTIGRAN_CACHE") or Path.home() / ".cache" / "plastigran")


def cached(
    compute: Callable[..., Result],
    *arguments: object,
    settings: Settings | None = None,
    progress: bool = False,
    **named: object,
) -> Result:
    """Return `compute(*arguments, settings, progress, **named)`, from disk if possible.

    A damaged file is computed again. A result that stopped early is not kept.

    Warns:
        CacheWarning: The result could not be kept; the message names the file.
    """
    settings = settings or Settings()
    path = folder() / f"{compute.__name__}_{_key(compute, arguments, settings, named)}.result"
    try:
        return from_bytes(_sound(path.read_bytes()))
    except (OSError, ValueError):  # missing, unreadable or damaged
        result = compute(*arguments, settings, progress, **named)
    if not getattr(result, "stopped", ""):
        _keep(to_bytes(result), path)
    return result


def _keep(content: bytes, path: Path) -> None:
    """Write a file completely or not at all."""
    temporary = None
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with NamedTemporaryFile(dir=path.parent, delete=False) as file:
            temporary = Path(file.name)
            file.write(sha256(content).digest() + content)
        temporary.replace(path)
    except OSError as error:
        warnings.warn(
            f"the result is not kept for later: cannot write {path} ({error.strerror}). To keep "
            "results, set PLASTIGRAN_CACHE to a folder that can be written",
            CacheWarning,
            stacklevel=3,
        )
    finally:
        if temporary:
            with suppress(OSError):
                temporary.unlink(missing_ok=True)


def _sound(file: bytes) -> bytes:
    """Return the content after the checksum.

    Raises:
        ValueError: The checksum is wrong.
    """
    digest, content = file[:DIGEST], file[DIGEST:]
    if sha256(content).digest() != digest:
        raise ValueError("the file is damaged")
    return content


def _key(
    compute: Callable,
    arguments: tuple[object, ...],
    settings: Settings,
    named: dict[str, object],
) -> str:
    others = [(name, _plain(value)) for name, value in sorted(named.items()) if value is not None]
    said = [compute.__qualname__, *map(_plain, arguments), _plain(settings), others, _sources()]
    return sha256(repr(said).encode()).hexdigest()[:32]


def _plain(value: object) -> object:
    """Return a value whose repr contains all its data, for the cache key."""
    if attrs.has(type(value)):
        return type(value).__qualname__, {
            field.name: _plain(getattr(value, field.name)) for field in attrs.fields(type(value))
        }
    if isinstance(value, np.ndarray):  # the repr of a long array is abbreviated
        return value.dtype.str, value.shape, sha256(value.tobytes()).hexdigest()
    if isinstance(value, list | tuple):
        return [_plain(entry) for entry in value]
    return value


@cache
def _sources() -> str:
    """Return a digest of the code of this package and the versions of libraries."""
    digest = sha256(repr([(name, version(name)) for name in LIBRARIES]).encode())
    for path in sorted(Path(__file__).parent.rglob("*.py")):
        digest.update(path.read_bytes())
    return digest.hexdigest()

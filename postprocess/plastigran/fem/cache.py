# SPDX-License-Identifier: GPL-2.0-or-later
"""Cache of finite-element results on disk.

A stored result is used again for the same arguments and settings, until a source file of
`plastigran.fem` or the version of a library changes. The results are stored in the folder
`$PLASTIGRAN_CACHE`; without this variable, in `~/.cache/plastigran`.
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

from plastigran.fem.result_file import from_bytes, to_bytes
from plastigran.fem.settings import Settings

Result = TypeVar("Result")
DIGEST = 32  # number of bytes of the checksum at the start of a file
# Libraries whose versions affect the results; pandas affects the file format.
LIBRARIES = ("numpy", "scipy", "scikit-fem", "pandas")


class CacheWarning(UserWarning):
    """A result could not be written to disk."""


def folder() -> Path:
    """Return the folder in which finite-element results are stored."""
    return Path(os.environ.get("PLASTIGRAN_CACHE") or Path.home() / ".cache" / "plastigran")


def cached(
    compute: Callable[..., Result],
    *arguments: object,
    settings: Settings | None = None,
    progress: bool = False,
    **options: object,
) -> Result:
    """Return `compute(*arguments, settings, progress, **options)`, from disk if possible.

    If the stored file is damaged, the result is computed again. The result of a computation that
    stopped early is not stored.

    Warns:
        CacheWarning: The result could not be stored; the message names the file.
    """
    settings = settings or Settings()
    given = {name: value for name, value in sorted(options.items()) if value is not None}
    key = sha256(to_bytes([compute.__qualname__, arguments, settings, given, _sources()]))
    path = folder() / f"{compute.__name__}_{key.hexdigest()[:32]}.result"
    try:
        return from_bytes(_checked(path.read_bytes()))
    except (OSError, ValueError):  # compute again if the file is missing, unreadable or damaged
        result = compute(*arguments, settings, progress, **options)
    if not getattr(result, "stopped", ""):
        _store(to_bytes(result), path)
    return result


def _store(content: bytes, path: Path) -> None:
    """Write a file with a checksum and `content`, either completely or not at all."""
    temporary = None
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with NamedTemporaryFile(dir=path.parent, delete=False) as file:
            temporary = Path(file.name)
            file.write(sha256(content).digest() + content)
        temporary.replace(path)
    except OSError as error:
        warnings.warn(
            f"the result is not stored: cannot write {path} ({error.strerror}). To store results, "
            "set PLASTIGRAN_CACHE to a folder that can be written",
            CacheWarning,
            stacklevel=3,
        )
    finally:
        if temporary:
            with suppress(OSError):
                temporary.unlink(missing_ok=True)


def _checked(file: bytes) -> bytes:
    """Return the content of a cache file without its leading checksum.

    Raises:
        ValueError: The checksum is wrong.
    """
    digest, content = file[:DIGEST], file[DIGEST:]
    if sha256(content).digest() != digest:
        raise ValueError("the cache file is damaged: its checksum differs")
    return content


@cache
def _sources() -> str:
    """Return a checksum of the code of `plastigran.fem` and of the library versions.

    A change of either makes the stored results invalid.
    """
    digest = sha256(repr([(name, version(name)) for name in LIBRARIES]).encode())
    for path in sorted(Path(__file__).parent.rglob("*.py")):
        digest.update(path.read_bytes())
    return digest.hexdigest()

# SPDX-License-Identifier: GPL-2.0-or-later
"""Independent computations by finite elements, side by side and kept on disk."""

from __future__ import annotations

import os
import signal
import sys
import warnings
from collections.abc import Callable, Hashable, Mapping
from concurrent.futures import ProcessPoolExecutor, as_completed
from multiprocessing import get_context, parent_process
from pathlib import Path
from threading import Thread
from typing import Any, TypeVar

import attrs

from plastigran.fem.cache import cached, folder
from plastigran.progress import ProgressBar

Key = TypeVar("Key", bound=Hashable)


@attrs.frozen
class Computation:
    """A call `compute(*arguments, settings, progress)` as `plastigran.fem.cache.cached` takes it.

    Attributes:
        compute: A function of a module, such as `plastigran.fem.sphere.throw.throw`.
        arguments: Positional.
        settings: How fine; None for the defaults.
        named: Further arguments, by name.
    """

    compute: Callable[..., Any]
    arguments: tuple[object, ...]
    settings: Any = None
    named: Mapping[str, object] = attrs.field(factory=dict)

    def run(self) -> Any:
        """The result, from disk where it was computed before."""
        return cached(self.compute, *self.arguments, settings=self.settings, **self.named)


def compute_all(computations: Mapping[Key, Computation], progress: bool = False) -> dict[Key, Any]:
    """Results by the computations' names, a process a core.

    Args:
        computations: By name; the longest first uses the cores best.
        progress: Show a bar.

    Raises:
        ValueError: One found no equilibrium, or gave up before its end; the message names it.
    """
    found: dict[Key, Any] = {}
    pool = ProcessPoolExecutor(
        os.cpu_count(),
        mp_context=get_context("spawn"),  # this process may have threads
        initializer=_begin,
        initargs=(folder(),),
    )
    waiting = {pool.submit(each.run): name for name, each in computations.items()}
    bar = ProgressBar(total=len(waiting), shown=progress, desc="finite elements")
    try:
        for done in as_completed(waiting):
            name = waiting[done]
            try:
                found[name] = done.result()
            except ArithmeticError as error:
                raise ValueError(f"finite elements, {name}: {error}") from None
            if stopped := getattr(found[name], "stopped", ""):
                raise ValueError(f"finite elements, {name}: {stopped}")
            bar.update()
    finally:
        pool.shutdown(wait=True, cancel_futures=True)
        bar.close()
    return {name: found[name] for name in computations}


def _begin(cache: Path) -> None:
    """Prepare a worker: results go to the folder `cache`, warnings are told as plain lines, and the
    worker ends with the process that started it, and at once upon Ctrl-C."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    os.environ["PLASTIGRAN_CACHE"] = str(cache)
    warnings.showwarning = lambda said, *_, **__: print(f"plastigran: {said}", file=sys.stderr)
    Thread(target=_end_with_parent, daemon=True).start()


def _end_with_parent() -> None:
    # A killed parent closes no pool, and an idle worker would wait for work for ever.
    parent_process().join()
    os._exit(1)

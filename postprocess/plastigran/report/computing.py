# SPDX-License-Identifier: GPL-2.0-or-later
"""Run independent finite-element computations in parallel."""

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

from plastigran.fem.cache import folder
from plastigran.progress import ProgressBar

Key = TypeVar("Key", bound=Hashable)


def compute_all(
    computations: Mapping[Key, Callable[[], Any]], progress: bool = False
) -> dict[Key, Any]:
    """Run computations in parallel, one per core, and return their results by name.

    Args:
        computations: Functions by name. Other processes must be able to import the functions. Most
            are a `partial` of `plastigran.fem.cache.cached`, which stores results on disk. Put the
            longest computation first, so that no core is idle at the end.
        progress: Whether to show a progress bar.

    Raises:
        ValueError: A computation did not converge or stopped early. The message names the
            computation.
    """
    results: dict[Key, Any] = {}
    pool = ProcessPoolExecutor(
        os.cpu_count(),
        # The start method "fork" is unsafe, because this process may have threads.
        mp_context=get_context("spawn"),
        initializer=_start_worker,
        initargs=(folder(),),
    )
    running = {pool.submit(function): name for name, function in computations.items()}
    bar = ProgressBar(total=len(running), shown=progress, desc="finite elements")
    try:
        for future in as_completed(running):
            name = running[future]
            try:
                results[name] = future.result()
            except ArithmeticError as error:
                raise ValueError(f"finite-element computation of {name}: {error}") from None
            if stopped := getattr(results[name], "stopped", ""):
                raise ValueError(f"finite-element computation of {name}: {stopped}")
            bar.update()
    finally:
        pool.shutdown(wait=True, cancel_futures=True)
        bar.close()
    return {name: results[name] for name in computations}


def _start_worker(cache: Path) -> None:
    """Prepare a worker process: set the folder of the cache, and print warnings as plain lines.

    The worker process ends when its parent process ends, and immediately on Ctrl-C.
    """
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    os.environ["PLASTIGRAN_CACHE"] = str(cache)
    warnings.showwarning = lambda text, *_, **__: print(f"plastigran: {text}", file=sys.stderr)
    Thread(target=_end_with_parent, daemon=True).start()


def _end_with_parent() -> None:
    # If the parent process is killed, it does not close the pool. Without this thread, an idle
    # worker process would then wait forever.
    parent_process().join()
    os._exit(1)

# SPDX-License-Identifier: GPL-2.0-or-later
"""Show how far a run of the engine is."""

from __future__ import annotations

from pathlib import Path

from tqdm import tqdm

from plastigran.engine.log import LogFollower


class ProgressBar:
    """A bar on standard error that follows a run's log.

    Args:
        name: What stands before the bar.
        log: The engine's log, which need not be there yet.
        shown: Show the bar when standard error is a terminal.
    """

    def __init__(self, name: str, log: Path, shown: bool = True) -> None:
        self._follower = LogFollower(log)
        self._bar = tqdm(desc=name, unit="step", unit_scale=True, disable=None if shown else True)

    def update(self) -> None:
        """Take in what the log has gained."""
        if self._bar.disable:
            return
        before = self._follower.progress.run
        progress = self._follower.read()
        if not progress.run:
            return
        self._bar.set_postfix_str(f"t = {progress.step * progress.timestep:.3g} s", refresh=False)
        if progress.run != before:
            self._bar.reset(progress.last - progress.first)
        self._bar.update(progress.step - progress.first - self._bar.n)

    def close(self) -> None:
        """Leave the bar as it is."""
        self._bar.close()

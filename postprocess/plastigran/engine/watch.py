# SPDX-License-Identifier: GPL-2.0-or-later
"""Show how far a run of the engine is."""

from __future__ import annotations

from pathlib import Path

from plastigran.engine.log import LogFollower
from plastigran.progress import ProgressBar


class RunBar:
    """A bar on standard error that follows a run's log.

    Args:
        name: What stands before the bar.
        log: The engine's log, which need not be there yet.
        shown: Show the bar.
    """

    def __init__(self, name: str, log: Path, shown: bool = True) -> None:
        self._follower = LogFollower(log)
        self._bar = ProgressBar(desc=name, unit="steps", unit_scale=True, shown=shown)

    def update(self) -> None:
        """Take in what the log has gained."""
        if self._bar.disable:
            return
        before = self._follower.progress.run
        now = self._follower.read()
        if not now.run:
            return
        said = [f"run {now.run}"] if now.run > 1 else []
        if now.timestep:
            said.append(f"t = {now.step * now.timestep:.3g} s")
        self._bar.set_postfix_str(", ".join(said), refresh=False)
        if now.run != before:
            self._bar.reset(now.last - now.first)
        self._bar.update(now.step - now.first - self._bar.n)

    def close(self) -> None:
        """Leave the bar as it is."""
        self._bar.close()

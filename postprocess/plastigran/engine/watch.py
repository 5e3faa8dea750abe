# SPDX-License-Identifier: GPL-2.0-or-later
"""Progress bar of a LIGGGHTS run."""

from __future__ import annotations

from pathlib import Path

from plastigran.engine.log import LogFollower
from plastigran.progress import ProgressBar


class RunBar:
    """Progress bar on standard error that follows the log of a run.

    Args:
        name: Text before the bar.
        log: Path of the log, which may not exist yet.
        shown: Whether to show the bar.
        planned: Total steps of all `run` commands of the deck, or 0 if unknown. A line `planned
            steps = N` in the log replaces this value. If the total is unknown, the bar shows the
            progress of the current `run` command.
    """

    def __init__(self, name: str, log: Path, shown: bool = True, planned: int = 0) -> None:
        self._follower = LogFollower(log)
        self._planned = planned
        self._bar = ProgressBar(desc=name, unit="steps", unit_scale=True, shown=shown)

    def update(self) -> None:
        """Read the new lines of the log, and update the bar."""
        if self._bar.disable:
            return
        earlier_run = self._follower.progress.run
        now = self._follower.read()
        if not now.run:
            return
        details = [f"run {now.run}"] if now.run > 1 else []
        if now.timestep:
            details.append(f"t = {now.step * now.timestep:.3g} s")
        self._bar.set_postfix_str(", ".join(details), refresh=False)
        planned = now.planned or self._planned
        if planned and earlier_run == 0:
            self._bar.reset(planned)
        elif not planned and now.run != earlier_run:
            self._bar.reset(now.last - now.first)
        self._bar.scope = "" if planned else " in this run"
        done = now.step - now.first + (now.earlier if planned else 0)
        self._bar.update(done - self._bar.n)

    def close(self) -> None:
        """Close the bar and leave it visible."""
        self._bar.close()

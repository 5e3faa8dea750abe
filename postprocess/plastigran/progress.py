# SPDX-License-Identifier: GPL-2.0-or-later
"""Progress of long computations on standard error: a bar on a terminal, otherwise lines of text."""

from __future__ import annotations

import sys
from typing import Any

from tqdm import tqdm

#: Without a terminal, time before the first progress line, and time between lines [s].
FIRST, EVERY = 5.0, 10.0


class ProgressBar(tqdm):
    """Progress bar on a terminal; otherwise lines of text, but no line for a short computation.

    Args:
        *arguments: Positional arguments of tqdm.
        shown: Whether to show the progress.
        **named: Keyword arguments of tqdm, except `file`, which is standard error.
    """

    def __init__(self, *arguments: Any, shown: bool = True, **named: Any) -> None:
        self.scope = ""  # words after the remaining time, such as " in this run"
        self._in_place = sys.stderr.isatty()
        if not self._in_place:
            named |= {"delay": FIRST, "mininterval": EVERY, "miniters": 0}
        super().__init__(*arguments, file=sys.stderr, disable=not shown, **named)

    def reset(self, total: float | None = None) -> None:
        """Set the bar back to zero; `total` replaces the earlier number of steps."""
        # Prevent tqdm.reset() from drawing a bar at zero.
        display, self.display = self.display, lambda *_, **__: False
        try:
            super().reset(total)
        finally:
            self.display = display

    def display(self, msg: str | None = None, pos: int | None = None) -> bool:
        """Draw the bar; without a terminal, print a line of text."""
        if self._in_place:
            return super().display(msg, pos)
        if msg is None:
            self.fp.write(f"{self._line()}\n")
            self.fp.flush()
        return False

    def close(self) -> None:
        """Close the bar, which stays visible; without a terminal, print the final state."""
        if not (self.disable or self._in_place):
            self.leave = False  # add no line feed, because each printed line ends with a line feed
            if self.last_print_t >= self.start_t + self.delay and self.n > self.last_print_n:
                self.display()
        super().close()

    def _line(self) -> str:
        """Return the progress in words: `impact: 24/84, 00:20 so far, 00:50 to go`."""
        elapsed = self.format_dict["elapsed"]
        number = self.format_sizeof if self.unit_scale else "{:.4g}".format
        count = f"{number(self.n)}/{number(self.total)}" if self.total else number(self.n)
        parts = [f"{self.desc.removesuffix(': ') or 'progress'}: {count} {self.unit}".rstrip()]
        if self.postfix:
            parts.append(self.postfix)
        parts.append(f"{self.format_interval(elapsed)} so far")
        if self.total and self.n:
            remaining = max(elapsed * (self.total / self.n - 1), 0.0)
            parts.append(f"{self.format_interval(remaining)} to go{self.scope}")
        return ", ".join(parts)

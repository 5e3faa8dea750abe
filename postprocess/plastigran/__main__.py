# SPDX-License-Identifier: GPL-2.0-or-later
"""The command `plastigran`, and `python -m plastigran`."""

from __future__ import annotations

import signal
import sys


def start() -> int:
    """Run the command; an interrupt while modules load is reported, too."""
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        from plastigran.cli import main  # takes a second

        return main()
    except KeyboardInterrupt:
        print("plastigran: stopped", file=sys.stderr)
        return 130


if __name__ == "__main__":
    sys.exit(start())

# SPDX-License-Identifier: GPL-2.0-or-later
"""Entry point of the command `plastigran` and of `python -m plastigran`."""

from __future__ import annotations

import signal
import sys


def start() -> int:
    """Run the command and return its exit code, also if Ctrl-C interrupts the import of modules."""
    # Handle SIGTERM, which batch systems send to stop a job, like Ctrl-C.
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        # Import this slow module here, so that Ctrl-C during the import is handled.
        from plastigran.cli import main

        return main()
    except KeyboardInterrupt:
        print("plastigran: stopped", file=sys.stderr)
        return 130


if __name__ == "__main__":
    sys.exit(start())

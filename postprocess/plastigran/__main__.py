# SPDX-License-Identifier: GPL-2.0-or-later
"""Entry point of the command `plastigran` and of `python -m plastigran`."""

from __future__ import annotations

import signal
import sys


def start() -> int:
    """Run the command and return its exit code; Ctrl-C during imports gives exit code 130."""
    # Treat SIGTERM like Ctrl-C. Batch systems send SIGTERM to stop a job.
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        # Import this slow module inside `try`: Ctrl-C during the import then prints no traceback.
        from plastigran.cli import main

        return main()
    except KeyboardInterrupt:
        print("plastigran: stopped", file=sys.stderr)
        return 130


if __name__ == "__main__":
    sys.exit(start())

# SPDX-License-Identifier: GPL-2.0-or-later
"""`python -m plastigran.cli`."""

import sys

from plastigran.cli import main

sys.exit(main())

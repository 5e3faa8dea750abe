# SPDX-License-Identifier: GPL-2.0-or-later
"""The engine: how it is run, watched and read."""

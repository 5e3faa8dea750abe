# SPDX-License-Identifier: GPL-2.0-or-later
"""A rigid cylinder that hits a body in plane strain."""

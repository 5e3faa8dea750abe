# SPDX-License-Identifier: GPL-2.0-or-later
"""Reference data for the contact laws, and errors of the laws compared with these data."""

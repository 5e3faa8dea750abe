# SPDX-License-Identifier: GPL-2.0-or-later
"""Reference data for the contact laws, and the errors of the laws relative to these data."""

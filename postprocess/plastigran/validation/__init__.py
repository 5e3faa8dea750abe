# SPDX-License-Identifier: GPL-2.0-or-later
"""How far every law is off finite elements, papers and experiments; nothing here is fitted."""

# SPDX-License-Identifier: GPL-2.0-or-later
"""Contacts with which the cases are computed."""

from __future__ import annotations

#: Settings of the contacts by label: LIGGGHTS' own hertz with the prescribed restitution, and a
#: yield strength instead of it.
CONTACTS = {
    "hertz": {"law": "hertz", "ledger": "off"},
    "thornton": {"law": "thornton"},
}

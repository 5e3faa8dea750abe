# SPDX-License-Identifier: GPL-2.0-or-later
"""Contacts with which the cases are computed."""

from __future__ import annotations

#: Settings of the contacts by label. LIGGGHTS' own hertz has the prescribed restitution; the law
#: thornton has a yield strength instead.
CONTACTS = {
    "hertz": {"law": "hertz", "ledger": "off"},
    "thornton": {"law": "thornton"},
}

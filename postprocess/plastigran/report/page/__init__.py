# SPDX-License-Identifier: GPL-2.0-or-later
"""One page of HTML for runs of any kind: no network, nothing beside it.

`collect` finds results, the `*_section` modules say what is to be shown of a folder, `*_charts` and
`movie` make its charts and its view of grains, and `render` writes the page by `templates` with the
styles and scripts of `assets`.
"""

from plastigran.report.page.render import write_report

__all__ = ["write_report"]

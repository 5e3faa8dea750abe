# SPDX-License-Identifier: GPL-2.0-or-later
"""One HTML page for runs of any kind, without network access or other files.

`collect` finds results. The `*_section` modules decide what a page shows of a folder. The
`*_charts` modules, `trust` and `movie` make the data of its charts and of its view of grains.
`charts` draws charts, and `render` writes the page from `templates`, with the styles and scripts of
`assets`.
"""

from plastigran.report.page.render import write_report

__all__ = ["write_report"]

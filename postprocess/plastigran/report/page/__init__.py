# SPDX-License-Identifier: GPL-2.0-or-later
"""One HTML page for results of any kind. The page needs no network access and no other files.

`collect` finds results. The `*_section` modules decide what the page shows of a folder. The
`*_charts` modules and `trust` make the data of charts, `movie` the data of the view of grains.
`charts` draws charts. `render` writes the page from `templates`, with the styles and scripts of
`assets`.
"""

from plastigran.report.page.render import write_report

__all__ = ["write_report"]

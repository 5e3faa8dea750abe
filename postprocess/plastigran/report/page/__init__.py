# SPDX-License-Identifier: GPL-2.0-or-later
"""One HTML page that shows results of any kind. The page needs no network and no other files.

`collect` finds folders with results. The `*_section` modules make the section of the page for one
folder. The `*_charts` modules and `trust` make the data of charts. `movie` packs the snapshots for
the three-dimensional view of grains. `charts` draws charts. `render` writes the page from
`templates`, with the styles and scripts of `assets`.
"""

from plastigran.report.page.render import write_report

__all__ = ["write_report"]

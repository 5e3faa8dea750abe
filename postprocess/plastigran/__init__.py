# SPDX-License-Identifier: GPL-2.0-or-later
"""Plastigran: elasto-plastic contact laws for LIGGGHTS, with tools to run, test and plot them.

    import numpy as np, plastigran as pg

    steel = pg.material("steel")
    contact = pg.Contact("kogut_etsion", steel, pg.RIGID, radius=5e-3)
    contact.path(np.linspace(0, 5e-6, 200)).plot("overlap", "force")
    contact.restitution(np.geomspace(1e-3, 0.4, 40))
    runs = pg.collide(["kogut_etsion", "thornton"], [0.1, 1.0], steel, radius=5e-3)
    runs.table, runs.figure("restitution")
    flow = pg.bulk("hopper", law="thornton", ranks=2)    # or pg.open("results/hopper")
    flow.series, flow.checks, flow.figures["hopper"]

The package imports a public name at its first use, so that `import plastigran` is fast. Type
checkers read the plain imports below `TYPE_CHECKING`.
"""

from importlib import import_module
from typing import TYPE_CHECKING

_PUBLIC = {
    "RIGID": ("materials", "RIGID"),
    "Contact": ("contact", "Contact"),
    "bulk": ("bulk", None),
    "calibrate": ("calibration", "calibrate"),
    "cite": ("citation", "cite"),
    "collide": ("experiments.collide", "collide"),
    "laws": ("laws", None),
    "material": ("materials", "read_material"),
    "open": ("bulk", "open"),
}

__all__ = ["RIGID", "Contact", "bulk", "calibrate", "cite", "collide", "laws", "material", "open"]

if TYPE_CHECKING:
    from plastigran import bulk, laws
    from plastigran.bulk import open
    from plastigran.calibration import calibrate
    from plastigran.citation import cite
    from plastigran.contact import Contact
    from plastigran.experiments.collide import collide
    from plastigran.materials import RIGID
    from plastigran.materials import read_material as material
else:

    def __getattr__(name: str) -> object:
        if name not in _PUBLIC:
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        module_name, attribute = _PUBLIC[name]
        module = import_module(f"{__name__}.{module_name}")
        globals()[name] = module if attribute is None else getattr(module, attribute)
        return globals()[name]


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})

# SPDX-License-Identifier: GPL-2.0-or-later
"""From what one can measure, or afford, to the constants of a deck."""

from plastigran.calibration.calibrating import calibrate
from plastigran.calibration.drop_test import DropTest
from plastigran.calibration.metal import CalibratedMetal

__all__ = ["CalibratedMetal", "DropTest", "calibrate"]

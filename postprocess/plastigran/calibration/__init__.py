# SPDX-License-Identifier: GPL-2.0-or-later
"""From what people can measure of a metal to what the laws take."""

from plastigran.calibration.calibrating import calibrate
from plastigran.calibration.drop_test import DropTest
from plastigran.calibration.metal import CalibratedMetal

__all__ = ["CalibratedMetal", "DropTest", "calibrate"]

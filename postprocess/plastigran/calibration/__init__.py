# SPDX-License-Identifier: GPL-2.0-or-later
"""Calibration of material constants from measurements, and softening of materials."""

from plastigran.calibration.calibrating import calibrate
from plastigran.calibration.drop_test import DropTest
from plastigran.calibration.metal import CalibratedMetal
from plastigran.calibration.surface_energy import CalibratedAdhesion, calibrate_adhesion

__all__ = ["CalibratedAdhesion", "CalibratedMetal", "DropTest", "calibrate", "calibrate_adhesion"]

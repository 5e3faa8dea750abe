# SPDX-License-Identifier: GPL-2.0-or-later
"""The sphere of Zhang and Vu-Quoc (2002), and coarse finite-element settings for fast tests."""

from plastigran.fem.material.elastic_plastic import ElasticPlastic
from plastigran.fem.material.hardening import LinearHardening
from plastigran.fem.settings import Settings

RADIUS = 0.1
ELASTIC = ElasticPlastic(youngs_modulus=70e9, poissons_ratio=0.3, density=2699.0)
METAL = ElasticPlastic(
    youngs_modulus=70e9, poissons_ratio=0.3, density=2699.0, hardening=LinearHardening(100e6)
)
COARSE = Settings(divisions=4, fineness=0.5, growth=1.15, unloading_steps=10, steps_of_contact=80)

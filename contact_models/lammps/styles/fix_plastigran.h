// SPDX-License-Identifier: GPL-2.0-or-later
//
// Fix styles. LAMMPS and plugin.cpp include this list with their own definition of FixStyle.
#ifdef FIX_CLASS
// clang-format off
FixStyle(wall/gran/plastigran,plastigran::WallStyle<LAMMPS_NS::FixWallGran>);
FixStyle(wall/gran/region/plastigran,plastigran::WallStyle<LAMMPS_NS::FixWallGranRegion>);
FixStyle(plastigran/energy,plastigran::EnergyBalance);
FixStyle(plastigran/checks,plastigran::RunTimeChecks);
FixStyle(plastigran/values,plastigran::ParticleValues);
// clang-format on
#else
#include "lammps/energy_balance.h"
#include "lammps/particle_values.h"
#include "lammps/run_time_checks.h"
#include "lammps/wall_style.h"
#endif

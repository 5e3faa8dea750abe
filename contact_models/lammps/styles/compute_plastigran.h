// SPDX-License-Identifier: GPL-2.0-or-later
//
// Compute styles. LAMMPS and plugin.cpp include this list with their own definition of
// ComputeStyle.
#ifdef COMPUTE_CLASS
// clang-format off
ComputeStyle(plastigran/energy,plastigran::EnergyCompute);
// clang-format on
#else
#include "lammps/energy_compute.h"
#endif

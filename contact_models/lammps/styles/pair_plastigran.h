// SPDX-License-Identifier: GPL-2.0-or-later
//
// Pair styles. LAMMPS and plugin.cpp include this list with their own definition of PairStyle.
#ifdef PAIR_CLASS
// clang-format off
PairStyle(granular/plastigran,plastigran::PairStyle);
// clang-format on
#else
#include "lammps/pair_style.h"
#endif

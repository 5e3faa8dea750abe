// SPDX-License-Identifier: GPL-2.0-or-later
//
// Includes LIGGGHTS' contact models, pair styles and walls for Plastigran, without compiler
// warnings.
#pragma once

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include "fix_insert_stream.h"  // granular_styles.h uses these two without including them
#include "fix_mesh_surface.h"
#include "granular_styles.h"
#pragma GCC diagnostic pop

// SPDX-License-Identifier: GPL-2.0-or-later
//
// The engine's contact models and what makes pair styles and walls of them, for the registration of
// plastigran's laws, without the compiler's warnings about them.
#pragma once

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include "fix_insert_stream.h"  // granular_styles.h uses these two without including them
#include "fix_mesh_surface.h"
#include "granular_styles.h"
#pragma GCC diagnostic pop

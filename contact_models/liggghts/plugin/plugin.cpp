// SPDX-License-Identifier: GPL-2.0-or-later
//
// Checks that the plugin was compiled for this LIGGGHTS. The data layout is checked when the plugin
// is loaded, and the version at the first line with a law. With a wrong layout, pairs would work
// but walls would crash. If LIGGGHTS was built with superquadric particles, its data structures are
// larger. The plugin recognizes such a build by the symbol of the superquadric atom style.
#include <dlfcn.h>
#include <unistd.h>

#include <cstdio>
#include <string>

#include "liggghts/fixes/messages.h"
#include "liggghts/plugin/registered.h"
#include "universe.h"

namespace {

#ifdef SUPERQUADRIC_ACTIVE_FLAG
constexpr bool expects_superquadric = true;
#else
constexpr bool expects_superquadric = false;
#endif

const bool engine_checked = [] {
  const bool superquadric = dlsym(RTLD_DEFAULT, "_ZTVN9LAMMPS_NS18AtomVecSuperquadricE");
  if (superquadric == expects_superquadric) return true;
  std::fprintf(stderr,
               "ERROR: Plastigran was compiled for a LIGGGHTS %s superquadric particles, but this "
               "LIGGGHTS was built %s them. Its data layout differs. Compile Plastigran with the "
               "headers of this LIGGGHTS (%s)\n",
               expects_superquadric ? "with" : "without", superquadric ? "with" : "without",
               PLASTIGRAN_ENGINE_VERSION);
  std::fflush(stderr);
  _exit(1);
}();

}  // namespace

namespace plastigran {

void require_version(LAMMPS_NS::LAMMPS* engine) {
  if (std::string(engine->universe->version).find(PLASTIGRAN_ENGINE_VERSION) != std::string::npos)
    return;
  stop(engine, std::string("Plastigran was compiled for ") + PLASTIGRAN_ENGINE_VERSION +
                   ", but this is " + engine->universe->version +
                   ". Compile Plastigran with the headers of this LIGGGHTS");
}

}  // namespace plastigran

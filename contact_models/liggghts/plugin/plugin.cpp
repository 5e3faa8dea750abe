// SPDX-License-Identifier: GPL-2.0-or-later
//
// Is the engine the one that the plugin was compiled for? Its version can be asked once an engine
// exists; the layout of its structures as the plugin is loaded.
// The build options of LIGGGHTS change them silently, pairs would still work and walls would crash.
// The superquadric atom style is exported by just those engines that have the larger layout.
#include <dlfcn.h>
#include <unistd.h>

#include <cstdio>
#include <string>

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
               "LIGGGHTS was built %s them. Its data layout differs; compile Plastigran against "
               "this engine (%s)\n",
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
  const std::string text = std::string("Plastigran was compiled for ") + PLASTIGRAN_ENGINE_VERSION +
                           " but this engine is " + engine->universe->version +
                           "; compile Plastigran against this engine's headers";
  engine->error->all(FLERR, text.c_str());
}

}  // namespace plastigran

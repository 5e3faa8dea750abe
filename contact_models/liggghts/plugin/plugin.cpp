// SPDX-License-Identifier: GPL-2.0-or-later
//
// Load-time check of the plugin: do the engine's structures have the layout it was compiled for?
// The build options of LIGGGHTS change them silently, pairs would still work and walls would crash.
// The superquadric atom style is exported by just those engines that have the larger layout.
#include <dlfcn.h>
#include <unistd.h>

#include <cstdio>

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

// SPDX-License-Identifier: GPL-2.0-or-later
//
// Registers the styles of `plastigranplugin.so`. LAMMPS loads the plugin by `plugin load`, or at
// its start from the folders in LAMMPS_PLUGIN_PATH.
#include <cstring>

#include "error.h"
#include "lammps.h"
#include "lammps/energy_balance.h"
#include "lammps/energy_compute.h"
#include "lammps/pair_style.h"
#include "lammps/particle_values.h"
#include "lammps/run_time_checks.h"
#include "lammps/wall_style.h"

namespace plastigran {
namespace {

using LAMMPS_NS::LAMMPS;

void* make_pair(void* lammps) {
  return static_cast<LAMMPS_NS::Pair*>(new PairStyle(static_cast<LAMMPS*>(lammps)));
}

template <class Style, class Base>
void* make(void* lammps, int count, char** words) {
  return static_cast<Base*>(new Style(static_cast<LAMMPS*>(lammps), count, words));
}

#ifndef PLASTIGRAN_LAMMPS_TAG
#define PLASTIGRAN_LAMMPS_TAG "any update"  // the sources define the binary interface
#endif
constexpr const char* tag = PLASTIGRAN_LAMMPS_TAG;

// Returns whether the plugin was compiled for the binary interface of this LAMMPS.
bool fits(const LAMMPS& lammps) {
  if (std::strcmp(lammps.version, PLASTIGRAN_LAMMPS_VERSION) != 0) return false;
#ifdef PLASTIGRAN_LAMMPS_SOURCE
  return true;
#else
  const std::string description = LAMMPS::git_descriptor();
  return description == "(unknown)" || description == tag;
#endif
}

}  // namespace
}  // namespace plastigran

// Warns if the plugin does not fit. An error would stop every LAMMPS that finds the plugin in
// LAMMPS_PLUGIN_PATH, even with decks that do not use it.
extern "C" __attribute__((visibility("default"))) void lammpsplugin_init(void* host, void* handle,
                                                                         void* register_style) {
  using namespace plastigran;
  auto* const lammps = static_cast<LAMMPS*>(host);
  if (!fits(*lammps)) {
    lammps->error->warning(FLERR,
                           "plastigranplugin.so was built for LAMMPS {} ({}), but this is LAMMPS "
                           "{} ({}); its styles are not available. Build the plugin again",
                           PLASTIGRAN_LAMMPS_VERSION, tag, lammps->version,
                           LAMMPS::git_descriptor());
    return;
  }
  lammpsplugin_t plugin{};
  plugin.version = PLASTIGRAN_LAMMPS_VERSION;
  plugin.author = "Plastigran";
  plugin.info = "Elasto-plastic contact laws";
  plugin.handle = handle;
  const auto add = [&](const char* style, const char* name) {
    plugin.style = style;
    plugin.name = name;
    reinterpret_cast<lammpsplugin_regfunc>(register_style)(&plugin, lammps);
  };
  plugin.creator.v1 = &make_pair;
  add("pair", "granular/plastigran");
  plugin.creator.v2 = &make<WallStyle<LAMMPS_NS::FixWallGran>, LAMMPS_NS::Fix>;
  add("fix", "wall/gran/plastigran");
  plugin.creator.v2 = &make<WallStyle<LAMMPS_NS::FixWallGranRegion>, LAMMPS_NS::Fix>;
  add("fix", "wall/gran/region/plastigran");
  plugin.creator.v2 = &make<EnergyBalance, LAMMPS_NS::Fix>;
  add("fix", "plastigran/energy");
  plugin.creator.v2 = &make<RunTimeChecks, LAMMPS_NS::Fix>;
  add("fix", "plastigran/checks");
  plugin.creator.v2 = &make<ParticleValues, LAMMPS_NS::Fix>;
  add("fix", "plastigran/values");
  plugin.creator.v2 = &make<EnergyCompute, LAMMPS_NS::Compute>;
  add("compute", "plastigran/energy");
}

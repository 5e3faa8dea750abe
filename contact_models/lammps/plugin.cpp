// SPDX-License-Identifier: GPL-2.0-or-later
//
// Registers the styles of `plastigranplugin.so`. LAMMPS loads the plugin by `plugin load`, or at
// its start from the folders in LAMMPS_PLUGIN_PATH.
#include <cstring>

#include "error.h"
#include "lammps.h"
#include "lammps/styles/compute_plastigran.h"
#include "lammps/styles/fix_plastigran.h"
#include "lammps/styles/pair_plastigran.h"
#include "library.h"

namespace plastigran {
namespace {

using LAMMPS_NS::LAMMPS;

template <class Style>
void* make_pair(void* lammps) {
  return static_cast<LAMMPS_NS::Pair*>(new Style(static_cast<LAMMPS*>(lammps)));
}

template <class Style, class Base>
void* make(void* lammps, int count, char** words) {
  return static_cast<Base*>(new Style(static_cast<LAMMPS*>(lammps), count, words));
}

#ifndef PLASTIGRAN_LAMMPS_TAG
#define PLASTIGRAN_LAMMPS_TAG "any update"  // built with LAMMPS' own headers
#endif
constexpr const char* tag = PLASTIGRAN_LAMMPS_TAG;

// Returns whether the plugin was compiled for the binary interface of the running LAMMPS.
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

// Registers the styles. If the plugin was built for another version of LAMMPS, only warns: an error
// would stop every run of LAMMPS that finds the plugin in LAMMPS_PLUGIN_PATH, even if its deck does
// not use the plugin.
extern "C" __attribute__((visibility("default"))) void lammpsplugin_init(void* host, void* handle,
                                                                         void* register_style) {
  using namespace plastigran;
  auto* const lammps = static_cast<LAMMPS*>(host);
  if (lammps_has_style(host, "pair", "granular/plastigran")) return;  // compiled into LAMMPS
  if (!fits(*lammps)) {
    lammps->error->warning(FLERR,
                           "plastigranplugin.so was built for LAMMPS {} ({}), but this is LAMMPS "
                           "{} ({}); its styles are not available. Build the plugin for this "
                           "version",
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
#define PAIR_CLASS
#define PairStyle(name, Class)           \
  plugin.creator.v1 = &make_pair<Class>; \
  add("pair", #name)
#include "lammps/styles/pair_plastigran.h"
#define FIX_CLASS
#define FixStyle(name, Class)                       \
  plugin.creator.v2 = &make<Class, LAMMPS_NS::Fix>; \
  add("fix", #name)
#include "lammps/styles/fix_plastigran.h"
#define COMPUTE_CLASS
#define ComputeStyle(name, Class)                       \
  plugin.creator.v2 = &make<Class, LAMMPS_NS::Compute>; \
  add("compute", #name)
#include "lammps/styles/compute_plastigran.h"
}

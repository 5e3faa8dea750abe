// SPDX-License-Identifier: GPL-2.0-or-later
//
// What a contact model must reach in the engine and the engine keeps private. Naming a private
// member in an explicit instantiation is the language's own way in.
#ifndef PLASTIGRAN_ENGINE_ACCESS_H
#define PLASTIGRAN_ENGINE_ACCESS_H

#include <map>
#include <string>

#include "fix.h"
#include "modify.h"
#include "output.h"
#include "settings.h"
#include "thermo.h"

namespace plastigran {

// The engine's Settings offers on/off and numbers to models, and keeps choices among words to
// itself.
struct EngineSettings {
  typedef std::map<std::string, Setting*> Settings::*type;
  friend type reach(EngineSettings);
};

// Styles of fixes by name: a plugin has no other way to add one.
struct EngineFixes {
  typedef LAMMPS_NS::Fix* (*Creator)(LAMMPS_NS::LAMMPS*, int, char**);
  typedef std::map<std::string, Creator>* LAMMPS_NS::Modify::*type;
  friend type reach(EngineFixes);
};

// What the engine does about lost particles.
struct EngineThermoLost {
  typedef int LAMMPS_NS::Thermo::*type;
  friend type reach(EngineThermoLost);
};

// The step of the next restart file.
struct EngineNextRestart {
  typedef LAMMPS_NS::bigint LAMMPS_NS::Output::*type;
  friend type reach(EngineNextRestart);
};

template <class Tag, typename Tag::type Member>
struct Reach {
  friend typename Tag::type reach(Tag) { return Member; }
};
template struct Reach<EngineSettings, &Settings::settings>;
template struct Reach<EngineFixes, &LAMMPS_NS::Modify::fix_map>;
template struct Reach<EngineNextRestart, &LAMMPS_NS::Output::next_restart>;
template struct Reach<EngineThermoLost, &LAMMPS_NS::Thermo::lostflag>;

}  // namespace plastigran

#endif

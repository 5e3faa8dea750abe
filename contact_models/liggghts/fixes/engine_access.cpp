// SPDX-License-Identifier: GPL-2.0-or-later
//
// Naming a private member in an explicit instantiation is the language's own way in.
#include "liggghts/fixes/engine_access.h"

#include <limits>

#include "fix.h"
#include "fix_insert_pack.h"
#include "fix_property_global.h"
#include "modify.h"
#include "output.h"
#include "primitive_wall.h"
#include "settings.h"
#include "thermo.h"

namespace plastigran {

namespace {

struct SettingsByName {
  typedef std::map<std::string, Setting*> Settings::*type;
  friend type reach(SettingsByName);
};
struct NumberValue {
  typedef ValuePropagator<double> DoubleSetting::*type;
  friend type reach(NumberValue);
};
struct FixCreators {
  typedef std::map<std::string, FixCreator>* LAMMPS_NS::Modify::*type;
  friend type reach(FixCreators);
};
struct RestartedIds {
  typedef char** LAMMPS_NS::Modify::*type;
  friend type reach(RestartedIds);
};
struct RestartedStyles {
  typedef char** LAMMPS_NS::Modify::*type;
  friend type reach(RestartedStyles);
};
struct RestartedStates {
  typedef char** LAMMPS_NS::Modify::*type;
  friend type reach(RestartedStates);
};
struct RestartedIdsByAtom {
  typedef char** LAMMPS_NS::Modify::*type;
  friend type reach(RestartedIdsByAtom);
};
struct RestartedStylesByAtom {
  typedef char** LAMMPS_NS::Modify::*type;
  friend type reach(RestartedStylesByAtom);
};
struct LostFlag {
  typedef int LAMMPS_NS::Thermo::*type;
  friend type reach(LostFlag);
};
struct NextRestart {
  typedef LAMMPS_NS::bigint LAMMPS_NS::Output::*type;
  friend type reach(NextRestart);
};
struct VariableName {
  typedef char* LAMMPS_NS::FixPropertyGlobal::*type;
  friend type reach(VariableName);
};
struct InsertHasTotal {
  typedef int LAMMPS_NS::FixInsert::*type;
  friend type reach(InsertHasTotal);
};
struct InsertTotal {
  typedef int LAMMPS_NS::FixInsert::*type;
  friend type reach(InsertTotal);
};
struct InsertDone {
  typedef int LAMMPS_NS::FixInsert::*type;
  friend type reach(InsertDone);
};
struct InsertEvery {
  typedef int LAMMPS_NS::FixInsert::*type;
  friend type reach(InsertEvery);
};
struct InsertInRegion {
  typedef int LAMMPS_NS::FixInsertPack::*type;
  friend type reach(InsertInRegion);
};
struct WallKind {
  typedef PRIMITIVE_WALL_DEFINITIONS::WallType LAMMPS_NS::PrimitiveWall::*type;
  friend type reach(WallKind);
};
struct WallNumbers {
  typedef double* LAMMPS_NS::PrimitiveWall::*type;
  friend type reach(WallNumbers);
};
struct WallNumberCount {
  typedef int LAMMPS_NS::PrimitiveWall::*type;
  friend type reach(WallNumberCount);
};

template <class Tag, typename Tag::type Member>
struct Reach {
  friend typename Tag::type reach(Tag) { return Member; }
};
template struct Reach<SettingsByName, &Settings::settings>;
template struct Reach<NumberValue, &DoubleSetting::current>;
template struct Reach<FixCreators, &LAMMPS_NS::Modify::fix_map>;
template struct Reach<RestartedIds, &LAMMPS_NS::Modify::id_restart_global>;
template struct Reach<RestartedStyles, &LAMMPS_NS::Modify::style_restart_global>;
template struct Reach<RestartedStates, &LAMMPS_NS::Modify::state_restart_global>;
template struct Reach<RestartedIdsByAtom, &LAMMPS_NS::Modify::id_restart_peratom>;
template struct Reach<RestartedStylesByAtom, &LAMMPS_NS::Modify::style_restart_peratom>;
template struct Reach<LostFlag, &LAMMPS_NS::Thermo::lostflag>;
template struct Reach<NextRestart, &LAMMPS_NS::Output::next_restart>;
template struct Reach<VariableName, &LAMMPS_NS::FixPropertyGlobal::variablename>;
template struct Reach<InsertHasTotal, &LAMMPS_NS::FixInsert::ninsert_exists>;
template struct Reach<InsertTotal, &LAMMPS_NS::FixInsert::ninsert>;
template struct Reach<InsertDone, &LAMMPS_NS::FixInsert::ninserted>;
template struct Reach<InsertEvery, &LAMMPS_NS::FixInsert::insert_every>;
template struct Reach<InsertInRegion, &LAMMPS_NS::FixInsertPack::ntotal_region>;
template struct Reach<WallKind, &LAMMPS_NS::PrimitiveWall::wType>;
template struct Reach<WallNumbers, &LAMMPS_NS::PrimitiveWall::param>;
template struct Reach<WallNumberCount, &LAMMPS_NS::PrimitiveWall::nParam>;

}  // namespace

void add_choice(Settings& settings, const std::string& name, const char* const* words,
                std::size_t count, int& chosen) {
  EnumSetting<int>* const setting = new EnumSetting<int>(name);  // Settings deletes it
  for (std::size_t k = 0; k < count; ++k)
    if (words[k]) setting->addOption(words[k], k);
  setting->setDefault(words[chosen]);
  setting->registerTarget(chosen);
  (settings.*reach(SettingsByName()))[name] = setting;
}

const std::map<std::string, Setting*>& settings_by_name(const Settings& settings) {
  return settings.*reach(SettingsByName());
}

bool is_number(const Setting& setting, double& number) {
  const auto found = dynamic_cast<const DoubleSetting*>(&setting);
  if (found) number = (found->*reach(NumberValue())).getValue();
  return found;
}

void add_fix_style(LAMMPS_NS::Modify* modify, const std::string& style, FixCreator creator) {
  (*(modify->*reach(FixCreators())))[style] = creator;
}

FixCreator fix_creator(LAMMPS_NS::Modify* modify, const std::string& style) {
  const auto& creators = *(modify->*reach(FixCreators()));
  const auto found = creators.find(style);
  return found == creators.end() ? nullptr : found->second;
}

const char* restarted_state(LAMMPS_NS::Modify* modify, const std::string& id,
                            const std::string& style) {
  for (int k = 0; k < modify->nfix_restart_global; ++k)
    if ((modify->*reach(RestartedIds()))[k] == id &&
        (modify->*reach(RestartedStyles()))[k] == style)
      return (modify->*reach(RestartedStates()))[k];
  return nullptr;
}

bool discard_restarted(LAMMPS_NS::Modify* modify, const std::string& id, const std::string& style) {
  bool any = false;
  const auto discard = [&](char* restarted_id, const char* restarted_style) {
    if (restarted_id != id || restarted_style != style) return;
    restarted_id[0] = '\0';  // an ID that no fix has
    any = true;
  };
  for (int k = 0; k < modify->nfix_restart_global; ++k)
    discard((modify->*reach(RestartedIds()))[k], (modify->*reach(RestartedStyles()))[k]);
  for (int k = 0; k < modify->nfix_restart_peratom; ++k)
    discard((modify->*reach(RestartedIdsByAtom()))[k],
            (modify->*reach(RestartedStylesByAtom()))[k]);
  return any;
}

bool lost_is_error(const LAMMPS_NS::Output* output) {
  constexpr int error = 2;  // of Thermo's IGNORE, WARN, ERROR
  return output->thermo->*reach(LostFlag()) == error;
}

LAMMPS_NS::bigint next_restart(const LAMMPS_NS::Output* output) {
  return output->*reach(NextRestart());
}

std::string variable_name(LAMMPS_NS::FixPropertyGlobal* property) {
  return property->*reach(VariableName());
}

int particles_to_insert(const LAMMPS_NS::FixInsert* fix) {
  if (fix->next_reneighbor <= 0) return 0;       // all are inserted
  const int total = fix->*reach(InsertTotal());  // 0 before the first run where a mass is given
  if (fix->*reach(InsertHasTotal()) && total > 0) return total - fix->*reach(InsertDone());
  const auto pack = dynamic_cast<const LAMMPS_NS::FixInsertPack*>(fix);
  const bool once = fix->*reach(InsertEvery()) == 0;
  const int in_region = pack ? pack->*reach(InsertInRegion()) : 0;
  return once && in_region > 0 ? in_region : std::numeric_limits<int>::max();
}

std::vector<double> geometry(const LAMMPS_NS::PrimitiveWall* wall) {
  const double* const numbers = wall->*reach(WallNumbers());
  std::vector<double> all{static_cast<double>(wall->*reach(WallKind()))};
  all.insert(all.end(), numbers, numbers + wall->*reach(WallNumberCount()));
  return all;
}

}  // namespace plastigran

// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/fixes/engine_access.h"

#include <limits>

#include "fix.h"
#include "fix_insert_pack.h"
#include "fix_property_global.h"
#include "liggghts/fixes/private_member.h"
#include "modify.h"
#include "output.h"
#include "primitive_wall.h"
#include "settings.h"
#include "thermo.h"

namespace plastigran {

namespace {

PRIVATE_MEMBER(SettingsByName, Settings::settings);
PRIVATE_MEMBER(NumberValue, DoubleSetting::current);
PRIVATE_MEMBER(FixCreators, LAMMPS_NS::Modify::fix_map);
PRIVATE_MEMBER(RestartedIds, LAMMPS_NS::Modify::id_restart_global);
PRIVATE_MEMBER(RestartedStyles, LAMMPS_NS::Modify::style_restart_global);
PRIVATE_MEMBER(RestartedStates, LAMMPS_NS::Modify::state_restart_global);
PRIVATE_MEMBER(RestartedIdsByAtom, LAMMPS_NS::Modify::id_restart_peratom);
PRIVATE_MEMBER(RestartedStylesByAtom, LAMMPS_NS::Modify::style_restart_peratom);
PRIVATE_MEMBER(LostFlag, LAMMPS_NS::Thermo::lostflag);
PRIVATE_MEMBER(NextRestart, LAMMPS_NS::Output::next_restart);
PRIVATE_MEMBER(VariableName, LAMMPS_NS::FixPropertyGlobal::variablename);
PRIVATE_MEMBER(InsertHasTotal, LAMMPS_NS::FixInsert::ninsert_exists);
PRIVATE_MEMBER(InsertTotal, LAMMPS_NS::FixInsert::ninsert);
PRIVATE_MEMBER(InsertDone, LAMMPS_NS::FixInsert::ninserted);
PRIVATE_MEMBER(InsertEvery, LAMMPS_NS::FixInsert::insert_every);
PRIVATE_MEMBER(InsertInRegion, LAMMPS_NS::FixInsertPack::ntotal_region);
PRIVATE_MEMBER(WallKind, LAMMPS_NS::PrimitiveWall::wType);
PRIVATE_MEMBER(WallNumbers, LAMMPS_NS::PrimitiveWall::param);
PRIVATE_MEMBER(WallNumberCount, LAMMPS_NS::PrimitiveWall::nParam);

}  // namespace

void add_choice(Settings& settings, const std::string& name, const char* const* words,
                std::size_t count, int& chosen) {
  EnumSetting<int>* const setting = new EnumSetting<int>(name);  // deleted by Settings
  for (std::size_t k = 0; k < count; ++k)
    if (words[k]) setting->addOption(words[k], k);
  setting->setDefault(words[chosen]);
  setting->registerTarget(chosen);
  (settings.*member_of(SettingsByName()))[name] = setting;
}

const std::map<std::string, Setting*>& settings_by_name(const Settings& settings) {
  return settings.*member_of(SettingsByName());
}

bool is_number(const Setting& setting, double& number) {
  const auto number_setting = dynamic_cast<const DoubleSetting*>(&setting);
  if (number_setting) number = (number_setting->*member_of(NumberValue())).getValue();
  return number_setting;
}

void add_fix_style(LAMMPS_NS::Modify* modify, const std::string& style, FixCreator creator) {
  (*(modify->*member_of(FixCreators())))[style] = creator;
}

const char* restarted_state(LAMMPS_NS::Modify* modify, const std::string& id,
                            const std::string& style) {
  for (int k = 0; k < modify->nfix_restart_global; ++k)
    if ((modify->*member_of(RestartedIds()))[k] == id &&
        (modify->*member_of(RestartedStyles()))[k] == style)
      return (modify->*member_of(RestartedStates()))[k];
  return nullptr;
}

bool discard_restarted(LAMMPS_NS::Modify* modify, const std::string& id, const std::string& style) {
  bool any = false;
  const auto discard = [&](char* restarted_id, const char* restarted_style) {
    if (restarted_id != id || restarted_style != style) return;
    restarted_id[0] = '\0';  // an empty ID, which no fix has, marks the entry as unused
    any = true;
  };
  for (int k = 0; k < modify->nfix_restart_global; ++k)
    discard((modify->*member_of(RestartedIds()))[k], (modify->*member_of(RestartedStyles()))[k]);
  for (int k = 0; k < modify->nfix_restart_peratom; ++k)
    discard((modify->*member_of(RestartedIdsByAtom()))[k],
            (modify->*member_of(RestartedStylesByAtom()))[k]);
  return any;
}

bool lost_is_error(const LAMMPS_NS::Output* output) {
  constexpr int error = 2;  // value of ERROR in Thermo's enum IGNORE, WARN, ERROR
  return output->thermo->*member_of(LostFlag()) == error;
}

LAMMPS_NS::bigint next_restart(const LAMMPS_NS::Output* output) {
  return output->*member_of(NextRestart());
}

std::string variable_name(LAMMPS_NS::FixPropertyGlobal* property) {
  return property->*member_of(VariableName());
}

int particles_to_insert(const LAMMPS_NS::FixInsert* fix) {
  if (fix->next_reneighbor <= 0) return 0;  // LIGGGHTS sets 0 when the insertion is complete
  // If the deck gives the mass of all particles instead of their number, LIGGGHTS computes the
  // number in the setup of the first run. Until then, the number is 0.
  const int total = fix->*member_of(InsertTotal());
  if (fix->*member_of(InsertHasTotal()) && total > 0) return total - fix->*member_of(InsertDone());
  const auto pack = dynamic_cast<const LAMMPS_NS::FixInsertPack*>(fix);
  const bool once = fix->*member_of(InsertEvery()) == 0;
  const int in_region = pack ? pack->*member_of(InsertInRegion()) : 0;
  return once && in_region > 0 ? in_region : std::numeric_limits<int>::max();
}

std::vector<double> geometry(const LAMMPS_NS::PrimitiveWall* wall) {
  const double* const numbers = wall->*member_of(WallNumbers());
  std::vector<double> all{static_cast<double>(wall->*member_of(WallKind()))};
  all.insert(all.end(), numbers, numbers + wall->*member_of(WallNumberCount()));
  return all;
}

}  // namespace plastigran

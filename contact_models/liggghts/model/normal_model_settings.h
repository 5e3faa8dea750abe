// SPDX-License-Identifier: GPL-2.0-or-later
//
// What the line of a pair style or wall may say to a normal model over a law.
#pragma once

#include <string>

#include "liggghts/fixes/engine_access.h"
#include "liggghts/model/deck_properties.h"
#include "liggghts/model/line_settings.h"
#include "plastigran/shared/contact.h"

namespace plastigran {

template <class Law>
class NormalModelSettings {
 public:
  typename Law::Parameters choices;  // the law's options as set; its constants at their defaults
  bool viscous_damping = false;
  bool tangential_damping = true;  // the dashpot beside the tangential spring too
  double overlap_limit = 1.0;      // of the smaller radius; beyond it the run is stopped

  // The engine reads a line into `settings` after this and before read().
  void declare(Settings& settings) {
    being_read_ = &settings;
    settings.registerOnOff("viscous_damping", viscous_damping, false);
    settings.registerOnOff("tangential_damping", tangential_damping, true);
    settings.registerDoubleSetting("overlap_limit", overlap_limit, 1.0);
    for (const auto& option : options_of<Law>)
      add_choice(settings, option.name, option.choices.data(), option.choices.size(),
                 choices.*option.value);
    settings.registerOnOff("computeElasticPotential", engine_elastic_potential_, false);
    settings.registerOnOff("computeDissipatedEnergy", engine_dissipated_energy_, false);
  }

  // The line is there: keeps its text. Returns what is wrong with it, empty when nothing is.
  std::string read() {
    text_ = settings_text(*being_read_);
    being_read_ = nullptr;
    if (engine_elastic_potential_) return refusal("computeElasticPotential");
    if (engine_dissipated_energy_) return refusal("computeDissipatedEnergy");
    if (!(overlap_limit > 0 && overlap_limit <= 2))
      return "overlap_limit is " + std::to_string(overlap_limit) +
             "; it must be above 0 and at most 2, of the smaller radius";
    return "";
  }

  // Lines on what the deck gives and this model does not use; said of pairs, not again of walls.
  // `has_foreign`: another line has a model of LIGGGHTS, which uses the restitution.
  std::string describe_unused(const std::string& caller, const DeckProperties& deck, bool is_wall,
                              bool has_foreign) const {
    if (is_wall) return "";
    std::string text;
    if (!viscous_damping && !has_foreign && deck.given("coefficient_restitution"))
      text += caller +
              ": coefficientRestitution is not used, restitution follows from the law; "
              "it is the dashpot's, viscous_damping on\n";
    if (!hardens<Law> && deck.given("tangent_modulus"))
      text += caller + ": tangentModulus is not used, this law does not harden\n";
    return text;
  }

  // The line as NAME WORD NAME WORD ..., empty as long as none was read.
  const std::string& text() const { return text_; }

 private:
  static std::string refusal(const char* setting) {
    return std::string(setting) + " is not available with this model; leave it off";
  }

  bool engine_elastic_potential_ = false;
  bool engine_dissipated_energy_ = false;
  Settings* being_read_ = nullptr;
  std::string text_;
};

}  // namespace plastigran

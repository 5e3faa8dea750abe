// SPDX-License-Identifier: GPL-2.0-or-later
//
// Settings of a normal model in a pair_style or fix wall/gran line.
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
  typename Law::Parameters choices;  // options of the law; its constants keep their defaults here
  bool viscous_damping = false;
  bool tangential_damping = true;  // whether the tangential spring has a dashpot
  double overlap_limit = 1.0;      // largest overlap/smaller radius before the run stops

  // Registers the settings. LIGGGHTS reads the pair_style or wall line into `settings` between
  // declare() and read().
  void declare(Settings& settings) {
    being_read_ = &settings;
    settings.registerOnOff("viscous_damping", viscous_damping, false);
    settings.registerOnOff("tangential_damping", tangential_damping, true);
    settings.registerDoubleSetting("overlap_limit", overlap_limit, 1.0);
    for (const auto& option : options_of<Law>)
      add_choice(settings, option.name, option.choices.data(), option.choices.size(),
                 choices.*option.value);
    // LIGGGHTS' own settings; read() rejects them with a message that names the alternative.
    settings.registerOnOff("computeElasticPotential", host_elastic_potential_, false);
    settings.registerOnOff("computeDissipatedEnergy", host_dissipated_energy_, false);
  }

  // Sets the text of the settings that another normal model has read from the same line.
  void set_text(const std::string& text) { text_ = text; }

  // Stores the text of the settings. Returns an error message; empty if all settings are valid.
  std::string read() {
    text_ = settings_text(*being_read_);
    being_read_ = nullptr;
    if (host_elastic_potential_) return refusal("computeElasticPotential");
    if (host_dissipated_energy_) return refusal("computeDissipatedEnergy");
    if (overlap_limit > 0 && overlap_limit <= 2) return "";
    return "overlap_limit is " + std::to_string(overlap_limit) +
           "; it must be above 0 and at most 2, in radii of the smaller body";
  }

  // Returns log lines on deck properties that this model does not use; empty for walls.
  // `has_foreign` is true if another line has one of LIGGGHTS' own models, which use the
  // restitution.
  std::string describe_unused(const std::string& caller, const DeckProperties& deck, bool is_wall,
                              bool has_foreign) const {
    if (is_wall) return "";
    std::string text;
    if (!viscous_damping && !has_foreign && deck.given("coefficient_restitution"))
      text += caller +
              ": coefficientRestitution is not used, because the restitution follows from the law. "
              "Only the dashpot of `viscous_damping on` uses it\n";
    if (!hardens<Law> && deck.given("tangent_modulus"))
      text += caller + ": tangentModulus is not used, because the law has no hardening\n";
    if (!adhesive<Law> && deck.given("surface_energy"))
      text += caller +
              ": surfaceEnergy is not used, because the law has no adhesion. With most laws, the "
              "option `adhesion jkr` at the end of each line adds adhesion\n";
    return text;
  }

  // Returns the settings as NAME WORD NAME WORD ...; empty before LIGGGHTS has read a line.
  const std::string& text() const { return text_; }

 private:
  static std::string refusal(const char* setting) {
    return std::string(setting) +
           " is not supported by this model. Remove it, or use `energy_ledger on`";
  }

  bool host_elastic_potential_ = false;
  bool host_dissipated_energy_ = false;
  Settings* being_read_ = nullptr;
  std::string text_;
};

}  // namespace plastigran

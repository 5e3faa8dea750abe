// SPDX-License-Identifier: GPL-2.0-or-later
#include "lammps/wall_style.h"

#include <algorithm>
#include <cmath>

#include "error.h"

namespace plastigran {

WallLine::WallLine(LAMMPS_NS::LAMMPS* lammps, int count, char** words)
    : lammps_(lammps), command_("fix " + std::string(count > 2 ? words[2] : "")) {
  LAMMPS_NS::Error* const error = lammps->error;
  if (count < 7 || std::strcmp(words[3], "granular") != 0)
    error->all(FLERR, "{}: the style must be followed by `granular LAW E nu ...`", command_);
  PairStyle* const pair = PairStyle::of(lammps);
  if (!pair)
    error->all(FLERR,
               "{}: the bodies of the particles are missing; give `pair_style "
               "granular/plastigran` and its pair_coeff lines first",
               command_);
  line_ = pair->read({words + 4, words + count}, command_);
  if (line_.mixed)
    error->all(FLERR,
               "{}: `mixed` is only for pairs of atom types; give the body of the wall by `E nu`, "
               "`body FILE` or `rigid`",
               command_);
  make_laws();
  words_.assign(words, words + 4);
  const auto placeholder = line_.placeholder();
  words_.insert(words_.end(), placeholder.begin(), placeholder.end());
  for (std::string& word : words_) pointers_.push_back(word.data());
}

void WallLine::make_laws() {
  PairStyle* const pair = PairStyle::of(lammps_);
  if (!pair)
    lammps_->error->all(FLERR,
                        "{}: the pair style has changed, but the wall needs `pair_style "
                        "granular/plastigran`; give this pair style, or remove the wall by `unfix`",
                        command_);
  laws_.clear();
  for (int type = 1; type <= lammps_->atom->ntypes; ++type)
    laws_.push_back(pair->law(line_, pair->line_of(type).body, line_.body, command_));
  const auto tangential = std::find(line_.models.begin(), line_.models.end(), "tangential");
  const bool derived = line_.tangential.law.empty() && line_.models.end() - tangential > 2 &&
                       tangential[2] == "NULL";
  const double shear_modulus = laws_.front()->bodies.shear_modulus_eff;
  for (const auto& law : laws_)
    if (derived && std::abs(law->bodies.shear_modulus_eff - shear_modulus) > 1e-9 * shear_modulus)
      lammps_->error->all(
          FLERR,
          "{}: the atom types have different shear moduli, but a wall has one tangential "
          "stiffness; give a number instead of `NULL`",
          command_);
}

}  // namespace plastigran

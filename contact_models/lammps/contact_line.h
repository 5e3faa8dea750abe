// SPDX-License-Identifier: GPL-2.0-or-later
//
// The words of a `pair_coeff` line after the atom types, or of a wall after `granular`:
//
//   LAW BODY [name value ...] [viscous e] MODELS
//
// BODY is `E nu`, `body FILE` with a file of materials, `rigid`, or `mixed` for the bodies of two
// atom types. The names are constants of the body, and constants and options of the law. MODELS
// begins with the first word of LAMMPS' granular models, such as `tangential`, or with the place of
// a wall.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "plastigran/shared/body.h"
#include "plastigran/shared/complaint.h"

namespace plastigran {

struct ContactLine {
  std::string law;
  Body body;
  bool mixed = false;
  std::map<std::string, std::string> law_words;  // constants and options of the law
  std::string viscous;              // coefficient of LAMMPS' damping model; empty if not given
  std::vector<std::string> models;  // the words of LAMMPS' own models
  std::vector<std::string> words;   // all words

  // Reads a line; returns what is wrong with it.
  Complaint read(const std::vector<std::string>& line);

  // The words that LAMMPS reads instead: its model `hertz/material`, for a body whose effective
  // shear modulus against itself is the given one.
  std::vector<std::string> placeholder(double shear_modulus_eff) const;
};

Body rigid_body();

bool to_number(const std::string& word, double& number);
Complaint not_a_number(const std::string& name, const std::string& word);

// The names of the constants of a body, apart from Young's modulus and Poisson's ratio.
std::string body_words();

}  // namespace plastigran

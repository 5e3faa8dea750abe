// SPDX-License-Identifier: GPL-2.0-or-later
//
// Syntax of a `pair_coeff` line after the atom types, and of a wall line after `granular`:
//
//   LAW BODY [name value ...] [viscous e] MODELS
//
// BODY is `E nu`, `body FILE` with a material file, or `rigid`. It can also be `mixed`: the bodies
// are then those that the two atom types have in their own lines. Each `name` is a constant of the
// body, or a constant or an option of the law. MODELS are LAMMPS' granular models, which begin with
// a word such as `tangential`. In a wall line, the position of the wall follows. `tangential` can
// also name a tangential law of Plastigran: `incremental MU`, or `partial_slip MU [rings N]`, with
// the friction coefficient MU.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "plastigran/shared/body.h"
#include "plastigran/shared/complaint.h"

namespace plastigran {

struct TangentialLine {
  std::string law;  // name of the law; empty if the line uses LAMMPS' own model
  double friction = 0;
  int rings = 0;

  bool operator!=(const TangentialLine& other) const {
    return law != other.law || friction != other.friction || rings != other.rings;
  }
};

struct ContactLine {
  std::string law;
  Body body;
  bool mixed = false;
  std::map<std::string, std::string> law_words;  // constants and options of the law
  std::string viscous;  // coefficient of LAMMPS' damping model; empty if not given
  TangentialLine tangential;
  std::vector<std::string> models;  // words that select LAMMPS' own models
  // Words of the line that restart files store. The constants of the body replace `body FILE`,
  // because the material file may change before the restart.
  std::vector<std::string> words;

  // Reads the words of a line. Returns an error message; empty if the line is valid.
  Complaint read(const std::vector<std::string>& line);

  // Returns the words that LAMMPS reads instead of the law: its model `hertz/material`. The modulus
  // in these words is arbitrary, because NormalModel later sets the modulus of the bodies.
  std::vector<std::string> placeholder() const;
};

Body rigid_body();

bool to_number(const std::string& word, double& number);
Complaint not_a_number(const std::string& name, const std::string& word);

// Returns the names of the constants of a body, except Young's modulus and Poisson's ratio.
std::string body_words();

}  // namespace plastigran

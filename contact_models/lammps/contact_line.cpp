// SPDX-License-Identifier: GPL-2.0-or-later
#include "lammps/contact_line.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>

#include "plastigran/friction/incremental.h"
#include "plastigran/friction/partial_slip.h"

namespace plastigran {

namespace {

// Returns whether a word in a `pair_coeff` or wall line begins the part that LAMMPS itself reads:
// the choice of its own models, or the position of a wall.
bool begins_models(const std::string& word) {
  static const std::vector<std::string> first{
      "damping",       "tangential",          "rolling", "twisting", "heat",   "cutoff",   "region",
      "limit_damping", "synchronized_verlet", "xplane",  "yplane",   "zplane", "zcylinder"};
  return std::find(first.begin(), first.end(), word) != first.end();
}

const BodyConstant* body_constant(const std::string& name) {
  for (const BodyConstant& constant : body_constants)
    if (name == constant.name) return &constant;
  return nullptr;
}

// Returns whether a constant precedes the words `name value` of a line. Young's modulus and
// Poisson's ratio do; they have no name in the line.
bool precedes_names(const BodyConstant& constant) {
  return constant.value == &Body::youngs_modulus || constant.value == &Body::poissons_ratio;
}

// Returns a number as text with so many digits that to_number() reads exactly the same number.
std::string exact(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", number);
  return text;
}

// Reads the constants of a body from a material file with lines `variable NAME index VALUE`.
Complaint read_material(const std::string& name, Body& body) {
  std::ifstream file(name);
  const char* const folder = std::getenv("PLASTIGRAN_MATERIALS");
  if (!file && folder) file.open(std::string(folder) + '/' + name + ".in");
  if (!file)
    return Complaint("body: there is no file " + name +
                     "; give the path of a file with lines `variable NAME index VALUE`");
  std::string line;
  std::set<std::string> given;
  while (std::getline(file, line)) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string command, constant, style, value;
    if (!(words >> command >> constant >> style >> value) || command != "variable") continue;
    if (!given.insert(constant).second)
      return Complaint("body: " + name + " defines {" + constant + "} twice; define it once");
    if (const BodyConstant* const entry = body_constant(constant))
      if (!to_number(value, body.*entry->value)) return not_a_number(constant, value);
  }
  for (const std::string constant : {"youngs_modulus", "poissons_ratio"})
    if (!given.count(constant))
      return Complaint("body: " + name + " does not define {" + constant +
                       "}; add a line `variable " + constant + " index VALUE`");
  return {};
}

// Returns the words of a `pair_coeff` or wall line. The constants of the body replace the name of
// its material file.
std::vector<std::string> words_without_file(const ContactLine& line) {
  std::vector<std::string> words{line.law, exact(line.body.youngs_modulus),
                                 exact(line.body.poissons_ratio)};
  for (const BodyConstant& constant : body_constants)
    if (!precedes_names(constant))
      words.insert(words.end(), {constant.name, exact(line.body.*constant.value)});
  for (const auto& [name, value] : line.law_words) words.insert(words.end(), {name, value});
  if (!line.viscous.empty()) words.insert(words.end(), {"viscous", line.viscous});
  words.insert(words.end(), line.models.begin(), line.models.end());
  return words;
}

// Returns whether the coefficient of the damping model is a coefficient of restitution.
bool is_restitution(const std::vector<std::string>& models) {
  const auto damping = std::find(models.begin(), models.end(), "damping");
  return damping != models.end() && damping + 1 != models.end() &&
         (damping[1] == "tsuji" || damping[1] == "coeff_restitution");
}

// Reads the tangential law in a `pair_coeff` or wall line. Replaces the words of this law by the
// words of LAMMPS' model `mindlin`.
Complaint read_tangential(std::vector<std::string>& models, TangentialLine& line) {
  for (const char* const word : {"tangential", "rings"})
    if (std::count(models.begin(), models.end(), word) > 1)
      return Complaint('`' + std::string(word) + "` is given twice; give it once");
  const auto at = std::find(models.begin(), models.end(), "tangential");
  if (models.end() - at < 2) return {};
  const std::string name = at[1];
  if (name != Incremental::name && name != PartialSlip<>::name) return {};
  line.law = name;
  line.rings = PartialSlip<>::default_rings;
  auto end = at + 2;
  const std::string friction = end != models.end() ? *end++ : "";
  if (!to_number(friction, line.friction) || !(line.friction >= 0))
    return Complaint("`tangential " + name + "` is followed by `" + friction +
                     "`; give the coefficient of friction, 0 or more");
  if (name == PartialSlip<>::name && end != models.end() && *end == "rings") {
    const std::string rings = ++end != models.end() ? *end++ : "";
    double number = 0;
    if (!to_number(rings, number) ||
        !(number >= PartialSlip<>::least_rings && number <= PartialSlip<>::most_rings) ||
        number != static_cast<int>(number))
      return Complaint("{rings} is `" + rings + "`; it must be a whole number, 2 to " +
                       std::to_string(PartialSlip<>::most_rings));
    line.rings = static_cast<int>(number);
  }
  if (std::find(models.begin(), models.end(), "marshall") != models.end())
    return Complaint(
        "`twisting marshall` works only with LAMMPS' own tangential models, not with `" + name +
        "`; use `twisting sds`");
  const std::vector<std::string> rest(end, models.end());
  models.erase(at + 1, models.end());
  models.insert(models.end(), {"mindlin", "NULL", "0", friction});
  models.insert(models.end(), rest.begin(), rest.end());
  return {};
}

}  // namespace

Body rigid_body() {
  Body body;
  body.youngs_modulus = 1e30;
  body.poissons_ratio = 0.3;
  return body;
}

bool to_number(const std::string& word, double& number) {
  char* end = nullptr;
  number = std::strtod(word.c_str(), &end);
  return end != word.c_str() && *end == 0;
}

Complaint not_a_number(const std::string& name, const std::string& word) {
  return Complaint('{' + name + "} is `" + word + "`; it must be a number");
}

std::string body_words() {
  std::string names;
  for (const BodyConstant& constant : body_constants)
    if (!precedes_names(constant)) names += (names.empty() ? "" : " ") + std::string(constant.name);
  return names;
}

Complaint ContactLine::read(const std::vector<std::string>& line) {
  *this = ContactLine();
  words = line;
  std::size_t at = 0;
  const auto next = [&] { return at < line.size() ? line[at++] : std::string(); };
  law = next();
  const std::string first = next();
  if (first == "rigid") {
    body = rigid_body();
  } else if (first == "mixed") {
    mixed = true;
  } else if (first == "body") {
    const Complaint complaint = read_material(next(), body);
    if (!complaint.empty()) return complaint;
  } else {
    const std::string second = next();
    if (!to_number(first, body.youngs_modulus) || !to_number(second, body.poissons_ratio))
      return Complaint("the law is followed by `" + first + ' ' + second +
                       "`; give Young's modulus [Pa] and Poisson's ratio, `body FILE`, "
                       "`rigid`, or `mixed`");
  }
  std::set<std::string> given;
  while (at < line.size() && !begins_models(line[at])) {
    const std::string name = next();
    if (!given.insert(name).second) return Complaint('{' + name + "} is given twice; give it once");
    if (at >= line.size()) return Complaint("the value of {" + name + "} is missing");
    const std::string value = next();
    if (name == "viscous") {
      double restitution;
      if (!to_number(value, restitution) || !(restitution >= 0))
        return Complaint("{viscous} is " + value + "; it must be a number, 0 or more");
      viscous = value;
    } else if (const BodyConstant* const constant = body_constant(name)) {
      if (!to_number(value, body.*constant->value)) return not_a_number(name, value);
    } else {
      law_words[name] = value;
    }
  }
  models.assign(line.begin() + static_cast<std::ptrdiff_t>(at), line.end());
  if (first == "body") words = words_without_file(*this);
  const Complaint complaint = read_tangential(models, tangential);
  if (!complaint.empty()) return complaint;
  double restitution = 0;
  if (is_restitution(models) && to_number(viscous, restitution) && restitution > 1)
    return Complaint("{viscous} is " + viscous +
                     "; with this damping model it must be a coefficient of restitution, 0 to 1");
  return {};
}

std::vector<std::string> ContactLine::placeholder() const {
  const std::string none = is_restitution(models) ? "1" : "0";  // value without damping
  std::vector<std::string> all{"hertz/material", "1", viscous.empty() ? none : viscous, "0"};
  all.insert(all.end(), models.begin(), models.end());
  return all;
}

}  // namespace plastigran

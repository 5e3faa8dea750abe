// SPDX-License-Identifier: GPL-2.0-or-later
#include "lammps/pair_style.h"

#include <algorithm>
#include <cstdlib>

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "force.h"
#include "lammps.h"
#include "lammps/energy_balance.h"
#include "lammps/impact_extremes.h"
#include "lammps/load_model.h"
#include "lammps/normal_model.h"
#include "lammps/particle_values.h"
#include "lammps/run_time_checks.h"
#include "update.h"
#include "utils.h"

namespace plastigran {

using LAMMPS_NS::PairGranular;
using LAMMPS_NS::Granular_NS::GranularModel;

namespace {

constexpr const char* ids = "plastigran_id";  // per-particle value: atom ID in the last run

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> all;
  for (std::string& word : words) all.push_back(word.data());
  return all;
}

}  // namespace

PairStyle::PairStyle(LAMMPS_NS::LAMMPS* lammps) : PairGranular(lammps) {
  comm_reverse = EnergyBalance::reverse_size;
  set_cutoff("");
}

// Passes the argument of pair_style to LAMMPS. read_restart() also calls this function, because
// LAMMPS does not set its cutoff from the restart file.
void PairStyle::set_cutoff(const std::string& cutoff) {
  cutoff_ = cutoff;
  char* word = cutoff_.data();
  PairGranular::settings(cutoff.empty() ? 0 : 1, &word);
}

void PairStyle::settings(int count, char** words) {
  if (count > 1)
    error->all(FLERR, "pair_style granular/plastigran: unknown word {}; give at most a cutoff",
               words[1]);
  set_cutoff(count == 1 ? words[0] : "");
}

PairStyle* PairStyle::of(LAMMPS_NS::LAMMPS* lammps) {
  return dynamic_cast<PairStyle*>(lammps->force->pair_match("granular/plastigran", 1));
}

ContactLine PairStyle::read(const std::vector<std::string>& words, const std::string& command) {
  ContactLine line;
  const Complaint complaint = line.read(words);
  if (!complaint.empty()) error->all(FLERR, "{}: {}", command, complaint.text());
  return line;
}

std::shared_ptr<const RuntimeLaw> PairStyle::law(const ContactLine& line, const Body& one,
                                                 const Body& other, const std::string& command) {
  std::string names;
  for (const NamedLaw* const named : named_laws()) {
    names += std::string(" ") + named->name;
    if (line.law != named->name) continue;
    Complaint complaint;
    auto made = named->make(line, one, other, complaint);
    if (!made) error->all(FLERR, "{}: {}: {}", command, line.law, complaint.text());
    return made;
  }
  error->all(FLERR, "{}: there is no law `{}`; choose one of{}", command, line.law, names);
}

const PairStyle::Model& PairStyle::model_of(int type, int other_type) {
  return models_.at(models_list[types_indices[type][other_type]]);
}

const ContactLine& PairStyle::line_of(int type) {
  if (!allocated || !setflag[type][type])
    error->all(FLERR,
               "granular/plastigran: atom type {} has no body; give `pair_coeff {} {}` first", type,
               type, type);
  return model_of(type, type).line;
}

void PairStyle::coeff(int count, char** words) {
  if (count < 4)
    error->all(FLERR,
               "pair_coeff: words are missing; give atom types, law and body, such as "
               "`pair_coeff 1 1 thornton 7e10 0.3 yield_strength 3e8 tangential mindlin NULL "
               "1.0 0.5`");
  const ContactLine line = read({words + 2, words + count}, "pair_coeff");
  // Make init_style() mix these types again, because the new line may change a body or a law.
  for (const auto& [i, j] : mixed_) setflag[i][j] = 0;
  mixed_.clear();
  if (!line.mixed) return add_model(words[0], words[1], line, line.body, line.body);
  Body bodies[2];
  for (int k = 0; k < 2; ++k) {
    const std::string word = words[k];
    const long type = std::strtol(word.c_str(), nullptr, 10);
    if (!LAMMPS_NS::utils::is_integer(word) || type < 1 || type > atom->ntypes)
      error->all(FLERR,
                 "pair_coeff: `mixed` is given with the atom type `{}`; give two single atom "
                 "types, 1 to {}",
                 word, atom->ntypes);
    bodies[k] = line_of(static_cast<int>(type)).body;
  }
  if (std::stoi(words[0]) == std::stoi(words[1]))
    error->all(FLERR,
               "pair_coeff {} {}: `mixed` needs two different atom types; give the law and a body "
               "for a single type",
               words[0], words[1]);
  add_model(words[0], words[1], line, bodies[0], bodies[1]);
}

// Makes LAMMPS create its own model for the atom types, and replaces this model with the law.
void PairStyle::add_model(const std::string& types, const std::string& other_types,
                          const ContactLine& line, const Body& one, const Body& other) {
  const auto made = law(line, one, other, "pair_coeff");
  std::vector<std::string> words = line.placeholder();
  words.insert(words.begin(), {types, other_types});
  auto all = pointers(words);
  PairGranular::coeff(static_cast<int>(all.size()), all.data());
  int type = 0, other_type = 0, last = 0;
  LAMMPS_NS::utils::bounds(FLERR, types, 1, atom->ntypes, type, last, error);
  LAMMPS_NS::utils::bounds(FLERR, other_types, 1, atom->ntypes, other_type, last, error);
  set_model(models_list[types_indices[type][std::max(type, other_type)]], line, made);
}

void PairStyle::set_model(GranularModel* model, const ContactLine& line,
                          const std::shared_ptr<const RuntimeLaw>& made) {
  NormalModel::replace(model, lmp, {made}, line.tangential, *this);
  models_[model] = {line, made};
}

// Adds a model for two atom types without a line of their own. LAMMPS cannot mix the laws. LAMMPS'
// mixing of `mindlin NULL` is also unsuitable: between two types of equal modulus, the tangential
// stiffness would differ from that between particles of one type.
void PairStyle::mix(int type, int other_type) {
  const ContactLine one = line_of(type), other = line_of(other_type);
  if (one.law != other.law || one.law_words != other.law_words || one.models != other.models ||
      one.viscous != other.viscous || one.tangential != other.tangential)
    error->all(
        FLERR,
        "granular/plastigran: atom types {} and {} have different laws, constants or models; "
        "give `pair_coeff {} {} LAW mixed ...`",
        type, other_type, type, other_type);
  add_model(std::to_string(type), std::to_string(other_type), one, one.body, other.body);
  mixed_.push_back({type, other_type});
}

// Adds models for all pairs of atom types without a line of their own.
void PairStyle::mix_types() {
  for (int i = 1; i <= atom->ntypes; ++i)
    for (int j = i + 1; j <= atom->ntypes; ++j)
      if (!setflag[i][j] && setflag[i][i] && setflag[j][j]) mix(i, j);
}

void PairStyle::init_style() {
  if (force->nktv2p != 1 || force->mvv2e != 1)
    error->all(FLERR,
               "granular/plastigran needs units in which force is mass times acceleration; "
               "use `units si`, `cgs`, `micro`, `nano` or `lj`");
  if (force->pair_match("^gran", 0, 1) != force->pair_match("^gran", 0, 2))
    error->all(FLERR,
               "granular/plastigran: `pair_style hybrid` has a second granular style, but LAMMPS "
               "stores contact histories for only one; use one granular style for all atom types");
  if (update->whichflag == 2)
    error->all(FLERR,
               "granular/plastigran: `minimize` would change the contact history in every trial "
               "step; use `run`");
  mix_types();
  set_mixed_models();
  PairGranular::init_style();
  check_models();
  ParticleValues::create(lmp, ids);
  for (int k = 0; k < nmodels; ++k) {
    auto* const normal = static_cast<NormalModel*>(models_list[k]->normal_model);
    normal->count_in(RunTimeChecks::of(lmp).account(*normal->laws().front()));
  }
}

// Updates the models of `mixed` lines to the present bodies of their atom types.
void PairStyle::set_mixed_models() {
  for (int i = 1; i <= atom->ntypes; ++i)
    for (int j = i + 1; j <= atom->ntypes; ++j) {
      if (!setflag[i][j]) continue;
      GranularModel* const model = models_list[types_indices[i][j]];
      const ContactLine line = models_.at(model).line;
      if (line.mixed)
        set_model(model, line, law(line, line_of(i).body, line_of(j).body, "pair_coeff"));
    }
}

// Returns the law and the models of each pair of atom types, with their numbers of history values.
std::map<std::pair<int, int>, std::string> PairStyle::models_of_pairs() {
  std::map<std::pair<int, int>, std::string> models;
  for (int i = 1; i <= atom->ntypes; ++i)
    for (int j = i; j <= atom->ntypes; ++j) {
      if (!setflag[i][j]) continue;
      std::string& text = models[{i, j}] = model_of(i, j).line.law;
      for (const auto* const part : models_list[types_indices[i][j]]->sub_models)
        text += ' ' + part->name + ' ' + std::to_string(part->size_history);
    }
  return models;
}

// Stops the run if a pair of atom types has another law or other models than in the last run. Its
// contacts would otherwise continue with a history that belongs to the old models.
void PairStyle::check_models() {
  if (last_models_.empty()) return;
  for (const auto& [types, text] : models_of_pairs()) {
    const auto last = last_models_.find(types);
    if (last != last_models_.end() && last->second != text)
      error->all(FLERR,
                 "granular/plastigran: atom types {} and {} have another law or other models than "
                 "in the last run; their contacts would keep the old history, so change only "
                 "constants",
                 types.first, types.second);
  }
  if (!last_offsets_.empty() && offsets() != last_offsets_)
    error->all(
        FLERR,
        "granular/plastigran: new pair_coeff lines move the values in the contact history, so "
        "contacts would read wrong values; give each pair of atom types only one line "
        "before the first run");
}

// Returns the positions of the models' values in the contact history, which are the same for all
// pairs of atom types. read_restart() needs these positions before LAMMPS computes them in
// init_style(). Therefore this function repeats the computation.
std::vector<int> PairStyle::offsets() const {
  std::vector<int> all{0};
  for (int part = 0; part < LAMMPS_NS::Granular_NS::NSUBMODELS; ++part) {
    int size = 0;
    for (int k = 0; k < nmodels; ++k)
      size = std::max(size, models_list[k]->sub_models[part]->size_history);
    all.push_back(all.back() + size);
  }
  return all;
}

// Stops if particles were renumbered, because contact histories refer to particles by their IDs.
void PairStyle::check_particle_ids() {
  int renumbered = 0;
  double* const last = ParticleValues::of(lmp, ids);
  for (int i = 0; i < atom->nlocal; ++i) {
    const auto id = static_cast<double>(atom->tag[i]);
    if (last[i] != 0 && last[i] != id) renumbered = 1;
    last[i] = id;
  }
  MPI_Allreduce(MPI_IN_PLACE, &renumbered, 1, MPI_INT, MPI_MAX, world);
  if (renumbered)
    error->all(FLERR,
               "granular/plastigran: atom IDs have changed since the last run, so contacts "
               "would lose their history; use `delete_atoms ... compress no`, and no "
               "`reset_atoms id`");
}

void PairStyle::setup() {
  check_particle_ids();
  last_models_ = models_of_pairs();
  last_offsets_ = offsets();
  expect_impacts();
}

void PairStyle::expect_impacts() {
  std::vector<ExpectedImpact> impacts;
  const int all = 1;  // bit of the group `all`
  const ImpactForecast forecast(type_extremes(lmp, all), all_types(atom->ntypes), false, {});
  for (const Meeting& meeting : forecast.meetings()) {
    const auto [first, second] = std::minmax(meeting.type, meeting.partner_type);
    // In `pair_style hybrid`, these types may have another pair style.
    if (setflag[first][second]) impacts.push_back({meeting, model_of(first, second).law});
  }
  RunTimeChecks::of(lmp).expect(impacts);
}

void PairStyle::compute(int eflag, int vflag) {
  begin(lmp);
  if (balance_)
    for (int k = 0; k < nmodels; ++k) LoadModel::enable(models_list[k]);
  PairGranular::compute(eflag, vflag);
  end();
  if (EnergyBalance::of(lmp) && force->newton_pair) comm->reverse_comm(this);
}

// Copies the history of a contact from one particle of the pair to the other particle. The parts of
// the history (normal, tangential, ...) begin at offsets that leave space for the largest model of
// all type pairs. LAMMPS' own function assumes that the parts of one model follow each other
// without gaps.
void PairStyle::transfer_history(double* source, double* target, int type, int other_type) {
  const GranularModel* const model = models_list[types_indices[type][other_type]];
  for (const auto* const part : model->sub_models)
    for (int k = 0; k < part->size_history; ++k) {
      const double factor =
          part->nondefault_history_transfer ? part->transfer_history_factor[k] : -1;
      target[part->history_index + k] = factor * source[part->history_index + k];
    }
}

int PairStyle::pack_reverse_comm(int count, int first, double* buffer) {
  const EnergyBalance* const balance = EnergyBalance::of(lmp);
  for (int k = 0; k < count; ++k)
    balance->pack_ghost(first + k, buffer + k * EnergyBalance::reverse_size);
  return count * EnergyBalance::reverse_size;
}

void PairStyle::unpack_reverse_comm(int count, int* particles, double* buffer) {
  EnergyBalance* const balance = EnergyBalance::of(lmp);
  for (int k = 0; k < count; ++k)
    balance->add_ghost(particles[k], buffer + k * EnergyBalance::reverse_size);
}

// Writes LAMMPS' own data, then the lines of the laws. LAMMPS calls this function on rank 0 only.
// Omits the models that mix() has added, because mix() adds them again after a restart.
void PairStyle::write_restart(FILE* file) {
  for (const auto& [i, j] : mixed_) setflag[i][j] = 0;
  PairGranular::write_restart(file);
  for (const auto& [i, j] : mixed_) setflag[i][j] = 1;
  const auto write_text = [&](const std::string& text) {
    const int size = static_cast<int>(text.size());
    std::fwrite(&size, sizeof size, 1, file);
    std::fwrite(text.data(), 1, text.size(), file);
  };
  write_text(cutoff_);
  for (int k = 0; k < nmodels; ++k) {
    std::string text;
    for (const std::string& word : models_.at(models_list[k]).line.words) text += word + ' ';
    write_text(text);
  }
}

void PairStyle::read_restart(FILE* file) {
  PairGranular::read_restart(file);
  const auto read_bytes = [&](void* bytes, int size) {
    if (comm->me == 0)
      LAMMPS_NS::utils::sfread(FLERR, bytes, 1, static_cast<std::size_t>(size), file, nullptr,
                               error);
    MPI_Bcast(bytes, size, MPI_BYTE, 0, world);
  };
  const auto read_text = [&] {
    int size = 0;
    read_bytes(&size, sizeof size);
    std::string text(static_cast<std::size_t>(size), ' ');
    read_bytes(text.data(), size);
    return text;
  };
  set_cutoff(read_text());
  std::vector<std::pair<GranularModel*, ContactLine>> mixed;
  Body body;  // the body of any line
  for (int k = 0; k < nmodels; ++k) {
    const ContactLine line = read(LAMMPS_NS::utils::split_words(read_text()), "read_restart");
    if (line.mixed) {
      mixed.push_back({models_list[k], line});
    } else {
      set_model(models_list[k], line, law(line, line.body, line.body, "read_restart"));
      body = line.body;
    }
  }
  // Construct `mixed` models with an arbitrary body. set_mixed_models() then sets the right bodies,
  // except in unused models, which a later line has replaced.
  for (const auto& [model, line] : mixed)
    set_model(model, line, law(line, body, body, "read_restart"));
  set_mixed_models();
  last_offsets_ = offsets();
  mix_types();  // so that check_models() compares all pairs of atom types
  last_models_ = models_of_pairs();
}

}  // namespace plastigran

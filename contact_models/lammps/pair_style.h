// SPDX-License-Identifier: GPL-2.0-or-later
//
// `pair_style granular/plastigran`: LAMMPS' pair style granular with Plastigran's laws for the
// normal force.
//
//   pair_coeff 1 1 universal 7e10 0.3 yield_strength 3e8 tangential mindlin_rescale NULL 1.0 0.5
//
// If no line names two atom types together, both types must have the same law. Their contacts then
// have this law, with the material constants of both types.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "lammps/contact_line.h"
#include "lammps/contact_tally.h"
#include "lammps/granular_interface.h"
#include "lammps/runtime_law.h"

namespace plastigran {

class PairStyle : public LAMMPS_NS::PairGranular, public ContactTally {
 public:
  explicit PairStyle(LAMMPS_NS::LAMMPS* lammps);

  // Returns the pair style of a simulation; null if it is another style.
  static PairStyle* of(LAMMPS_NS::LAMMPS* lammps);

  // Returns the pair_coeff line of an atom type with itself; stops the run if there is none.
  const ContactLine& line_of(int type);

  // Reads the words of a line; stops the run if the line is invalid.
  ContactLine read(const std::vector<std::string>& words, const std::string& command);
  // Returns the law that a line selects, for two bodies; stops the run if a constant is invalid.
  std::shared_ptr<const RuntimeLaw> law(const ContactLine& line, const Body& one, const Body& other,
                                        const std::string& command);

  void settings(int count, char** words) override;
  void coeff(int count, char** words) override;
  void init_style() override;
  void setup() override;
  void compute(int eflag, int vflag) override;
  void transfer_history(double* source, double* target, int type, int other_type) override;
  int pack_reverse_comm(int count, int first, double* buffer) override;
  void unpack_reverse_comm(int count, int* particles, double* buffer) override;
  void write_restart(FILE* file) override;
  void read_restart(FILE* file) override;

 private:
  struct Model {
    ContactLine line;
    std::shared_ptr<const RuntimeLaw> law;
  };

  void set_cutoff(const std::string& cutoff);
  void add_model(const std::string& types, const std::string& other_types, const ContactLine& line,
                 const Body& one, const Body& other);
  void set_model(LAMMPS_NS::Granular_NS::GranularModel* model, const ContactLine& line,
                 const std::shared_ptr<const RuntimeLaw>& made);
  const Model& model_of(int type, int other_type);
  void mix(int type, int other_type);
  void mix_types();
  void set_mixed_models();
  std::map<std::pair<int, int>, std::string> models_of_pairs();
  std::vector<int> offsets() const;
  void check_models();
  void check_particle_ids();
  void expect_impacts();

  std::string cutoff_;  // argument of pair_style; empty if it has none
  std::map<LAMMPS_NS::Granular_NS::GranularModel*, Model> models_;
  std::vector<std::pair<int, int>> mixed_;  // pairs of atom types without a line of their own
  // Models of the last run, or of the restart file, by pair of atom types, and offsets of their
  // history.
  std::map<std::pair<int, int>, std::string> last_models_;
  std::vector<int> last_offsets_;
};

}  // namespace plastigran

// SPDX-License-Identifier: GPL-2.0-or-later
//
// `fix wall/gran/plastigran` and `fix wall/gran/region/plastigran`: LAMMPS' granular walls with
// Plastigran's laws for the normal force. The line gives the law and the body of the wall. The
// bodies of the particles are those of the pair style:
//
//   fix floor all wall/gran/plastigran granular universal 2.1e11 0.3 yield_strength 1e9 &
//     tangential mindlin_rescale NULL 1.0 0.5 zplane 0 NULL
#pragma once

#include <mpi.h>

#include <array>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "lammps.h"
#include "lammps/granular_interface.h"
#include "lammps/impact_extremes.h"
#include "lammps/load_model.h"
#include "lammps/normal_model.h"
#include "lammps/pair_style.h"
#include "lammps/run_time_checks.h"
#include "memory.h"
#include "region.h"
#include "update.h"

namespace plastigran {

// Reads the line of a wall, and replaces the law in it by the words of LAMMPS' own model. The
// constructor of LAMMPS' wall reads these words, so this class must be the first base class of a
// wall. This class also creates the laws: after an error that follows LAMMPS' constructor, LAMMPS'
// destructor would stop the run with a misleading message.
class WallLine {
 public:
  WallLine(LAMMPS_NS::LAMMPS* lammps, int count, char** words);

  int count() { return static_cast<int>(pointers_.size()); }
  char** words() { return pointers_.data(); }

  // Creates the laws between the wall and the body of each atom type; stops the run if a value is
  // invalid.
  void make_laws();
  const NormalModel::Laws& laws() const { return laws_; }
  const std::string& law_name() const { return line_.law; }
  const TangentialLine& tangential() const { return line_.tangential; }

 private:
  LAMMPS_NS::LAMMPS* lammps_;
  std::string command_;
  ContactLine line_;
  NormalModel::Laws laws_;
  std::vector<std::string> words_;
  std::vector<char*> pointers_;
};

template <class LammpsWall>
class WallStyle : private WallLine, public LammpsWall, public ContactTally {
 public:
  WallStyle(LAMMPS_NS::LAMMPS* lammps, int count, char** words)
      : WallLine(lammps, count, words), LammpsWall(lammps, WallLine::count(), WallLine::words()) {
    NormalModel::replace(this->model, lammps, laws(), tangential(), *this);
    this->size_history = history_size();
    this->use_history = this->restart_peratom = this->restart_global = 1;
    this->memory->destroy(this->history_one);  // allocated for LAMMPS' own model
    this->grow_arrays(this->atom->nmax);
    for (int i = 0; i < this->atom->nlocal; ++i) this->set_arrays(i);
    this->vector_flag = this->extvector = this->global_freq = 1;
    this->size_vector = 3;
  }

  double compute_vector(int axis) override {  // force on the wall [N]
    double force = 0;
    MPI_Allreduce(&wall_load_.force[axis], &force, 1, MPI_DOUBLE, MPI_SUM, this->world);
    return -force;
  }

  // Creates the laws again from the current pair_coeff lines.
  void init() override {
    make_laws();
    NormalModel::replace(this->model, this->lmp, laws(), tangential(), *this);
    if (history_size() != this->size_history)
      this->error->all(FLERR,
                       "fix {}: new pair_coeff lines change the number of history values of the "
                       "contacts; remove the wall by `unfix {}`, and give it again",
                       this->style, this->id);
    LammpsWall::init();
    auto* const normal = static_cast<NormalModel*>(this->model->normal_model);
    normal->count_in(RunTimeChecks::of(this->lmp).account(*normal->laws().front()));
  }

  // Writes the law, and the names and history sizes of the models, to the restart file.
  void write_restart(FILE* file) override {
    if (this->comm->me != 0) return;
    const std::string text = law_and_models();
    const int size = static_cast<int>(text.size()) + 1;
    std::fwrite(&size, sizeof size, 1, file);
    std::fwrite(text.c_str(), 1, static_cast<std::size_t>(size), file);
  }

  // Stops the run if the restart file has another law or other models. The contacts would otherwise
  // continue with a history that belongs to the old models.
  void restart(char* text) override {
    if (law_and_models() != text)
      this->error->all(FLERR,
                       "fix {}: the restart file has another law or other models; the contacts "
                       "would keep the old history, so change only constants",
                       this->id);
  }

  void setup(int vflag) override {
    LammpsWall::setup(vflag);
    const auto* const normal = static_cast<NormalModel*>(this->model->normal_model);
    std::vector<ExpectedImpact> impacts;
    const ImpactForecast forecast(type_extremes(this->lmp, this->groupbit), {1}, true, {});
    for (const Meeting& meeting : forecast.meetings())
      impacts.push_back({meeting, normal->laws()[static_cast<std::size_t>(meeting.type) - 1]});
    RunTimeChecks::of(this->lmp).expect(impacts);
  }

  void post_force(int vflag) override {
    const WallLoad last = wall_load_;
    const std::array<double, 3> before = region_velocity();
    begin(this->lmp);
    LoadModel::enable(this->model);
    LammpsWall::post_force(vflag);
    end();
    if (balance_ && !this->update->setupflag) {
      std::array<double, 3> change = region_velocity();
      for (std::size_t k = 0; k < 3; ++k) change[k] -= before[k];
      balance_->add_wall_change(last.force, last.lossy, change.data());
    }
  }

 private:
  std::string law_and_models() const {
    std::string text = law_name();
    for (const auto* const part : this->model->sub_models)
      text += ' ' + part->name + ' ' + std::to_string(part->size_history);
    return text;
  }
  // Returns the number of history values of a contact. If contacts can last without overlap, LAMMPS
  // stores in an additional first value whether the bodies touch.
  int history_size() const {
    return this->model->size_history + (this->model->beyond_contact ? 1 : 0);
  }
  // Returns the velocity of a moving region, which LAMMPS computes as the mean over the last step.
  // Returns zero for planes: LAMMPS computes their velocity at the end of the step, so their work
  // needs no correction.
  std::array<double, 3> region_velocity() const {
    const LAMMPS_NS::Region* const region =
        this->idregion ? this->domain->get_region_by_id(this->idregion) : nullptr;
    if (!region || !region->moveflag) return {};
    return {region->v[0], region->v[1], region->v[2]};
  }
};

}  // namespace plastigran

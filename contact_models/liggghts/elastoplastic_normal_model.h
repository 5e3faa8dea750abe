// SPDX-License-Identifier: GPL-2.0-or-later
//
// The one adapter between a law and the engine: a normal contact model over any law of laws/.
// It turns `fix property/global` values into one law object per pair of atom types, keeps the law's
// state in the engine's contact history, and hands force and tangential stiffness on.
//
// History values carry the flag "0": they are scalars, the same seen from either particle. ("1"
// would flip their sign whenever the pair is stored from the other side.)
#ifndef PLASTIGRAN_ELASTOPLASTIC_NORMAL_MODEL_H
#define PLASTIGRAN_ELASTOPLASTIC_NORMAL_MODEL_H

#include <algorithm>
#include <cmath>
#include <cstring>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "atom.h"
#include "comm.h"
#include "plastigran/shared/contact.h"
#include "domain.h"
#include "plastigran/impact/elastic_times.h"
#include "energy_ledger.h"
#include "engine_access.h"
#include "error.h"
#include "fix_mesh_surface.h"
#include "fix_property_global.h"
#include "fix_wall_gran.h"
#include "force.h"
#include "global_properties.h"
#include "history_keeper.h"
#include "plastigran/impact/central_impact.h"
#include "modify.h"
#include "motion_watch.h"
#include "neighbor.h"
#include "normal_model_base.h"
#include "pair_gran.h"
#include "property_name.h"
#include "range_watch.h"
#include "settings.h"
#include "step_watch.h"
#include "plastigran/impact/validate.h"

namespace LIGGGHTS {
namespace ContactModels {

template <class Law>
class ElastoplasticNormalModel : public NormalModelBase {
  typedef typename Law::State State;
  static constexpr std::size_t state_size = Law::state_names.size() * sizeof(double);
  static_assert(state_size == 0 || state_size == sizeof(State),
                "a law's State is its named doubles and nothing else");

 public:
  ElastoplasticNormalModel(LAMMPS* lmp, IContactHistorySetup* owner,
                           ContactModelBase* contact_model)
      : NormalModelBase(lmp, owner, contact_model),
        owner_(owner),
        contact_model_(contact_model),
        is_wall_(contact_model->is_wall()) {
    for (std::size_t k = 0; k < Law::state_names.size(); ++k) {
      const int offset = owner->add_history_value(Law::state_names[k], "0");
      if (k == 0) history_offset_ = offset;
    }
  }

  void registerSettings(Settings& settings) override {
    settings.registerOnOff("viscous_damping", viscous_damping_, false);
    settings.registerOnOff("tangential_damping", tangential_damping_, true);
    settings.registerDoubleSetting("overlap_limit", overlap_limit_, 1.0);
    for (const auto& option : Law::options) register_choice(settings, option);
    settings.registerOnOff("computeElasticPotential", engine_elastic_potential_, false);
    settings.registerOnOff("computeDissipatedEnergy", engine_dissipated_energy_, false);
  }

  void postSettings(IContactHistorySetup*, ContactModelBase*) override {
    if (engine_elastic_potential_) refuse("computeElasticPotential");
    if (engine_dissipated_energy_) refuse("computeDissipatedEnergy");
    if (!(overlap_limit_ > 0 && overlap_limit_ <= 2))
      fail("overlap_limit is " + std::to_string(overlap_limit_) +
           "; it must be above 0 and at most 2, of the smaller radius");
  }

  // Called by the engine before every run, on all ranks together.
  void connectToProperties(PropertyRegistry& registry) override {
#ifdef SUPERQUADRIC_ACTIVE_FLAG
    if (atom->superquadric_flag) fail("it is for spheres; this atom style is not");
#endif
    if (is_cylinder && domain->dimension != 2)
      fail("it is for cylinders, the discs of a 2D deck (dimension 2); this deck is 3D");
    type_count_ = registry.max_type();
    build_laws();
    excess_ = plastigran::RangeWatch::of(lmp, caller(), Law::range);
    step_watch_ = plastigran::own_fix<plastigran::StepWatch>(lmp);
    step_watch_->forget();  // the laws were built anew: contacts are looked at again
    plastigran::own_fix<plastigran::MotionWatch>(lmp);
    plastigran::own_fix<plastigran::HistoryKeeper>(lmp);
    const auto user = dynamic_cast<plastigran::LedgerUser*>(contact_model_);
    ledger_ = user ? user->ledger : nullptr;
    if (viscous_damping_) {
      registry.registerProperty("betaeff", &MODEL_PARAMS::createBetaEff);
      registry.connect("betaeff", damping_, caller().c_str());
    }
    smooth_friction_ = tangential_model_is("no_history");
    // Ask for surfacesClose() just outside contact, where the history is cleared: otherwise a pair
    // that parts and meets again before the next neighbour build would remember its dent.
    neighbor->register_contact_dist_factor(1.01);
    if (!reported_) report_constants();
    reported_ = true;
    check_impacts();
  }

  // Force as a power of overlap while elastic: Hertz, or the nearly straight line contact.
  double stressStrainExponent() override { return is_cylinder ? 1 : 1.5; }

  // Flattened: only with the law inlined can the compiler drop the energies nobody reads here,
  // among them Vu-Quoc-Zhang's quadrature; without it that law costs half as much again.
  [[gnu::flatten]] void surfacesIntersect(SurfacesIntersectData& contact, ForceData& i_forces,
                                          ForceData& j_forces) override {
    if (contact.contact_flags) *contact.contact_flags |= CONTACT_NORMAL_MODEL;
    const double radius_eff = contact.is_wall
                                  ? contact.radi
                                  : contact.radi * contact.radj / (contact.radi + contact.radj);
    const int pair = index(contact.itype, contact.jtype);
    if constexpr (takes_bodies)  // particles that came after the check before the run
      if (!lacking_[pair].empty()) stop_at_touch(pair);

    double* const history = contact.contact_history + history_offset_;
    State state;
    std::memcpy(&state, history, state_size);
    const plastigran::Response response =
        plastigran::respond(laws_[pair], radius_eff, contact.deltan, state, -contact.vn);
    if (ledger_ && contact.computeflag) account(contact, pair, radius_eff);
    if (contact.computeflag) {
      if (contact.deltan > watched_[pair] * radius_eff) note_depth(contact, pair, radius_eff);
      if (contact.shearupdate) std::memcpy(history, &state, state_size);
    }

    // A residual dent carries no force and so no friction, but a tangential spring needs a
    // stiffness to be released against: give it the undeformed sphere's.
    const double contact_radius =
        response.force > 0 ? response.contact_radius : std::sqrt(radius_eff * contact.deltan);
    const plastigran::Stiffness elastic = plastigran::elastic_stiffness(
        laws_[pair], moduli_[pair], shear_moduli_[pair], contact_radius);
    contact.kt = elastic.tangential;
    contact.kn = contact.deltan > 0 ? response.force / contact.deltan : 0;  // secant
    contact.gamman = 0;
    // Friction without a spring is a viscous force cut at mu F: critical damping of the spring it
    // stands for makes the cut the rule and creep the exception.
    contact.gammat = smooth_friction_ ? 2 * std::sqrt(contact.kt * contact.meff) : 0;
    double force = response.force;
    if (viscous_damping_) {
      // Tsuji, Tanaka & Ishida 1992 (Powder Technol. 71:239) with the law's own contact radius.
      const double beta =
          -1.8257418583505538 * damping_[contact.itype][contact.jtype];  // 2 sqrt(5/6)
      contact.gamman = beta * std::sqrt(elastic.normal * contact.meff);
      if (tangential_damping_ && !smooth_friction_)
        contact.gammat = beta * std::sqrt(contact.kt * contact.meff);
      force = std::max(0.0, force - contact.gamman * contact.vn);
    }
    contact.Fn = force;
    if (ledger_ && contact.computeflag)
      ledger_->add_dashpot(contact, force - response.force + response.viscous_force);

    const double applied = contact.is_wall ? force * contact.area_ratio : force;
    for (int axis = 0; axis < 3; ++axis) {
      i_forces.delta_F[axis] += applied * contact.en[axis];
      if (!contact.is_wall) j_forces.delta_F[axis] -= applied * contact.en[axis];
    }
  }

  void surfacesClose(SurfacesCloseData& contact, ForceData&, ForceData&) override {
    if (contact.contact_flags) *contact.contact_flags &= ~CONTACT_NORMAL_MODEL;
    if (contact.contact_history)
      std::memset(contact.contact_history + history_offset_, 0, state_size);
  }

  void beginPass(SurfacesIntersectData&, ForceData&, ForceData&) override {}
  void endPass(SurfacesIntersectData&, ForceData&, ForceData&) override {}

 private:
  static constexpr bool is_cylinder =
      std::string_view(plastigran::shape<Law>) == std::string_view("cylinder");
  static constexpr bool takes_bodies = [] {
    for (const auto& parameter : Law::parameters)
      if (parameter.per_body) return true;
    return false;
  }();

  // Energies for the ledger, from the state before this step; apart, so that the force is computed
  // without them. At no overlap a law answers with the plastic work of the state alone.
  [[gnu::noinline]] void account(const SurfacesIntersectData& contact, int pair,
                                 double radius_eff) {
    State before, reached;
    std::memcpy(&before, contact.contact_history + history_offset_, state_size);
    reached = before;
    const plastigran::Response now = laws_[pair].respond(radius_eff, contact.deltan, reached);
    double plastic_work = 0;
    if (std::memcmp(&before, &reached, state_size) != 0)
      plastic_work = now.plastic_work - laws_[pair].respond(radius_eff, 0, before).plastic_work;
    ledger_->add_law(contact, now.elastic_energy, plastic_work);
  }

  // A contact deeper than what was noted of its pair of types on this rank: by a tenth, so that few
  // are; and all beyond the law's range, or near the limit.
  [[gnu::noinline]] void note_depth(const SurfacesIntersectData& contact, int pair,
                                    double radius_eff) {
    const double smaller = contact.is_wall ? contact.radi : std::min(contact.radi, contact.radj);
    if (contact.deltan > overlap_limit_ * smaller) stop_overlap(contact, smaller);
    if (contact.shearupdate && contact.deltan > ranges_[pair] * radius_eff)
      note_excess(contact, pair, radius_eff);
    const double depth = contact.deltan / radius_eff;
    if (depth <= noted_[pair]) return;
    noted_[pair] = 1.1 * depth;
    watched_[pair] = std::min({noted_[pair], ranges_[pair], overlap_limit_});  // R* <= smaller
    typename Law::State state;
    const plastigran::Response virgin = laws_[pair].respond(radius_eff, contact.deltan, state);
    const double energy = virgin.elastic_energy + virgin.plastic_work;
    const double speed = std::sqrt(2 * energy / contact.meff);
    const double* const x = atom->x[contact.i];
    step_watch_->met(
        {plastigran::recommended_time_step(laws_[pair], radius_eff, contact.meff, speed),
         speed,
         {x[0], x[1], x[2]},
         atom->tag[contact.i],
         contact.is_wall ? 0 : atom->tag[contact.j]});
  }

  // On this rank alone.
  [[gnu::noinline]] void stop_overlap(const SurfacesIntersectData& contact, double smaller) {
    std::ostringstream text;
    text << caller() << ": " << plastigran::describe(atom, contact.i) << " overlaps ";
    if (contact.is_wall)
      text << "a wall";
    else
      text << plastigran::describe(atom, contact.j);
    text << " by " << contact.deltan / smaller << " of the smaller radius, more than overlap_limit "
         << overlap_limit_ << ". Look for particles inserted into each other or in a wall, a time "
         << "step that is too long, or bodies too soft for their load";
    error->one(FLERR, text.str().c_str());
  }

  // A contact is counted when it passes the end of its law's range for the first time: when what it
  // had reached before this step is less than loading to that end makes of it.
  [[gnu::noinline]] void note_excess(const SurfacesIntersectData& contact, int pair,
                                     double radius_eff) {
    const double limit = ranges_[pair] * radius_eff;
    excess_->furthest = std::max(excess_->furthest, contact.deltan / limit);
    State before, reached;
    std::memcpy(&before, contact.contact_history + history_offset_, state_size);
    reached = before;
    laws_[pair].respond(radius_eff, limit, reached);
    if (std::memcmp(&before, &reached, state_size) == 0) return;
    const bool shared = !contact.is_wall && !force->newton_pair && contact.j >= atom->nlocal;
    excess_->contacts += shared ? 0.5 : 1;
  }

  int index(int itype, int jtype) const { return (itype - 1) * type_count_ + jtype - 1; }

  static std::string caller() { return std::string("model ") + Law::name; }

  void fail(const std::string& reason) { error->all(FLERR, (caller() + ": " + reason).c_str()); }

  // On this rank alone: the others are not in the force loop at the same contact.
  [[gnu::noinline]] void stop_at_touch(int pair) {
    error->one(FLERR, (caller() + ": " + lacking_[pair]).c_str());
  }

  void refuse(const char* setting) {
    fail(std::string(setting) + " is not available with this model; leave it off");
  }

  void register_choice(Settings& settings,
                       const plastigran::Option<typename Law::Parameters>& option) {
    EnumSetting<int>* const setting = new EnumSetting<int>(option.name);  // Settings deletes it
    for (int k = 0; k < static_cast<int>(option.choices.size()) && option.choices[k]; ++k)
      setting->addOption(option.choices[k], k);
    setting->setDefault(option.choices[choices_.*option.value]);
    setting->registerTarget(choices_.*option.value);
    (settings.*reach(plastigran::EngineSettings()))[option.name] = setting;
  }

  FixPropertyGlobal* find(const char* name, const char* shape, int rows, int columns,
                          bool required) {
    return static_cast<FixPropertyGlobal*>(modify->find_fix_property(
        name, "property/global", shape, rows, columns, caller().c_str(), required));
  }

  bool given(const char* name) {
    return find(name, "scalar", 0, 0, false) || find(name, "vector", 0, 0, false) ||
           find(name, "matrix", 0, 0, false);
  }

  // The values the deck gives for a property; null when it gives none. Values of the wrong shape
  // are the engine's error, not a silent default.
  FixPropertyGlobal* property(const char* name, const char* shape, int rows, int columns) {
    return given(name) ? find(name, shape, rows, columns, true) : nullptr;
  }

  double per_type(const char* name, int type, const char* unit, double fallback = NAN) {
    FixPropertyGlobal* values = property(name, "peratomtype", type_count_, 0);
    if (values) return values->compute_vector(type - 1);
    if (std::isnan(fallback))
      fail(std::string(name) + " is missing; give it for every atom type [" + unit +
           "]: fix ID all property/global " + name + " peratomtype VALUE ...");
    return fallback;
  }

  void build_laws() {
    materials_.assign(type_count_, plastigran::Material());
    for (int type = 1; type <= type_count_; ++type) {
      plastigran::Material& body = materials_[type - 1];
      body.youngs_modulus = per_type("youngsModulus", type, "Pa");
      body.poissons_ratio = per_type("poissonsRatio", type, "-");
      body.yield_strength = per_type("yieldStrength", type, "Pa",
                                     plastigran::Yields<Law>::value ? NAN : plastigran::unlimited);
      body.yield_pressure_factor = per_type("yieldPressureFactor", type, "-", 0);
      check(plastigran::validate(body), type, 0);
    }
    laws_.clear(), constants_.clear(), ranges_.clear(), moduli_.clear(), shear_moduli_.clear();
    lacking_.clear();
    noted_.assign(type_count_ * type_count_, 0);
    watched_ = noted_;
    for (int i = 1; i <= type_count_; ++i)
      for (int j = 1; j <= type_count_; ++j) {
        if (j < i) {  // as (j, i): the engine takes symmetric properties only
          const int same = index(j, i);
          lacking_.push_back(lacking_[same]), constants_.push_back(constants_[same]);
          laws_.push_back(laws_[same]), ranges_.push_back(ranges_[same]);
          moduli_.push_back(moduli_[same]), shear_moduli_.push_back(shear_moduli_[same]);
          continue;
        }
        typename Law::Parameters constants = choices_;
        std::string lacking;
        for (const auto& parameter : Law::parameters) {
          if (parameter.per_body) {
            constants.*parameter.value = larger_of_bodies(parameter, i, j);
            if (lacking.empty() && constants.*parameter.value == 0)
              lacking =
                  about_types(plastigran::in_property_names(plastigran::complaint(parameter, 0)) +
                                  "; one of the two must have it",
                              i, j);
          } else if (FixPropertyGlobal* values =
                         property(property_of(parameter).c_str(), "peratomtypepair", type_count_,
                                  type_count_)) {
            constants.*parameter.value = values->compute_array(i - 1, j - 1);
          }
        }
        const auto pair = plastigran::combine(materials_[i - 1], materials_[j - 1]);
        if (lacking.empty()) check(plastigran::validate<Law>(pair, constants), i, j);
        lacking_.push_back(lacking);
        laws_.emplace_back(pair, constants);
        constants_.push_back(constants);
        ranges_.push_back(plastigran::overlap_range(laws_.back()));
        moduli_.push_back(pair.youngs_modulus_eff);
        shear_moduli_.push_back(pair.shear_modulus_eff);
      }
  }

  // A pair's value of a property that bodies bring: the larger one; 0 says "not this body".
  double larger_of_bodies(const plastigran::Parameter<typename Law::Parameters>& parameter,
                          int type, int other_type) {
    double larger = 0;
    for (int each : {type, other_type}) {
      const double value = per_type(property_of(parameter).c_str(), each, parameter.unit);
      if (value != 0) check(plastigran::complaint(parameter, value), each, 0);
      larger = std::max(larger, value);
    }
    return larger;
  }

  static std::string about_types(const std::string& complaint, int type, int other_type) {
    std::ostringstream text;
    text << complaint << (other_type ? " (atom types " : " (atom type ") << type;
    if (other_type) text << " and " << other_type;
    text << ')';
    return text.str();
  }

  void check(const plastigran::Complaint& complaint, int type, int other_type) {
    if (!complaint.empty())
      fail(about_types(plastigran::in_property_names(complaint), type, other_type));
  }

  static std::string property_of(const plastigran::Parameter<typename Law::Parameters>& parameter) {
    return plastigran::property_name(parameter.name);
  }

  bool tangential_model_is(const char* name) {
    return is_wall_ ? static_cast<FixWallGran*>(owner_)->contact_match("tangential", name)
                    : static_cast<PairGran*>(owner_)->contact_match("tangential", name);
  }

  std::vector<int> partner_types() {
    std::vector<int> types;
    if (!is_wall_) {
      for (int type = 1; type <= type_count_; ++type) types.push_back(type);
      return types;
    }
    FixWallGran* const wall = static_cast<FixWallGran*>(owner_);
    if (!wall->is_mesh_wall()) return {wall->atom_type_wall()};
    for (int mesh = 0; mesh < wall->n_meshes(); ++mesh)
      types.push_back(wall->mesh_list()[mesh]->atomTypeWall());
    return types;
  }

  // What the model was given and what it assumed: a misspelt optional property shows here.
  void report_constants() {
    if (comm->me != 0) return;
    std::ostringstream text;
    for (int i = 1; i <= type_count_; ++i)
      for (int j = i; j <= type_count_; ++j) {
        if (!lacking_[index(i, j)].empty()) continue;  // never to meet
        const auto pair = plastigran::combine(materials_[i - 1], materials_[j - 1]);
        text << caller() << (is_wall_ ? ", wall" : "") << ", atom types " << i << " and " << j
             << ": effective modulus " << pair.youngs_modulus_eff << " Pa";
        if (plastigran::Yields<Law>::value)
          text << ", yield strength " << pair.yield_strength << " Pa, yield pressure "
               << pair.yield_pressure << " Pa";
        for (const auto& parameter : Law::parameters)
          text << ", " << property_of(parameter) << ' ' << constants_[index(i, j)].*parameter.value
               << (given(property_of(parameter).c_str()) ? "" : " (default)");
        for (const auto& option : Law::options)
          text << ", " << option.name << ' ' << option.choices[choices_.*option.value];
        text << '\n';
      }
    if (screen) fputs(text.str().c_str(), screen);
    if (logfile) fputs(text.str().c_str(), logfile);
  }

  // Unloading is stiffer than the elastic loading other checks know, and a law is good for so much
  // load. Take the fastest impact the present velocities allow between the smallest particles: the
  // step watch compares the time step with it, and a law out of its range is warned of here.
  void check_impacts() {
    const double unset = 1e300;
    std::vector<double> radius(type_count_ + 1, unset), mass(radius), slowness(radius);
    std::vector<double> count(type_count_ + 1, 0);
    for (int i = 0; i < atom->nlocal; ++i) {
      const int type = atom->type[i];
      const double* v = atom->v[i];
      const double speed = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
      radius[type] = std::min(radius[type], atom->radius[i]);
      mass[type] = std::min(mass[type], atom->rmass[i]);
      slowness[type] = std::min(slowness[type], -speed);
      ++count[type];
    }
    for (std::vector<double>* extreme : {&radius, &mass, &slowness})
      MPI_Allreduce(MPI_IN_PLACE, extreme->data(), type_count_ + 1, MPI_DOUBLE, MPI_MIN, world);
    MPI_Allreduce(MPI_IN_PLACE, count.data(), type_count_ + 1, MPI_DOUBLE, MPI_SUM, world);
    const auto can_meet = [&](int i, int j) {
      return count[i] > 0 && (is_wall_ || (count[j] > 0 && (i != j || count[i] > 1)));
    };
    for (int i = 1; i <= type_count_; ++i)
      for (int j : partner_types())
        if (can_meet(i, j) && !lacking_[index(i, j)].empty()) fail(lacking_[index(i, j)]);
    if (comm->me != 0) return;

    plastigran::StepWatch::Recommended fastest;
    fastest.wall = is_wall_;
    double hertz = unset, rayleigh = unset, outside_speed = 0;
    for (int i = 1; i <= type_count_; ++i) {
      if (count[i] > 0 && !is_cylinder) {
        const plastigran::Material& body = materials_[i - 1];
        const double volume = 4.0 / 3 * plastigran::pi * std::pow(radius[i], 3);
        rayleigh =
            std::min(rayleigh, plastigran::rayleigh_time(radius[i], mass[i] / volume,
                                                         body.youngs_modulus, body.poissons_ratio));
      }
      for (int j : partner_types()) {
        if (!can_meet(i, j)) continue;
        const double speed = -slowness[i] - (is_wall_ ? 0 : slowness[j]);
        if (!(speed > 0)) continue;
        const auto reduced = [](double a, double b) { return a * b / (a + b); };
        const int pair = index(i, j);
        const Law& law = laws_[pair];
        const double radius_eff = is_wall_ ? radius[i] : reduced(radius[i], radius[j]);
        const double mass_eff = is_wall_ ? mass[i] : reduced(mass[i], mass[j]);
        const double recommended =
            plastigran::recommended_time_step(law, radius_eff, mass_eff, speed);
        if (recommended < fastest.step) fastest.step = recommended, fastest.speed = speed;
        if (!is_cylinder)
          hertz = std::min(hertz,
                           plastigran::hertz_duration(radius_eff, mass_eff, moduli_[pair], speed));
        if (!plastigran::central_impact(law, radius_eff, mass_eff, speed).in_range)
          outside_speed = std::max(outside_speed, speed);
      }
    }
    step_watch_->expect(caller(), fastest, rayleigh, hertz);
    static double warned_speed = 0;  // once for all walls, unless it gets worse
    std::ostringstream text;
    if (outside_speed > 1.01 * warned_speed) {
      warned_speed = outside_speed;
      text << caller() << ": impacts at the present speeds (up to " << outside_speed
           << ") leave the law's range (" << Law::range << ')';
      error->warning(FLERR, text.str().c_str());
    }
  }

  IContactHistorySetup* owner_;
  ContactModelBase* contact_model_;
  bool is_wall_;
  int history_offset_ = 0;
  typename Law::Parameters choices_;  // the law's options as set; its constants at their defaults
  bool viscous_damping_ = false;
  bool tangential_damping_ = true;  // the dashpot beside the tangential spring too
  double overlap_limit_ = 1.0;      // of the smaller radius; beyond it the run is stopped
  bool engine_elastic_potential_ = false;
  bool engine_dissipated_energy_ = false;
  bool smooth_friction_ = false;
  double** damping_ = nullptr;  // the engine's beta(coefficientRestitution) of each type pair

  plastigran::RangeWatch::Excess* excess_ = nullptr;
  plastigran::StepWatch* step_watch_ = nullptr;
  plastigran::EnergyLedger* ledger_ = nullptr;
  bool reported_ = false;
  int type_count_ = 0;
  std::vector<plastigran::Material> materials_;  // by type - 1
  // By index(itype, jtype):
  std::vector<Law> laws_;
  std::vector<typename Law::Parameters> constants_;
  std::vector<double> ranges_;        // largest overlap the law is good for, over R*
  std::vector<double> noted_;         // overlap over R* up to which contacts were looked at
  std::vector<double> watched_;       // where to look at them again
  std::vector<double> moduli_;        // E*
  std::vector<double> shear_moduli_;  // G*
  std::vector<std::string> lacking_;  // what neither body brings; an error once the two can meet
};

}  // namespace ContactModels
}  // namespace LIGGGHTS

#endif

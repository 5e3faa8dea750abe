// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/model/impact_forecast.h"

#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "atom.h"
#include "plastigran/impact/elastic_times.h"

namespace plastigran {

ImpactForecast::ImpactForecast(LAMMPS_NS::LAMMPS* engine, const ContactOwner& owner, int type_count)
    : Pointers(engine), is_wall_(owner.is_wall()), types_(type_count + 1) {
  gather();
  const auto reduced = [](double a, double b) { return a * b / (a + b); };
  const std::set<int> walls = ContactOwner::wall_types(modify);
  const auto may_come = [&](int type) { return types_[type].count > 0 || !walls.count(type); };
  for (int type = 1; type <= type_count; ++type) {
    const Extremes& one = types_[type];
    for (int partner : owner.partner_types(type_count))
      if (may_come(type) && (is_wall_ || may_come(partner))) expected_.push_back({type, partner});
    if (one.count == 0) continue;
    for (int partner : owner.partner_types(type_count)) {
      const Extremes& other = types_[partner];
      if (is_wall_)
        meetings_.push_back({type, partner, one.radius, one.mass, one.speed});
      else if (other.count > (type == partner ? 1 : 0))
        meetings_.push_back({type, partner, reduced(one.radius, other.radius),
                             reduced(one.mass, other.mass), relative_speed(one, other)});
    }
  }
}

double ImpactForecast::relative_speed(const Extremes& one, const Extremes& other) {
  double squared = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double apart =
        std::max(one.most[axis] - other.least[axis], other.most[axis] - one.least[axis]);
    squared += apart * apart;
  }
  return std::min(std::sqrt(squared), one.speed + other.speed);
}

void ImpactForecast::gather() {
  for (int i = 0; i < atom->nlocal; ++i) {
    Extremes& type = types_[atom->type[i]];
    const double* const v = atom->v[i];
    type.count += 1;
    type.radius = std::min(type.radius, atom->radius[i]);
    type.mass = std::min(type.mass, atom->rmass[i]);
    type.speed = std::max(type.speed, std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
    for (int axis = 0; axis < 3; ++axis) {
      type.least[axis] = std::min(type.least[axis], v[axis]);
      type.most[axis] = std::max(type.most[axis], v[axis]);
    }
  }
  const auto over_ranks = [&](MPI_Op operation, auto value) {
    std::vector<double> values;
    for (Extremes& type : types_) values.push_back(value(type));
    MPI_Allreduce(MPI_IN_PLACE, values.data(), values.size(), MPI_DOUBLE, operation, world);
    for (std::size_t type = 0; type < types_.size(); ++type) value(types_[type]) = values[type];
  };
  over_ranks(MPI_SUM, [](Extremes& type) -> double& { return type.count; });
  over_ranks(MPI_MIN, [](Extremes& type) -> double& { return type.radius; });
  over_ranks(MPI_MIN, [](Extremes& type) -> double& { return type.mass; });
  over_ranks(MPI_MAX, [](Extremes& type) -> double& { return type.speed; });
  for (int axis = 0; axis < 3; ++axis) {
    over_ranks(MPI_MIN, [=](Extremes& type) -> double& { return type.least[axis]; });
    over_ranks(MPI_MAX, [=](Extremes& type) -> double& { return type.most[axis]; });
  }
}

double ImpactForecast::rayleigh_time(const std::vector<Body>& materials) const {
  double shortest = ImpactTimes::unknown;
  for (std::size_t type = 1; type < types_.size(); ++type) {
    const Extremes& extremes = types_[type];
    if (extremes.count == 0) continue;
    const Body& body = materials[type - 1];
    const double volume = 4.0 / 3 * pi * std::pow(extremes.radius, 3);
    shortest =
        std::min(shortest, plastigran::rayleigh_time(extremes.radius, extremes.mass / volume,
                                                     body.youngs_modulus, body.poissons_ratio));
  }
  return shortest;
}

}  // namespace plastigran

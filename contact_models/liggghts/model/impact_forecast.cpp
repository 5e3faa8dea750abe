// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/model/impact_forecast.h"

#include <mpi.h>

#include <algorithm>
#include <cmath>

#include "atom.h"
#include "plastigran/impact/elastic_times.h"

namespace plastigran {

ImpactForecast::ImpactForecast(LAMMPS_NS::LAMMPS* engine, const ContactOwner& owner, int type_count)
    : Pointers(engine), is_wall_(owner.is_wall()), types_(type_count + 1) {
  gather();
  const auto reduced = [](double a, double b) { return a * b / (a + b); };
  for (int type = 1; type <= type_count; ++type) {
    const Extremes& one = types_[type];
    if (one.count == 0) continue;
    for (int partner : owner.partner_types(type_count)) {
      const Extremes& other = types_[partner];
      if (is_wall_)
        meetings_.push_back({type, partner, one.radius, one.mass, one.speed});
      else if (other.count > (type == partner ? 1 : 0))
        meetings_.push_back({type, partner, reduced(one.radius, other.radius),
                             reduced(one.mass, other.mass), one.speed + other.speed});
    }
  }
}

void ImpactForecast::gather() {
  for (int i = 0; i < atom->nlocal; ++i) {
    Extremes& type = types_[atom->type[i]];
    const double* const v = atom->v[i];
    type.count += 1;
    type.radius = std::min(type.radius, atom->radius[i]);
    type.mass = std::min(type.mass, atom->rmass[i]);
    type.speed = std::max(type.speed, std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
  }
  const auto over_ranks = [&](double Extremes::*value, MPI_Op operation) {
    std::vector<double> values;
    for (const Extremes& type : types_) values.push_back(type.*value);
    MPI_Allreduce(MPI_IN_PLACE, values.data(), values.size(), MPI_DOUBLE, operation, world);
    for (std::size_t type = 0; type < types_.size(); ++type) types_[type].*value = values[type];
  };
  over_ranks(&Extremes::count, MPI_SUM);
  over_ranks(&Extremes::radius, MPI_MIN);
  over_ranks(&Extremes::mass, MPI_MIN);
  over_ranks(&Extremes::speed, MPI_MAX);
}

double ImpactForecast::rayleigh_time(const std::vector<Body>& materials) const {
  double shortest = StepWatch::unknown;
  for (std::size_t type = 1; type < types_.size(); ++type) {
    const auto& [count, radius, mass, speed] = types_[type];
    if (count == 0) continue;
    const Body& body = materials[type - 1];
    const double volume = 4.0 / 3 * pi * std::pow(radius, 3);
    shortest = std::min(
        shortest,
        plastigran::rayleigh_time(radius, mass / volume, body.youngs_modulus, body.poissons_ratio));
  }
  return shortest;
}

}  // namespace plastigran

// SPDX-License-Identifier: GPL-2.0-or-later
//
// Viscoelastic spheres: quasi-static Hertz contact with an additional viscous stress.
// Kuwabara & Kono 1987 (Jpn. J. Appl. Phys. 26:1230); Brilliantov, Spahn, Hertzsch & Pöschel 1996
// (Phys. Rev. E 53:5382, eq. 19); end of the contact: Schwager & Pöschel 2008 (Phys. Rev. E
// 78:051304).
//
//   F = rho_k (overlap^(3/2) + 3/2 A sqrt(overlap) d overlap/dt),   rho_k = 4/3 E* sqrt(R*)
//   a = sqrt(R* overlap),   elastic energy = 2/5 rho_k overlap^(5/2)
//
// A [s] is the ratio of the viscous to the elastic constants of the bodies. The force is largest
// before the overlap is largest. During unloading, the force vanishes while the spheres still
// overlap. The contact ends there, because the surfaces recover more slowly than the spheres
// separate, and never attract each other.
//
// Range: no yield; impact speed much lower than the speed of sound, contact time much longer than
// A.
#pragma once

#include "plastigran/shared/contact.h"

namespace plastigran {

class ViscoelasticHertz {
 public:
  static constexpr const char* name = "viscoelastic_hertz";
  static constexpr const char* source =
      "Brilliantov, Spahn, Hertzsch & Pöschel 1996, Phys. Rev. E 53:5382";
  static constexpr const char* range = "no yield, a << R*, contact time >> A";
  static constexpr bool rate_dependent = true;
  static constexpr bool yields = false;

  struct Parameters {
    double dissipative_constant = required;
  };
  static constexpr std::array<Parameter<Parameters>, 1> parameters{
      {{"dissipative_constant", "s", &Parameters::dissipative_constant, 0, 1,
        "A, ratio of viscous to elastic constants of the two bodies; 0: Hertz"}}};

  struct State {};
  static constexpr std::array<const char*, 0> state_names{};

  ViscoelasticHertz(const MaterialPair& pair, const Parameters& constants)
      : modulus_(4.0 / 3.0 * pair.youngs_modulus_eff),
        delay_(1.5 * constants.dissipative_constant) {}

  PLASTIGRAN_DEVICE Response respond(double radius_eff, double overlap, State&,
                                     double overlap_rate = 0) const {
    if (!(overlap > 0)) return {};
    Response response;
    const double radius = std::sqrt(radius_eff * overlap);
    const double elastic_force = modulus_ * radius * overlap;
    const double force = elastic_force + modulus_ * radius * delay_ * overlap_rate;
    if (force > 0) {
      response.force = force;
      response.contact_radius = radius;
    }
    // Some elastic energy remains when the contact ends. It is dissipated while the surfaces
    // recover.
    response.elastic_energy = 0.4 * elastic_force * overlap;
    response.viscous_force = response.force - elastic_force;
    return response;
  }

 private:
  double modulus_;  // 4/3 E* [Pa]
  double delay_;    // 3/2 A [s]
};

}  // namespace plastigran

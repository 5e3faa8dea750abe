// SPDX-License-Identifier: GPL-2.0-or-later
//
// The adhesive elastic contact of spheres by Johnson, Kendall & Roberts 1971 (Proc. R. Soc. Lond. A
// 324:301), and functions that adhesive laws share. Gamma is the work of adhesion; with s = a^(1/2)
// and c = (2 pi Gamma/E*)^(1/2):
//
//   overlap = s^4/R* - c s
//   F = 4/3 E* s^6/R* - 2 E* c s^3
//   elastic energy = E* (8/15 s^10/R*^2 - 4/3 c s^7/R* + c^2 s^4)
//   surface energy = -1/2 E* c^2 s^4
//
// The contact breaks under displacement control at s_0 = (c R*/4)^(1/3), where overlap is least,
// -3/4 c s_0. In u = s/s_0 and x = overlap/(3/4 c s_0), u^4 - 4 u = 3 x. Ferrari's solution of that
// equation has the resolvent z^3 + 12 x z = 16.
#pragma once

#include <cmath>

#include "plastigran/shared/contact.h"
#include "plastigran/shared/device.h"

namespace plastigran {

template <class Law, class = void>
constexpr bool can_stretch = false;
template <class Law>
constexpr bool can_stretch<Law, std::void_t<decltype(&Law::pull_off_distance)>> = true;

// Returns the largest separation at which two bodies may still be in contact [m]; 0 for laws
// without adhesion.
template <class Law>
double pull_off_distance([[maybe_unused]] const Law& law, [[maybe_unused]] double radius_eff) {
  if constexpr (can_stretch<Law>)
    return law.pull_off_distance(radius_eff);
  else
    return 0;
}

class JkrContact {
 public:
  JkrContact() = default;
  JkrContact(double youngs_modulus_eff, double work_of_adhesion)
      : modulus_(youngs_modulus_eff),
        pull_(std::sqrt(2 * pi * work_of_adhesion / youngs_modulus_eff)) {}

  PLASTIGRAN_DEVICE double modulus() const { return modulus_; }
  PLASTIGRAN_DEVICE double pull() const { return pull_; }  // returns c [m^(1/2)]

  // Returns the overlap of an equilibrium contact with radius a = s^2 [m].
  PLASTIGRAN_DEVICE double overlap(double radius_eff, double s) const {
    return (s * s * s / radius_eff - pull_) * s;
  }
  PLASTIGRAN_DEVICE double pull_off_force(double radius_eff) const {  // returns 3/2 pi Gamma R* [N]
    return 0.75 * modulus_ * pull_ * pull_ * radius_eff;
  }
  // Returns the overlap at pull-off, the least overlap of a contact [m].
  PLASTIGRAN_DEVICE double pull_off_overlap(double radius_eff) const {
    return -0.75 * pull_ * root_at_pull_off(radius_eff);
  }

  // Returns s at an overlap; below the least overlap, s at pull-off.
  PLASTIGRAN_DEVICE double root(double radius_eff, double overlap) const {
    if (pull_ == 0) return overlap > 0 ? std::sqrt(std::sqrt(radius_eff * overlap)) : 0;
    const double least = root_at_pull_off(radius_eff), x = overlap / (0.75 * pull_ * least);
    if (!(x > -1)) return least;
    const double cube = 1 + std::sqrt(1 + x * x * x), part = std::cbrt(cube);
    const double z = 4 / (part * part + x + x * x / (part * part)), half = std::sqrt(z);
    const double rest = 8 / half - z;
    return 0.5 * least * (half + std::sqrt(rest > 0 ? rest : 0));
  }

  PLASTIGRAN_DEVICE Response at(double radius_eff, double s) const {
    const double square = s * s, fourth = square * square, hertz = fourth / radius_eff;
    Response response;
    response.force = modulus_ * square * (4.0 / 3.0 * hertz - 2 * pull_ * s);
    response.contact_radius = square;
    response.elastic_energy =
        modulus_ * (square * (8.0 / 15.0 * hertz * hertz - 4.0 / 3.0 * pull_ * s * hertz) +
                    pull_ * pull_ * fourth);
    response.surface_energy = -0.5 * modulus_ * pull_ * pull_ * fourth;
    return response;
  }

 private:
  PLASTIGRAN_DEVICE double root_at_pull_off(double radius_eff) const {
    return std::cbrt(0.25 * pull_ * radius_eff);
  }

  double modulus_ = 0;  // E* [Pa]
  double pull_ = 0;     // c [m^(1/2)]
};

// Returns the pull-off force F_c [N], which enters the limit of friction: |T| <= mu (F + F_c)
// (Derjaguin 1934, Z. Phys. 88:661). Luding 2008 uses k_c overlap for F_c.
template <class Law>
PLASTIGRAN_DEVICE double pull_off_force([[maybe_unused]] const Law& law,
                                        [[maybe_unused]] double radius_eff,
                                        [[maybe_unused]] double overlap,
                                        [[maybe_unused]] const typename Law::State& state) {
  if constexpr (adhesive<Law>)
    return law.pull_off_force(radius_eff, overlap, state);
  else
    return 0;
}

// Returns the energy dissipated if a contact forms or breaks in the step from `before` to `now`
// [J].
template <class Law>
double lost_at_ends([[maybe_unused]] const Law& law, [[maybe_unused]] double radius_eff,
                    [[maybe_unused]] const typename Law::State& before,
                    [[maybe_unused]] const typename Law::State& now) {
  if constexpr (can_stretch<Law>) {
    if (before.in_contact == now.in_contact) return 0;
    const JkrContact contact = law.contact();
    const double radius = law.unloading_radius(radius_eff, before);
    const bool forms = now.in_contact != 0;
    const double overlap = forms ? 0 : contact.pull_off_overlap(radius);
    const Response end = contact.at(radius, contact.root(radius, overlap));
    const double energy = end.elastic_energy + end.surface_energy;
    return forms ? -energy : energy;
  } else {
    return 0;
  }
}

}  // namespace plastigran

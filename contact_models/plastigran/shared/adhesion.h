// SPDX-License-Identifier: GPL-2.0-or-later
//
// Adhesive elastic contact of spheres after Johnson, Kendall & Roberts 1971 (Proc. R. Soc. Lond. A
// 324:301), and functions that adhesive laws share. With the work of adhesion Gamma, the contact
// radius a, s = a^(1/2) and c = (2 pi Gamma/E*)^(1/2):
//
//   overlap = s^4/R* - c s
//   F = 4/3 E* s^6/R* - 2 E* c s^3
//   elastic energy = E* (8/15 s^10/R*^2 - 4/3 c s^7/R* + c^2 s^4)
//   surface energy = -1/2 E* c^2 s^4
//
// If the overlap is prescribed, the contact breaks at the smallest overlap, -3/4 c s_0 with
// s_0 = (c R*/4)^(1/3). With u = s/s_0 and x = overlap/(3/4 c s_0), the first equation is
// u^4 - 4 u = 3 x. Ferrari's solution of this quartic has the resolvent cubic z^3 + 12 x z = 16.
#pragma once

#include <cmath>

#include "plastigran/shared/contact.h"
#include "plastigran/shared/device.h"

namespace plastigran {

template <class Law, class = void>
constexpr bool can_stretch = false;
template <class Law>
constexpr bool can_stretch<Law, std::void_t<decltype(&Law::pull_off_distance)>> = true;

// Whether the yield strength of a law may depend on the strain rate (rate_factor.h).
template <class Law>
constexpr bool takes_rate_factor = yields<Law> && !can_stretch<Law>;

// Returns the largest separation at which two bodies may still be in contact [m]; 0 for laws
// without adhesion.
template <class Law>
double pull_off_distance([[maybe_unused]] const Law& law, [[maybe_unused]] double radius_eff) {
  if constexpr (can_stretch<Law>)
    return law.pull_off_distance(radius_eff);
  else
    return 0;
}

// Returns the largest root of w^4 - b w = x, with b >= 0, by Ferrari's solution. If there is no
// root, returns (b/4)^(1/3), where w^4 - b w is smallest.
[[gnu::noinline, gnu::const]] PLASTIGRAN_DEVICE inline double near_pull_off(double x, double b) {
  const double least = std::cbrt(0.25 * b), square = least * least;
  const double depth = x / (3 * square * square);
  if (!(depth > -1)) return least;
  const double cube = 1 + std::sqrt(1 + depth * depth * depth), part = std::cbrt(cube);
  const double z = 4 / (part * part + depth + depth * depth / (part * part)), half = std::sqrt(z);
  const double rest = 8 / half - z;
  return 0.5 * least * (half + std::sqrt(rest > 0 ? rest : 0));
}

// Returns the largest root w of w^4 - b w = x, like near_pull_off() but faster. With w = x^(1/4) u
// and e = b/x^(3/4), the equation is u^4 - e u = 1. For weak adhesion, e <= 1, u is a polynomial in
// e that interpolates the root at Chebyshev points with an error of 5e-16. Its terms are grouped so
// that the processor can add them in parallel.
PLASTIGRAN_DEVICE inline double adhesive_root(double x, double b) {
  const double scale = std::sqrt(std::sqrt(x)), e = b / x * scale;
  if (!(e <= 1)) return near_pull_off(x, b);
  const double e_2 = e * e, e_4 = e_2 * e_2;
  const double low =
      (1 + 0.2500000000000008 * e) + e_2 * (-0.03125000000030635 + 2.004345288109921e-11 * e);
  const double middle = (0.0034179682306909064 - 0.0019531179372289167 * e) +
                        e_2 * (0.0005950348376882902 + 3.1046389643882865e-07 * e);
  const double high = (-0.00012571495758715033 + 8.688770752053581e-05 * e) +
                      e_2 * (-3.434196589018017e-05 + 7.4195645892230935e-06 * e);
  const double highest =
      (1.4073054527898652e-08 - 4.6446967250098653e-07 * e) + e_2 * 8.903896089798289e-08;
  return scale * ((low + e_4 * middle) + e_4 * e_4 * (high + e_4 * highest));
}

// Returns the root q >= 1 of q^3 - q = b, with b >= 0, which gives the contact radius a_y at yield
// with adhesion: q = (a_y/a)^(1/2) and b = c R*/(2 a^(3/2)), where a is the contact radius at yield
// without adhesion.
PLASTIGRAN_DEVICE inline double root_at_yield(double b) {
  if (b < 1) {  // Newton's method; the series in b starts it
    double q = 1 + b * (0.5 - 0.375 * b);
    for (int k = b < 0.05 ? 2 : 6; k > 0; --k) q = (2 * q * q * q + b) / (3 * q * q - 1);
    return q;
  }
  const double part = std::cbrt(0.5 * b + std::sqrt(0.25 * b * b - 1.0 / 27));
  return part + 1 / (3 * part);
}

class JkrContact {
 public:
  JkrContact() = default;
  JkrContact(double youngs_modulus_eff, double work_of_adhesion)
      : modulus_(youngs_modulus_eff),
        pull_(std::sqrt(2 * pi * work_of_adhesion / youngs_modulus_eff)) {}

  PLASTIGRAN_DEVICE double modulus() const { return modulus_; }
  PLASTIGRAN_DEVICE double pull() const { return pull_; }  // returns c [m^(1/2)]

  // Returns the overlap of a contact with the radius a = s^2 [m].
  PLASTIGRAN_DEVICE double overlap(double radius_eff, double s) const {
    return (s * s * s * (1 / radius_eff) - pull_) * s;
  }
  PLASTIGRAN_DEVICE double pull_off_force(double radius_eff) const {  // returns 3/2 pi Gamma R* [N]
    return 0.75 * modulus_ * pull_ * pull_ * radius_eff;
  }
  // Returns the overlap at pull-off, the smallest overlap of a contact [m].
  PLASTIGRAN_DEVICE double pull_off_overlap(double radius_eff) const {
    return -0.75 * pull_ * root_at_pull_off(radius_eff);
  }

  // Returns s = a^(1/2) at an overlap; if the overlap is below the pull-off overlap, s at pull-off.
  PLASTIGRAN_DEVICE double root(double radius_eff, double overlap) const {
    return adhesive_root(overlap * radius_eff, pull_ * radius_eff);
  }

  // Returns the sum of elastic and surface energy of a contact [J]. If `forms`, the contact has
  // just formed; otherwise it is about to break.
  double energy_at_end(double radius_eff, bool forms) const {
    const Response end = at(radius_eff, root(radius_eff, forms ? 0 : pull_off_overlap(radius_eff)));
    return end.elastic_energy + end.surface_energy;
  }

  PLASTIGRAN_DEVICE Response at(double radius_eff, double s) const {
    // Divide by radius_eff once: the processor can compute the reciprocal before s is known.
    const double square = s * s, fourth = square * square, hertz = fourth * (1 / radius_eff);
    Response response;
    response.force = modulus_ * square * (4.0 / 3.0 * hertz - 2 * pull_ * s);
    response.contact_radius = square;
    response.elastic_energy =
        modulus_ * (square * (8.0 / 15.0 * hertz * hertz - 4.0 / 3.0 * pull_ * s * hertz) +
                    pull_ * pull_ * fourth);
    response.surface_energy = -0.5 * modulus_ * pull_ * pull_ * fourth;
    response.pull_off_force = pull_off_force(radius_eff);
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
// (Derjaguin 1934, Z. Phys. 88:661). In the law of Luding 2008, F_c is the slope k_c of the
// adhesive limit times the overlap.
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

// Returns the pull-off force F_c [N]. If contacts of the law can stretch until pull-off, `response`
// at this overlap already contains F_c.
template <class Law>
PLASTIGRAN_DEVICE double pull_off_force(const Law& law, double radius_eff, double overlap,
                                        const typename Law::State& state,
                                        const Response& response) {
  if constexpr (can_stretch<Law>)
    return response.pull_off_force;
  else
    return pull_off_force(law, radius_eff, overlap, state);
}

// Returns the energy [J] that is dissipated because a contact forms or breaks between the states
// `before` and `now`; 0 if neither happens.
template <class Law>
double lost_at_ends([[maybe_unused]] const Law& law, [[maybe_unused]] double radius_eff,
                    [[maybe_unused]] const typename Law::State& before,
                    [[maybe_unused]] const typename Law::State& now) {
  if constexpr (can_stretch<Law>) {
    if (before.in_contact == now.in_contact) return 0;
    const bool forms = now.in_contact != 0;
    const double energy = law.energy_at_end(radius_eff, before, forms);
    return forms ? -energy : energy;
  } else {
    return 0;
  }
}

}  // namespace plastigran

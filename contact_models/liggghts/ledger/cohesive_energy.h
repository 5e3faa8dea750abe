// SPDX-License-Identifier: GPL-2.0-or-later
//
// Potential energy of LIGGGHTS' cohesion models sjkr and sjkr2. Their force depends only on the
// overlap: it is proportional to an area that grows from zero at first touch.
#pragma once

#include "contact_interface.h"
#include "contact_model_constants.h"

namespace plastigran {

class CohesiveEnergy {
  typedef LIGGGHTS::ContactModels::SurfacesIntersectData Contact;

 public:
  // Creates the energy of a cohesion model, whose LIGGGHTS ID is `model`.
  explicit CohesiveEnergy(int model) : model_(model) {}

  static bool is_known(int model) {
    using namespace LIGGGHTS::ContactModels;
    return model == COHESION_OFF || model == COHESION_SJKR || model == COHESION_SJKR2;
  }

  // Returns the energy [J]. Its sign is the sign of the cohesive force `pull` [N].
  double of(const Contact& contact, double pull) const {
    using namespace LIGGGHTS::ContactModels;
    if (pull == 0) return 0;
    // The area of sjkr2 is proportional to the overlap, so the energy is half of force times
    // overlap.
    if (model_ == COHESION_SJKR2) return 0.5 * pull * contact.deltan;
    return pull * integral(contact) / area(contact);
  }

 private:
  // Returns the area of sjkr divided by pi: the circle in which two spheres, or a sphere and a
  // plane, intersect [m2].
  static double area(const Contact& contact) {
    const double overlap = contact.deltan, r = contact.r;
    if (contact.is_wall) return overlap * (contact.radi + r);
    const double sum = contact.radi + contact.radj, difference = contact.radi - contact.radj;
    return overlap * (sum + r) * (r * r - difference * difference) / (4 * r * r);
  }

  // Returns the integral of the area over the overlap from first touch [m3]. For two spheres, the
  // antiderivative over the distance r is (r^3/3 - (s^2 + d^2) r - s^2 d^2 / r) / 4, with sum s and
  // difference d of the radii. The code evaluates its difference from r = s in a form without
  // cancellation.
  static double integral(const Contact& contact) {
    const double overlap = contact.deltan, r = contact.r;
    if (contact.is_wall) return overlap * overlap * (contact.radi - overlap / 3);
    const double sum = contact.radi + contact.radj, difference = contact.radi - contact.radj;
    return overlap * overlap * ((sum - overlap / 3) - difference * difference / r) / 4;
  }

  int model_;
};

}  // namespace plastigran

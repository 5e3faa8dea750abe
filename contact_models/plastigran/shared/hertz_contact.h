// SPDX-License-Identifier: GPL-2.0-or-later
//
// Hertz contact, which most laws follow up to yield. Source and equations: laws/hertz.h.
#pragma once

#include <cmath>

#include "plastigran/shared/contact.h"
#include "plastigran/shared/device.h"

namespace plastigran {

// Returns the response of a Hertz contact at a positive overlap; `modulus` is 4/3 E* [Pa].
PLASTIGRAN_DEVICE inline Response hertz_response(double modulus, double radius_eff,
                                                 double overlap) {
  Response response;
  response.contact_radius = std::sqrt(radius_eff * overlap);
  response.force = modulus * response.contact_radius * overlap;
  response.elastic_energy = 0.4 * response.force * overlap;
  return response;
}

}  // namespace plastigran

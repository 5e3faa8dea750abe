// SPDX-License-Identifier: GPL-2.0-or-later
//
// Kernels that call every normal and tangential law. The host builds the tables of the laws; the
// device reads them. `./run lint` compiles this file with clang for the device, without generating
// code.
#include "device_stubs.h"
// Include the stubs before the laws.
#include "all_laws.h"
#include "plastigran/friction/incremental.h"
#include "plastigran/friction/partial_slip.h"
#include "plastigran/tables/adhesive.h"

namespace plastigran {

template <class Law>
__global__ void force_loop(const Law table, const double* radius, const double* overlap,
                           typename Law::State* states, Response* responses, int count) {
  for (int k = 0; k < count; ++k) {
    typename Law::State state = states[k];
    responses[k] = respond(table, radius[k], overlap[k], state, 0);
    states[k] = state;
  }
}

template <class Law>
__global__ void friction_loop(const Law law, const NormalLoad* loads,
                              const TangentialMotion* motions, typename Law::State* states,
                              TangentialResponse* responses, int count) {
  for (int k = 0; k < count; ++k) responses[k] = law.respond(loads[k], motions[k], states[k]);
}

template <class... Laws>
void every_law() {
  (static_cast<void>(&force_loop<Laws>), ...);
}
void instances() {
  every_law<ALL_LAWS, Adhesive<Thornton>, Adhesive<Universal>, Adhesive<KogutEtsion>>();
  static_cast<void>(&friction_loop<Incremental>);
  static_cast<void>(&friction_loop<PartialSlip<>>);
}

}  // namespace plastigran

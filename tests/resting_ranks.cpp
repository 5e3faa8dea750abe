// SPDX-License-Identifier: GPL-2.0-or-later
//
// A sched_yield that sleeps, for the tests. With OMPI_MCA_mpi_yield_when_idle=1, ranks that wait
// call sched_yield. The kernel's version gives the core away for a whole time slice: four ranks on
// two busy cores then wait thirty times as long as they compute. The kernel wakes a rank that
// sleeps before those that compute.
#include <sched.h>
#include <time.h>
#include <unistd.h>

#include <cstdlib>

namespace {

double seconds() {
  timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec + 1e-9 * now.tv_nsec;
}

// How long a wait is spent awake [s]: no time where another rank waits for this core.
double awake() {
  const char* ranks = std::getenv("OMPI_COMM_WORLD_LOCAL_SIZE");
  return ranks && std::atol(ranks) <= sysconf(_SC_NPROCESSORS_ONLN) ? 5e-5 : 0;
}

}  // namespace

extern "C" int sched_yield() noexcept {
  static const double patience = awake();
  static double begun = 0, last = 0;  // of the present wait, of this call
  const double now = seconds();
  if (now - last > 5e-6) begun = now;  // something came in between
  last = now;
  if (now - begun < patience) return 0;
  const timespec shortest{0, 1};  // some 50 us: the kernel's slack
  nanosleep(&shortest, nullptr);
  last = seconds();
  return 0;
}

// SPDX-License-Identifier: GPL-2.0-or-later
//
// Replaces sched_yield in the tests by a function that sleeps. With the settings of conftest.py,
// waiting ranks of Open MPI and of MPICH call sched_yield. The kernel's own function gives the core
// away for a whole time slice. Four ranks on two busy cores then wait thirty times as long as they
// compute. A sleeping rank wakes up earlier, because the kernel prefers it to computing ranks.
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

// Returns how long a waiting rank stays awake [s]; 0 if there are more ranks than cores.
double awake() {
  const char* ranks = std::getenv("OMPI_COMM_WORLD_LOCAL_SIZE");
  if (!ranks) ranks = std::getenv("MPI_LOCALNRANKS");  // MPICH
  return ranks && std::atol(ranks) <= sysconf(_SC_NPROCESSORS_ONLN) ? 5e-5 : 0;
}

}  // namespace

extern "C" int sched_yield() noexcept {
  static const double patience = awake();
  static double begun = 0, last = 0;  // begin of the current wait; time of the last call
  const double now = seconds();
  if (now - last > 5e-6) begun = now;  // a new wait
  last = now;
  if (now - begun < patience) return 0;
  const timespec shortest{0, 1};  // the kernel makes it about 50 us
  nanosleep(&shortest, nullptr);
  last = seconds();
  return 0;
}

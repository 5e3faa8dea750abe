// SPDX-License-Identifier: GPL-2.0-or-later
//
// Ranks that outnumber the cores rest while they wait. Open MPI has them call sched_yield then,
// which gives the core to whoever else wants it for a whole slice of time: beside other processes,
// a run of four ranks on two cores waits thirty times as long as it computes. One that sleeps is
// woken ahead of those that compute; this one's sched_yield is the one the MPI library finds.
#include <sched.h>
#include <time.h>

extern "C" int sched_yield() noexcept {
  const timespec shortest{0, 1};  // some 50 us: the kernel's slack
  nanosleep(&shortest, nullptr);
  return 0;
}

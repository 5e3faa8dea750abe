// SPDX-License-Identifier: GPL-2.0-or-later
//
// Prints the restitution of a steel ball of 5 mm radius on a rigid plane for three impact speeds.
#include <cstdio>

#include "plastigran/impact/central_impact.h"
#include "plastigran/laws/universal.h"

int main() {
  const double radius = 5e-3, pi = 3.141592653589793;                // m
  const double mass = 4 * pi / 3 * radius * radius * radius * 7850;  // kg
  const plastigran::Body steel{2.1e11, 0.3, 3e8}, rigid{1e30, 0.3, 1e30};
  const plastigran::Universal law(plastigran::combine(steel, rigid), {});

  std::printf("speed,coefficient_of_restitution\n");
  for (const double speed : {0.01, 0.1, 1.0}) {
    const auto impact = plastigran::central_impact(law, radius, mass, speed);
    std::printf("%g,%.12g\n", speed, impact.coefficient_of_restitution);
  }
}

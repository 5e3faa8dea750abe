// SPDX-License-Identifier: GPL-2.0-or-later
//
// Numerical integration, maximization and root finding for the laws.
#pragma once

#include <cstdint>
#include <cstring>

#include "plastigran/shared/device.h"

namespace plastigran {

// Returns the cube root of x >= 0 for the force loop, with a relative error of 1e-14 unless x is
// subnormal. The start value has a third of the exponent and an error below 4 %; each step of
// Halley's method cubes the error.
PLASTIGRAN_DEVICE inline double cube_root(double x) {
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  bits = bits / 3 + 0x2A9F7893782DA1CE;
  double root;
  std::memcpy(&root, &bits, sizeof root);
  for (int k = 0; k < 2; ++k) {
    const double cube = root * root * root;
    root *= (cube + 2 * x) / (2 * cube + x);
  }
  return root;
}

// Returns the integral of f from left to right by Gauss-Legendre quadrature with 12 points.
template <class Function>
PLASTIGRAN_DEVICE double gauss_legendre(const Function& f, double left, double right) {
  constexpr double node[6] = {0.1252334085114689, 0.3678314989981802, 0.5873179542866175,
                              0.7699026741943047, 0.9041172563704749, 0.9815606342467192};
  constexpr double weight[6] = {0.2491470458134028, 0.2334925365383548, 0.2031674267230659,
                                0.1600783285433462, 0.1069393259953184, 0.0471753363865118};
  const double half = 0.5 * (right - left), middle = left + half;
  double sum = 0;
  for (int i = 0; i < 6; ++i)
    sum += half * weight[i] * (f(middle - half * node[i]) + f(middle + half * node[i]));
  return sum;
}

// Returns the position of the only maximum of f between left and right, by golden section search.
// Each step shortens the interval by the factor 0.618.
template <class Function>
double golden_section(const Function& f, double left, double right, int steps) {
  const double golden = 0.6180339887498949;
  for (int i = 0; i < steps; ++i) {
    const double width = golden * (right - left);
    if (f(right - width) > f(left + width))
      right = left + width;
    else
      left = right - width;
  }
  return 0.5 * (left + right);
}

// Bisects the interval [low, high] until its ends are adjacent floating-point numbers. The
// condition `holds` must be false at low and true at high.
template <class Condition>
void halve(double& low, double& high, const Condition& holds) {
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    if (middle == low || middle == high) return;
    (holds(middle) ? high : low) = middle;
  }
}

}  // namespace plastigran

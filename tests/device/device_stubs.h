// SPDX-License-Identifier: GPL-2.0-or-later
//
// Declarations of CUDA headers that the laws need, for a syntax check by clang without CUDA.
// Include this file before the standard headers, so that their `using` declarations find these
// functions.
#pragma once

#define __host__ __attribute__((host))
#define __device__ __attribute__((device))
#define __global__ __attribute__((global))

extern "C" {
__device__ void* malloc(__SIZE_TYPE__);
__device__ void free(void*);
__device__ double acos(double);
__device__ double cbrt(double);
__device__ double cos(double);
__device__ double cosh(double);
__device__ double exp(double);
__device__ double expm1(double);
__device__ double hypot(double, double);
__device__ double log(double);
__device__ double pow(double, double);
__device__ double sin(double);
__device__ double sqrt(double);
__device__ void* memcpy(void*, const void*, __SIZE_TYPE__);
}

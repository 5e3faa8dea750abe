// SPDX-License-Identifier: GPL-2.0-or-later
//
// Macro that marks functions called in the force loop. GPU compilers compile these functions for
// the device, too.
#pragma once

#if defined(__CUDACC__) || defined(__HIPCC__) || defined(__CUDA__)
#define PLASTIGRAN_DEVICE __host__ __device__
#else
#define PLASTIGRAN_DEVICE
#endif

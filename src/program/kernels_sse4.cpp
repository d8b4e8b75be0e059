// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#define BALCONY_KERNEL kernel_sse4
#include "program/kernels.inl"

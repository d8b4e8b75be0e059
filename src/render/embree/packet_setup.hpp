// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "render/embree/accelerator.hpp"

namespace balcony::render::embree {

/// The least size of a direction component that is not lost, less than the rounding error of the
/// other components of a unit direction: Embree's coherent packets lose rays with a component of
/// nearly 0, whose reciprocal is out of range for the bounds of a packet.
inline constexpr float min_component = 1e-8F;

/// Prepares packets for Embree: no ray has hit anything yet, and components of directions are at
/// least min_component. A ray that Embree does not accept, or that starts beyond `reach`, becomes
/// one of negative length, which Embree skips.
void prepare(std::span<Packet> packets, float reach);

}  // namespace balcony::render::embree

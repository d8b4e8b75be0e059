// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <stop_token>

#include <Imath/ImathBox.h>
#include <Imath/ImathVec.h>

#include "balcony/scene.hpp"
#include "render/probe/viewer.hpp"

namespace balcony::render {

/// A place outside of an object from which most of it is seen, if possible from in front of it and
/// slightly above. The box of the object and the place have z up.
[[nodiscard]] Imath::V3d place_before(const scene::Scene& scene, const Viewer& viewer,
                                      std::uint32_t object, const Imath::Box3d& box,
                                      const std::stop_token& stop);

}  // namespace balcony::render

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What clear glass shows, for the layers by which a picture is denoised. A path is mirrored or
// passes by chance; a surface that changes from sample to sample would be as noisy as its light.

#include "render/tracing/scene_tracer.hpp"

namespace balcony::render {

/// The mean of what clear glass mirrors and of what is behind it, by their parts of the light. Of
/// glass behind glass, the one of them with the larger part. Its albedo counts by the part, too.
[[nodiscard]] VisibleSurface shown_by_glass(const SceneTracer& tracer, const DifferentialRay& ray,
                                            const Interaction& at);

}  // namespace balcony::render

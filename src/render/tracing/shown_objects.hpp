// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the rays of a camera layer may meet first.

#include <optional>
#include <vector>

#include "balcony/picture.hpp"
#include "balcony/rays.hpp"
#include "render/tracing/scene_tracer.hpp"

namespace balcony::render {

/// The objects of a layer, before any reflection or refraction.
struct ShownObjects {
    std::optional<embree::Accelerator> some{};  ///< Nothing if all are shown.
    bool environment = true;

    /// As SceneTracer::nearest() expects it.
    [[nodiscard]] const embree::Accelerator* only() const { return some ? &*some : nullptr; }
};

/// Those that a filter leaves.
[[nodiscard]] Result<ShownObjects> shown_by(const camera::ObjectFilter& filter,
                                            const TracedScene& traced);

/// What the camera layers of a picture show, from back to front.
[[nodiscard]] Result<std::vector<ShownObjects>> shown_objects(const rays::CompiledPicture& picture,
                                                              const TracedScene& traced);

}  // namespace balcony::render

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the rays of a camera layer may meet first.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "balcony/picture.hpp"
#include "balcony/rays.hpp"
#include "render/tracing/scene_tracer.hpp"

namespace balcony::render {

/// The objects of a layer, before any reflection or refraction.
struct ShownObjects {
    std::optional<embree::Accelerator> some{};  ///< Nothing if all are shown.
    std::vector<std::uint8_t> instances{};      ///< Of these; 0 for one that is not shown.
    bool environment = true;

    [[nodiscard]] bool shows(std::size_t instance) const {
        return !some || instances[instance] != 0;
    }
    /// What rays of the layer are traced in.
    [[nodiscard]] const embree::Accelerator& in(const TracedScene& traced) const {
        return some ? *some : traced.accelerator;
    }
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

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// gsplat: the argument `rays` of rasterization(), of the shape [C, H, W, 6], in the world.

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "dataset/layouts/camera_rays.hpp"
#include "dataset/layouts/layout.hpp"

namespace balcony::dataset {

namespace {

std::string gsplat_misfit(const PlannedCamera& camera) {
    constexpr std::array<std::size_t, 2> small{8, 8};
    constexpr double parallel = 1e-12;
    const auto rays = camera_rays(camera.picture, small, Axes::z_up, 0.0);
    const bool spread = rays && std::any_of(rays->spreads.begin(), rays->spreads.end(),
                                            [](double one) { return one > parallel; });
    return spread ? "" : "pictures of one camera whose rays spread";
}

std::vector<std::string> gsplat_frame_files(const Plan& plan, const Frame& frame) {
    return {fmt::format("{}/gsplat/{}.npy", plan.scenes[frame.scene].name, frame.name)};
}

Result<std::vector<std::string>> gsplat_frame_bytes(const FrameData& data) {
    const auto& size = data.camera().size;
    const auto rays =
        camera_rays(data.picture, size, data.scene().axes, data.plan.recipe.picture.settings.time);
    if (!rays) {
        return rays.diagnostics;
    }
    std::vector<float> numbers;
    numbers.reserve(6 * rays->origins.size());
    for (std::size_t i = 0; i < rays->origins.size(); ++i) {
        for (const V3d& v : {rays->origins[i], rays->spreads[i] * rays->directions[i]}) {
            numbers.insert(numbers.end(), {static_cast<float>(v.x), static_cast<float>(v.y),
                                           static_cast<float>(v.z)});
        }
    }
    return std::vector{npy_bytes({1, size[1], size[0], 6}, std::span<const float>(numbers))};
}

}  // namespace

Layout gsplat_layout() {
    return {.info = {"gsplat", "rays of gsplat: origin, and direction times spread"},
            .misfit = gsplat_misfit,
            .frame_files = gsplat_frame_files,
            .frame_bytes = gsplat_frame_bytes};
}

}  // namespace balcony::dataset

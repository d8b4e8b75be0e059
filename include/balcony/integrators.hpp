// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Integrators: methods to compute the radiance along a ray, and the settings of each.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace balcony::render {

struct IntegratorInfo {
    std::string_view name;     ///< The name for users.
    std::string_view meaning;  ///< A short description.
};

/// All integrators.
[[nodiscard]] std::span<const IntegratorInfo> integrators();

/// The largest number of times that the light of a path is scattered on its way to the camera,
/// besides the lamp's own illumination of the last surface: in all, and by each kind of surface.
/// 0 is direct light alone.
struct BounceLimits {
    static constexpr std::size_t most = 128;  ///< The largest limit.

    std::size_t all = most;
    std::size_t diffuse = most;
    std::size_t glossy = most;
    std::size_t transmission = most;
};

/// How `path` finds the light of lamps with an extent. All give the same mean; each method alone
/// is noisy where the other is not.
enum class LampSampling : std::uint8_t {
    both,      ///< Multiple importance sampling.
    lamps,     ///< By directions to the lamps.
    surfaces,  ///< By directions that a surface scatters light to.
};

/// Settings of `path`.
struct PathSettings {
    BounceLimits bounces{};
    LampSampling lamp_sampling = LampSampling::both;
    /// Groups of eight nearby pixels share the light that their paths find, with less noise
    /// in the same time and the same mean. Otherwise each pixel is independent of the others.
    bool reuse = true;
    /// Before the picture, rays find where the light of environments and suns enters the rooms that
    /// it shows, so that this light is sampled there, with less noise and the same mean.
    bool probes_windows = true;
    /// Before the picture, paths find the parts of surfaces that lamps light most, such as a patch
    /// of sun, so that others are sent there, with less noise and the same mean.
    bool probes_patches = true;
    /// Otherwise, bright specks are kept down: mirrors and glass that are seen by light which a
    /// surface has scattered are blurred, less from pass to pass; and what a path finds at once of
    /// indirect light is limited, less from pass to pass, to a multiple of the light around.
    bool exact = false;
    /// The largest contribution of indirect light to a sample, in each channel; 0 is no limit. A
    /// limit removes bright specks, and with them some of the light.
    float clamp_indirect = 0.0F;
};

/// Settings of `direct`.
struct DirectSettings {
    std::size_t mirror_depth = 8;  ///< The maximum number of reflections.
};

}  // namespace balcony::render

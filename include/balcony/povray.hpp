// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// POV-Ray: renders scenes in POV-Ray's own language through any picture of cameras, with POV-Ray
// 3.7 as a program of its own. docs/povray.md describes the method.
//
//     find_povray() ─▶ render_with_povray(program, scene, picture, settings, film) ─▶ film

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/film.hpp"
#include "balcony/picture.hpp"
#include "balcony/render.hpp"

namespace balcony::bridge {

/// POV-Ray on this machine.
struct PovrayProgram {
    std::filesystem::path file;
    std::string version;  ///< "3.7.0.10.unofficial"
};

/// Looks for POV-Ray 3.7 in the folders of PATH. A missing program, and one of another version, are
/// errors whose remedy names the Debian package.
[[nodiscard]] Result<PovrayProgram> find_povray();

/// How the axes of a scene lie.
struct PovrayAxes {
    std::string_view name;     ///< The name for users.
    std::string_view meaning;  ///< One line for documentation.
};

[[nodiscard]] std::span<const PovrayAxes> povray_axes();

struct PovraySettings {
    std::size_t samples = 16;   ///< Rays per pixel. They are evenly spread over its square.
    std::uint32_t seed = 0;     ///< Of the points of a lens.
    double time = 0.0;          ///< Seconds: t in the camera's formulas, and POV-Ray's clock.
    std::string axes = "y_up";  ///< The name of the scene's axes.
    bool unclipped = false;     ///< Keep light brighter than white, which display files cut off.
    std::vector<std::string> options{};  ///< Further options for POV-Ray, such as "+Q9".
};

struct PovraySummary {
    /// Those of POV-Ray have the places in the scene's own files. An error of Kind::input is about
    /// the scene, the picture or an option; of Kind::environment, about the program, the disk, or
    /// what POV-Ray may read.
    Diagnostics diagnostics;
    bool interrupted = false;       ///< Stopped on request.
    std::size_t runs = 0;           ///< How often POV-Ray was started.
    std::uint64_t camera_rays = 0;  ///< One for each sample of a layer where there is a ray.
    /// Of these, the rays that are given one by one. The others are interpolated in cells.
    std::uint64_t single_rays = 0;
    std::uint64_t faces = 0;     ///< Of the meshes that give the rays to POV-Ray.
    double largest_error = 0.0;  ///< Of the interpolated rays, in pixels.
    double camera_seconds = 0.0;
    double povray_seconds = 0.0;
};

/// The tolerated difference between an interpolated ray and the exact one, in pixels.
inline constexpr double povray_tolerance = 0.05;

/// Adds `samples` passes to an empty film that covers the whole picture. POV-Ray runs in the
/// scene's folder and reads a copy of the scene, in a temporary folder, whose last camera is that
/// of Balcony. When a stop is requested, POV-Ray is ended; the film contains the complete passes.
[[nodiscard]] PovraySummary render_with_povray(const PovrayProgram& program,
                                               const std::filesystem::path& scene,
                                               const camera::Picture& picture,
                                               const PovraySettings& settings, render::Film& film,
                                               const render::ProgressCallback& progress = {},
                                               std::stop_token stop = {});

}  // namespace balcony::bridge

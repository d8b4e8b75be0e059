// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "balcony/render.hpp"
#include "cli/options/common_options.hpp"
#include "cli/options/crop_options.hpp"
#include "cli/options/film_options.hpp"
#include "cli/options/fit_options.hpp"
#include "cli/options/integrator_options.hpp"
#include "cli/options/job_options.hpp"
#include "cli/options/light_options.hpp"
#include "cli/options/sampling_options.hpp"
#include "cli/options/shutter_options.hpp"
#include "cli/options/stereo_options.hpp"
#include "cli/options/texture_options.hpp"

namespace balcony::cli {

/// The arguments of `balcony render`.
struct RenderOptions {
    std::vector<std::string> scenes;
    std::vector<std::string> add;
    std::string camera;
    std::optional<std::string> output;
    SizeWords size;
    CropWords crop;
    SamplingWords sampling;
    LightWords light;
    JobWords job;
    std::vector<std::string> set;
    FitWords fit;
    IntegratorWords integrator;
    std::string background = "auto";
    std::string threads = "0";
    std::string time = "0";
    ShutterWords shutter;
    StereoWords stereo;
    std::string exposure = "auto";
    std::string ambient = "auto";
    std::string view = std::string(render::view_transforms()[render::ViewTransform::neutral].name);
    FilmOptions film;
    TextureWords textures;
    bool watch = false;
    bool quiet = false;
    bool json = false;
    const CLI::App* command = nullptr;  ///< With the options as they were written.
};

/// Adds the options of what is rendered, and through which camera.
void add_scene_options(CLI::App& command, RenderOptions& options);
/// Adds the options of what a picture looks like: its size and part, its light and its colours.
void add_picture_options(CLI::App& command, RenderOptions& options);
/// Adds the options of how the command runs and reports.
void add_run_options(CLI::App& command, RenderOptions& options);

/// A picture as the options ask for it, but for its scene and its output; what cannot be read is
/// added to `diagnostics`, each with its option.
[[nodiscard]] app::Request read_request(const RenderOptions& options, Diagnostics& diagnostics);

}  // namespace balcony::cli

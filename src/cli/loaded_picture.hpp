// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a picture is rendered from.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "balcony/lang.hpp"
#include "balcony/render.hpp"
#include "cli/picture_run.hpp"
#include "cli/report/render_report.hpp"

namespace balcony::cli {

/// What remains loaded from one picture to the next.
struct Loaded {
    lang::Workspace cameras;
    std::shared_ptr<scene::Scene> scene;
    std::optional<render::Renderer> renderer;
    scene::TimeInterval times{};                       ///< Of the renderer's rays.
    double load_seconds = 0.0;                         ///< To read the scene.
    std::vector<std::filesystem::path> environment{};  ///< Its file, if there is one.

    /// The files that the picture depends on.
    [[nodiscard]] std::vector<std::filesystem::path> files() const {
        std::vector<std::filesystem::path> all = cameras.files();
        all.insert(all.end(), scene->files.begin(), scene->files.end());
        all.insert(all.end(), environment.begin(), environment.end());
        return all;
    }
};

/// Reads the scene, unless that is done. False if it fails, as the report says.
[[nodiscard]] bool read_scene(const std::string& name, const Request& request, Loaded& loaded,
                              RenderReport& outcome);

/// Reads the scene and prepares it for the times of the picture's rays, unless that is done. False
/// if it fails, as the report says. Without a picture, for the time that the shutter is open.
[[nodiscard]] bool load(const std::string& name, const Request& request,
                        const std::optional<camera::Picture>& picture, Loaded& loaded,
                        RenderReport& outcome);

/// The camera that the options name, or that of the scene, and the scene, both loaded and prepared.
/// Nothing if that fails, as the report says.
[[nodiscard]] std::optional<camera::Picture> load_all(const RenderOptions& options,
                                                      const Request& request,
                                                      const std::string& scene, Loaded& loaded,
                                                      RenderReport& outcome);

/// Prepares a scene that was moved for the rays of a picture at another time. False if it fails, as
/// the report says.
[[nodiscard]] bool move_along(const render::Settings& settings, const camera::Picture& picture,
                              Loaded& loaded, RenderReport& outcome);

/// The film that a picture needs. A picture for the display has no layers.
[[nodiscard]] render::FilmLayout film_layout(const Request& request, const camera::Picture& picture,
                                             bool is_displayed);

/// Adds to the report of a picture how long it took to read and prepare the scene.
void describe_preparation(RenderReport& report, const Loaded& loaded);

}  // namespace balcony::cli

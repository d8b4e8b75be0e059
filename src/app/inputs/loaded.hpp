// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a picture is rendered from.

#include <filesystem>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/inputs/file_watch.hpp"
#include "balcony/app.hpp"
#include "balcony/lang.hpp"
#include "balcony/render.hpp"
#include "balcony/request.hpp"

namespace balcony::app {

/// An environment that is a file, as it was read.
struct EnvironmentFile {
    std::filesystem::path file;
    FileWatch watch;
    render::Environment environment;
};

/// What remains loaded from one picture to the next.
struct Loaded {
    lang::Workspace cameras;
    std::shared_ptr<const scene::Scene> scene;
    std::optional<render::Renderer> renderer;
    std::shared_ptr<const scene::Scene> traced{};        ///< That of the renderer.
    scene::TimeInterval times{};                         ///< Of the renderer's rays.
    double load_seconds = 0.0;                           ///< To read the scene.
    render::Settings settings{};                         ///< With an environment that is a file.
    std::optional<std::filesystem::path> environment{};  ///< The file of the settings, if any.
    std::vector<EnvironmentFile> environments{};         ///< The last two that were read.
    std::vector<std::filesystem::path> marks{};          ///< The file of Request::solve, if any.
    FileWatch::Time since{};                             ///< Before the first file was read.

    /// The files that the picture depends on.
    [[nodiscard]] std::vector<std::filesystem::path> files() const;
};

/// The same scene and settings, with a workspace of its own.
[[nodiscard]] Loaded shared(const Loaded& loaded);

/// The settings of a request, with its environment, whose file is read again only if it has
/// changed. False if that fails, as the diagnostics say.
[[nodiscard]] bool load_settings(const Request& request, Loaded& loaded,
                                 const std::stop_token& stop, Diagnostics& found);

/// The camera that a request names, or that of the scene, and the scene, both loaded and prepared
/// for the times of the picture's rays, as far as that is not done. Nothing if that fails or is
/// stopped, as the diagnostics say.
[[nodiscard]] std::optional<camera::Picture> load_all(const Request& request, Loaded& loaded,
                                                      const Observer& observer,
                                                      const std::stop_token& stop,
                                                      Diagnostics& found);

/// The scene alone, prepared for the time that the shutter is open. False if that fails or is
/// stopped, as the diagnostics say.
[[nodiscard]] bool load_scene_of(const Request& request, Loaded& loaded, const Observer& observer,
                                 const std::stop_token& stop, Diagnostics& found);

/// Prepares the scene, which was moved or edited, for the rays of a picture, or without one for the
/// time that the shutter is open, as far as that is not done. False if it fails, as the diagnostics
/// say.
[[nodiscard]] bool move_along(const std::optional<camera::Picture>& picture, Loaded& loaded,
                              const std::stop_token& stop, Diagnostics& found);

/// Adds the lamps of a request to a scene, and gives it the unit of the request.
void complete(scene::Scene& scene, const Request& request);

/// The film that a picture needs. A picture for the display has no layers.
[[nodiscard]] render::FilmLayout film_layout(const Request& request, const camera::Picture& picture,
                                             bool is_displayed);

}  // namespace balcony::app

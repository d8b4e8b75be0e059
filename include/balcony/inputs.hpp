// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Inputs: the scenes and cameras that a program names, why a camera sees nothing of them, and that
// no output replaces them.

#include <cstdint>
#include <filesystem>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/inverse.hpp"
#include "balcony/lang.hpp"
#include "balcony/probe.hpp"
#include "balcony/render.hpp"
#include "balcony/scene.hpp"

namespace balcony::app {

// ------------------------------------------------------------------------------------- cameras

/// The file of a camera given as FILE, FILE:NAME or the name of a built-in camera.
[[nodiscard]] std::filesystem::path camera_file(const std::string& camera);

/// Whether a camera is given as scene:NAME, or scene: for the first camera of the scene.
[[nodiscard]] bool is_of_scene(const std::string& camera);

/// The camera of a scene of such a name.
[[nodiscard]] Result<const scene::Camera*> camera_of(const scene::Scene& scene,
                                                     const std::string& camera);

/// A selected camera, with values for its parameters.
struct CameraArgument {
    std::filesystem::path file;
    std::string name;  ///< Empty for the file's last camera.
    std::vector<lang::Override> overrides;
};

/// Reads FILE[:NAME] and values of parameters, each NAME=VALUE.
[[nodiscard]] Result<CameraArgument> read_camera(const std::string& camera,
                                                 const std::vector<std::string>& set);

/// Makes the selected picture, with values of its parameters, each NAME=VALUE; a camera becomes a
/// picture with one layer.
[[nodiscard]] Result<camera::Picture> load_picture(const std::string& picture,
                                                   const std::vector<std::string>& set,
                                                   const std::stop_token& stop = {});
[[nodiscard]] Result<camera::Picture> load_picture(const std::string& picture,
                                                   const std::vector<std::string>& set,
                                                   lang::Workspace& workspace);
/// The same with a scene, whose cameras can be selected.
[[nodiscard]] Result<camera::Picture> load_picture(const std::string& picture,
                                                   const std::vector<std::string>& set,
                                                   const scene::Scene& scene,
                                                   const std::stop_token& stop = {});

/// The picture of a camera of a scene with these axes.
[[nodiscard]] Result<camera::Picture> picture_of(const scene::Camera& camera, Axes axes);

/// That of the default camera: the first of the scene, or else that of its renderer.
[[nodiscard]] Result<camera::Picture> default_picture(const scene::Scene& scene,
                                                      const render::Renderer& renderer,
                                                      const std::stop_token& stop = {});

// -------------------------------------------------------------------------------------- scenes

/// Whether a file name has the extension of a scene.
[[nodiscard]] bool is_scene_file(std::string_view name);

/// Loads a scene as it stands at a time in seconds, with what other files add to it. A camera in
/// its place gives a specific error. A stop is an error of Kind::interrupted.
[[nodiscard]] Result<scene::Scene> load_scene(const std::string& name, double time = 0.0,
                                              const std::vector<std::string>& added = {},
                                              const PartDone& progress = {},
                                              const std::stop_token& stop = {},
                                              scene::LoadOptions options = {});

// ---------------------------------------------------------------------------------- explaining

/// Whether all rays start outside the scene.
[[nodiscard]] bool starts_outside(const render::Miss& miss);

/// Why the rays of a camera meet nothing or hardly anything, as far as it can be known, and what
/// may help.
struct MissText {
    std::string reason;
    std::string remedy;
};

[[nodiscard]] MissText miss_text(const render::Miss& miss, const camera::Camera& camera);

/// An object in which rays of a camera start.
struct StartInside {
    std::string object;
    std::uint32_t index = 0;     ///< Into Scene::objects.
    double share = 0.0;          ///< The fraction of the rays.
    Imath::V2d point{0.0};       ///< An example of a position in the probed picture, in pixels.
    bool is_around_all = false;  ///< All rays start in it, so it is probably a room.
    bool is_room = false;        ///< It is around all, and other objects are seen.
};

[[nodiscard]] std::vector<StartInside> starts_inside(const render::Probe& probe,
                                                     const scene::Scene& scene);

/// A request to locate points.
struct PointSearch {
    const camera::Picture& picture;
    double width = 0.0;
    double height = 0.0;
    double time = 0.0;
    Axes axes = Axes::z_up;  ///< Of the points.
    std::span<const analyse::V3d> points;
};

/// "y up" or "z up".
[[nodiscard]] std::string_view axes_text(Axes axes);

/// Why none of the points is in the picture, if that is known: they would be in it with the other
/// axes, or they all lie behind the camera.
[[nodiscard]] Diagnostics explain_unseen(const PointSearch& search,
                                         const std::stop_token& stop = {});

// ------------------------------------------------------------------------------------- outputs

/// An error of Kind::usage if an output is one of the files that are read, even under another name
/// or through a link. `option` is the one that names the output.
[[nodiscard]] Diagnostics check_overwrites(const std::filesystem::path& output,
                                           std::span<const std::filesystem::path> inputs,
                                           std::string_view option = "--output");

}  // namespace balcony::app

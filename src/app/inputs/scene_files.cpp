// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/inputs.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "balcony/lang.hpp"
#include "balcony/motion.hpp"

namespace balcony::app {

bool is_scene_file(std::string_view name) {
    const auto extensions = scene::file_extensions();
    return std::any_of(extensions.begin(), extensions.end(),
                       [name](std::string_view extension) { return name.ends_with(extension); });
}

Result<scene::Scene> load_scene(const std::string& name, double time,
                                const std::vector<std::string>& added, const PartDone& progress,
                                const std::stop_token& stop, scene::LoadOptions options) {
    const auto& built_in = lang::built_in_cameras();
    std::error_code ignored;
    const bool is_built_in = std::find(built_in.begin(), built_in.end(), name) != built_in.end() &&
                             !std::filesystem::exists(name, ignored);
    if (is_built_in || name.ends_with(".cam")) {
        return error(
            fmt::format("'{}' is a camera, not a scene", name), {},
            fmt::format("give a scene, and this camera with --camera {0}; balcony list {0} lists "
                        "the cameras in the file, balcony explain {0} describes one",
                        name));
    }
    const double share = 1.0 / static_cast<double>(1 + added.size());
    Result<scene::Scene> scene = scene::load(name, part_of(progress, 0.0, share), stop, options);
    options.is_addition = true;
    double done = share;
    for (const std::string& file : added) {
        Result<scene::Scene> part =
            scene::load(file, part_of(progress, done, done + share), stop, options);
        done += share;
        std::move(part.diagnostics.begin(), part.diagnostics.end(),
                  std::back_inserter(scene.diagnostics));
        if (!part) {
            return std::move(scene.diagnostics);
        }
        if (scene) {
            scene::add_scene(*scene, std::move(*part));
        }
    }
    if (!scene) {
        return scene;
    }
    Result<scene::Scene> moved = scene::moved_to(std::move(*scene), time);
    moved.diagnostics.insert(moved.diagnostics.begin(), scene.diagnostics.begin(),
                             scene.diagnostics.end());
    return moved;
}

}  // namespace balcony::app

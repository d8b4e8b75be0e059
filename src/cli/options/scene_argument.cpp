// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/options/scene_argument.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "balcony/lang.hpp"

namespace balcony::cli {

Result<scene::Scene> load_scene(const std::string& name) {
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
    return scene::load(name);
}

}  // namespace balcony::cli

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A data set as another program reads it. A layout has a file here and a row in layouts.cpp.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/dataset.hpp"
#include "dataset/frames/frame_data.hpp"

namespace balcony::dataset {

/// A file of a layout: its name in the folder of the data set, and its bytes.
struct LayoutFile {
    std::string file;
    std::string bytes;
};

struct Layout {
    LayoutInfo info;
    /// Layers of the data set that the files refer to.
    std::vector<std::string_view> layers{};
    /// What is wrong with a camera, after "layout ... ": "takes pinholes"; empty if nothing is.
    std::string (*misfit)(const PlannedCamera& camera) = [](const PlannedCamera&) {
        return std::string();
    };
    /// What is wrong with the cameras together.
    Diagnostics (*check)(const Plan& plan) = [](const Plan&) { return Diagnostics(); };
    /// What follows from the plan alone.
    std::vector<LayoutFile> (*files)(const Plan& plan) = [](const Plan&) {
        return std::vector<LayoutFile>();
    };
    /// The names of what each frame adds, and its bytes in the same order.
    std::vector<std::string> (*frame_files)(const Plan& plan, const Frame& frame) =
        [](const Plan&, const Frame&) { return std::vector<std::string>(); };
    Result<std::vector<std::string>> (*frame_bytes)(const FrameData& data) = [](const FrameData&) {
        return Result<std::vector<std::string>>(std::vector<std::string>());
    };
};

/// One of layouts().
[[nodiscard]] const Layout& layout_of(std::string_view name);
[[nodiscard]] Diagnostics check_layout(const Layout& layout, const PlannedCamera& camera);

/// Adds the layers that the layouts of a recipe refer to.
void add_layers_of_layouts(Recipe& recipe);

/// Where the lens of a camera stands in a frame.
[[nodiscard]] camera::Pose lens_pose(const Plan& plan, const Frame& frame);

[[nodiscard]] Layout nerfstudio_layout();
[[nodiscard]] Layout colmap_layout();
[[nodiscard]] Layout kitti360_layout();
[[nodiscard]] Layout gsplat_layout();
[[nodiscard]] Layout threedgrt_layout();
[[nodiscard]] Layout mapanything_layout();

}  // namespace balcony::dataset

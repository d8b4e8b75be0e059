// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cassert>
#include <utility>

#include <fmt/format.h>

#include "balcony/names.hpp"
#include "dataset/layouts/layout.hpp"

namespace balcony::dataset {

namespace {

const std::vector<Layout>& all_layouts() {
    static const std::vector<Layout> rows{nerfstudio_layout(), colmap_layout(),
                                          kitti360_layout(),   gsplat_layout(),
                                          threedgrt_layout(),  mapanything_layout()};
    return rows;
}

}  // namespace

std::span<const LayoutInfo> layouts() {
    static const std::vector<LayoutInfo> infos = [] {
        std::vector<LayoutInfo> made;
        for (const Layout& one : all_layouts()) {
            made.push_back(one.info);
        }
        return made;
    }();
    return infos;
}

const Layout& layout_of(std::string_view name) {
    const auto& all = all_layouts();
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const Layout& one) { return one.info.name == name; });
    assert(found != all.end());
    return *found;
}

Diagnostics check_layout(const Layout& layout, const PlannedCamera& camera) {
    const std::string misfit = layout.misfit(camera);
    if (misfit.empty()) {
        return {};
    }
    std::vector<std::string> others;
    for (const Layout& one : all_layouts()) {
        if (one.misfit(camera).empty()) {
            others.emplace_back(one.info.name);
        }
    }
    return {error(Kind::usage,
                  fmt::format("the layout {} cannot have the camera '{}': it takes {}",
                              layout.info.name, camera.name, misfit),
                  others.empty() ? "" : fmt::format("{} can", one_of(others)))};
}

void add_layers_of_layouts(Recipe& recipe) {
    const std::vector<std::string> given = std::exchange(recipe.layers, {});
    for (const LayerInfo& layer : layers()) {
        const auto is_used = [&](const std::string& name) {
            const auto& used = layout_of(name).layers;
            return std::find(used.begin(), used.end(), layer.name) != used.end();
        };
        if (std::find(given.begin(), given.end(), layer.name) != given.end() ||
            std::any_of(recipe.layouts.begin(), recipe.layouts.end(), is_used)) {
            recipe.layers.emplace_back(layer.name);
        }
    }
}

camera::Pose lens_pose(const Plan& plan, const Frame& frame) {
    const auto& lens = plan.camera_of(frame).lens;
    return app::combined(plan.pose_of(frame).pose, lens ? lens->in_camera : camera::Pose{});
}

}  // namespace balcony::dataset

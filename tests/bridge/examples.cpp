// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "examples.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "../laws/built_in_cameras.hpp"
#include "balcony/catalogue.hpp"
#include "balcony/lang.hpp"
#include "balcony/ray_difference.hpp"
#include "bridge/text/camera_formulas.hpp"

namespace balcony::bridge::test {

namespace {

bool is_picture(std::string_view text) {
    return text.starts_with("picture ") || text.find("\npicture ") != std::string_view::npos;
}

// The camera under another name.
Example renamed(std::string name, std::string shown, bool of_stage, const camera::Camera& camera) {
    std::replace(name.begin(), name.end(), ' ', '_');
    std::replace(name.begin(), name.end(), '-', '_');
    camera::Camera::Parts parts = camera.parts();
    parts.name = name;
    return {name, *camera::Camera::make(std::move(parts)).value, std::move(shown), of_stage};
}

std::vector<Example> all_examples() {
    std::vector<Example> made;
    const auto add = [&made](const std::string& name, std::string shown, bool of_stage,
                             const lang::CameraSource& source) {
        const auto camera = lang::make_camera(source, "");
        if (camera && !camera->parts().bend) {  // No exporter takes bent rays.
            made.push_back(renamed(name, std::move(shown), of_stage, *camera));
        }
    };
    for (const camera::StageEntry& row : camera::catalogue()) {
        if (!is_picture(row.example)) {
            add(fmt::format("{}_{}", name_of(row.kind), row.name),
                fmt::format("`{}`, {}", row.name, name_of(row.kind)), true,
                std::make_shared<const SourceText>("example", std::string(row.example)));
        }
    }
    for (const std::string& name : laws::single_built_in_cameras()) {
        add("built_in_" + name, fmt::format("built-in `{}`", name), false, name);
    }
    const std::filesystem::path plates = std::filesystem::path(BALCONY_SOURCE_DIR) / "plates";
    std::vector<std::filesystem::path> folders;
    for (const auto& folder : std::filesystem::directory_iterator(plates)) {
        if (std::filesystem::exists(folder.path() / "camera.cam")) {
            folders.push_back(folder.path());
        }
    }
    std::sort(folders.begin(), folders.end());
    for (const std::filesystem::path& folder : folders) {
        const std::string name = folder.filename().string();
        add("plate_" + name, fmt::format("plate `{}`", name), false, folder / "camera.cam");
    }
    return made;
}

}  // namespace

const std::vector<Example>& examples() {
    static const std::vector<Example> all = all_examples();
    return all;
}

bool has_formulas(const Example& example) {
    return formulas_of(example.camera, {"c", example.camera.parts().axes}).value.has_value();
}

std::vector<PicturePoint> points() {
    constexpr double step = 10.0;
    std::vector<PicturePoint> made;
    for (double y = 0.5 * step; y < height; y += step) {
        for (double x = 0.5 * step; x < width; x += step) {
            // Off the axes of symmetry, where poles and seams are.
            made.push_back({x + 0.3, y - 0.2});
        }
    }
    return made;
}

Comparison compare(const Example& example, const std::vector<ExportedRay>& exported) {
    const auto program = rays::compile(example.camera, width, height,
                                       {.footprints = true, .tiles = false, .points = true});
    std::vector<double> x;
    std::vector<double> y;
    for (const PicturePoint& point : points()) {
        x.push_back(point.x);
        y.push_back(point.y);
    }
    rays::Scratch scratch;
    rays::RayBatch batch;
    program->run({.x = x, .y = y}, scratch, batch);
    Comparison made{.rays = exported.size()};
    for (std::size_t i = 0; i < exported.size(); ++i) {
        const rays::Ray exact = batch[i];
        if (exact.valid != exported[i].valid) {
            ++made.lost;
        }
        if (!exact.valid || !exported[i].valid) {
            continue;
        }
        const auto& [origin, direction, valid] = exported[i];
        rays::Ray other = exact;
        other.origin = {origin[0], origin[1], origin[2]};
        other.direction = {direction[0], direction[1], direction[2]};
        made.largest = std::max(made.largest, rays::pixels_between(exact, other, 10.0));
    }
    return made;
}

}  // namespace balcony::bridge::test

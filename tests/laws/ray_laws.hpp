// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What holds for the rays of every camera and every layer of every picture, checked in a picture
// of 4 x 4 pixels.

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "balcony/rays.hpp"

namespace balcony::laws {

inline constexpr std::size_t side = 4;
inline const rays::Tile tile{.width = side, .height = side};

inline bool is_finite(const rays::V3d& vector) {
    return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

/// The law that a ray breaks; empty if it breaks none.
inline std::string broken_law(const rays::RayBatch& rays) {
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!rays.valid(i)) {
            continue;
        }
        if (!is_finite(rays.origin(i)) || !is_finite(rays.direction(i))) {
            return "a valid ray is not finite";
        }
        // Rounding alone; the products and sums that a renderer relies on are some 1e-15 off.
        if (!(std::abs(rays.direction(i).length() - 1.0) < 1e-9)) {
            return "a valid direction is not of unit length";
        }
    }
    return {};
}

/// The law that the rays of a program break over the picture.
inline std::string broken_law(const rays::RayProgram& program) {
    rays::Scratch scratch;
    rays::RayBatch batch;
    program.run(tile, scratch, batch);
    return broken_law(batch);
}

/// The law that a camera by itself breaks. A camera too large to be compiled breaks none.
inline std::string broken_law(const camera::Camera& camera) {
    const Result<rays::RayProgram> compiled = rays::compile(camera, side, side, {});
    if (!compiled) {
        return has_errors(compiled.diagnostics) ? "" : "neither rays nor an error";
    }
    return broken_law(*compiled);
}

/// The law that a picture breaks, in the rays of its layers or in what shows of them.
inline std::string broken_law(const camera::Picture& picture) {
    const Result<rays::CompiledPicture> compiled = rays::compile(picture, side, side, {});
    if (!compiled) {
        return has_errors(compiled.diagnostics) ? "" : "neither a picture nor an error";
    }
    for (const rays::CompiledPicture::CameraLayer& layer : compiled->layers()) {
        if (std::string broken = broken_law(layer.rays); !broken.empty()) {
            return "layer " + layer.name + ": " + broken;
        }
    }
    const std::size_t count = compiled->coverage_count();
    if (count == 0) {
        return {};
    }
    std::vector<std::array<double, side * side>> values(count);
    std::vector<double*> results;
    for (auto& row : values) {
        results.push_back(row.data());
    }
    rays::Scratch scratch;
    compiled->run_coverages(tile, scratch, results);
    std::vector<const rays::CompiledPicture::Element*> pending;
    for (const auto& element : compiled->elements()) {
        pending.push_back(&element);
    }
    while (!pending.empty()) {
        const rays::CompiledPicture::Element& element = *pending.back();
        pending.pop_back();
        for (const auto& part : element.group) {
            pending.push_back(&part);
        }
        if (!element.coverage) {
            continue;
        }
        for (const double coverage : values[*element.coverage]) {
            if (!std::isnan(coverage) && !(coverage >= 0.0 && coverage <= 1.0)) {
                return "a coverage is outside 0 .. 1";
            }
        }
    }
    return {};
}

}  // namespace balcony::laws

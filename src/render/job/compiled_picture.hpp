// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A picture as programs: one for all coverages and paints, one for the rays of each camera layer.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "balcony/picture.hpp"
#include "balcony/program.hpp"

namespace balcony::render {

struct CompiledPicture {
    /// What is drawn, in the order of drawing: a camera layer, a paint or a group.
    struct Element {
        camera::BlendMode blend = camera::BlendMode::normal;
        std::optional<std::size_t> coverage;  ///< Root of `coverages`; 1 everywhere without.
        std::optional<std::size_t> layer;     ///< Index into `layers`.
        std::optional<std::size_t> paint;     ///< The first of three roots of `coverages`.
        std::vector<Element> group;
    };
    struct CameraLayer {
        std::string name;
        program::Program rays;
    };

    std::vector<Element> elements;
    std::vector<CameraLayer> layers;
    std::optional<program::Program> coverages;
    bool footprints = false;  ///< The rays' programs have them.

    /// One camera that covers everything.
    [[nodiscard]] bool single() const {
        return elements.size() == 1 && elements.front().layer && !coverages;
    }
};

[[nodiscard]] CompiledPicture compile_picture(const camera::Picture& picture, Axes scene_axes,
                                              std::size_t width, std::size_t height,
                                              bool footprints);

}  // namespace balcony::render

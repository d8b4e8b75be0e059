// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "render/job/blend.hpp"
#include "render/job/depth_order.hpp"
#include "render/job/picture_rays.hpp"

namespace balcony::render {

/// Composites all elements of a picture at a point of a tile, from back to front.
class PointBlender {
public:
    /// The layers are what was drawn, by camera layer, or empty if one is invisible; the depths as
    /// DepthOrder has them.
    PointBlender(const TileCoverages& coverages, const std::vector<std::vector<Drawn>>& layers,
                 const std::vector<std::vector<double>>& depths)
        : coverages_(coverages), layers_(layers), order_(depths) {}

    [[nodiscard]] Drawn operator()(const std::vector<rays::CompiledPicture::Element>& elements,
                                   std::size_t i) {
        Blend blend;
        for (const rays::CompiledPicture::Element& element : elements) {
            add(element, i, blend);
        }
        return blend.all;
    }

private:
    struct Blend {
        Drawn all;
        bool over_nothing = true;
    };

    void add(const rays::CompiledPicture::Element& element, std::size_t i, Blend& blend) {
        const float part = coverages_.coverage(element, i);
        if (part <= 0.0F) {
            return;
        }
        const bool hides = part >= 1.0F && element.blend == camera::BlendMode::normal;
        blend.all = blend.over_nothing && hides
                        ? source(element, i)
                        : composed(blend.all, source(element, i), part, element.blend);
        blend.over_nothing = false;
    }

    [[nodiscard]] Drawn by_depth(const std::vector<rays::CompiledPicture::Element>& group,
                                 std::size_t i) {
        Blend blend;
        for (const rays::CompiledPicture::Element* const element : order_.at(group, i)) {
            add(*element, i, blend);
        }
        return blend.all;
    }

    [[nodiscard]] Drawn source(const rays::CompiledPicture::Element& element, std::size_t i) {
        const Drawn own = contents(element, i);
        return element.channels ? with_channels(own, *element.channels) : own;
    }

    [[nodiscard]] Drawn contents(const rays::CompiledPicture::Element& element, std::size_t i) {
        if (element.compositing == camera::Compositing::depth) {
            return by_depth(element.group, i);
        }
        if (!element.group.empty()) {
            return (*this)(element.group, i);
        }
        if (element.paint) {
            return {Color4f(0.0F), coverages_.paint(*element.paint, i), Color4f(0.0F), 1.0F};
        }
        const std::vector<Drawn>& layer = layers_[*element.layer];
        return layer.empty() ? Drawn{} : layer[i];
    }

    const TileCoverages& coverages_;
    const std::vector<std::vector<Drawn>>& layers_;
    DepthOrder order_;
};

/// Whether there are any paints among the elements, such as frames and leader lines.
[[nodiscard]] inline bool paints(const std::vector<rays::CompiledPicture::Element>& elements) {
    return std::any_of(elements.begin(), elements.end(),
                       [](const auto& element) { return element.paint || paints(element.group); });
}

}  // namespace balcony::render

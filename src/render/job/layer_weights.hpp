// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "render/job/blend.hpp"
#include "render/job/depth_order.hpp"
#include "render/job/picture_rays.hpp"

namespace balcony::render {

/// The weights of the camera layers at the points of a tile, as in blend mode normal: the coverage
/// of a layer times the part that nothing in front covers.
class LayerWeights {
public:
    /// The layers are what was drawn, by camera layer, or empty if one is invisible; the depths as
    /// DepthOrder has them.
    LayerWeights(const TileCoverages& coverages, const std::vector<std::vector<Drawn>>& layers,
                 const std::vector<std::vector<double>>& depths)
        : coverages_(coverages), layers_(layers), order_(depths) {}

    /// Calls visit(layer, weight) for the camera layers that contribute to point i, from front to
    /// back.
    template <class Visit>
    void at(const std::vector<rays::CompiledPicture::Element>& elements, std::size_t i,
            const Visit& visit) {
        uncovered(elements, i, 1.0F, visit);
    }

private:
    // Returns the part that the elements leave uncovered.
    template <class Visit>
    float uncovered(const std::vector<rays::CompiledPicture::Element>& elements, std::size_t i,
                    float scale, const Visit& visit) {
        float rest = 1.0F;
        for (auto element = elements.rbegin(); element != elements.rend() && rest > 0.0F;
             ++element) {
            rest *= uncovered(*element, i, scale * rest, visit);
        }
        return rest;
    }

    // The same for layers that are composited by depth.
    template <class Visit>
    float uncovered_by_depth(const std::vector<rays::CompiledPicture::Element>& group,
                             std::size_t i, float scale, const Visit& visit) {
        float rest = 1.0F;
        const auto order = order_.at(group, i);
        for (auto element = order.rbegin(); element != order.rend() && rest > 0.0F; ++element) {
            rest *= uncovered(**element, i, scale * rest, visit);
        }
        return rest;
    }

    template <class Visit>
    float uncovered(const rays::CompiledPicture::Element& element, std::size_t i, float scale,
                    const Visit& visit) {
        const float part = coverages_.coverage(element, i);
        if (part <= 0.0F) {
            return 1.0F;
        }
        float presence = 1.0F;  // Of a paint.
        if (element.compositing == camera::Compositing::depth) {
            presence = 1.0F - uncovered_by_depth(element.group, i, scale * part, visit);
        } else if (!element.group.empty()) {
            presence = 1.0F - uncovered(element.group, i, scale * part, visit);
        } else if (element.layer) {
            const std::vector<Drawn>& drawn = layers_[*element.layer];
            presence = drawn.empty() ? 0.0F : drawn[i].presence;
            if (presence > 0.0F) {
                visit(*element.layer, scale * part);
            }
        }
        return 1.0F - part * presence;
    }

    const TileCoverages& coverages_;
    const std::vector<std::vector<Drawn>>& layers_;
    DepthOrder order_;
};

}  // namespace balcony::render

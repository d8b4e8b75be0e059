// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/shading/transport.hpp"

#include <algorithm>
#include <numbers>

#include "render/shading/microfacets.hpp"

namespace balcony::render {

namespace {

// The smallest cosine that the quadrature can see from.
constexpr float grazing = 1e-6F;

// Calls visit(facet, part) with the facets that a viewer in the plane y = 0 sees, and the part of
// them that each stands for. Half of the facets, since the other half is their mirror image. The
// midpoint rule, closer where facets are steep: their tail decides how much light is lost.
template <typename Visit>
void for_visible_facets(const Ggx& layer, const V3f& to_viewer, Visit visit) {
    constexpr std::size_t count = 24;
    const auto midpoint = [](std::size_t i) {
        return (static_cast<float>(i) + 0.5F) / static_cast<float>(count);
    };
    for (std::size_t row = 0; row < count; ++row) {
        const float rest = 1.0F - midpoint(row);
        const float part = 2.0F * rest / (count * count);
        for (std::size_t column = 0; column < count; ++column) {
            visit(layer.sample_visible(to_viewer, 0.5F * midpoint(column), 1.0F - square(rest)),
                  part);
        }
    }
}

}  // namespace

const ByCosine& table_cosines() {
    static const ByCosine cosines = [] {
        ByCosine found{};
        for (std::size_t node = 0; node < cosine_count; ++node) {
            found[node] =
                square(square(static_cast<float>(node) / static_cast<float>(cosine_count - 1)));
        }
        return found;
    }();
    return cosines;
}

const ByCosine& cosine_weights() {
    static const ByCosine weights = [] {
        constexpr std::size_t steps = 4096;
        ByCosine found{};
        for (std::size_t step = 0; step < steps; ++step) {
            // Equal parts of the squared cosine are equal parts of the mean.
            const float cosine = std::sqrt((static_cast<float>(step) + 0.5F) / steps);
            const TablePosition at = position_of_cosine(cosine);
            found[at.node] += (1.0F - at.fraction) / steps;
            found[at.node + 1] += at.fraction / steps;
        }
        return found;
    }();
    return weights;
}

float cosine_mean(const ByCosine& function) {
    float mean = 0.0F;
    for (std::size_t node = 0; node < cosine_count; ++node) {
        mean += cosine_weights()[node] * function[node];
    }
    return mean;
}

void Transport::add(std::size_t viewer, float light, float part) {
    const TablePosition at = position_of_cosine(light);
    float* const row = &entries_[viewer * cosine_count];
    row[at.node] += (1.0F - at.fraction) * part;
    row[at.node + 1] += at.fraction * part;
}

float Transport::operator()(std::size_t viewer, const ByCosine& light) const {
    const float* const row = &entries_[viewer * cosine_count];
    float total = 0.0F;
    for (std::size_t node = 0; node < cosine_count; ++node) {
        total += row[node] * light[node];
    }
    return total;
}

GgxTransport ggx_transport(float alpha) {
    const Ggx layer(alpha);
    GgxTransport found;
    for (std::size_t row = 0; row < cosine_count; ++row) {
        const float viewer = std::max(table_cosines()[row], grazing);
        const float viewer_slant = layer.slant(viewer);
        const V3f to_viewer(std::sqrt(std::max(1.0F - square(viewer), 0.0F)), 0.0F, viewer);
        for_visible_facets(layer, to_viewer, [&](const V3f& facet, float part) {
            const float cosine = to_viewer.dot(facet);
            const float light = std::min(2.0F * cosine * facet.z - viewer, 1.0F);
            if (light <= 0.0F) {
                return;
            }
            const float seen = Ggx::visible(viewer, viewer_slant);
            const float lit =
                4.0F * light * Ggx::masking(viewer, viewer_slant, light, layer.slant(light));
            found.reflected.add(row, light, part * lit / seen);
            found.edge.add(row, light, part * lit / seen * schlick(cosine));
        });
    }
    return found;
}

ByCosine balance(const Transport& transport, const ByCosine& target) {
    // Each step halves the error, at least.
    constexpr int steps = 16;
    ByCosine scale;
    scale.fill(1.0F);
    for (int step = 0; step < steps; ++step) {
        const ByCosine before = scale;
        for (std::size_t row = 0; row < cosine_count; ++row) {
            scale[row] = std::sqrt(before[row] * target[row] / transport(row, before));
        }
    }
    return scale;
}

}  // namespace balcony::render

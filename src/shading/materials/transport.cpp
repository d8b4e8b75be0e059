// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "shading/materials/transport.hpp"

#include <algorithm>
#include <numbers>

#include "shading/materials/microfacets.hpp"

namespace balcony::render {

namespace {

// The smallest cosine that the quadrature can see from.
constexpr float grazing = 1e-6F;

// A facet that a viewer sees.
struct VisibleFacet {
    const Ggx& layer;
    float viewer;  // The viewer's cosine with the surface,
    float slant;   // and Ggx::slant() of it.
    V3f normal;
    float cosine;  // The viewer's with the facet.
    float part;    // Of all facets that the viewer sees.

    // The part of the light that goes this way without meeting other facets.
    [[nodiscard]] float unmasked(float light) const {
        return 4.0F * light * Ggx::masking(viewer, slant, light, layer.slant(light)) /
               Ggx::visible(viewer, slant);
    }
};

// Calls visit(row, facet) with the facets that the viewer sees from the cosine of each row. Half of
// the facets, since the other half is their mirror image. The midpoint rule, closer where facets
// are steep: their tail decides how much light is lost.
template <typename Visit>
void for_paths(const Ggx& layer, std::size_t count, Visit visit) {
    const auto midpoint = [count](std::size_t i) {
        return (static_cast<float>(i) + 0.5F) / static_cast<float>(count);
    };
    for (std::size_t node = 0; node < cosine_count; ++node) {
        const float viewer = std::max(table_cosines()[node], grazing);
        const V3f to_viewer(std::sqrt(std::max(1.0F - square(viewer), 0.0F)), 0.0F, viewer);
        const float slant = layer.slant(viewer);
        for (std::size_t row = 0; row < count; ++row) {
            const float rest = 1.0F - midpoint(row);
            const float part = 2.0F * rest / static_cast<float>(count * count);
            for (std::size_t column = 0; column < count; ++column) {
                const V3f facet = layer.visible_facet(to_viewer, on_circle(0.5F * midpoint(column)),
                                                      1.0F - square(rest));
                visit(node, VisibleFacet{layer, viewer, slant, facet, to_viewer.dot(facet), part});
            }
        }
    }
}

}  // namespace

float table_width(std::size_t row, std::size_t count) {
    const float first = std::sqrt(std::sqrt(min_alpha));
    const float fraction = static_cast<float>(row) / static_cast<float>(count - 1);
    return std::max(square(square(mix(first, 1.0F, fraction))), min_alpha);
}

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

void Transport::add(std::size_t viewer, const TablePosition& at, float part) {
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
    GgxTransport found;
    constexpr std::size_t count = 24;
    for_paths(Ggx(alpha), count, [&found](std::size_t row, const VisibleFacet& facet) {
        const float light = 2.0F * facet.cosine * facet.normal.z - facet.viewer;
        if (light > 0.0F) {
            const TablePosition at = position_of_cosine(light);
            const float part = facet.part * facet.unmasked(light);
            found.reflected.add(row, at, part);
            found.edge.add(row, at, part * schlick(facet.cosine));
        }
    });
    return found;
}

GlassTransport glass_transport(float alpha, float eta) {
    GlassTransport found;
    // Total reflection begins at an angle that the rule must resolve.
    constexpr std::size_t count = 40;
    for_paths(Ggx(alpha), count, [&](std::size_t row, const VisibleFacet& facet) {
        const float reflectance = fresnel(facet.cosine, eta);
        const float mirrored = 2.0F * facet.cosine * facet.normal.z - facet.viewer;
        if (mirrored > 0.0F) {
            found.reflected.add(row, position_of_cosine(mirrored),
                                facet.part * reflectance * facet.unmasked(mirrored));
        }
        if (reflectance < 1.0F) {
            const float light =
                facet.viewer / eta - refraction_shift(facet.cosine, eta) * facet.normal.z;
            if (light > 0.0F) {
                found.refracted.add(row, position_of_cosine(light),
                                    facet.part * (1.0F - reflectance) * facet.unmasked(light));
            }
        }
    });
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

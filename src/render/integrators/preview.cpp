// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The base colour, lit from the ray's origin.

#include <cmath>

#include "render/integrators/ray_tree.hpp"

namespace balcony::render {

namespace {

class Preview final : public RayTree {
public:
    using RayTree::RayTree;

private:
    [[nodiscard]] Shaded shade(const Ray& ray, const Interaction& at) const override {
        const float cosine = std::abs(at.surface.normal.dot(ray.direction));
        return {at.appearance.emission, Color3f(0.0F), cosine * at.appearance.base_color};
    }
};

}  // namespace

std::unique_ptr<Integrator> make_preview(const TracedScene& traced, const Settings& settings) {
    return std::make_unique<Preview>(traced, settings);
}

}  // namespace balcony::render

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/knot/knot.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "common/meshes.hpp"
#include "common/scene_builder.hpp"
#include "common/solids.hpp"

namespace balcony::plates {

namespace {

using scene::Color3f;
using scene::Material;

constexpr double knot_height = 9.0;

// A curve on a torus that winds `around` times round its axis and `through` times round its tube.
std::vector<V3d> torus_knot(int around, int through, double major, double minor) {
    std::vector<V3d> path;
    constexpr int steps = 480;
    for (int k = 0; k < steps; ++k) {
        const double t = 2.0 * std::numbers::pi * k / steps;
        const double r = major + minor * std::cos(through * t);
        path.emplace_back(r * std::cos(around * t), minor * std::sin(through * t) * 1.15,
                          r * std::sin(around * t));
    }
    return path;
}

Color bands(const Sample& sample) {
    static const Gradient colors({0x0d3b66, 0x1b998b, 0xf4d35e, 0xee964b, 0xd1495b, 0x6a2c70},
                                 true);
    return colors(0.5 * (sample.point.x / 64.0 + 1.0));
}

class Sculpture {
public:
    explicit Sculpture(const SceneOptions& options) : builder_("knot", options) {}

    Result<scene::Scene> build() && {
        builder_.place("ground", builder_.mesh("ground", rectangle(900, 900),
                                               builder_.material("ground", tint(0xa9a49c), 0.55F)));
        Material lacquer;
        lacquer.name = "lacquer";
        lacquer.base_color = Color3f(1.0F);
        lacquer.base_color_texture.index = builder_.texture("bands", 512, 8, bands);
        lacquer.roughness = 0.35F;
        lacquer.clearcoat = 1.0F;
        lacquer.clearcoat_roughness = 0.03F;
        const M44d raised = M44d().setTranslation(V3d(0, 0, knot_height));
        builder_.place("knot",
                       builder_.mesh("knot", tube(torus_knot(2, 3, 4.6, 2.2), 1.25, true, 40),
                                     builder_.material(lacquer)),
                       raised);
        Material gold;
        gold.name = "gold";
        gold.base_color = tint(0xe0b050);
        gold.metallic = 1.0F;
        gold.roughness = 0.2F;
        builder_.place("wire",
                       builder_.mesh("wire", tube(torus_knot(3, 11, 4.6, 4.0), 0.13, true, 16),
                                     builder_.material(gold)),
                       raised);
        const std::array<V2d, 6> plinth{V2d(3.6, 0.0), V2d(3.6, 0.4),  V2d(3.3, 0.55),
                                        V2d(3.2, 0.7), V2d(3.1, 0.75), V2d(0.0, 0.75)};
        builder_.place("plinth", builder_.mesh("plinth", lathe(plinth),
                                               builder_.material("marble", tint(0xe7e2d8), 0.25F)));
        return std::move(builder_).finish();
    }

private:
    SceneBuilder builder_;
};

}  // namespace

Result<scene::Scene> make_knot(const SceneOptions& options) { return Sculpture(options).build(); }

}  // namespace balcony::plates

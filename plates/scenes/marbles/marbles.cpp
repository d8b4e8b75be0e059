// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/marbles/marbles.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "common/meshes.hpp"
#include "common/scene_builder.hpp"
#include "common/solids.hpp"

namespace balcony::plates {

namespace {

using scene::Color3f;
using scene::Material;
using scene::MaterialIndex;
using scene::MeshIndex;

constexpr double tray_radius = 17.0;
constexpr int hues = 12;

struct Marble {
    V2d at;
    double radius;
};

// Marbles that do not overlap: places are tried in turn, large marbles first.
std::vector<Marble> scattered() {
    std::vector<Marble> marbles;
    for (int k = 0; k < 2600; ++k) {
        const double radius = k < 500 ? 1.7 : k < 1300 ? 1.15 : 0.75;
        const double distance = (tray_radius - radius) * std::sqrt(lattice_noise(k, 0, 71));
        const double angle = 2.0 * std::numbers::pi * lattice_noise(k, 1, 71);
        const Marble tried{V2d(std::cos(angle), std::sin(angle)) * distance, radius};
        bool free = true;
        for (const Marble& other : marbles) {
            const double gap = (other.at - tried.at).length2() + std::pow(other.radius - radius, 2);
            free = free && gap >= std::pow(other.radius + radius, 2);
        }
        if (free) {
            marbles.push_back(tried);
        }
    }
    return marbles;
}

class Marbles {
public:
    explicit Marbles(const SceneOptions& options) : builder_("marbles", options) {}

    Result<scene::Scene> build() && {
        add_table();
        add_marbles();
        return std::move(builder_).finish();
    }

private:
    void add_table() {
        builder_.place("table", builder_.mesh("table", rectangle(400, 400),
                                              builder_.material("slate", tint(0x39404a), 0.5F)));
        Material glass;
        glass.name = "window";
        glass.base_color = Color3f(0.0F);
        glass.emission = Color3f(11.0F, 10.2F, 9.0F);
        builder_.place(
            "window", builder_.mesh("window", rectangle(44, 44), builder_.material(glass)),
            M44d().setEulerAngles(V3d(0.6, 2.5, 0.0)) * M44d().setTranslation(V3d(-40, 32, 66)));
    }

    // Three kinds of a hue: lacquer, glass and metal.
    MaterialIndex marble_material(int hue, int kind) {
        static const Gradient wheel(
            {0xd8342a, 0xf08a24, 0xf6c945, 0x6fae3e, 0x1f8f86, 0x2a62b8, 0x5a3fa6, 0xb03a86}, true);
        const Color3f color(wheel(static_cast<double>(hue) / hues));
        Material material;
        material.name = fmt::format("marble {} {}", hue, kind);
        material.base_color = color;
        if (kind == 0) {
            material.roughness = 0.35F;
            material.clearcoat = 1.0F;
            material.clearcoat_roughness = 0.04F;
        } else if (kind == 1) {
            material.base_color = Color3f(1.0F);
            material.roughness = 0.0F;
            material.transmission = 1.0F;
            material.thin_walled = false;
            for (int channel = 0; channel < 3; ++channel) {
                material.absorption[channel] = -0.45F * std::log(0.04F + 0.96F * color[channel]);
            }
        } else {
            material.metallic = 1.0F;
            material.roughness = 0.18F;
        }
        return builder_.material(material);
    }

    void add_marbles() {
        const scene::Mesh ball = sphere(1.0, 56);
        std::vector<MeshIndex> balls;
        for (int k = 0; k < 3 * hues; ++k) {
            balls.push_back(
                builder_.mesh(fmt::format("marble {}", k), ball, marble_material(k / 3, k % 3)));
        }
        int number = 0;
        for (const Marble& marble : scattered()) {
            const double turn = std::atan2(marble.at.y, marble.at.x) / (2.0 * std::numbers::pi);
            const double strayed = turn + 0.09 * (lattice_noise(number, 2, 71) - 0.5) + 1.0;
            const int hue = static_cast<int>(std::floor(strayed * hues)) % hues;
            const int kind = static_cast<int>(3.0 * lattice_noise(number, 3, 71));
            builder_.place(fmt::format("marble {}", ++number), balls[std::size_t(3 * hue + kind)],
                           M44d().setScale(marble.radius) *
                               M44d().setTranslation(V3d(marble.at.x, marble.at.y, marble.radius)));
        }
    }

    SceneBuilder builder_;
};

}  // namespace

Result<scene::Scene> make_marbles(const SceneOptions& options) { return Marbles(options).build(); }

}  // namespace balcony::plates

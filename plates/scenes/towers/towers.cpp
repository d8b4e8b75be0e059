// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/towers/towers.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "common/meshes.hpp"
#include "common/scene_builder.hpp"

namespace balcony::plates {

namespace {

using scene::MeshIndex;

constexpr int reach = 13;  // Blocks from the middle to each side.
constexpr double pitch = 2.3;
constexpr double block = 1.9;
constexpr int colors = 12;

// Squares and streets stay low; elsewhere blocks rise towards the middle.
double height_at(int i, int j) {
    if (i % 5 == 0 || j % 5 == 0) {
        return 0.0;
    }
    const double distance = std::hypot(i, j) / reach;
    const double rise = std::exp(-3.0 * distance * distance);
    return 0.8 + 13.0 * rise * (0.25 + lattice_noise(i, j, 41)) + 2.2 * lattice_noise(i, j, 42);
}

class Towers {
public:
    explicit Towers(const SceneOptions& options) : builder_("towers", options) {}

    Result<scene::Scene> build() && {
        builder_.place("ground", builder_.mesh("ground", rectangle(800, 800),
                                               builder_.material("ground", tint(0xb8a98f), 0.9F)));
        const Gradient wash({0x24506b, 0x3d8c95, 0x9cc5a8, 0xf0dfb0, 0xeba05c, 0xc9543c, 0x7d2e46});
        std::vector<MeshIndex> blocks;
        for (int k = 0; k < colors; ++k) {
            blocks.push_back(
                builder_.mesh(fmt::format("block {}", k), chamfered_cube(1.0, 0.035),
                              builder_.material(fmt::format("wash {}", k),
                                                scene::Color3f(wash((k + 0.5) / colors)), 0.6F)));
        }
        for (int i = -reach; i <= reach; ++i) {
            for (int j = -reach; j <= reach; ++j) {
                const double height = height_at(i, j);
                if (height == 0.0) {
                    continue;
                }
                const double shade =
                    std::clamp(height / 13.0 + 0.35 * (lattice_noise(i, j, 43) - 0.4), 0.0, 0.999);
                builder_.place(fmt::format("block {} {}", i, j),
                               blocks[static_cast<std::size_t>(shade * colors)],
                               M44d().setScale(V3d(block, block, height)) *
                                   M44d().setTranslation(V3d(i * pitch, j * pitch, height / 2)));
            }
        }
        return std::move(builder_).finish();
    }

private:
    SceneBuilder builder_;
};

}  // namespace

Result<scene::Scene> make_towers(const SceneOptions& options) { return Towers(options).build(); }

}  // namespace balcony::plates

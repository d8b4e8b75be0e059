// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/vase/vase.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "common/meshes.hpp"
#include "common/scene_builder.hpp"
#include "common/solids.hpp"
#include "scenes/vase/vase_painting.hpp"

namespace balcony::plates {

namespace {

using scene::Color3f;
using scene::Material;

// The painted surface from the foot to the lip: (radius, height). The camera of plate 18 follows
// the same curve.
constexpr std::array<std::array<double, 2>, 13> profile{{{0.46, 0.40},
                                                         {0.60, 0.62},
                                                         {0.93, 1.05},
                                                         {1.22, 1.55},
                                                         {1.41, 2.10},
                                                         {1.48, 2.65},
                                                         {1.42, 3.15},
                                                         {1.20, 3.55},
                                                         {0.88, 3.82},
                                                         {0.62, 4.02},
                                                         {0.53, 4.30},
                                                         {0.53, 4.62},
                                                         {0.60, 4.90}}};
constexpr double painted_radius = 1.45;  // Where the painting has its own scale.
constexpr int pixels_round = 2560;

Path painted_profile() {
    Path points;
    for (const auto& [radius, height] : profile) {
        points.emplace_back(radius, height);
    }
    return smooth_path(points);
}

double length_of(const Path& path) {
    double length = 0.0;
    for (std::size_t i = 1; i < path.size(); ++i) {
        length += (path[i] - path[i - 1]).length();
    }
    return length;
}

// Noise that joins itself after a length, as a grid to look it up in.
class NoiseRound {
public:
    NoiseRound(double length, double height, const V2d& scale, std::uint32_t seed)
        : rows_(static_cast<int>(height / length * columns) + 2), cell_(length / columns) {
        for (int row = 0; row < rows_; ++row) {
            for (int column = 0; column < columns; ++column) {
                const V2d at = V2d(column, row) * cell_;
                values_.push_back(std::lerp(fractal_noise(at * scale, 4, seed),
                                            fractal_noise((at - V2d(length, 0.0)) * scale, 4, seed),
                                            at.x / length));
            }
        }
    }

    double operator()(const V2d& at) const {
        const V2d place = at / cell_;
        const int column = static_cast<int>(place.x);
        const int row = std::clamp(static_cast<int>(place.y), 0, rows_ - 2);
        const auto value = [&](int x, int y) {
            return values_[static_cast<std::size_t>(y * columns + x % columns)];
        };
        const double u = place.x - column;
        return std::lerp(std::lerp(value(column, row), value(column + 1, row), u),
                         std::lerp(value(column, row + 1), value(column + 1, row + 1), u),
                         place.y - row);
    }

private:
    static constexpr int columns = 512;
    int rows_;
    double cell_;
    std::vector<double> values_;
};

class VaseBuilder {
public:
    explicit VaseBuilder(const SceneOptions& options) : builder_("vase", options) {}

    Result<scene::Scene> build() {
        add_body();
        add_black_parts();
        add_surroundings();
        return std::move(builder_).finish();
    }

private:
    void add_body() {
        const Path outline = painted_profile();
        const double length = 2.0 * std::numbers::pi * painted_radius;
        const double height = length_of(outline);
        const int pixels_high = static_cast<int>(std::lround(pixels_round * height / length));
        const Drawing drawing =
            paint_vase(static_cast<int>(std::ceil(pixels_round * builder_.options().texture_scale)),
                       length, height);
        const auto place = [=](const Sample& sample) {
            const double aspect = static_cast<double>(pixels_round) / pixels_high;
            return V2d((sample.point.x / aspect + 1.0) / 2.0 * length,
                       (sample.point.y + 1.0) / 2.0 * height);
        };
        const NoiseRound kiln(length, height, V2d(0.9), 81);
        const NoiseRound brush(length, height, V2d(4.0, 12.0), 83);
        const Color glow = from_srgb(0x5a2a18);
        Material clay;
        clay.name = "painted clay";
        clay.base_color = Color3f(1.0F);
        clay.base_color_texture.index =
            builder_.texture("painting", pixels_round, pixels_high, [&](const Sample& sample) {
                // Fired clay is nowhere quite even, and slip is thin in places.
                const V2d at = place(sample);
                return drawing.at(at) * (1.0 + 0.22 * kiln(at) + 0.12 * brush(at)) +
                       glow * (0.05 * std::max(0.0, brush(at)));
            });
        // Slip has a gloss, clay next to none.
        clay.roughness_texture.index = builder_.texture(
            "gloss", pixels_round / 4, pixels_high / 4,
            [&](const Sample& sample) {
                const double light = drawing.at(place(sample)).x;
                return Color(0.3 + 0.45 * smooth_step(0.02, 0.25, light));
            },
            scene::Wrap::repeat, scene::TextureEncoding::linear);
        clay.roughness_texture.channel = 1;
        clay.specular = 0.5F;
        builder_.place("vase", builder_.mesh("vase", lathe(outline, 192), builder_.material(clay)));
    }

    void add_black_parts() {
        const auto slip = builder_.material("black slip", Color3f(vase_colors.slip), 0.3F);
        const std::vector<V2d> foot{{0.0, 0.0},   {0.74, 0.0},  {0.78, 0.03},
                                    {0.78, 0.15}, {0.75, 0.2},  {0.6, 0.25},
                                    {0.5, 0.31},  {0.46, 0.36}, {0.46, 0.41}};
        builder_.place("foot", builder_.mesh("foot", lathe(foot, 128), slip));
        const std::vector<V2d> lip{{0.59, 4.88}, {0.64, 4.95}, {0.78, 5.04}, {0.84, 5.1},
                                   {0.86, 5.18}, {0.84, 5.26}, {0.78, 5.28}, {0.72, 5.25},
                                   {0.6, 5.05},  {0.5, 4.8},   {0.45, 4.3},  {0.0, 4.2}};
        builder_.place("lip", builder_.mesh("lip", lathe(lip, 128), slip));
        for (const double side : {-1.0, 1.0}) {
            const std::vector<V2d> bend{{0.48, 4.58}, {0.72, 4.68}, {0.98, 4.64}, {1.14, 4.44},
                                        {1.2, 4.12},  {1.17, 3.8},  {1.08, 3.58}};
            std::vector<V3d> path;
            for (const V2d& at : smooth_path(bend)) {
                path.emplace_back(0.0, side * at.x, at.y);
            }
            const std::string name = side > 0.0 ? "handle left" : "handle right";
            builder_.place(name, builder_.mesh(name, tube(path, 0.115, false, 24), slip));
        }
    }

    // The visitor stands on the side of -x.
    void add_surroundings() {
        const auto stone = builder_.material("plinth", tint(0x2f2b28), 0.4F);
        builder_.place(
            "plinth", builder_.mesh("plinth", chamfered_cube(1.0, 0.01), stone),
            M44d().setScale(V3d(7.0, 60.0, 8.0)) * M44d().setTranslation(V3d(0.5, 0, -4.0)));
        const auto paint = builder_.material("wall", tint(0x5d6a70), 0.95F);
        builder_.place("wall", builder_.mesh("wall", rectangle(60.0, 40.0), paint),
                       M44d(0, -1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 0, 9.0, 0, 0, 1));
        constexpr int lamps = 8;
        for (int k = 0; k < lamps; ++k) {
            const double angle = 2.0 * std::numbers::pi * (k + 0.5) / lamps;
            scene::Light lamp;
            lamp.name = fmt::format("lamp {}", k + 1);
            lamp.kind = scene::LightKind::spot;
            lamp.position = V3d(5.6 * std::cos(angle), 5.6 * std::sin(angle), 7.5);
            lamp.direction = (V3d(0, 0, 2.2) - lamp.position).normalized();
            lamp.intensity = Color3f(1.0F, 0.9F, 0.77F) * 75.0F;
            lamp.inner_cone = 0.2F;
            lamp.outer_cone = 0.36F;
            builder_.light(lamp);
        }
        scene::Light halo;
        halo.name = "light of the wall";
        halo.kind = scene::LightKind::spot;
        halo.position = V3d(5.0, 0.0, 9.0);
        halo.direction = (V3d(9.0, 0.0, 3.0) - halo.position).normalized();
        halo.intensity = Color3f(1.0F, 0.9F, 0.77F) * 60.0F;
        halo.inner_cone = 0.1F;
        halo.outer_cone = 0.95F;
        builder_.light(halo);
    }

    SceneBuilder builder_;
};

}  // namespace

Result<scene::Scene> make_vase(const SceneOptions& options) { return VaseBuilder(options).build(); }

}  // namespace balcony::plates

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// A checker floor through a local zoom: its texture neither aliases where the camera shrinks it nor
// blurs where the camera swells it. The truth is the same floor made of black and white squares,
// with many samples.

#include <cmath>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "support.hpp"

namespace balcony::render::test::checker_floor_test {
namespace {

constexpr std::size_t width = 96;
constexpr std::size_t height = 64;
constexpr int squares = 64;  // Along each side of the floor.
constexpr float floor_side = 40.0F;
constexpr std::size_t many = 1024;

scene::Material glowing(float radiance) {
    scene::Material material = white();
    material.base_color = Color3f(0.0F);
    material.emission = Color3f(radiance);
    return material;
}

// A rectangle of the floor y = 0, in squares from its near left corner.
scene::Mesh part_of_floor(int x, int z, int side) {
    const float square = floor_side / squares;
    const auto length = static_cast<float>(side) * square;
    return parallelogram(
        {static_cast<float>(x) * square - 0.5F * floor_side, 0.0F, -static_cast<float>(z) * square},
        {length, 0.0F, 0.0F}, {0.0F, 0.0F, -length});
}

scene::Scene textured_floor() {
    constexpr int texels = 32;  // Of a square.
    scene::Scene scene;
    scene::Material material = glowing(1.0F);
    material.emission_texture.index = add_texture(
        scene, encode_png(texels * squares, texels * squares, 3, [](int x, int y) {
            const bool is_white = (x / texels + (texels * squares - 1 - y) / texels) % 2 == 0;
            return std::vector<std::uint8_t>(3, is_white ? 255 : 0);
        }));
    add(scene, part_of_floor(0, 0, squares), material);
    return scene;
}

scene::Scene floor_of_squares() {
    scene::Scene scene;
    scene::Mesh all;
    for (int i = 0; i < squares * squares; ++i) {
        const int x = i % squares;
        const int z = i / squares;
        if ((x + z) % 2 != 0) {
            continue;
        }
        const scene::Mesh one = part_of_floor(x, z, 1);
        const auto first = static_cast<std::uint32_t>(all.positions.size());
        all.positions.insert(all.positions.end(), one.positions.begin(), one.positions.end());
        for (const auto& corners : one.triangles) {
            all.triangles.push_back({first + corners[0], first + corners[1], first + corners[2]});
        }
    }
    add(scene, all, glowing(1.0F));
    return scene;
}

// A pinhole above the floor with a local zoom at (0, -0.3): the stage of the same name.
camera::Camera zoomed_camera() {
    const auto origin = [](const camera::ParameterPoint&, camera::Emitter& emit) {
        return camera::ObjectPoint{emit(0.0), emit(1.5), emit(0.0)};
    };
    const auto direction = [](const camera::ParameterPoint& p, camera::Emitter& emit) {
        constexpr double radius = 0.7;
        constexpr double strength = 4.0;
        const camera::Expr du = p.u;
        const camera::Expr dv = p.v + 0.3;
        const camera::Expr inside = max(1.0 - (du * du + dv * dv) / (radius * radius), emit(0.0));
        const camera::Expr pull = (1.0 - 1.0 / strength) * (inside * inside * inside);
        return camera::ObjectVector{1.2 * (p.u - pull * du), 0.8 * (p.v - pull * dv) - 0.35,
                                    emit(-1.0)};
    };
    return make_camera({origin, direction});
}

Film film_of(const scene::Scene& scene, std::size_t samples) {
    return render(scene, zoomed_camera(), request(width, height, "preview", samples)).film;
}

// The root mean square of the differences in a part of the picture.
double difference(const Film& a, const Film& b, const Region& part) {
    double sum = 0.0;
    for (std::size_t y = part.y; y < part.y + part.height; ++y) {
        for (std::size_t x = part.x; x < part.x + part.width; ++x) {
            const double d = static_cast<double>(a.pixel(x, y).r - b.pixel(x, y).r);
            sum += d * d;
        }
    }
    return std::sqrt(sum / static_cast<double>(part.size()));
}

TEST(CheckerFloor, IsFilteredWhereItShrinksAndSharpWhereItSwells) {
    const Region far_away{0, 20, width, 8};
    const Region swollen{40, 34, 16, 16};
    const scene::Scene squares_only = floor_of_squares();
    const scene::Scene textured = textured_floor();
    const Film truth = film_of(squares_only, many);
    for (const std::size_t few : {1U, 4U}) {
        const Film filtered = film_of(textured, few);
        const Film unfiltered = film_of(squares_only, few);
        const auto errors = [&](const char* part, const Region& region) {
            const std::pair found(difference(filtered, truth, region),
                                  difference(unfiltered, truth, region));
            // docs/textures.md has these figures.
            RecordProperty(part + std::to_string(few),
                           std::to_string(found.first) + " " + std::to_string(found.second));
            return found;
        };
        const auto [far_filtered, far_unfiltered] = errors("far", far_away);
        EXPECT_LT(far_filtered, 0.5 * far_unfiltered) << few;
        const auto [near_filtered, near_unfiltered] = errors("near", swollen);
        EXPECT_LT(near_filtered, near_unfiltered) << few;
    }
}

}  // namespace
}  // namespace balcony::render::test::checker_floor_test

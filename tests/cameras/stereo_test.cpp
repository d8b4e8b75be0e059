// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The built-in stereo cameras: omnidirectional stereo against Google's formula, pairs against the
// off-axis frusta of graphics libraries.

#include "balcony/stereo.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "support.hpp"

namespace balcony::cameras::test::stereo_test {
namespace {

using std::numbers::pi;

// Some dozen roundings of numbers of the size of the scene.
constexpr double rounding = 1e-12;
constexpr double height = 80.0;

// What the layers of a picture show, as rays at points in fractions from the top left.
class Layers {
public:
    explicit Layers(const camera::Picture& picture)
        : width_(height * picture.aspect()), layers_(compiled(picture, width_)) {}
    explicit Layers(const std::string& name, const std::vector<lang::Override>& set = {})
        : Layers(make_picture(name, set)) {}

    [[nodiscard]] std::size_t size() const { return layers_.layers().size(); }
    [[nodiscard]] Ray at(std::size_t layer, const V2d& fraction) const {
        const V2d point(fraction.x * width_, fraction.y * height);
        rays::Scratch scratch;
        rays::RayBatch batch;
        layers_.layers()[layer].rays.run(
            rays::Points{std::span(&point.x, 1), std::span(&point.y, 1), 0.0, {}}, scratch, batch);
        return batch[0];
    }

private:
    static rays::VisibleLayers compiled(const camera::Picture& picture, double width) {
        auto made = rays::compile_layers(picture, width, height, {.points = true});
        EXPECT_TRUE(made) << to_text(made.diagnostics);
        return *made;
    }
    double width_;
    rays::VisibleLayers layers_;
};

void at_fractions(const std::function<void(const V2d& at)>& check) {
    for (double x = 0.03; x < 1.0; x += 0.11) {
        for (double y = 0.04; y < 1.0; y += 0.13) {
            check({x, y});
        }
    }
}

void expect_same(const Ray& ray, const V3d& origin, const V3d& direction) {
    EXPECT_TRUE(ray.valid);
    EXPECT_LE((ray.origin - origin).length(), rounding) << origin.x << ' ' << origin.y;
    EXPECT_LE((ray.direction - direction).length(), rounding) << direction.x << ' ' << direction.y;
}

// Google's document has y up and z backwards: with the azimuth theta to the right, the origin is
// (cos theta, 0, sin theta) IPD/2 for the right eye, and the direction
// (sin theta cos phi, sin phi, -cos theta cos phi).
struct OmnidirectionalRay {
    V3d origin, direction;
};

OmnidirectionalRay google(double x, double y, double side, double separation) {
    const double theta = 2.0 * pi * x - pi;
    const double phi = 0.5 * pi - pi * y;
    const V3d origin(0.5 * side * separation * std::cos(theta), 0.0,
                     0.5 * side * separation * std::sin(theta));
    const V3d direction(std::sin(theta) * std::cos(phi), std::sin(phi),
                        -std::cos(theta) * std::cos(phi));
    const auto turned = [](const V3d& v) { return V3d(-v.z, -v.x, v.y); };
    return {turned(origin), turned(direction)};
}

}  // namespace

TEST(StereoCameras, OdsIsGooglesFormulaBelowTheMerge) {
    for (const auto& [side, text] : {std::pair(-1.0, "-1"), std::pair(1.0, "1")}) {
        const Layers eye("ods", {{"side", text}, {"px", "3"}, {"pz", "-1"}});
        at_fractions([&](const V2d& at) {
            const auto [origin, direction] = google(at.x, at.y, side, 0.064);
            if (std::abs(direction.z) < std::sin(pi / 3.0)) {
                expect_same(eye.at(0, at), origin + V3d(3.0, 0.0, -1.0), direction);
            }
        });
        EXPECT_LE((eye.at(0, {0.3, 0.01}).origin - V3d(3.0, 0.0, -1.0)).length(), rounding);
    }
}

TEST(StereoCameras, OdsStereoHasTheLeftEyeOnTop) {
    const Layers both("ods_stereo");
    ASSERT_EQ(both.size(), 2U);
    at_fractions([&](const V2d& at) {
        for (const std::size_t eye : {std::size_t{0}, std::size_t{1}}) {
            const auto [origin, direction] = google(at.x, at.y, eye == 0 ? -1.0 : 1.0, 0.064);
            const Ray ray = both.at(eye, {at.x, 0.5 * (at.y + static_cast<double>(eye))});
            if (std::abs(direction.z) < std::sin(pi / 3.0)) {
                expect_same(ray, origin, direction);
            }
        }
        EXPECT_FALSE(both.at(0, {at.x, 0.5 + 0.5 * at.y}).valid);
    });
}

TEST(StereoCameras, Vr180IsTheFrontOfOmnidirectionalStereo) {
    const Layers both("vr180");
    ASSERT_EQ(both.size(), 2U);
    at_fractions([&](const V2d& at) {
        for (const std::size_t eye : {std::size_t{0}, std::size_t{1}}) {
            const auto [origin, direction] =
                google(0.25 + 0.5 * at.x, at.y, eye == 0 ? -1.0 : 1.0, 0.064);
            const Ray ray = both.at(eye, {0.5 * (at.x + static_cast<double>(eye)), at.y});
            if (std::abs(direction.z) < std::sin(pi / 3.0)) {
                expect_same(ray, origin, direction);
            }
        }
    });
}

// The frustum of glFrustum for an eye beside the middle of a window at the convergence: its left
// and right at the distance 1. The projection matrix maps a point of each ray to the ray's place.
TEST(StereoCameras, PairsHaveOffAxisFrusta) {
    constexpr double separation = 0.2;
    constexpr double convergence = 5.0;
    const double half_width = std::tan(pi / 6.0);
    const double half_height = half_width * 9.0 / 16.0;
    const std::vector<lang::Override> set{{"separation", "0.2"}, {"convergence", "5"}};
    for (const std::string name : {"stereo_pair", "cross_eyed", "anaglyph"}) {
        const Layers both(name, set);
        ASSERT_EQ(both.size(), 2U);
        for (const std::size_t eye : {std::size_t{0}, std::size_t{1}}) {
            const double beside = (eye == 0 ? -0.5 : 0.5) * separation;
            const double l = -half_width - beside / convergence;
            const double r = half_width - beside / convergence;
            const bool on_the_left = (eye == 0) == (name == "stereo_pair");
            at_fractions([&](const V2d& at) {
                const V2d place =
                    name == "anaglyph" ? at : V2d(0.5 * at.x + (on_the_left ? 0.0 : 0.5), at.y);
                const Ray ray = both.at(eye, place);
                ASSERT_TRUE(ray.valid) << name;
                EXPECT_NEAR(ray.origin.y, -beside, rounding);
                // In eye coordinates: x to the right, y up, -z forward.
                const V3d point = 7.0 * V3d(-ray.direction.y, ray.direction.z, -ray.direction.x);
                const double clip_x = 2.0 / (r - l) * point.x + (r + l) / (r - l) * point.z;
                const double clip_y = point.y / half_height;
                EXPECT_NEAR(clip_x / -point.z, 2.0 * at.x - 1.0, rounding) << name;
                EXPECT_NEAR(clip_y / -point.z, 1.0 - 2.0 * at.y, rounding) << name;
            });
        }
    }
}

// A camera whose moves leave no height has the axes' own.
TEST(StereoCameras, StandUprightWhereMovesLeaveNoHeight) {
    const auto text = std::make_shared<const SourceText>("flat.cam", R"(camera flat {
    aspect 1
    map    u = 0.5 .. -0.5, v = square
    eye    point(0, 0, 2)
    toward plane((1, 0, 0))
    move   formula(x, y, z) = [x, y, 0]
    stereo(separation = 0.1, side = 1, baseline = level)
}
)");
    const auto flat = lang::Workspace().make_picture({text});
    ASSERT_TRUE(flat) << to_text(flat.diagnostics);
    const Layers eye(*flat);
    at_fractions([&](const V2d& at) {
        const V3d direction = V3d(1.0, 0.5 - at.x, 0.0).normalized();
        expect_same(eye.at(0, at), 0.05 * direction.cross(V3d(0.0, 0.0, 1.0)), direction);
    });
}

TEST(StereoCameras, TheAnaglyphHasTheColoursOfTheOption) {
    const camera::Picture built_in = make_picture("anaglyph");
    const auto made =
        camera::stereo_picture(make_picture("pinhole"), camera::StereoFormat::anaglyph);
    ASSERT_TRUE(made);
    for (const std::size_t eye : {std::size_t{0}, std::size_t{1}}) {
        EXPECT_EQ(built_in.parts().layers[eye].channels, made->parts().layers[eye].channels);
        EXPECT_EQ(built_in.parts().layers[eye].blend, made->parts().layers[eye].blend);
    }
    // White stays white, but for the rounding of six published weights to 0.001.
    for (const std::size_t channel : {std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
        double sum = 0.0;
        for (const camera::Layer& layer : built_in.parts().layers) {
            for (const double weight : (*layer.channels)[channel]) {
                sum += weight;
            }
        }
        EXPECT_NEAR(sum, 1.0, 6 * 0.0005) << channel;
    }
}

}  // namespace balcony::cameras::test::stereo_test

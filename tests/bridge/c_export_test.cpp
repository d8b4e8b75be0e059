// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// The C functions of all examples, compiled by a C compiler and called.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "balcony/inverse.hpp"
#include "bridge/text/camera_formulas.hpp"
#include "compiled_library.hpp"
#include "examples.hpp"

namespace balcony::bridge::c_export_test {
namespace {

using test::Example;
using test::ExportedRay;

// Derivatives of a megabyte of noise take a compiler too long for a test.
bool is_searched(const Example& example) { return example.camera.operations() < 3000; }

/// The functions of all examples.
std::string text_of_all(bool single, bool inverse) {
    std::string text;
    for (const Example& example : test::examples()) {
        const auto made = export_camera(*find_export_target("c"), {example.camera},
                                        {.single = single, .inverse = inverse});
        text += made && (!inverse || is_searched(example)) ? made->text : "";
    }
    return text;
}

/// These functions in one library.
class Library : public test::CompiledLibrary {
public:
    explicit Library(bool single, bool inverse = false)
        : CompiledLibrary(text_of_all(single, inverse),
                          "-x c -std=c99 -Wall -Wextra -Werror -Wconversion "
                          "-Wno-float-conversion -pedantic") {}

    /// The position whose ray passes a point, and the distance.
    struct Found {
        std::array<double, 2> position{};
        double distance = 0.0;
    };
    [[nodiscard]] std::optional<Found> find(const Example& example,
                                            const analyse::V3d& point) const {
        using Find = int (*)(const double*, double, double, double, double*, double*);
        Found made;
        const auto find = reinterpret_cast<Find>(symbol(example.name + "_find"));
        return find(&point.x, test::width, test::height, 0.0, made.position.data(),
                    &made.distance) != 0
                   ? std::optional(made)
                   : std::nullopt;
    }

    template <class Real>
    [[nodiscard]] std::vector<ExportedRay> rays(const Example& example, bool lens) const {
        using Pinhole = int (*)(Real, Real, Real, Real, Real, Real*, Real*);
        using Lens = int (*)(Real, Real, Real, Real, Real, Real, Real, Real*, Real*);
        void* const function = symbol(example.name + "_ray");
        std::vector<ExportedRay> made;
        for (const auto& [x, y] : test::points()) {
            Real o[3];
            Real d[3];
            const auto px = static_cast<Real>(x);
            const auto py = static_cast<Real>(y);
            const auto w = static_cast<Real>(test::width);
            const auto h = static_cast<Real>(test::height);
            const int valid = lens ? reinterpret_cast<Lens>(function)(px, py, w, h, 0, 0, 0, o, d)
                                   : reinterpret_cast<Pinhole>(function)(px, py, w, h, 0, o, d);
            made.push_back({{o[0], o[1], o[2]}, {d[0], d[1], d[2]}, valid == 1});
        }
        return made;
    }
};

// The C library computes both, so that all numbers are the same.
TEST(CExport, ComputesTheGraphToTheLastBit) {
    const Library library(false);
    ASSERT_TRUE(library.compiled());
    std::size_t compared = 0;
    for (const Example& example : test::examples()) {
        const auto formulas = formulas_of(example.camera, {"c", example.camera.parts().axes});
        if (!formulas) {
            continue;
        }
        const std::vector<ExportedRay> rays = library.rays<double>(example, formulas->lens);
        const auto points = test::points();
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const std::array<expr::InputValue, 4> inputs{
                {{"width", test::width}, {"height", test::height}, {"lens_x", 0}, {"lens_y", 0}}};
            const std::vector<double> r = expr::evaluate(
                formulas->roots, {.x = points[i].x, .y = points[i].y, .inputs = inputs});
            ASSERT_EQ(rays[i].valid, r[RayRoots::valid] == 1.0) << example.name;
            for (std::size_t k = 0; rays[i].valid && k < 3; ++k) {
                ASSERT_EQ(rays[i].origin[k], r[k]) << example.name;
                ASSERT_EQ(rays[i].direction[k], r[3 + k]) << example.name;
            }
        }
        const test::Comparison comparison = test::compare(example, rays);
        EXPECT_EQ(comparison.lost, 0U) << example.name;
        EXPECT_LT(comparison.largest, 1e-6) << example.name;
        ++compared;
    }
    EXPECT_GE(compared + 3, test::examples().size()) << "only meshes have no formula";
}

// The functions of the C library are not rounded as the reported ones are, and the points are
// others; but no camera is much worse than its report.
TEST(CExport, InSinglePrecisionDiffersAsMuchAsIsReported) {
    const Library library(true);
    ASSERT_TRUE(library.compiled());
    for (const Example& example : test::examples()) {
        if (!test::has_formulas(example)) {
            continue;
        }
        const bool lens = example.camera.parts().lens != nullptr;
        const auto exported = export_camera(*find_export_target("c"), {example.camera},
                                            {.single = true, .judged_in = {{160, 90}}});
        ASSERT_TRUE(exported && exported->single) << example.name;
        const SinglePrecision& reported = *exported->single;
        const test::Comparison comparison =
            test::compare(example, library.rays<float>(example, lens));
        EXPECT_LE(comparison.lost, reported.lost) << example.name;
        EXPECT_LT(comparison.largest, 1e-3 + 4.0 * reported.largest) << example.name;
    }
}

// Every tenth point of the picture, at a distance on its ray that is no radius of an example: all
// of a row may see the axis of a cylinder.
TEST(CExport, FindsPointsWhereBalconyLocatesThem) {
    const Library library(false, true);
    ASSERT_TRUE(library.compiled());
    std::size_t wanted = 0;
    std::size_t found = 0;
    for (const Example& example : test::examples()) {
        if (!test::has_formulas(example) || !is_searched(example)) {
            continue;
        }
        const auto locator =
            analyse::Locator::make(camera::Picture(example.camera).with_fit(camera::Fit::stretch),
                                   test::width, test::height);
        ASSERT_TRUE(locator) << example.name;
        const std::vector<ExportedRay> rays =
            library.rays<double>(example, example.camera.parts().lens != nullptr);
        for (std::size_t i = 0; i < rays.size(); i += 10) {
            if (!rays[i].valid) {
                continue;
            }
            const analyse::V3d origin(rays[i].origin[0], rays[i].origin[1], rays[i].origin[2]);
            const analyse::V3d direction(rays[i].direction[0], rays[i].direction[1],
                                         rays[i].direction[2]);
            const analyse::V3d point = origin + 2.7 * direction;
            const std::vector<analyse::Sighting> sightings = locator->locate(point);
            const auto place = library.find(example, point);
            ++wanted;
            found += place ? 1 : 0;
            if (!place || sightings.empty()) {
                continue;
            }
            const bool same =
                std::any_of(sightings.begin(), sightings.end(), [&](const analyse::Sighting& one) {
                    return std::abs(one.position.x - place->position[0]) < 0.01 &&
                           std::abs(one.position.y - place->position[1]) < 0.01 &&
                           std::abs(one.distance - place->distance) < 1e-3 * one.distance;
                });
            EXPECT_TRUE(same) << example.name << ' ' << place->position[0] << ' '
                              << place->position[1];
        }
    }
    EXPECT_GT(wanted, 2000U);
    // Some lie behind seams of every_side, where the best positions of the grid are in other parts.
    EXPECT_GT(static_cast<double>(found), 0.995 * static_cast<double>(wanted)) << wanted;
}

}  // namespace
}  // namespace balcony::bridge::c_export_test

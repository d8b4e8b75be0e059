// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Surfaces and glasses of lenses: what each kind of surface does by its formula, in lenses that no
// file has.

#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "balcony/prescription.hpp"
#include "lens_rays.hpp"
#include "support.hpp"

namespace balcony::rays::test::lens_surfaces_test {
namespace {

using camera::LensSurface;
using camera::ParaxialLens;
using camera::Prescription;
using std::numbers::pi;

/// A plane in front, and behind it a surface that a point at the distance f is imaged to infinity
/// by, exactly: the hyperboloid with the conic constant -n² and the radius (n - 1) f.
Prescription hyperbolic(double n, double f) {
    return {"hyperbolic",
            {{.radius = 0.45 * f,
              .stop = true,
              .gap = 0.3 * f,
              .behind = {"glass", camera::Medium::Dispersion::none, {n}}},
             {.curvature = -1.0 / ((n - 1.0) * f), .conic = -n * n, .radius = 0.45 * f}}};
}

}  // namespace

// All rays from the middle of the sensor leave along the axis. Points of the lens reach 0.9 of the
// disc, whose radius of 22.5 mm makes it f/1.1.
TEST(LensSurfaces, HasConics) {
    const LensRaysAt rays(camera_with(hyperbolic(1.6, 50.0), {{"focus", 1e15}}));
    double widest = 0.0;
    at_lens([&](const V2d& at) {
        const Ray ray = rays({200.0, 200.0}, at);
        ASSERT_TRUE(ray.valid) << at;
        widest = std::max(widest, std::hypot(ray.origin.y, ray.origin.z));
        EXPECT_NEAR(ray.direction.y, 0.0, 1e-12);
        EXPECT_NEAR(ray.direction.z, 0.0, 1e-12);
    });
    EXPECT_GT(widest, 19.0);
}

// Nothing holds off light from the side, so that it arrives far off the axis; yet in the middle, no
// more of the samples are lost than the disc's margin of 1 %, which is one of the 50 rings of the
// samples. The rim of the disc is that of the stop, as wide as the f-number says; the aberrations
// of these pupils and the margin are 2 % of it.
TEST(LensSurfaces, IsAsBrightWithoutMounts) {
    const camera::Medium glass{"glass", camera::Medium::Dispersion::none, {1.5}};
    Prescription slow = hyperbolic(1.6, 50.0);
    slow.surfaces.front().radius = slow.surfaces.back().radius = 2.5;
    const Prescription single{
        "single",
        {{.curvature = 0.02, .radius = 5.0, .stop = true, .gap = 4.0, .behind = glass},
         {.curvature = -0.02, .radius = 5.0}}};
    for (const Prescription& lens : {slow, single}) {
        const LensRaysAt rays(camera_with(lens, {{"focus", 1e15}}));
        const V2d middle(200.0, 200.0);
        EXPECT_GT(lit_part(rays, middle), 0.96) << lens.name;
        // At the edge, the two holes are off each other by the slope in the glass times its length;
        // cos⁴ and a ring of the samples are 4 %.
        const LensSurface& front = lens.surfaces.front();
        const double half = 0.1 / front.behind.index(camera::line_d) * front.gap / 2.0;
        const double overlap =
            2.0 / pi *
            (std::acos(half / front.radius) -
             half / front.radius * std::sqrt(1.0 - std::pow(half / front.radius, 2)));
        EXPECT_NEAR(lit_part(rays, {0.0, 200.0}), overlap, 0.04) << lens.name;
        const ParaxialLens near_axis = camera::paraxial(lens);
        const double rim = near_axis.focal_length / (2.0 * near_axis.f_number());
        EXPECT_NEAR(rays(middle, {0.0, 0.98}).origin.z, 0.98 * rim, 0.02 * rim) << lens.name;
    }
    const LensRaysAt fast(camera_with(hyperbolic(1.6, 50.0), {{"focus", 1e15}}));
    EXPECT_GT(lit_part(fast, {200.0, 200.0}), 0.96);
}

// The same surface as a sphere with terms of h⁴ to h¹²: with c the curvature and K = -n² the conic
// constant, c h²/(1 + √(1 - (1 + K) c² h²)) has the coefficients binomial(1/2, i) (-1)^(i + 1)
// c^(2i - 1) (1 + K)^(i - 1) of h^(2i), and the sphere those of K = 0. What is left is of h¹⁴.
TEST(LensSurfaces, HasAspheres) {
    const double n = 1.6;
    Prescription lens = hyperbolic(n, 50.0);
    LensSurface& s = lens.surfaces.back();
    s.conic = 0.0;
    s.radius = lens.surfaces.front().radius = 6.0;
    double binomial = 0.5;
    for (int i = 2; i <= 6; ++i) {
        binomial *= (0.5 - (i - 1)) / i;
        const double sign = i % 2 == 0 ? -1.0 : 1.0;
        s.aspheric[static_cast<std::size_t>(i - 2)] = binomial * sign *
                                                      std::pow(s.curvature, 2 * i - 1) *
                                                      (std::pow(1.0 - n * n, i - 1) - 1.0);
    }
    const LensRaysAt rays(camera_with(lens, {{"focus", 1e15}}));
    const LensRaysAt exact(camera_with(hyperbolic(n, 50.0), {{"focus", 1e15}}));
    at_lens([&](const V2d& at) {
        const Ray ray = rays({200.0, 200.0}, at);
        ASSERT_TRUE(ray.valid) << at;
        // (h/R)¹³ at h = 6 and R = 30 is 8e-10, times (n² - 1)⁶ = 14 and the coefficient 0.02.
        EXPECT_NEAR(ray.direction.y, 0.0, 1e-9);
        EXPECT_NEAR(ray.direction.z, 0.0, 1e-9);
        EXPECT_NEAR(ray.direction.length(), 1.0, 1e-13);
    });
    // Off the axis, too, it is the same lens.
    const Ray a = rays.central({60.0, 90.0});
    const Ray b = exact.central({60.0, 90.0});
    EXPECT_LT(a.direction.cross(b.direction).length(), 1e-2);
}

TEST(LensSurfaces, SaysWhatItCannotDo) {
    const auto fault = [](std::vector<camera::NamedValue> values) {
        values.push_back({"file", std::make_shared<const Prescription>(hyperbolic(1.6, 50.0))});
        values.push_back({"focus", 5.0});
        const auto made = table(values);
        if (made) {
            return std::string("none");
        }
        EXPECT_FALSE(made.diagnostics.front().remedy.empty());
        return made.diagnostics.front().message;
    };
    EXPECT_EQ(fault({{"f_number", 1.0}}), "f/1 is wider than this lens, which is f/1.11");
    EXPECT_EQ(fault({{"group", {2.0, 1.0}}}), "there is no group from surface 2 to surface 1");
    EXPECT_EQ(fault({{"group", {1.0, 3.0}}}), "there is no group from surface 1 to surface 3");
    EXPECT_EQ(fault({{"blades", 2.0}}), "an aperture cannot have 2 blades");
    EXPECT_EQ(fault({}), "none");
}

}  // namespace balcony::rays::test::lens_surfaces_test

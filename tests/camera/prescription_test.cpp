// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Prescriptions of lenses: glass, the optics of rays near the axis, and what is no lens.

#include <gtest/gtest.h>

#include <cmath>

#include "balcony/prescription.hpp"

namespace balcony::camera::prescription_test {
namespace {

constexpr double rounding = 1e-12;

Medium of_index(double n) { return {"glass", Medium::Dispersion::none, {n}}; }

/// A lens of one glass, which is its own stop.
Prescription singlet(double first, double second, double thickness, double n) {
    return {"singlet",
            {{.curvature = 1.0 / first,
              .radius = 2.0,
              .stop = true,
              .gap = thickness,
              .behind = of_index(n)},
             {.curvature = 1.0 / second, .radius = 2.0}}};
}

/// The message of the only error.
std::string fault(const Prescription& lens) {
    const Diagnostics found = check(lens);
    if (found.size() != 1) {
        return to_text(found);
    }
    EXPECT_FALSE(found.front().remedy.empty());
    return found.front().message;
}

}  // namespace

// n_d, Abbe number and, for some, n_F as their makers' data sheets print them.
TEST(Glass, HasThePublishedIndices) {
    struct Known {
        const char* name;
        double index, abbe;
    };
    for (const Known& known :
         {Known{"N-BK7", 1.51680, 64.17}, Known{"N-SK16", 1.62041, 60.32},
          Known{"N-F2", 1.62005, 36.43}, Known{"N-SF6", 1.80518, 25.36},
          Known{"n-sf11", 1.78472, 25.68}, Known{"Fused-Silica", 1.45846, 67.82},
          Known{"CaF2", 1.43384, 95.0}}) {
        const Medium* glass = find_glass(known.name);
        ASSERT_NE(glass, nullptr) << known.name;
        const double d = glass->index(line_d);
        EXPECT_NEAR(d, known.index, 1.5e-5) << known.name;
        EXPECT_NEAR((d - 1.0) / (glass->index(line_F) - glass->index(line_C)), known.abbe, 0.1)
            << known.name;
    }
    EXPECT_NEAR(find_glass("N-BK7")->index(line_F), 1.52238, 1e-5);
    EXPECT_NEAR(find_glass("N-BK7")->index(line_C), 1.51432, 1e-5);
    EXPECT_EQ(find_glass("N-BK"), nullptr);
}

TEST(Glass, HasTheIndexAndTheAbbeNumberThatAreGiven) {
    const Medium glass = Medium::by_abbe_number(1.67, 47.1);
    const double d = glass.index(line_d);
    EXPECT_NEAR(d, 1.67, rounding);
    EXPECT_NEAR((d - 1.0) / (glass.index(line_F) - glass.index(line_C)), 47.1, 1e-9);
}

// The same dispersion written as Schott's polynomial and as Cauchy's.
TEST(Glass, KnowsTheFormulas) {
    const double w = 0.5;
    const Medium cauchy{"a", Medium::Dispersion::cauchy, {1.5, 0.004, 0.0001}};
    EXPECT_NEAR(cauchy.index(w), 1.5 + 0.016 + 0.0016, rounding);
    const Medium schott{"b", Medium::Dispersion::schott, {2.25, -0.01, 0.01, 0.0002, 3e-5, 1e-6}};
    EXPECT_NEAR(schott.index(w), std::sqrt(2.25 - 0.0025 + 0.04 + 0.0032 + 0.00192 + 0.000256),
                rounding);
}

// The thick lens of textbooks: 1/f = (n - 1)(1/R1 - 1/R2 + (n - 1) d/(n R1 R2)), and principal
// planes at -f (n - 1) d/(n R2) and -f (n - 1) d/(n R1) from their surfaces.
TEST(ParaxialLens, OfOneThickLensIsThatOfTheTextbook) {
    const double r1 = 20.0;
    const double r2 = -35.0;
    const double n = 1.6;
    const double d = 5.0;
    const ParaxialLens lens = paraxial(singlet(r1, r2, d, n));
    const double f = 1.0 / ((n - 1.0) * (1.0 / r1 - 1.0 / r2 + (n - 1.0) * d / (n * r1 * r2)));
    EXPECT_NEAR(lens.focal_length, f, 1e-11);
    EXPECT_NEAR(lens.front_principal, -f * (n - 1.0) * d / (n * r2), 1e-11);
    EXPECT_NEAR(lens.back_principal, -f * (n - 1.0) * d / (n * r1), 1e-11);
    EXPECT_NEAR(lens.front_focus, lens.front_principal - f, 1e-11);
    EXPECT_NEAR(lens.back_focus, lens.back_principal + f, 1e-11);
    EXPECT_NEAR(lens.entrance_pupil, 0.0, rounding);
    EXPECT_NEAR(lens.f_number(), f / 4.0, 1e-11);
}

// A triplet of Cooke's kind, f/5, which programs for designing lenses have as their example, with
// the focal length stated as 50.0 mm.
TEST(ParaxialLens, OfAPublishedTripletHasTheStatedFocalLength) {
    const Medium sk16 = of_index(1.62041);
    const Medium f2 = of_index(1.62004);
    const ParaxialLens lens =
        paraxial({"triplet",
                  {{.curvature = 1.0 / 22.01359, .radius = 9.5, .gap = 3.25896, .behind = sk16},
                   {.curvature = -1.0 / 435.76044, .radius = 9.5, .gap = 6.00755},
                   {.curvature = -1.0 / 22.21328, .radius = 5.0, .gap = 0.99997, .behind = f2},
                   {.curvature = 1.0 / 20.29192, .radius = 5.0, .stop = true, .gap = 4.75041},
                   {.curvature = 1.0 / 79.68360, .radius = 7.5, .gap = 2.95208, .behind = sk16},
                   {.curvature = -1.0 / 18.39533, .radius = 7.5}}});
    EXPECT_NEAR(lens.focal_length, 50.0, 0.05);
}

// Both principal planes of a ball are in its middle, and f = n R/(2 (n - 1)).
TEST(ParaxialLens, OfABallHasItsPlanesInTheMiddle) {
    const ParaxialLens lens = paraxial(singlet(10.0, -10.0, 20.0, 1.5));
    EXPECT_NEAR(lens.focal_length, 15.0, 1e-11);
    EXPECT_NEAR(lens.front_principal, 10.0, 1e-11);
    EXPECT_NEAR(lens.back_principal, -10.0, 1e-11);
}

// A stop at a distance s behind a lens of focal length f is seen through it at s' with
// 1/s' = 1/s - 1/f, larger by s'/s; one in front of it is its own entrance pupil.
TEST(ParaxialLens, HasPupilsThatAreImagesOfTheStop) {
    Prescription lens = singlet(50.0, -50.0, 1e-9, 1.5);
    const double f = paraxial(lens).focal_length;
    lens.surfaces[0].stop = false;
    lens.surfaces[1].gap = 10.0;
    lens.surfaces.push_back({.radius = 1.5, .stop = true});
    const ParaxialLens behind = paraxial(lens);
    const double seen = 1.0 / (1.0 / 10.0 - 1.0 / f);
    EXPECT_NEAR(behind.entrance_pupil, seen, 1e-6);
    EXPECT_NEAR(behind.entrance_radius, 1.5 * seen / 10.0, 1e-6);
    EXPECT_NEAR(behind.exit_pupil, 0.0, rounding);
    EXPECT_NEAR(behind.exit_radius, 1.5, rounding);

    lens.surfaces.pop_back();
    lens.surfaces.insert(lens.surfaces.begin(), {.radius = 1.5, .stop = true, .gap = 10.0});
    const ParaxialLens front = paraxial(lens);
    EXPECT_NEAR(front.entrance_pupil, 0.0, rounding);
    EXPECT_NEAR(front.entrance_radius, 1.5, rounding);
    EXPECT_NEAR(front.exit_pupil, -seen, 1e-6);
    EXPECT_NEAR(front.exit_radius, 1.5 * seen / 10.0, 1e-6);
}

// A cylinder has the focal length of the lens with its section in the meridian that is curved, and
// none in the other one, in which it is a plate.
TEST(ParaxialLens, OfACylinderIsThatOfItsSection) {
    const Prescription sphere = singlet(20.0, -35.0, 5.0, 1.6);
    const auto infinite = [](const Prescription& lens) {
        return std::isinf(paraxial(lens).focal_length);
    };
    Prescription level = sphere;
    Prescription upright = sphere;
    for (std::size_t i = 0; i < 2; ++i) {
        level.surfaces[i].curvature_x = 0.0;
        upright.surfaces[i].curvature_x = sphere.surfaces[i].curvature;
        upright.surfaces[i].curvature = 0.0;
    }
    const double f = paraxial(sphere).focal_length;
    EXPECT_EQ(paraxial(level).focal_length, f);
    EXPECT_TRUE(infinite(horizontal_section(level)));
    EXPECT_EQ(paraxial(horizontal_section(upright)).focal_length, f);
    EXPECT_TRUE(infinite(upright));
    EXPECT_EQ(fault(level),
              "'singlet' has no real image of what is far away in the horizontal "
              "plane");
    EXPECT_EQ(fault(upright),
              "'singlet' has no real image of what is far away in the vertical "
              "plane");
    EXPECT_FALSE(sphere.is_anamorphic());
    EXPECT_TRUE(level.is_anamorphic());
}

TEST(ParaxialLens, ChangesWithTheWavelength) {
    Prescription lens = singlet(50.0, -50.0, 4.0, 1.5);
    lens.surfaces[0].behind = *find_glass("N-BK7");
    const double f = paraxial(lens).focal_length;
    // Of a thin lens, f is proportional to 1/(n - 1): the difference is f divided by the Abbe
    // number. Of this one, (n - 1) d/(n R) = 2.7 % of the power is that of its thickness.
    EXPECT_NEAR((paraxial(lens, line_C).focal_length - paraxial(lens, line_F).focal_length) / f,
                1.0 / 64.17, 0.027 / 64.17);
}

TEST(Prescription, SagIsThatOfTheFormula) {
    LensSurface s{.curvature = 0.02, .conic = -0.5, .aspheric = {1e-5, -2e-8}};
    const double h = 7.0;
    EXPECT_NEAR(s.sag(h),
                0.02 * h * h / (1.0 + std::sqrt(1.0 - 0.5 * 0.0004 * h * h)) +
                    1e-5 * std::pow(h, 4) - 2e-8 * std::pow(h, 6),
                rounding);
    // From the vertex towards the centre of curvature, on a sphere.
    s = {.curvature = -0.1};
    EXPECT_NEAR(s.sag(6.0), -2.0, rounding);
    EXPECT_FALSE(std::isfinite(s.sag(11.0)));
}

TEST(Prescription, IsCheckedSurfaceBySurface) {
    const Prescription good = singlet(20.0, -35.0, 5.0, 1.6);
    EXPECT_EQ(to_text(check(good)), "");
    const auto with = [&](const auto& change) {
        Prescription lens = good;
        change(lens.surfaces);
        return fault(lens);
    };
    using Surfaces = std::vector<LensSurface>;
    EXPECT_EQ(with([](Surfaces& s) { s[0].stop = false; }), "'singlet' has no stop");
    EXPECT_EQ(with([](Surfaces& s) { s[1].stop = true; }), "'singlet' has 2 stops");
    EXPECT_EQ(with([](Surfaces& s) { s[0].radius = 0.0; }), "this stop lets nothing through");
    EXPECT_EQ(with([](Surfaces& s) { s[1].radius = 0.0; }), "no light passes through this surface");
    EXPECT_EQ(with([](Surfaces& s) { s[0].gap = std::nan(""); }),
              "a number of this surface is not finite");
    EXPECT_EQ(with([](Surfaces& s) { s[0].behind = of_index(0.5); }),
              "the index of what is behind this surface is 0.5");
    EXPECT_EQ(with([](Surfaces& s) { s[0].radius = 21.0; }),
              "this surface ends before its hole does: its radius of curvature is 20 mm, that of "
              "its hole 21 mm");
    EXPECT_EQ(with([](Surfaces& s) { s[1].behind = of_index(1.5); }), "the last medium is not air");
    EXPECT_EQ(with([](Surfaces& s) { s[0].curvature = -0.1; }),
              "'singlet' has no real image of what is far away");
    EXPECT_EQ(with([](Surfaces& s) { s[0].gap = -1.0; }),
              "this surface crosses the one in front of it at the distance 0 mm from the axis");
    // 20 - √(20² - h²) + 35 - √(35² - h²) is 0.2 at h = 2.26.
    EXPECT_EQ(with([](Surfaces& s) {
                  s[0].radius = s[1].radius = 4.0;
                  s[0].gap = 0.2;
              }),
              "this surface crosses the one in front of it at the distance 2.5 mm from the axis");
    // Where only the sides of a toroid cross: 20 - √(20² - h²) is 0.12 at h = 2.19.
    EXPECT_EQ(with([](Surfaces& s) {
                  s[0].radius = s[1].radius = 4.0;
                  s[0].gap = 0.12;
                  s[0].curvature_x = 0.0;
                  s[0].curvature = 0.001;
                  s[1].curvature_x = -0.05;
                  s[1].curvature = 0.0;
              }),
              "this surface crosses the one in front of it at the distance 2.25 mm from the axis");
    EXPECT_EQ(with([](Surfaces& s) {
                  s[0].radius = 4.0;
                  s[0].curvature_x = 0.3;
              }),
              "this surface ends before its hole does: its radius of curvature is 3.33333 mm, that "
              "of its hole 4 mm");
}

// Light in glass of the index 1.6 is totally reflected where sin i > 1/1.6: where the slope 4 a h³
// of the term h⁴ is above tan i = 0.8006, beyond h = 0.1 with a = 200.
TEST(Prescription, NamesTheSurfaceThatReflectsAllLight) {
    Prescription lens = singlet(20.0, -35.0, 5.0, 1.6);
    lens.surfaces[0].curvature = 0.0;
    lens.surfaces[1].aspheric[0] = 200.0;
    EXPECT_EQ(fault(lens),
              "light of the axis is totally reflected by this surface if it is more than 0.0938 mm "
              "away from it");
    // A hundredth of the light may be all that passes.
    lens.surfaces[1].aspheric[0] = 10.0;
    EXPECT_EQ(to_text(check(lens)), "");
    // A hole that stops as much is the lens's aperture.
    lens.surfaces[1].aspheric[0] = 0.0;
    lens.surfaces[1].radius = 0.05;
    EXPECT_EQ(to_text(check(lens)), "");
}

}  // namespace balcony::camera::prescription_test

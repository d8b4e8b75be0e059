// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Calibrated cameras: a ray put into the published formula, which leads from the scene to the
// image, gives the pixel again. The formulas stand here as their authors write them, and share
// nothing with the library.

#include <functional>
#include <numbers>
#include <random>

#include "support.hpp"

namespace balcony::camera::calibrated_cameras_test {

namespace {

using std::numbers::pi;
using Numbers = std::map<std::string_view, double>;
using Pixel = std::array<double, 2>;

struct Lens {
    std::string_view name;
    Numbers numbers;
    /// The point in focal lengths from the centre of a direction with x right, y down, z forward.
    std::function<Pixel(const Vector& d)> forward;
    double min_share = 1.0;  ///< Of the pixels that have rays.
};

double value_of(const Numbers& numbers, std::string_view name) {
    const auto found = numbers.find(name);
    return found != numbers.end() ? found->second : 0.0;
}

/// OpenCV's formula of calib3d, term by term.
Pixel opencv(const Numbers& n, double x, double y) {
    const auto k = [&n](std::string_view name) { return value_of(n, name); };
    const double r2 = x * x + y * y;
    const double r4 = r2 * r2;
    const double r6 = r4 * r2;
    const double radial = (1.0 + k("k1") * r2 + k("k2") * r4 + k("k3") * r6) /
                          (1.0 + k("k4") * r2 + k("k5") * r4 + k("k6") * r6);
    const double xd = x * radial + 2.0 * k("p1") * x * y + k("p2") * (r2 + 2.0 * x * x) +
                      k("s1") * r2 + k("s2") * r4;
    const double yd = y * radial + k("p1") * (r2 + 2.0 * y * y) + 2.0 * k("p2") * x * y +
                      k("s3") * r2 + k("s4") * r4;
    // R = Ry(tau_y) Rx(tau_x), then the projection onto the tilted sensor.
    const double cx = std::cos(k("tau_x"));
    const double sx = std::sin(k("tau_x"));
    const double cy = std::cos(k("tau_y"));
    const double sy = std::sin(k("tau_y"));
    const std::array<Vector, 3> r{
        {{cy, sy * sx, -sy * cx}, {0.0, cx, sx}, {sy, -cy * sx, cy * cx}}};
    const Vector p{xd, yd, 1.0};
    const Vector turned{dot(r[0], p), dot(r[1], p), dot(r[2], p)};
    return {(r[2][2] * turned[0] - r[0][2] * turned[2]) / turned[2],
            (r[2][2] * turned[1] - r[1][2] * turned[2]) / turned[2]};
}

Pixel pinhole(const Numbers& n, const Vector& d) { return opencv(n, d[0] / d[2], d[1] / d[2]); }

/// A radius as a function of the angle to the axis.
Pixel by_angle(const Vector& d, const std::function<double(double)>& radius) {
    const double across = std::hypot(d[0], d[1]);
    const double r = radius(std::atan2(across, d[2]));
    return across > 0.0 ? Pixel{r * d[0] / across, r * d[1] / across} : Pixel{0.0, 0.0};
}

Pixel fisheye(const Numbers& n, const Vector& d) {
    return by_angle(d, [&n](double t) {
        const double t2 = t * t;
        const double t4 = t2 * t2;
        return t * (1.0 + value_of(n, "k1") * t2 + value_of(n, "k2") * t4 +
                    value_of(n, "k3") * t4 * t2 + value_of(n, "k4") * t4 * t4);
    });
}

Pixel kannala_brandt(const Numbers& n, const Vector& d) {
    return by_angle(d, [&n](double t) {
        return value_of(n, "k1") * t + value_of(n, "k2") * std::pow(t, 3) +
               value_of(n, "k3") * std::pow(t, 5) + value_of(n, "k4") * std::pow(t, 7) +
               value_of(n, "k5") * std::pow(t, 9);
    });
}

/// COLMAP's ThinPrismFisheyeCameraModel.
Pixel thin_prism_fisheye(const Numbers& n, const Vector& d) {
    const auto k = [&n](std::string_view name) { return value_of(n, name); };
    const auto [u, v] = by_angle(d, [](double angle) { return angle; });
    const double r2 = u * u + v * v;
    const double radial =
        k("k1") * r2 + k("k2") * r2 * r2 + k("k3") * std::pow(r2, 3) + k("k4") * std::pow(r2, 4);
    return {u + u * radial + 2.0 * k("p1") * u * v + k("p2") * (r2 + 2.0 * u * u) + k("sx1") * r2,
            v + v * radial + 2.0 * k("p2") * u * v + k("p1") * (r2 + 2.0 * v * v) + k("sy1") * r2};
}

Pixel omnidirectional(const Numbers& n, const Vector& d) {
    const double depth = d[2] / length(d) + value_of(n, "xi");
    return opencv(n, d[0] / length(d) / depth, d[1] / length(d) / depth);
}

Pixel field_of_view(const Numbers& n, const Vector& d) {
    const double omega = value_of(n, "omega");
    const double r = std::hypot(d[0], d[1]) / d[2];
    const double distorted = std::atan(2.0 * r * std::tan(0.5 * omega)) / omega;
    return r > 0.0 ? Pixel{distorted / r * d[0] / d[2], distorted / r * d[1] / d[2]} : Pixel{};
}

Pixel double_sphere(const Numbers& n, const Vector& d) {
    const double xi = value_of(n, "xi");
    const double alpha = value_of(n, "alpha");
    const double d1 = length(d);
    const double d2 = std::hypot(d[0], d[1], xi * d1 + d[2]);
    const double depth = alpha * d2 + (1.0 - alpha) * (xi * d1 + d[2]);
    return {d[0] / depth, d[1] / depth};
}

Pixel extended_unified(const Numbers& n, const Vector& d) {
    const double alpha = value_of(n, "alpha");
    const double reach = std::sqrt(value_of(n, "beta") * (d[0] * d[0] + d[1] * d[1]) + d[2] * d[2]);
    const double depth = alpha * reach + (1.0 - alpha) * d[2];
    return {d[0] / depth, d[1] / depth};
}

/// The published formula leads from undistorted to distorted points by a quadratic equation.
Pixel division(const Numbers& n, const Vector& d) {
    const double r = std::hypot(d[0], d[1]) / d[2];
    const double l = value_of(n, "l1");
    const double distorted = 2.0 * r / (1.0 + std::sqrt(1.0 - 4.0 * l * r * r));
    return r > 0.0 ? Pixel{distorted / r * d[0] / d[2], distorted / r * d[1] / d[2]} : Pixel{};
}

template <class Formula>
Lens lens(std::string_view name, Numbers numbers, Formula formula, double min_share = 1.0) {
    return {name, numbers, [numbers, formula](const Vector& d) { return formula(numbers, d); },
            min_share};
}

const Numbers camera_1080p{{"width", 1920}, {"height", 1080}, {"fx", 1105.7},
                           {"fy", 1103.2},  {"cx", 947.1},    {"cy", 551.3}};

Numbers with(const Numbers& frame, const Numbers& more) {
    Numbers made = more;
    made.insert(frame.begin(), frame.end());
    return made;
}

// The shares are a little below those of the pixels within the folds, and of the directions.
std::vector<Lens> lenses() {
    const Numbers& normal = camera_1080p;
    const Numbers wide = with(normal, {{"fx", 640.3}, {"fy", 639.1}});
    const Numbers fish = with(normal, {{"fx", 410.0}, {"fy", 411.0}});
    return {
        lens("opencv_pinhole", normal, pinhole),
        lens("opencv_pinhole", with(normal, {{"k1", -0.31}, {"k2", 0.12}, {"k3", -0.02}}), pinhole),
        lens("opencv_pinhole",
             with(normal, {{"k1", 0.21}, {"k2", 0.3}, {"p1", 0.004}, {"p2", -0.003}}), pinhole),
        lens("opencv_pinhole",
             with(wide, {{"k1", 0.31},
                         {"k2", 0.03},
                         {"k3", 0.0006},
                         {"k4", 0.47},
                         {"k5", 0.09},
                         {"k6", 0.0042},
                         {"p1", 0.0011},
                         {"p2", -0.0007},
                         {"s1", 0.001},
                         {"s2", -2e-4},
                         {"s3", -0.002},
                         {"s4", 3e-4},
                         {"tau_x", 0.03},
                         {"tau_y", -0.02}}),
             pinhole, 0.76),
        // Lenses that fold within their image.
        lens("opencv_pinhole", with(wide, {{"k1", -0.12}}), pinhole, 0.65),
        lens("opencv_pinhole", with(wide, {{"k1", -0.12}, {"p1", 0.01}, {"p2", -0.02}}), pinhole,
             0.6),
        lens("opencv_fisheye", fish, fisheye),
        lens("opencv_fisheye",
             with(fish,
                  {{"k1", 0.031}, {"k2", -0.017}, {"k3", 0.0046}, {"k4", -0.0004}, {"skew", 1.7}}),
             fisheye, 0.99),
        lens("opencv_fisheye", with(fish, {{"k1", -0.2}}), fisheye, 0.15),
        lens("kannala_brandt",
             with(normal, {{"fx", 260.0},
                           {"fy", 261.0},
                           {"k1", 1.62},
                           {"k2", 0.021},
                           {"k3", -0.006},
                           {"k4", 0.0009},
                           {"k5", -2e-5}}),
             kannala_brandt, 0.99),
        lens("thin_prism_fisheye",
             with(fish, {{"k1", -0.012},
                         {"k2", 0.003},
                         {"p1", 0.002},
                         {"p2", -0.001},
                         {"sx1", 0.003},
                         {"sy1", -0.002}}),
             thin_prism_fisheye, 0.99),
        lens("omnidirectional",
             with(normal, {{"fx", 900.0},
                           {"fy", 898.0},
                           {"xi", 0.9},
                           {"k1", -0.11},
                           {"k2", 0.02},
                           {"p1", 0.0007},
                           {"p2", -0.0004},
                           {"skew", 0.6}}),
             omnidirectional),
        lens("omnidirectional",
             with(normal, {{"fx", 1600.0}, {"fy", 1600.0}, {"xi", 1.7}, {"k1", -0.3}, {"k2", 0.1}}),
             omnidirectional, 0.9),
        lens("field_of_view", with(normal, {{"omega", 0.93}}), field_of_view),
        lens("division", with(normal, {{"l1", -0.22}, {"l2", 0.0}}), division),
        lens("double_sphere", with(fish, {{"xi", -0.19}, {"alpha", 0.59}}), double_sphere, 0.8),
        lens("double_sphere", with(fish, {{"xi", 0.4}, {"alpha", 0.3}}), double_sphere),
        lens("extended_unified", with(fish, {{"alpha", 0.63}, {"beta", 1.09}}), extended_unified,
             0.72),
        lens("extended_unified", with(normal, {{"alpha", 0.4}, {"beta", 1.0}}), extended_unified),
    };
}

GeneratorProbe probe_of(const Lens& lens, double radius = 1.0) {
    Given given{{"radius", numbers({radius})}};
    for (const auto& [name, value] : lens.numbers) {
        given[name] = numbers({value});
    }
    return GeneratorProbe(object(lens.name, given));
}

/// From the camera's axes to those of the formulas.
Vector optical(const Vector& d) { return {-d[1], -d[2], d[0]}; }

/// With u and v from the outer corner of the top left pixel, whose centre is OpenCV's (0, 0).
Pixel pixel_of(const Lens& lens, const Vector& direction) {
    const auto& n = lens.numbers;
    const auto [x, y] = lens.forward(optical(direction));
    return {value_of(n, "fx") * x + value_of(n, "skew") * y + value_of(n, "cx") + 0.5,
            value_of(n, "fy") * y + value_of(n, "cy") + 0.5};
}

void at_random_pixels(const std::function<void(double u, double v)>& check) {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    for (int i = 0; i < 3000; ++i) {
        const double u = 1920.0 * part(random);
        check(u, 1080.0 * part(random));
    }
}

}  // namespace

// The stage gives no ray unless the miss is below 1e-12 of 1.25 times half of the diagonal; the
// formulas here have roundings of their own, some 1e-16 of the picture each.
TEST(CalibratedCameras, RaysPutIntoThePublishedFormulaGiveThePixel) {
    const double tolerance = 1e-12 * std::hypot(1920.0, 1080.0);
    for (const Lens& lens : lenses()) {
        const GeneratorProbe probe = probe_of(lens);
        int valid = 0;
        at_random_pixels([&](double u, double v) {
            const Sample s = probe(u, v);
            if (!s.valid) {
                return;
            }
            ++valid;
            EXPECT_NEAR(length(s.point), 1.0, 1e-14) << lens.name;
            const Pixel again = pixel_of(lens, s.point);
            EXPECT_NEAR(again[0], u, tolerance) << lens.name << ' ' << u << ' ' << v;
            EXPECT_NEAR(again[1], v, tolerance) << lens.name << ' ' << u << ' ' << v;
        });
        EXPECT_GE(valid / 3000.0, lens.min_share) << lens.name;
    }
}

TEST(CalibratedCameras, DerivativesAreDifferencesOfNeighbours) {
    constexpr double step = 1e-3;
    for (const Lens& lens : lenses()) {
        const GeneratorProbe probe = probe_of(lens);
        at_random_pixels([&](double u, double v) {
            const Sample s = probe(u, v);
            const Sample left = probe(u - step, v);
            const Sample right = probe(u + step, v);
            const Sample above = probe(u, v - step);
            const Sample below = probe(u, v + step);
            // Next to a fold, the third derivative is without bounds.
            if (!(s.valid && left.valid && right.valid && above.valid && below.valid) ||
                length(s.along_u) > 0.005 || length(s.along_v) > 0.005) {
                return;
            }
            expect_near((0.5 / step) * (right.point - left.point), s.along_u, 1e-9);
            expect_near((0.5 / step) * (below.point - above.point), s.along_v, 1e-9);
        });
    }
}

// From the centre outwards, the angle to the axis grows, and where the image of that lens has
// folded, there are no more rays.
TEST(CalibratedCameras, ShowNothingTwice) {
    for (const Lens& lens : lenses()) {
        const GeneratorProbe probe = probe_of(lens);
        for (const double turn : {0.1, 1.3, 2.9, 4.4, 5.6}) {
            double angle = 0.0;
            bool ended = false;
            for (double r = 1.0; r < 2500.0; r += 3.0) {
                const Sample s = probe(947.6 + r * std::cos(turn), 551.8 + r * std::sin(turn));
                EXPECT_FALSE(ended && s.valid) << lens.name << " at " << r;
                ended = ended || !s.valid;
                if (s.valid) {
                    const double now = std::atan2(std::hypot(s.point[1], s.point[2]), s.point[0]);
                    EXPECT_GT(now, angle) << lens.name << " at " << r;
                    angle = now;
                }
            }
        }
    }
}

// k1 alone folds where 1 + 3 k1 r² = 0, which the image has at 2/3 of that radius.
TEST(CalibratedCameras, EndAtTheFold) {
    const double k1 = -0.12;
    const double fold = 2.0 / 3.0 / std::sqrt(-3.0 * k1);
    const GeneratorProbe probe = probe_of(lens(
        "opencv_pinhole",
        {{"width", 1000}, {"height", 1000}, {"fx", 400}, {"cx", 499.5}, {"cy", 499.5}, {"k1", k1}},
        pinhole));
    EXPECT_TRUE(probe(500.0 + 400.0 * fold - 0.01, 500.0).valid);
    EXPECT_FALSE(probe(500.0 + 400.0 * fold + 0.01, 500.0).valid);
    EXPECT_FALSE(probe(500.0, 500.0 - 400.0 * fold - 0.01).valid);
}

TEST(CalibratedCameras, LookForwardWithTheImageUpright) {
    for (const Lens& lens : lenses()) {
        const GeneratorProbe probe = probe_of(lens);
        expect_near(probe(947.1 + 0.5, 551.3 + 0.5).point, {1.0, 0.0, 0.0}, 1e-12);
        const Vector right_below = probe(1000.0, 600.0).point;
        EXPECT_LT(right_below[1], 0.0) << lens.name;
        EXPECT_LT(right_below[2], 0.0) << lens.name;
    }
}

TEST(CalibratedCameras, HaveTheOriginOfOpenCVOrOfCOLMAP) {
    const auto camera = [](std::string_view origin) {
        return GeneratorProbe(object("opencv_pinhole", {{"width", numbers({640})},
                                                        {"height", numbers({480})},
                                                        {"fx", numbers({500})},
                                                        {"cx", numbers({300})},
                                                        {"cy", numbers({200})},
                                                        {"origin", std::string(origin)}}));
    };
    expect_near(camera("pixel_center")(300.5, 200.5).point, {1.0, 0.0, 0.0}, 0.0);
    expect_near(camera("pixel_corner")(300.0, 200.0).point, {1.0, 0.0, 0.0}, 0.0);
}

TEST(CalibratedCameras, HaveTheirCentreInTheMiddleAndTheirOwnPicture) {
    const ObjectGeneratorPointer camera =
        object("opencv_fisheye",
               {{"width", numbers({640})}, {"height", numbers({480})}, {"fx", numbers({500})}});
    expect_near(GeneratorProbe(camera)(320.0, 240.0).point, {1.0, 0.0, 0.0}, 1e-15);
    const auto picture = camera->own_picture();
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->u_first, 0.0);
    EXPECT_EQ(picture->u_last, 640.0);
    EXPECT_EQ(picture->v_first, 480.0);
    EXPECT_EQ(picture->v_last, 0.0);
}

TEST(CalibratedCameras, WarnOfAFoldInTheMiddleOfTheImage) {
    const auto made = try_stage(StageKind::object_generator, "opencv_pinhole",
                                {{"width", numbers({1000})},
                                 {"height", numbers({800})},
                                 {"fx", numbers({500})},
                                 {"k1", numbers({-3.0})}});
    ASSERT_TRUE(made);
    ASSERT_EQ(made.diagnostics.size(), 1U);
    EXPECT_EQ(made.diagnostics[0].message,
              "this distortion folds the image 111 pixels from its centre: there are no rays "
              "beyond");
}

// OCamCalib's world2cam: the radius rho at which the polynomial has the direction's slope.
TEST(Scaramuzza, RaysAreThoseOfThePolynomial) {
    const std::vector<double> a{-341.7, 0.0, 0.00089, -2.4e-7, 1.1e-9};
    const double c = 0.9996;
    const double d = 0.0004;
    const double e = -0.0002;
    const GeneratorProbe probe(object("scaramuzza", {{"width", numbers({1024})},
                                                     {"height", numbers({768})},
                                                     {"coefficients", PointList{1, a}},
                                                     {"row", numbers({388.3})},
                                                     {"column", numbers({516.4})},
                                                     {"c", numbers({c})},
                                                     {"d", numbers({d})},
                                                     {"e", numbers({e})}}));
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    for (int i = 0; i < 1000; ++i) {
        const double u = 1024.0 * part(random);
        const double v = 768.0 * part(random);
        const Sample s = probe(u, v);
        ASSERT_TRUE(s.valid);
        // Down, right and backwards.
        const Vector p{-s.point[2], -s.point[1], -s.point[0]};
        const double across = std::hypot(p[0], p[1]);
        double low = 0.0;
        double high = 2000.0;
        for (int k = 0; k < 200; ++k) {
            const double rho = 0.5 * (low + high);
            double f = 0.0;
            for (std::size_t j = a.size(); j-- > 0;) {
                f = f * rho + a[j];
            }
            (std::atan2(f, rho) < std::atan2(p[2], across) ? low : high) = rho;
        }
        const double x = p[0] / across * low;
        const double y = p[1] / across * low;
        EXPECT_NEAR(c * x + d * y + 388.3 + 0.5, v, 1e-9);
        EXPECT_NEAR(e * x + y + 516.4 + 0.5, u, 1e-9);
    }
    EXPECT_FALSE(try_stage(StageKind::object_generator, "scaramuzza",
                           {{"coefficients", PointList{1, {341.7, 0.0, 0.0}}}}));
}

}  // namespace balcony::camera::calibrated_cameras_test

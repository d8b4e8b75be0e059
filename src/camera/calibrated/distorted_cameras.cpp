// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Object generators, PCS → OCS: calibrated cameras whose published formulas lead from the scene to
// the image, by way of a distortion. A ray is the inverse of these formulas.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "camera/calibrated/image_model.hpp"
#include "camera/calibrated/undistortion.hpp"
#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"

namespace balcony::camera {

namespace {

/// The projection of the sphere of directions to the plane that is then distorted.
class Chart {
public:
    enum class Kind : std::uint8_t { perspective, equidistant, shifted_sphere };
    explicit Chart(Kind kind, double xi = 0.0) : kind_(kind), xi_(xi) {}

    /// How far from 0 the plane goes.
    double limit() const {
        constexpr double nearly_a_right_angle = 1e4;
        switch (kind_) {
            case Kind::perspective: return nearly_a_right_angle;
            case Kind::equidistant: return std::numbers::pi;
            case Kind::shifted_sphere: break;
        }
        return xi_ > 1.0 ? 1.0 / std::sqrt(xi_ * xi_ - 1.0) : nearly_a_right_angle;
    }
    ObjectVector direction(const PlanePoint<Expr>& p, Emitter& emit) const {
        const auto& [a, b] = p;
        const Expr q = a * a + b * b;
        switch (kind_) {
            case Kind::perspective: return {a, b, emit(1.0)};
            case Kind::equidistant: {
                constexpr double tiny = 1e-20;  // makes sin(r)/r equal 1 in the centre
                const Expr angle = sqrt(max(q, emit(tiny)));
                const Expr ratio = sin(angle) / angle;
                return {ratio * a, ratio * b, cos(angle)};
            }
            case Kind::shifted_sphere: break;
        }
        const Expr inside = 1.0 + (1.0 - xi_ * xi_) * q;
        emit.require(0.0 <= inside);
        const Expr factor = (xi_ + sqrt(max(inside, emit(0.0)))) / (1.0 + q);
        return {factor * a, factor * b, factor - xi_};
    }

private:
    Kind kind_;
    double xi_;
};

/// OpenCV's tilted sensor: R is the rotation by tau_x about x, then by tau_y about y.
class Tilt {
public:
    Tilt(double tau_x, double tau_y)
        : cos_x_(std::cos(tau_x)),
          sin_x_(std::sin(tau_x)),
          cos_y_(std::cos(tau_y)),
          sin_y_(std::sin(tau_y)) {}

    /// The vector through the point of an upright sensor that the tilted one has at (x, y).
    template <class Number>
    std::array<Number, 3> upright(const Number& x, const Number& y) const {
        const double r33 = cos_y_ * cos_x_;
        const Number a = (x - sin_y_ * cos_x_) / r33;
        const Number b = (y + sin_x_) / r33;
        return {cos_y_ * a + sin_y_, (sin_y_ * sin_x_) * a + cos_x_ * b - cos_y_ * sin_x_,
                sin_x_ * b - (sin_y_ * cos_x_) * a + r33};
    }

private:
    double cos_x_, sin_x_, cos_y_, sin_y_;
};

class DistortedModel final : public ImageModel {
public:
    DistortedModel(const Tilt& tilt, Undistortion undistortion, const Chart& chart)
        : tilt_(tilt), undistortion_(std::move(undistortion)), chart_(chart) {}
    ObjectVector direction(Expr x, Expr y, Emitter& emit) const override {
        const auto [a, b, depth] = tilt_.upright(x, y);
        emit.require(0.0 < depth);
        return chart_.direction(undistortion_.emit({a / depth, b / depth}, emit), emit);
    }

private:
    Tilt tilt_;
    Undistortion undistortion_;
    Chart chart_;
};

/// The distance from the centre that the inverse of the distortion has to cover: to the farthest
/// corner of the image, and a quarter more.
double reach_of(const ImageFrame& frame, const Tilt& tilt) {
    double farthest = 0.0;
    for (const auto& [x, y] : frame.corners()) {
        const auto [a, b, depth] = tilt.upright(x, y);
        farthest = std::max(farthest, depth > 0.0 ? std::hypot(a, b) / depth : 0.0);
    }
    return 1.25 * farthest;
}

/// A fold between the centre and the middle of an edge: this is more often a wrong coefficient than
/// a lens.
Diagnostics warn_of_fold(const ImageFrame& frame, const Distortion& distortion,
                         const Undistortion& undistortion, const Chart& chart) {
    const double edge = 0.5 * std::min(frame.width / frame.fx, frame.height / frame.fy);
    const auto [ends, zero] = distorted(distortion, PlanePoint<double>{undistortion.radius(), 0.0});
    if (ends >= edge || undistortion.radius() >= chart.limit()) {
        return {};
    }
    return {warning(
        fmt::format("this distortion folds the image {:.0f} pixels from its centre: there are no "
                    "rays beyond",
                    ends * std::min(frame.fx, frame.fy)),
        {}, "check the coefficients and their order; OpenCV has k1, k2, p1, p2, k3")};
}

StageResult distorted_camera(const Arguments& a, const Distortion& distortion, const Chart& chart,
                             const Tilt& tilt = Tilt(0.0, 0.0)) {
    const ImageFrame frame = frame_of(a);
    Undistortion undistortion(distortion, reach_of(frame, tilt), chart.limit());
    if (!undistortion.exists()) {
        return error("this distortion has no inverse in the centre of the image", {},
                     "check the coefficients and their order");
    }
    Diagnostics warnings = warn_of_fold(frame, distortion, undistortion, chart);
    return {calibrated_camera(
                a, frame, std::make_shared<DistortedModel>(tilt, std::move(undistortion), chart)),
            std::move(warnings)};
}

/// The first number and the parameters of these names, without zeros at the end.
std::vector<double> coefficients(const Arguments& a, double first,
                                 std::initializer_list<std::string_view> names) {
    std::vector<double> made{first};
    for (const std::string_view name : names) {
        made.push_back(a.constant(name));
    }
    while (made.size() > 1 && made.back() == 0.0) {
        made.pop_back();
    }
    return made;
}

StageResult make_pinhole(const Arguments& a) {
    return distorted_camera(
        a,
        {.numerator = coefficients(a, 1.0, {"k1", "k2", "k3"}),
         .denominator = coefficients(a, 1.0, {"k4", "k5", "k6"}),
         .tangential = {a.constant("p1"), a.constant("p2")},
         .prism = {a.constant("s1"), a.constant("s2"), a.constant("s3"), a.constant("s4")}},
        Chart(Chart::Kind::perspective), Tilt(a.constant("tau_x"), a.constant("tau_y")));
}

StageResult make_fisheye(const Arguments& a) {
    return distorted_camera(a, {.numerator = coefficients(a, 1.0, {"k1", "k2", "k3", "k4"})},
                            Chart(Chart::Kind::equidistant));
}

StageResult make_thin_prism_fisheye(const Arguments& a) {
    return distorted_camera(a,
                            {.numerator = coefficients(a, 1.0, {"k1", "k2", "k3", "k4"}),
                             .tangential = {a.constant("p1"), a.constant("p2")},
                             .prism = {a.constant("sx1"), 0.0, a.constant("sy1"), 0.0}},
                            Chart(Chart::Kind::equidistant));
}

StageResult make_kannala_brandt(const Arguments& a) {
    return distorted_camera(
        a, {.numerator = coefficients(a, a.constant("k1"), {"k2", "k3", "k4", "k5"})},
        Chart(Chart::Kind::equidistant));
}

StageResult make_omnidirectional(const Arguments& a) {
    return distorted_camera(a,
                            {.numerator = coefficients(a, 1.0, {"k1", "k2"}),
                             .tangential = {a.constant("p1"), a.constant("p2")}},
                            Chart(Chart::Kind::shifted_sphere, a.constant("xi")));
}

std::vector<StageParameter> coefficient_parameters(std::initializer_list<std::string_view> names,
                                                   std::string_view meaning) {
    std::vector<StageParameter> made;
    for (const std::string_view name : names) {
        made.push_back(coefficient_parameter(name, 0.0, meaning));
    }
    return made;
}

std::vector<StageParameter> tangential_parameters() {
    return coefficient_parameters({"p1", "p2"}, "a tangential coefficient");
}

StageParameter tilt_parameter(std::string_view name, std::string_view meaning) {
    return {.name = name,
            .type = NumberParameter{.unit = Unit::angle,
                                    .default_value = 0.0,
                                    .range = {.minimum = -1.5, .maximum = 1.5},
                                    .constant = true},
            .meaning = meaning};
}

}  // namespace

std::vector<StageEntry> distorted_cameras() {
    return {
        calibrated_row(
            {.name = "opencv_pinhole",
             .meaning = "a calibrated camera by OpenCV's model: a pinhole with radial, tangential, "
                        "thin prism and tilt distortion",
             .formula = R"(
the ray d of the pixel (u, v), whose forward formula is, with a = d_x/d_z,
b = d_y/d_z, q = a² + b²:
R = (1 + k1 q + k2 q² + k3 q³)/(1 + k4 q + k5 q² + k6 q³)
x = a R + 2 p1 a b + p2 (q + 2a²) + s1 q + s2 q²
y = b R + p1 (q + 2b²) + 2 p2 a b + s3 q + s4 q²
(x, y)   then moved by the tilt of the sensor about x and y, tau_x and tau_y
u = fx x + skew y + cx,   v = fy y + cy
no ray beyond the radius where the distortion folds
)",
             .parameters =
                 coefficient_parameters({"k1", "k2", "k3"}, "a radial coefficient") +
                 coefficient_parameters({"k4", "k5", "k6"},
                                        "a radial coefficient of the denominator") +
                 tangential_parameters() +
                 coefficient_parameters({"s1", "s2", "s3", "s4"}, "a thin prism coefficient") +
                 std::vector{tilt_parameter("tau_x", "the tilt of the sensor about x"),
                             tilt_parameter("tau_y", "the tilt of the sensor about y")},
             .make = make_pinhole,
             .example = R"(
// An action camera with a strong barrel distortion.
camera action {
    eye opencv_pinhole(width = 1920, height = 1080, fx = 900, cx = 952.3, cy = 541.8,
                       k1 = -0.24, k2 = 0.07, k3 = -0.009, p1 = 0.0004, p2 = -0.0002)
}
)"}),
        calibrated_row(
            {.name = "opencv_fisheye",
             .meaning = "a calibrated fisheye camera by OpenCV's model, which is Kannala and "
                        "Brandt's with k1 = 1",
             .formula = R"(
the ray d of the pixel (u, v), whose forward formula is, with its angle θ to the
axis and its azimuth φ:
r = θ (1 + k1 θ² + k2 θ⁴ + k3 θ⁶ + k4 θ⁸)
x = r cos φ,   y = r sin φ,   u = fx x + skew y + cx,   v = fy y + cy
no ray beyond the angle where the distortion folds, or 180°
)",
             .parameters = coefficient_parameters({"k1", "k2", "k3", "k4"}, "a radial coefficient"),
             .make = make_fisheye,
             .example = R"(
// A fisheye lens of 150 degrees from one side of the picture to the other.
camera doorbell {
    eye opencv_fisheye(width = 1600, height = 1200, fx = 610, cx = 803.1, cy = 597.4,
                       k1 = 0.021, k2 = -0.013, k3 = 0.0047, k4 = -0.0009)
}
)"}),
        calibrated_row(
            {.name = "kannala_brandt",
             .meaning = "a calibrated camera by Kannala and Brandt's radially symmetric model of "
                        "five coefficients",
             .formula = R"(
the ray d of the pixel (u, v), whose forward formula is, with its angle θ to the
axis and its azimuth φ (Kannala and Brandt 2006):
r = k1 θ + k2 θ³ + k3 θ⁵ + k4 θ⁷ + k5 θ⁹
x = r cos φ,   y = r sin φ,   u = fx x + skew y + cx,   v = fy y + cy
no ray beyond the angle where r decreases, or 180°
)",
             .parameters =
                 std::vector{StageParameter{
                     .name = "k1",
                     .type = NumberParameter{.default_value = 1.0,
                                             .range = {.minimum = 0.0, .excludes_minimum = true},
                                             .constant = true},
                     .meaning = "the coefficient of θ"}} +
                 coefficient_parameters({"k2", "k3", "k4", "k5"},
                                        "the coefficient of the next odd power"),
             .make = make_kannala_brandt,
             .example = R"(
// A circular fisheye lens of 190 degrees, in millimetres: fx is the number of pixels in one.
camera circular {
    eye kannala_brandt(width = 1400, height = 1400, fx = 220, k1 = 1.85, k2 = 0.032, k3 = -0.014)
}
)"}),
        calibrated_row(
            {.name = "thin_prism_fisheye",
             .meaning = "a calibrated fisheye camera by COLMAP's model with tangential and thin "
                        "prism distortion",
             .formula = R"(
the ray d of the pixel (u, v), whose forward formula is, with its angle θ to the
axis, its azimuth φ, a = θ cos φ, b = θ sin φ, q = θ²:
R = 1 + k1 q + k2 q² + k3 q³ + k4 q⁴
x = a R + 2 p1 a b + p2 (q + 2a²) + sx1 q
y = b R + p1 (q + 2b²) + 2 p2 a b + sy1 q
u = fx x + skew y + cx,   v = fy y + cy
no ray beyond the angle where the distortion folds, or 180°
)",
             .parameters =
                 coefficient_parameters({"k1", "k2", "k3", "k4"}, "a radial coefficient") +
                 tangential_parameters() +
                 coefficient_parameters({"sx1", "sy1"}, "a thin prism coefficient"),
             .make = make_thin_prism_fisheye,
             .example = R"(
camera rig {
    eye thin_prism_fisheye(width = 1500, height = 1000, fx = 640, origin = pixel_corner,
                           k1 = -0.03, k2 = 0.004, p1 = 0.0011, p2 = -0.0008, sx1 = 0.002)
}
)"}),
        calibrated_row(
            {.name = "omnidirectional",
             .meaning = "a calibrated catadioptric or fisheye camera by Mei's model, as in "
                        "OpenCV's omnidir",
             .formula = R"(
the ray d of the pixel (u, v), whose forward formula is, with the unit vector d
(Mei and Rives 2007):
a = d_x/(d_z + xi),   b = d_y/(d_z + xi),   q = a² + b²
x = a (1 + k1 q + k2 q²) + 2 p1 a b + p2 (q + 2a²)
y = b (1 + k1 q + k2 q²) + p1 (q + 2b²) + 2 p2 a b
u = fx x + skew y + cx,   v = fy y + cy
no ray beyond the radius where the distortion folds
)",
             .parameters = std::vector{StageParameter{
                               .name = "xi",
                               .type = NumberParameter{.default_value = 1.0,
                                                       .range = {.minimum = 0.0},
                                                       .constant = true},
                               .meaning = "how far the sphere's centre is in front of the centre "
                                          "of projection: 0 is a pinhole, 1 a parabolic mirror"}} +
                           coefficient_parameters({"k1", "k2"}, "a radial coefficient") +
                           tangential_parameters(),
             .make = make_omnidirectional,
             .example = R"(
// A lens that sees 200 degrees.
camera all_around {
    eye omnidirectional(width = 1200, height = 1200, fx = 560, xi = 1.4, k1 = -0.12, k2 = 0.03,
                        p1 = 0.0003, p2 = 0.0006)
}
)"}),
    };
}

}  // namespace balcony::camera

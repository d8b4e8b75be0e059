// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Object generators, PCS → OCS: calibrated cameras whose ray of a pixel is a closed formula.

#include <cmath>
#include <numbers>

#include "camera/calibrated/image_model.hpp"
#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"

namespace balcony::camera {

namespace {

Expr squared_radius(Expr x, Expr y) { return x * x + y * y; }

/// Devernay and Faugeras, "Straight Lines Have to Be Straight" (2001).
class FieldOfViewModel final : public ImageModel {
public:
    explicit FieldOfViewModel(double omega) : omega_(omega) {}
    ObjectVector direction(Expr x, Expr y, Emitter& emit) const override {
        constexpr double tiny = 1e-20;
        const Expr r = sqrt(max(squared_radius(x, y), emit(tiny)));
        emit.require(omega_ * r < 0.5 * std::numbers::pi);
        const Expr ratio = tan(omega_ * r) / (2.0 * std::tan(0.5 * omega_) * r);
        return {ratio * x, ratio * y, emit(1.0)};
    }

private:
    double omega_;
};

/// Fitzgibbon, "Simultaneous Linear Estimation of Multiple View Geometry and Lens Distortion"
/// (2001).
class DivisionModel final : public ImageModel {
public:
    DivisionModel(double first, double second) : first_(first), second_(second) {}
    ObjectVector direction(Expr x, Expr y, Emitter& emit) const override {
        const Expr q = squared_radius(x, y);
        const Expr depth = 1.0 + q * (first_ + second_ * q);
        emit.require(0.0 < depth);
        // The undistorted radius r/depth increases with r.
        emit.require(0.0 < 1.0 - q * (first_ + (3.0 * second_) * q));
        return {x, y, depth};
    }

private:
    double first_, second_;
};

/// Usenko, Demmel and Cremers, "The Double Sphere Camera Model" (2018), section 3.4.
class DoubleSphereModel final : public ImageModel {
public:
    DoubleSphereModel(double xi, double alpha) : xi_(xi), alpha_(alpha) {}
    ObjectVector direction(Expr x, Expr y, Emitter& emit) const override {
        const Expr q = squared_radius(x, y);
        const Expr inner = 1.0 - (2.0 * alpha_ - 1.0) * q;
        emit.require(0.0 <= inner);
        const Expr depth =
            (1.0 - (alpha_ * alpha_) * q) / (alpha_ * sqrt(max(inner, emit(0.0))) + (1.0 - alpha_));
        const Expr squared = depth * depth + (1.0 - xi_ * xi_) * q;
        emit.require(0.0 <= squared);
        const Expr ratio = (xi_ * depth + sqrt(max(squared, emit(0.0)))) / (depth * depth + q);
        return {ratio * x, ratio * y, ratio * depth - xi_};
    }

private:
    double xi_, alpha_;
};

/// Khomutenko, Garcia and Martinet, "An Enhanced Unified Camera Model" (2016).
class ExtendedUnifiedModel final : public ImageModel {
public:
    ExtendedUnifiedModel(double alpha, double beta) : alpha_(alpha), beta_(beta) {}
    ObjectVector direction(Expr x, Expr y, Emitter& emit) const override {
        const Expr q = beta_ * squared_radius(x, y);
        const Expr inner = 1.0 - (2.0 * alpha_ - 1.0) * q;
        emit.require(0.0 <= inner);
        return {x, y,
                (1.0 - (alpha_ * alpha_) * q) /
                    (alpha_ * sqrt(max(inner, emit(0.0))) + (1.0 - alpha_))};
    }

private:
    double alpha_, beta_;
};

/// Scaramuzza, Martinelli and Siegwart, "A Toolbox for Easily Calibrating Omnidirectional Cameras"
/// (2006). OCamCalib's x runs down the image, y to the right and z backwards.
class ScaramuzzaModel final : public ImageModel {
public:
    ScaramuzzaModel(std::vector<double> coefficients, const std::array<double, 3>& affine,
                    double needed)
        : coefficients_(std::move(coefficients)), affine_(affine), reach_(reach(needed)) {}
    [[nodiscard]] bool exists() const { return reach_ > 0.0; }
    /// x and y are in pixels.
    ObjectVector direction(Expr x, Expr y, Emitter& emit) const override {
        constexpr double tiny = 1e-20;
        const auto& [c, d, e] = affine_;
        const double determinant = c - d * e;
        const Expr down = (y - d * x) / determinant;
        const Expr right = (c * x - e * y) / determinant;
        const Expr rho = sqrt(max(squared_radius(down, right), emit(tiny)));
        emit.require(rho <= emit(reach_));
        Expr backwards = emit(coefficients_.back());
        for (std::size_t i = coefficients_.size() - 1; i-- > 0;) {
            backwards = backwards * rho + coefficients_[i];
        }
        return {right, down, -backwards};
    }

private:
    /// Up to where the angle from the axis increases with rho: -f + rho f' > 0.
    [[nodiscard]] double reach(double needed) const {
        constexpr int parts = 4096;
        for (int i = 0; i <= parts; ++i) {
            const double rho = needed * i / parts;
            double turn = 0.0;
            double power = 1.0;
            for (std::size_t k = 0; k < coefficients_.size(); ++k) {
                turn += (static_cast<double>(k) - 1.0) * coefficients_[k] * power;
                power *= rho;
            }
            if (!(turn > 0.0)) {
                return needed * (i - 1) / parts;
            }
        }
        return needed;
    }

    std::vector<double> coefficients_;
    std::array<double, 3> affine_;
    double reach_;
};

template <class Model, class... Numbers>
StageResult closed_form(const Arguments& a, Numbers... numbers) {
    return {calibrated_camera(a, frame_of(a), std::make_shared<const Model>(numbers...))};
}

StageResult make_scaramuzza(const Arguments& a) {
    const std::array affine{a.constant("c"), a.constant("d"), a.constant("e")};
    if (affine[0] == affine[1] * affine[2]) {
        return error("the affine matrix ((c, d), (e, 1)) has no inverse", {},
                     "check the order: OCamCalib writes c, d, e, with c near 1");
    }
    const double width = a.constant("width");
    const double height = a.constant("height");
    const ImageFrame frame{.width = width,
                           .height = height,
                           .fx = 1.0,
                           .fy = 1.0,
                           .cx = (a.has("column") ? a.constant("column") : 0.5 * width - 0.5) + 0.5,
                           .cy = (a.has("row") ? a.constant("row") : 0.5 * height - 0.5) + 0.5};
    auto model = std::make_shared<const ScaramuzzaModel>(a.points("coefficients").values, affine,
                                                         2.0 * std::hypot(width, height));
    if (!model->exists()) {
        return error("the first coefficient of OCamCalib's polynomial must be below 0", {},
                     "write a0, a1, a2, ... in this order, as calib_results.txt has them");
    }
    return {calibrated_camera(a, frame, std::move(model))};
}

StageParameter number_in(std::string_view name, double value, Range range,
                         std::string_view meaning) {
    return {.name = name,
            .type = NumberParameter{.default_value = value, .range = range, .constant = true},
            .meaning = meaning};
}

StageParameter optional_number(std::string_view name, std::string_view meaning) {
    return {.name = name,
            .type = NumberParameter{.constant = true},
            .optional = true,
            .meaning = meaning};
}

StageEntry scaramuzza_row() {
    StageEntry row = calibrated_row(
        {.name = "scaramuzza",
         .meaning = "a calibrated omnidirectional camera by Scaramuzza's polynomial, as OCamCalib "
                    "writes it",
         .formula = R"(
the ray of the pixel (u, v), with x down, y to the right and z backwards:
d = (x, y, a0 + a1 ρ + a2 ρ² + a3 ρ³ + …),   ρ = √(x² + y²)
((c, d), (e, 1)) (x, y) = (v − row, u − column)
no ray beyond the radius where the angle to the axis decreases
)",
         .make = make_scaramuzza,
         .example = R"(
// A fisheye camera of 185 degrees.
camera robot {
    eye scaramuzza(1024, 768, [-341.7, 0, 0.00089, -2.4e-7, 1.1e-9],
                   row = 388.3, column = 516.4, c = 0.9996, d = 0.0004, e = -0.0002)
}
)"});
    const std::vector<StageParameter> frame = frame_parameters();
    row.parameters = {frame[0],
                      frame[1],
                      {.name = "coefficients",
                       .type = PointsParameter{.coordinates = {1}, .min_points = 2},
                       .meaning = "a0, a1, a2, ... of the polynomial; a0 is negative"},
                      optional_number("row",
                                      "the row of the centre in pixels, from that of the "
                                      "top pixels; without it, of the image"),
                      optional_number("column", "its column, from that of the pixels on the left"),
                      number_in("c", 1.0, {}, "of the affine matrix"),
                      number_in("d", 0.0, {}, "of the affine matrix"),
                      number_in("e", 0.0, {}, "of the affine matrix"),
                      sphere_parameter()};
    return row;
}

}  // namespace

std::vector<StageEntry> closed_form_cameras() {
    return {
        calibrated_row(
            {.name = "field_of_view",
             .meaning = "a calibrated camera by the field of view model of Devernay and Faugeras, "
                        "COLMAP's FOV",
             .formula = R"(
the ray of the pixel (u, v), with y = (v − cy)/fy, x = (u − cx − skew y)/fx,
r = √(x² + y²):
d = (s x, s y, 1),   s = tan(r ω)/(2 r tan(ω/2)),   ω = omega,   r ω < 90°
)",
             .parameters = {{.name = "omega",
                             .type = NumberParameter{.unit = Unit::angle,
                                                     .default_value = 1.0,
                                                     .range = {.minimum = 0.0,
                                                               .maximum = 3.1,
                                                               .excludes_minimum = true},
                                                     .constant = true},
                             .meaning = "the angle of view of an ideal fisheye lens"}},
             .make =
                 [](const Arguments& a) {
                     return closed_form<FieldOfViewModel>(a, a.constant("omega"));
                 },
             .example = R"(
camera phone {
    eye field_of_view(width = 640, height = 480, fx = 280, omega = 53deg)
}
)"}),
        calibrated_row(
            {.name = "division",
             .meaning = "a calibrated camera by Fitzgibbon's division model",
             .formula = R"(
the ray of the pixel (u, v), with y = (v − cy)/fy, x = (u − cx − skew y)/fx,
q = x² + y²:
d = (x, y, 1 + l1 q + l2 q²)
no ray where d is not in front of the camera or its angle to the axis decreases
)",
             .parameters = {coefficient_parameter("l1", 0.0,
                                                  "the coefficient of the squared radius in focal "
                                                  "lengths; negative for a barrel distortion"),
                            coefficient_parameter("l2", 0.0, "that of its square")},
             .make =
                 [](const Arguments& a) {
                     return closed_form<DivisionModel>(a, a.constant("l1"), a.constant("l2"));
                 },
             .example = R"(
camera dashboard {
    eye division(width = 1280, height = 720, fx = 640, l1 = -0.31)
}
)"}),
        calibrated_row(
            {.name = "double_sphere",
             .meaning = "a calibrated fisheye camera by the double sphere model",
             .formula = R"(
the ray of the pixel (u, v), with y = (v − cy)/fy, x = (u − cx − skew y)/fx,
q = x² + y²:
m = (1 − α² q)/(α √(1 − (2α − 1) q) + 1 − α),   α = alpha
s = (m ξ + √(m² + (1 − ξ²) q))/(m² + q),   ξ = xi
d = (s x, s y, s m − ξ),   |d| = 1
no ray where a root is of a negative number
)",
             .parameters = {number_in("xi", 0.0, {.minimum = -1.0, .maximum = 2.0},
                                      "the distance of the two spheres"),
                            number_in("alpha", 0.5, {.minimum = 0.0, .maximum = 1.0},
                                      "how far the pinhole is shifted, as a part of itself and 1")},
             .make =
                 [](const Arguments& a) {
                     return closed_form<DoubleSphereModel>(a, a.constant("xi"),
                                                           a.constant("alpha"));
                 },
             .example = R"(
// A fisheye camera of a headset.
camera headset {
    eye double_sphere(width = 1024, height = 1024, fx = 313.2, cx = 511.7, cy = 512.9,
                      xi = -0.18, alpha = 0.591)
}
)"}),
        calibrated_row(
            {.name = "extended_unified",
             .meaning =
                 "a calibrated camera by the extended unified model; with beta = 1 it is the "
                 "unified model of Geyer and Daniilidis",
             .formula = R"(
the ray of the pixel (u, v), with y = (v − cy)/fy, x = (u − cx − skew y)/fx,
q = β (x² + y²):
d = (x, y, (1 − α² q)/(α √(1 − (2α − 1) q) + 1 − α)),   α = alpha,   β = beta
no ray where the root is of a negative number
)",
             .parameters = {number_in("alpha", 0.5, {.minimum = 0.0, .maximum = 1.0},
                                      "0 is a pinhole, 0.5 a parabolic mirror"),
                            number_in("beta", 1.0, {.minimum = 0.0, .excludes_minimum = true},
                                      "the squared ratio of the axes of the ellipsoid in place of "
                                      "the sphere")},
             .make =
                 [](const Arguments& a) {
                     return closed_form<ExtendedUnifiedModel>(a, a.constant("alpha"),
                                                              a.constant("beta"));
                 },
             .example = R"(
camera drone {
    eye extended_unified(width = 752, height = 480, fx = 271, alpha = 0.62, beta = 1.06)
}
)"}),
        scaramuzza_row(),
    };
}

}  // namespace balcony::camera

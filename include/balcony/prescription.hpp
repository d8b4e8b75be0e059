// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Prescriptions: lenses of glass, surface by surface from the scene to the sensor, and their
// paraxial optics. Lengths are in millimetres, wavelengths in micrometres.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/base.hpp"

namespace balcony::camera {

/// Wavelengths of the lines that indices of glass are given for.
inline constexpr double line_d = 0.5875618;
inline constexpr double line_F = 0.4861327;
inline constexpr double line_C = 0.6562725;

/// What is between two surfaces, by its refractive index n at the wavelength w.
struct Medium {
    enum class Dispersion : std::uint8_t {
        none,       ///< n = c0
        cauchy,     ///< n = c0 + c1/w² + c2/w⁴
        schott,     ///< n² = c0 + c1 w² + c2/w² + c3/w⁴ + c4/w⁶ + c5/w⁸
        sellmeier,  ///< n² = 1 + c0 w²/(w² - c3) + c1 w²/(w² - c4) + c2 w²/(w² - c5)
    };

    std::string name{};  ///< For messages.
    Dispersion dispersion = Dispersion::none;
    std::array<double, 6> coefficients{1.0};

    [[nodiscard]] double index(double wavelength) const;
    /// Cauchy's formula with two terms that has this index at d and this Abbe number,
    /// (n_d - 1)/(n_F - n_C).
    [[nodiscard]] static Medium by_abbe_number(double index, double abbe_number);
};

/// A glass that Balcony knows, in letters of any case; null if it knows none of this name.
[[nodiscard]] const Medium* find_glass(std::string_view name);
[[nodiscard]] std::vector<std::string> glass_names();

/// A surface of revolution around the axis of the lens, or a plane with a hole, the stop. At the
/// distance h from the axis it is h² c/(1 + √(1 - (1 + k) c² h²)) + a4 h⁴ + a6 h⁶ + ... nearer to
/// the sensor than on the axis.
///
/// With curvature_x, it is toroidal: this curve in the vertical plane through the axis, turned
/// about a vertical line that is 1/curvature_x behind its vertex. With curvature_x = 0, it is moved
/// to the sides instead: a cylinder.
struct LensSurface {
    double curvature = 0.0;  ///< c: positive if the centre of curvature is on the sensor's side.
    double conic = 0.0;      ///< k: 0 is a sphere.
    std::array<double, 5> aspheric{};     ///< a4, a6, a8, a10, a12.
    std::optional<double> curvature_x{};  ///< In the horizontal plane, if that is another one.
    double radius = 0.0;                  ///< Of the hole through which light passes.
    bool stop = false;                    ///< Of the surfaces, one is the stop.
    double gap = 0.0;                     ///< To the next surface along the axis.
    Medium behind{};                      ///< As far as the next surface.
    SourceSpan written{};                 ///< Where a file has it.

    /// Whether it has terms of h⁴ or more.
    [[nodiscard]] bool is_aspheric() const;
    /// How far it is behind its vertex at a point; not a number where the surface ends.
    [[nodiscard]] double sag(double x, double y = 0.0) const;
};

/// A lens in air.
struct Prescription {
    std::string name;                     ///< For messages.
    std::vector<LensSurface> surfaces{};  ///< From the scene to the sensor, at least one.

    [[nodiscard]] std::size_t stop() const;  ///< The index of the stop.
    /// Whether a surface is toroidal.
    [[nodiscard]] bool is_anamorphic() const;
};

/// The lens of revolution with the optics near the axis that a lens has in the horizontal plane:
/// its toroidal surfaces have their horizontal curvature, and no terms of higher order.
[[nodiscard]] Prescription horizontal_section(const Prescription& lens);

/// What makes it no lens, at the surfaces' places in the file: none or several stops, numbers that
/// are not finite, a surface that ends before its hole does, surfaces that cross, a stop that lets
/// nothing through, a surface that reflects all light of the axis but that next to it, no real
/// image of what is far away in the vertical or the horizontal plane.
[[nodiscard]] Diagnostics check(const Prescription& lens);

/// The optics of rays near the axis, in the vertical plane. Positions are along the axis towards
/// the sensor.
struct ParaxialLens {
    double focal_length = 0.0;
    double front_focus = 0.0;      ///< From the first surface: negative in front of it.
    double back_focus = 0.0;       ///< From the last surface.
    double front_principal = 0.0;  ///< From the first surface.
    double back_principal = 0.0;   ///< From the last surface.
    double entrance_pupil = 0.0;   ///< From the first surface.
    double entrance_radius = 0.0;
    double exit_pupil = 0.0;  ///< From the last surface.
    double exit_radius = 0.0;

    /// Of the stop as wide as it is.
    [[nodiscard]] double f_number() const { return 0.5 * focal_length / entrance_radius; }
};

/// Of a lens that check() finds nothing wrong with.
[[nodiscard]] ParaxialLens paraxial(const Prescription& lens, double wavelength = line_d);

/// Light of a point that is far away, through a lens that is focused there for the line d.
struct SpotOptions {
    /// Where the light comes from: the tangents of its angle to the right of the axis and above it.
    std::array<double, 2> field{};
    double wavelength = line_d;
    std::optional<double> f_number{};  ///< Without it, the stop is as wide as it is.
    double defocus = 0.0;              ///< How far behind its focus the sensor is.
};

/// Where this light arrives.
struct Spot {
    /// The centroid on the sensor, in the axes of `field`: of an image, which is upside down, the
    /// negative tangent times the focal length, and distortion.
    std::array<double, 2> middle{};
    double rms_radius = 0.0;  ///< The root of the mean square of the distance from the centroid.
    double area = 0.0;  ///< Of the light that passes, at right angles to it in front of the lens.
};

/// Of light from one direction, in several colours.
struct FieldSpots {
    std::array<double, 2> degrees{};  ///< To the right of the axis and above it.
    std::vector<Spot> spots{};        ///< By wavelength.
    double light = 1.0;               ///< In relation to that of the axis.
    double distortion = 0.0;  ///< How much farther from the axis it arrives than a pinhole's does.
};

/// By tracing some 10,000 rays, all of which carry the same part of the light, through a lens that
/// check() finds nothing wrong with. Nothing if none passes.
[[nodiscard]] std::optional<Spot> spot_of(const Prescription& lens, const SpotOptions& options);

/// The colours of field_spots().
inline constexpr std::array spot_wavelengths{line_F, line_d, line_C};

/// On the axis, above it, and of an anamorphic lens also beside it, as far as light passes, up to
/// 60 degrees; nothing if none passes on the axis. Light and distortion are those of the line d.
[[nodiscard]] std::vector<FieldSpots> field_spots(const Prescription& lens);

}  // namespace balcony::camera

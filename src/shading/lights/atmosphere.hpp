// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Sunlight in the air of the earth: scattering by molecules (Rayleigh) and by haze (Mie), and
// absorption by ozone. The formulation follows Bruneton and Neyret, "Precomputed Atmospheric
// Scattering" (2008); light that is scattered more than once follows Hillaire, "A Scalable and
// Production Ready Sky and Atmosphere Rendering Technique" (2020).

#include <array>
#include <cstddef>
#include <vector>

#include <Imath/ImathColor.h>
#include <Imath/ImathVec.h>

namespace balcony::render {

/// Values at wavelengths from 390 nm, 30 nm apart.
class Spectrum {
public:
    static constexpr std::size_t size = 11;

    Spectrum() = default;
    explicit Spectrum(double value) { values_.fill(value); }
    /// A function of the wavelength in nanometres.
    template <class Function>
    static Spectrum of(const Function& function) {
        Spectrum made;
        for (std::size_t i = 0; i < size; ++i) {
            made.values_[i] = function(wavelength(i));
        }
        return made;
    }

    [[nodiscard]] static constexpr double wavelength(std::size_t i) {
        return 390.0 + step * static_cast<double>(i);
    }
    [[nodiscard]] double& operator[](std::size_t i) { return values_[i]; }
    [[nodiscard]] double operator[](std::size_t i) const { return values_[i]; }

    /// In linear Rec. 709, of which Y is a luminance in cd/m² if this is radiance in W/(m² sr nm).
    /// Colours that it cannot show are clamped.
    [[nodiscard]] Imath::Color3f to_color() const;

    static constexpr double step = 30.0;

private:
    std::array<double, size> values_{};
};

/// The air, and the sun above it. Lengths are in metres; heights are above sea level.
class Atmosphere {
public:
    /// The turbidity is the optical depth of air with haze over that of pure air; from 1 to 10. The
    /// elevation of the sun is in radians.
    Atmosphere(double turbidity, double elevation);

    /// The radiance of the sky at sea level in a direction with z up, where the sun is above x.
    [[nodiscard]] Spectrum sky(const Imath::V3d& direction) const;
    /// The irradiance of the sun at sea level, on a plane perpendicular to its direction.
    [[nodiscard]] Spectrum sun() const;
    [[nodiscard]] const Imath::V3d& to_sun() const { return to_sun_; }

private:
    /// Amounts of what scatters and absorbs: molecules, haze, ozone, in metres of the densities of
    /// the coefficients.
    using Amounts = std::array<double, 3>;

    /// A point by its distance from the centre of the earth, and a direction by its cosine from
    /// the vertical.
    struct Sightline {
        double radius = 0.0;
        double cosine = 0.0;
        [[nodiscard]] Sightline moved(double distance) const;
    };

    /// A ray through the air: the parts of the light that its steps scatter to its beginning.
    struct ScatteringRay {
        struct Step {
            Imath::V3d position;
            Spectrum part;
        };
        std::array<Step, 20> steps;
        Imath::V3d end;
        bool meets_ground = false;
        Spectrum transmitted;
    };

    [[nodiscard]] static Amounts densities(double radius);
    [[nodiscard]] static double distance_to_top(const Sightline& line);
    [[nodiscard]] static bool meets_ground(const Sightline& line);
    [[nodiscard]] static Amounts amounts_to_top(const Sightline& line);

    [[nodiscard]] double extinction(const Amounts& amounts, std::size_t wavelength) const;
    [[nodiscard]] Spectrum sunlight(const Sightline& sun) const;
    void tabulate_amounts();
    void tabulate_multiple_scattering();
    [[nodiscard]] Spectrum multiple_scattering(const Sightline& sun) const;
    [[nodiscard]] std::vector<ScatteringRay> scattering_rays(double radius) const;
    [[nodiscard]] Spectrum mean_scattered_light(const std::vector<ScatteringRay>& rays,
                                                double sun_cosine) const;

    Imath::V3d to_sun_;
    Spectrum sun_outside_;                                // Irradiance.
    Spectrum rayleigh_, haze_, haze_extinction_, ozone_;  // Coefficients, per metre.
    std::vector<Amounts> amounts_;                        // By height and cosine.
    std::vector<Spectrum> multiple_;                      // By height and cosine of the sun.
};

}  // namespace balcony::render

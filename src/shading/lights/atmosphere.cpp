// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "shading/lights/atmosphere.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/parallel_for.hpp"

namespace balcony::render {

namespace {

using Imath::V3d;

using std::numbers::pi;
constexpr double ground = 6'360'000.0;  // The radius of the earth, in metres.
constexpr double top = ground + 100'000.0;
constexpr double observer = ground + 1.0;
constexpr double planet_albedo = 0.3;

constexpr std::size_t molecules = 0;
constexpr std::size_t haze = 1;
constexpr std::size_t ozone = 2;

constexpr double rayleigh_height = 8000.0;  // In which the density falls to 1/e.
constexpr double haze_height = 1200.0;
constexpr double haze_albedo = 0.9;
constexpr double haze_asymmetry = 0.76;
constexpr double ozone_middle = 25'000.0;
constexpr double ozone_half_width = 15'000.0;

double square(double x) { return x * x; }

double gaussian(double x, double center, double below, double above) {
    return std::exp(-0.5 * square((x - center) / (x < center ? below : above)));
}

// The matching functions of the CIE of 1931: Wyman, Sloan and Shirley, "Simple Analytic
// Approximations to the CIE XYZ Color Matching Functions" (JCGT 2013), table 1.
V3d matching_functions(double nm) {
    return {1.056 * gaussian(nm, 599.8, 37.9, 31.0) + 0.362 * gaussian(nm, 442.0, 16.0, 26.7) -
                0.065 * gaussian(nm, 501.1, 20.4, 26.2),
            0.821 * gaussian(nm, 568.8, 46.9, 40.5) + 0.286 * gaussian(nm, 530.9, 16.3, 31.1),
            1.217 * gaussian(nm, 437.0, 11.8, 36.0) + 0.681 * gaussian(nm, 459.0, 26.0, 13.8)};
}

// Planck's law for the sun's effective temperature, in W/(m² nm), at the mean distance.
double sun_irradiance(double nm) {
    constexpr double temperature = 5772.0;
    constexpr double sun_solid_angle = 6.79e-5;
    constexpr double c1 = 1.191043e20;  // 2 h c², for wavelengths in nanometres.
    constexpr double c2 = 1.438777e7;   // h c / k
    const double radiance = c1 / (std::pow(nm, 5.0) * std::expm1(c2 / (nm * temperature)));
    return radiance * sun_solid_angle;
}

double rayleigh_phase(double cosine) { return 3.0 / (16.0 * pi) * (1.0 + square(cosine)); }

// Cornette and Shanks (1992).
double haze_phase(double cosine) {
    constexpr double g = haze_asymmetry;
    const double spread = 1.0 + square(g) - 2.0 * g * cosine;
    return 3.0 / (8.0 * pi) * (1.0 - square(g)) / (2.0 + square(g)) * (1.0 + square(cosine)) /
           (spread * std::sqrt(spread));
}

// A table over the height, which is finer near the ground, and over a cosine, which is finer near
// the horizon.
struct Grid {
    std::size_t heights;
    std::size_t cosines;

    [[nodiscard]] double height(std::size_t i) const {
        return (top - ground) * square(static_cast<double>(i) / static_cast<double>(heights - 1));
    }
    [[nodiscard]] double cosine(std::size_t i) const {
        const double x = 2.0 * static_cast<double>(i) / static_cast<double>(cosines - 1) - 1.0;
        return x * std::abs(x);
    }

    // Calls a function with the indices of four values and their shares.
    template <class Function>
    void interpolate(double height, double cosine, const Function& add) const {
        const auto split = [](double x, std::size_t count) {
            const double at = std::clamp(x, 0.0, 1.0) * static_cast<double>(count - 1);
            const std::size_t low = std::min(static_cast<std::size_t>(at), count - 2);
            return std::pair(low, at - static_cast<double>(low));
        };
        const auto [h, s] = split(std::sqrt(std::max(height, 0.0) / (top - ground)), heights);
        const double x = std::copysign(std::sqrt(std::abs(cosine)), cosine);
        const auto [c, t] = split(0.5 * (x + 1.0), cosines);
        add(h * cosines + c, (1.0 - s) * (1.0 - t));
        add(h * cosines + c + 1, (1.0 - s) * t);
        add((h + 1) * cosines + c, s * (1.0 - t));
        add((h + 1) * cosines + c + 1, s * t);
    }
};

constexpr Grid amount_grid{48, 256};
constexpr Grid multiple_grid{16, 32};

}  // namespace

Imath::Color3f Spectrum::to_color() const {
    constexpr double lumens_per_watt = 683.0;
    V3d xyz(0.0);
    for (std::size_t i = 0; i < size; ++i) {
        xyz += values_[i] * step * lumens_per_watt * matching_functions(wavelength(i));
    }
    const V3d color(3.2404542 * xyz.x - 1.5371385 * xyz.y - 0.4985314 * xyz.z,
                    -0.9692660 * xyz.x + 1.8760108 * xyz.y + 0.0415560 * xyz.z,
                    0.0556434 * xyz.x - 0.2040259 * xyz.y + 1.0572252 * xyz.z);
    const auto shown = [](double value) { return static_cast<float>(std::max(value, 0.0)); };
    return {shown(color.x), shown(color.y), shown(color.z)};
}

Atmosphere::Sightline Atmosphere::Sightline::moved(double distance) const {
    const double moved_radius =
        std::sqrt(square(radius) + square(distance) + 2.0 * radius * distance * cosine);
    return {moved_radius, std::clamp((radius * cosine + distance) / moved_radius, -1.0, 1.0)};
}

// Coefficients at sea level. Molecules: Bruneton and Neyret. Haze: Ångström's law with the relation
// to turbidity of Preetham, Shirley and Smits, "A Practical Analytic Model for Daylight" (1999).
// Ozone: 300 Dobson units, and a bell through the cross sections of Serdyuchenko et al. (2014).
Atmosphere::Atmosphere(double turbidity, double elevation)
    : to_sun_(std::cos(elevation), 0.0, std::sin(elevation)),
      sun_outside_(Spectrum::of(sun_irradiance)),
      rayleigh_(Spectrum::of([](double nm) { return 1.24062e-6 * std::pow(1e-3 * nm, -4.0); })),
      haze_extinction_(Spectrum::of([turbidity](double nm) {
          const double depth = std::max(0.0, 0.04608 * turbidity - 0.04586);
          return depth * std::pow(1e-3 * nm, -1.3) / haze_height;
      })),
      ozone_(Spectrum::of([](double nm) {
          constexpr double column = 300.0 * 2.687e20;  // Molecules per square metre.
          return 4.9e-25 * gaussian(nm, 590.0, 55.0, 55.0) * column / ozone_half_width;
      })) {
    for (std::size_t i = 0; i < Spectrum::size; ++i) {
        haze_[i] = haze_albedo * haze_extinction_[i];
    }
    tabulate_amounts();
    tabulate_multiple_scattering();
}

Atmosphere::Amounts Atmosphere::densities(double radius) {
    const double height = radius - ground;
    Amounts found{};
    found[molecules] = std::exp(-height / rayleigh_height);
    found[haze] = std::exp(-height / haze_height);
    found[ozone] = std::max(0.0, 1.0 - std::abs(height - ozone_middle) / ozone_half_width);
    return found;
}

double Atmosphere::distance_to_top(const Sightline& line) {
    const double rise = line.radius * line.cosine;
    return std::sqrt(std::max(0.0, square(rise) + square(top) - square(line.radius))) - rise;
}

bool Atmosphere::meets_ground(const Sightline& line) {
    return line.cosine < 0.0 && square(line.radius) * (1.0 - square(line.cosine)) < square(ground);
}

Atmosphere::Amounts Atmosphere::amounts_to_top(const Sightline& line) {
    constexpr int steps = 200;
    const double length = distance_to_top(line);
    Amounts total{};
    double before = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double after = length * square((i + 1.0) / steps);
        const Amounts found = densities(line.moved(0.5 * (before + after)).radius);
        for (std::size_t kind = 0; kind < total.size(); ++kind) {
            total[kind] += found[kind] * (after - before);
        }
        before = after;
    }
    return total;
}

double Atmosphere::extinction(const Amounts& amounts, std::size_t wavelength) const {
    return rayleigh_[wavelength] * amounts[molecules] +
           haze_extinction_[wavelength] * amounts[haze] + ozone_[wavelength] * amounts[ozone];
}

void Atmosphere::tabulate_amounts() {
    amounts_.resize(amount_grid.heights * amount_grid.cosines);
    parallel_for(amount_grid.heights, [&](std::size_t h) {
        for (std::size_t c = 0; c < amount_grid.cosines; ++c) {
            const Sightline line{ground + amount_grid.height(h), amount_grid.cosine(c)};
            amounts_[h * amount_grid.cosines + c] = amounts_to_top(line);
        }
    });
}

// The irradiance of the sun, which is hidden where the earth is in its way.
Spectrum Atmosphere::sunlight(const Sightline& sun) const {
    Spectrum arriving;
    if (meets_ground(sun)) {
        return arriving;
    }
    Amounts amounts{};
    amount_grid.interpolate(sun.radius - ground, sun.cosine, [&](std::size_t i, double share) {
        for (std::size_t kind = 0; kind < amounts.size(); ++kind) {
            amounts[kind] += share * amounts_[i][kind];
        }
    });
    for (std::size_t i = 0; i < Spectrum::size; ++i) {
        arriving[i] = sun_outside_[i] * std::exp(-extinction(amounts, i));
    }
    return arriving;
}

Spectrum Atmosphere::sun() const { return sunlight({observer, to_sun_.z}); }

// Light along a ray from the observer: at each step, the sunlight that the air scatters towards
// him, and the light that was scattered before.
Spectrum Atmosphere::sky(const V3d& direction) const {
    constexpr int steps = 40;
    const Sightline start{observer, direction.z};
    const double length = distance_to_top(start);
    const double phase_cosine = direction.dot(to_sun_);
    const double by_molecules = rayleigh_phase(phase_cosine);
    const double by_haze = haze_phase(phase_cosine);
    Spectrum total;
    Spectrum transmitted(1.0);
    double before = 0.0;
    for (int step = 0; step < steps; ++step) {
        const double after = length * square((step + 1.0) / steps);
        const double middle = 0.5 * (before + after);
        const V3d position = V3d(0.0, 0.0, observer) + middle * direction;
        const double radius = position.length();
        const Sightline sun{radius, position.dot(to_sun_) / radius};
        const Amounts density = densities(radius);
        const Spectrum direct = sunlight(sun);
        const Spectrum indirect = multiple_scattering(sun);
        for (std::size_t i = 0; i < Spectrum::size; ++i) {
            const double molecular = rayleigh_[i] * density[molecules];
            const double hazy = haze_[i] * density[haze];
            const double scattered = (molecular * by_molecules + hazy * by_haze) * direct[i] +
                                     (molecular + hazy) * indirect[i];
            const double lost = extinction(density, i);
            const double left = std::exp(-lost * (after - before));
            // The exact integral of an even step.
            total[i] += transmitted[i] * scattered * (lost > 0.0 ? (1.0 - left) / lost : 0.0);
            transmitted[i] *= left;
        }
        before = after;
    }
    return total;
}

void Atmosphere::tabulate_multiple_scattering() {
    multiple_.resize(multiple_grid.heights * multiple_grid.cosines);
    parallel_for(multiple_grid.heights, [&](std::size_t h) {
        const double radius = ground + multiple_grid.height(h);
        const std::vector<ScatteringRay> rays = scattering_rays(radius);
        for (std::size_t c = 0; c < multiple_grid.cosines; ++c) {
            multiple_[h * multiple_grid.cosines + c] =
                mean_scattered_light(rays, multiple_grid.cosine(c));
        }
    });
}

Spectrum Atmosphere::multiple_scattering(const Sightline& sun) const {
    Spectrum total;
    multiple_grid.interpolate(sun.radius - ground, sun.cosine, [&](std::size_t i, double share) {
        for (std::size_t k = 0; k < Spectrum::size; ++k) {
            total[k] += share * multiple_[i][k];
        }
    });
    return total;
}

// Rays in all directions from a height, as far as they do not depend on the sun.
std::vector<Atmosphere::ScatteringRay> Atmosphere::scattering_rays(double radius) const {
    constexpr int directions = 64;
    std::vector<ScatteringRay> rays(directions);
    for (int d = 0; d < directions; ++d) {
        ScatteringRay& ray = rays[static_cast<std::size_t>(d)];
        const double z = 1.0 - (2.0 * d + 1.0) / directions;
        const double across = std::sqrt(1.0 - z * z);
        const double turn = 2.0 * pi * d / std::numbers::phi;
        const V3d direction(across * std::cos(turn), across * std::sin(turn), z);
        const Sightline start{radius, z};
        ray.meets_ground = meets_ground(start);
        const double rise = start.radius * z;
        const double length =
            ray.meets_ground
                ? -rise -
                      std::sqrt(std::max(0.0, square(rise) + square(ground) - square(start.radius)))
                : distance_to_top(start);
        ray.end = V3d(0.0, 0.0, radius) + length * direction;
        ray.transmitted = Spectrum(1.0);
        const auto steps = static_cast<double>(ray.steps.size());
        double before = 0.0;
        for (std::size_t step = 0; step < ray.steps.size(); ++step) {
            const double after = length * square((static_cast<double>(step) + 1.0) / steps);
            const V3d position = V3d(0.0, 0.0, radius) + 0.5 * (before + after) * direction;
            const Amounts density = densities(position.length());
            ray.steps[step].position = position;
            for (std::size_t i = 0; i < Spectrum::size; ++i) {
                const double scattered =
                    rayleigh_[i] * density[molecules] + haze_[i] * density[haze];
                const double lost = extinction(density, i);
                const double left = std::exp(-lost * (after - before));
                ray.steps[step].part[i] =
                    ray.transmitted[i] * scattered * (lost > 0.0 ? (1.0 - left) / lost : 0.0);
                ray.transmitted[i] *= left;
            }
            before = after;
        }
    }
    return rays;
}

// Hillaire, section 5.5: the mean over all directions of the light that was scattered once, and
// then, in equal parts by each further scattering, a geometric series.
Spectrum Atmosphere::mean_scattered_light(const std::vector<ScatteringRay>& rays,
                                          double sun_cosine) const {
    const auto directions = static_cast<double>(rays.size());
    const V3d to_sun(std::sqrt(1.0 - square(sun_cosine)), 0.0, sun_cosine);
    Spectrum once;
    Spectrum share;
    for (const ScatteringRay& ray : rays) {
        for (const ScatteringRay::Step& step : ray.steps) {
            const double radius = step.position.length();
            const Spectrum direct = sunlight({radius, step.position.dot(to_sun) / radius});
            for (std::size_t i = 0; i < Spectrum::size; ++i) {
                once[i] += step.part[i] * direct[i] / (4.0 * pi) / directions;
                share[i] += step.part[i] / directions;
            }
        }
        if (ray.meets_ground) {
            const double cosine = ray.end.dot(to_sun) / ray.end.length();
            const Spectrum direct = sunlight({ground, cosine});
            for (std::size_t i = 0; i < Spectrum::size; ++i) {
                once[i] += ray.transmitted[i] * planet_albedo / pi * std::max(0.0, cosine) *
                           direct[i] / directions;
            }
        }
    }
    for (std::size_t i = 0; i < Spectrum::size; ++i) {
        once[i] /= 1.0 - share[i];
    }
    return once;
}

}  // namespace balcony::render

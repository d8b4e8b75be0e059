// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/prescription.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>

#include "camera/lenses/lens_optics.hpp"

namespace balcony::camera {

// --------------------------------------------------------------------------------------- glass

double Medium::index(double wavelength) const {
    const double w2 = wavelength * wavelength;
    const auto& c = coefficients;
    switch (dispersion) {
        case Dispersion::none: return c[0];
        case Dispersion::cauchy: return c[0] + (c[1] + c[2] / w2) / w2;
        case Dispersion::schott:
            return std::sqrt(c[0] + c[1] * w2 +
                             (c[2] + (c[3] + (c[4] + c[5] / w2) / w2) / w2) / w2);
        case Dispersion::sellmeier:
            return std::sqrt(1.0 + c[0] * w2 / (w2 - c[3]) + c[1] * w2 / (w2 - c[4]) +
                             c[2] * w2 / (w2 - c[5]));
    }
    return 1.0;
}

Medium Medium::by_abbe_number(double index, double abbe_number) {
    const auto inverse_square = [](double line) { return 1.0 / (line * line); };
    const double slope =
        (index - 1.0) / abbe_number / (inverse_square(line_F) - inverse_square(line_C));
    return {fmt::format("{:.6g}/{:.6g}", index, abbe_number),
            Dispersion::cauchy,
            {index - slope * inverse_square(line_d), slope}};
}

namespace {

Medium sellmeier(std::string name, const std::array<double, 6>& coefficients) {
    return {std::move(name), Medium::Dispersion::sellmeier, coefficients};
}

// The coefficients that the makers of the glasses publish, with w in micrometres; of fused silica
// Malitson 1965, of fluorite Malitson 1963.
const std::vector<Medium>& glasses() {
    static const std::vector<Medium> all{
        sellmeier("N-BK7",
                  {1.03961212, 0.231792344, 1.01046945, 0.00600069867, 0.0200179144, 103.560653}),
        sellmeier("N-SK16",
                  {1.34317774, 0.241144399, 0.994317969, 0.00704687339, 0.0229005, 92.7508526}),
        sellmeier("N-F2",
                  {1.39757037, 0.159201403, 1.2686543, 0.00995906143, 0.0546931752, 119.248346}),
        sellmeier("N-SF6",
                  {1.77931763, 0.338149866, 2.08734474, 0.0133714182, 0.0617533621, 174.01759}),
        sellmeier("N-SF11",
                  {1.73759695, 0.313747346, 1.89878101, 0.013188707, 0.0623068142, 155.23629}),
        sellmeier("FUSED-SILICA", {0.6961663, 0.4079426, 0.8974794, 0.0684043 * 0.0684043,
                                   0.1162414 * 0.1162414, 9.896161 * 9.896161}),
        sellmeier("CAF2", {0.5675888, 0.4710914, 3.8484723, 0.050263605 * 0.050263605,
                           0.1003909 * 0.1003909, 34.649040 * 34.649040})};
    return all;
}

}  // namespace

const Medium* find_glass(std::string_view name) {
    const auto same = [](char a, char b) {
        return std::toupper(static_cast<unsigned char>(a)) == b;
    };
    const auto found = std::find_if(glasses().begin(), glasses().end(), [&](const Medium& glass) {
        return std::equal(name.begin(), name.end(), glass.name.begin(), glass.name.end(), same);
    });
    return found == glasses().end() ? nullptr : &*found;
}

std::vector<std::string> glass_names() {
    std::vector<std::string> names;
    for (const Medium& glass : glasses()) {
        names.push_back(glass.name);
    }
    return names;
}

// ------------------------------------------------------------------------------------ surfaces

bool LensSurface::is_aspheric() const {
    return std::any_of(aspheric.begin(), aspheric.end(), [](double a) { return a != 0.0; });
}

double LensSurface::sag(double x, double y) const {
    const Height<double> here = height_at(*this, x, y);
    return here.exists ? -here.height : std::nan("");
}

std::size_t Prescription::stop() const {
    const auto found =
        std::find_if(surfaces.begin(), surfaces.end(), [](const LensSurface& s) { return s.stop; });
    return static_cast<std::size_t>(found - surfaces.begin());
}

bool Prescription::is_anamorphic() const {
    return std::any_of(surfaces.begin(), surfaces.end(),
                       [](const LensSurface& s) { return s.curvature_x.has_value(); });
}

Prescription horizontal_section(const Prescription& lens) {
    Prescription made = lens;
    for (LensSurface& s : made.surfaces) {
        if (s.curvature_x) {
            s.curvature = *s.curvature_x;
            s.curvature_x.reset();
            s.conic = 0.0;
            s.aspheric = {};
        }
    }
    return made;
}

// ------------------------------------------------------------------------------ near the axis

LensOptics optics_of(const Prescription& lens, double wavelength, double focusing_wavelength) {
    LensOptics made;
    const Medium air;
    const Medium* before = &air;
    for (const LensSurface& s : lens.surfaces) {
        made.surfaces.push_back({s, s.behind.index(wavelength), before->index(wavelength),
                                 s.behind.index(focusing_wavelength),
                                 before->index(focusing_wavelength)});
        before = &s.behind;
    }
    made.stop = lens.stop();
    return made;
}

void narrow_stop(LensOptics& lens, const ParaxialLens& paraxial, double f_number) {
    lens.surfaces[lens.stop].shape.radius *= std::min(1.0, paraxial.f_number() / f_number);
}

ParaxialLens paraxial(const Prescription& lens, double wavelength) {
    const LensOptics optics = optics_of(lens, wavelength, wavelength);
    std::vector<double> gaps;
    for (const LensSurface& s : lens.surfaces) {
        gaps.push_back(s.gap);
    }
    const auto [a, b, c, d] = matrix_of(optics, gaps, 0, gaps.size() - 1, 0.0);
    const Pupils<double> pupils = pupils_of(optics, gaps, 0.0);
    const double stop = lens.surfaces[optics.stop].radius;
    return {-1.0 / c,
            d / c,
            -a / c,
            (d - 1.0) / c,
            (1.0 - a) / c,
            pupils.entrance,
            std::abs(stop / pupils.stop_by_entrance),
            pupils.exit,
            std::abs(stop * pupils.exit_by_stop)};
}

}  // namespace balcony::camera

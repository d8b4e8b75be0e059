// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/report/lens_report.hpp"

#include <cmath>
#include <numbers>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "balcony/names.hpp"

namespace balcony::cli {

namespace {

using camera::ParaxialLens;
using camera::Prescription;
using camera::Spot;

constexpr std::size_t middle_color = 1;  // Of the line d.

/// The spots of a direction; none where no light of one of the colours passes.
std::vector<Spot> spots_at(const Prescription& lens, const LensSpots& all,
                           const std::array<double, 2>& degrees) {
    std::vector<Spot> made;
    for (const double wavelength : all.wavelengths) {
        camera::SpotOptions options{.wavelength = wavelength};
        for (std::size_t axis = 0; axis < 2; ++axis) {
            options.field[axis] = std::tan(degrees[axis] * std::numbers::pi / 180.0);
        }
        const auto spot = camera::spot_of(lens, options);
        if (!spot) {
            return {};
        }
        made.push_back(*spot);
    }
    return made;
}

/// The light in relation to that of the axis.
double light_of(const LensSpots& all, const LensSpots::Field& field) {
    return field.spots[middle_color].area / all.fields.front().spots[middle_color].area;
}

ParaxialLens beside(const Prescription& lens) {
    return camera::paraxial(camera::horizontal_section(lens));
}

/// How much farther from the axis the light arrives than that of a pinhole would.
double distortion_of(const Prescription& lens, const LensSpots::Field& field) {
    const std::size_t axis = field.degrees[0] == 0.0 ? 1 : 0;
    const double length =
        axis == 1 ? camera::paraxial(lens).focal_length : beside(lens).focal_length;
    const double wanted = -length * std::tan(field.degrees[axis] * std::numbers::pi / 180.0);
    return field.spots[middle_color].middle[axis] / wanted - 1.0;
}

// "19.2 mm behind the first surface"
std::string place(double position, std::string_view surface) {
    return fmt::format("{:.4g} mm {} the {} surface", std::abs(position),
                       position < 0.0 ? "in front of" : "behind", surface);
}

std::string spots_text(const Prescription& lens, const LensSpots& all) {
    std::string text =
        "\nspots: the root mean square radius in micrometres\n    field   light  distortion";
    for (const double wavelength : all.wavelengths) {
        text += fmt::format("  {:>5.1f} nm", 1000.0 * wavelength);
    }
    for (const LensSpots::Field& field : all.fields) {
        const bool middle = field.degrees == std::array{0.0, 0.0};
        text += fmt::format(
            "\n  {:>3.0f}{:<6} {:>3.0f} %  {:>10}", std::max(field.degrees[0], field.degrees[1]),
            !lens.is_anamorphic() || middle ? " deg"
            : field.degrees[0] > 0.0        ? " aside"
                                            : " up",
            100.0 * light_of(all, field),
            middle ? "" : fmt::format("{:+.2f} %", 100.0 * distortion_of(lens, field)));
        for (const Spot& spot : field.spots) {
            text += fmt::format("  {:>8.4g}", 1000.0 * spot.rms_radius);
        }
    }
    return text + "\n";
}

}  // namespace

LensSpots find_spots(const Prescription& lens) {
    constexpr std::array angles{5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 40.0, 50.0, 60.0};
    LensSpots made{.wavelengths = {camera::line_F, camera::line_d, camera::line_C}};
    made.fields.push_back({{0.0, 0.0}, spots_at(lens, made, {0.0, 0.0})});
    for (const bool aside : {false, true}) {
        for (const double angle : angles) {
            const std::array<double, 2> degrees{aside ? angle : 0.0, aside ? 0.0 : angle};
            auto spots = aside && !lens.is_anamorphic() ? std::vector<Spot>()
                                                        : spots_at(lens, made, degrees);
            if (spots.empty()) {
                break;
            }
            made.fields.push_back({degrees, std::move(spots)});
        }
    }
    return made;
}

std::string to_text(const Prescription& lens, const LensSpots& spots) {
    const ParaxialLens near_axis = camera::paraxial(lens);
    std::string text = fmt::format("{}\n", printable(lens.name));
    const auto line = [&text](std::string_view name, const std::string& value) {
        text += fmt::format("  {:<17} {}\n", name, value);
    };
    line("lens", fmt::format("{}, of which number {} is the stop",
                             counted(lens.surfaces.size(), "surface"), lens.stop() + 1));
    line("focal length",
         fmt::format("{:.4g} mm{}, f/{:.3g}", near_axis.focal_length,
                     lens.is_anamorphic() ? " in the vertical plane" : "", near_axis.f_number()));
    if (lens.is_anamorphic()) {
        line("", fmt::format("{:.4g} mm in the horizontal plane", beside(lens).focal_length));
    }
    line("focus", place(near_axis.back_focus, "last"));
    line("principal planes", fmt::format("{}, {}", place(near_axis.front_principal, "first"),
                                         place(near_axis.back_principal, "last")));
    line("entrance pupil", fmt::format("{:.4g} mm wide, {}", 2.0 * near_axis.entrance_radius,
                                       place(near_axis.entrance_pupil, "first")));
    line("exit pupil", fmt::format("{:.4g} mm wide, {}", 2.0 * near_axis.exit_radius,
                                   place(near_axis.exit_pupil, "last")));
    return text + spots_text(lens, spots);
}

nlohmann::json to_json(const Prescription& lens, const LensSpots& all) {
    const ParaxialLens near_axis = camera::paraxial(lens);
    nlohmann::json spots = nlohmann::json::array();
    for (const LensSpots::Field& field : all.fields) {
        for (std::size_t i = 0; i < field.spots.size(); ++i) {
            const Spot& spot = field.spots[i];
            spots.push_back({{"field", field.degrees},
                             {"wavelength", 1000.0 * all.wavelengths[i]},
                             {"middle", spot.middle},
                             {"rms_radius", spot.rms_radius},
                             {"area", spot.area}});
        }
    }
    return {{"surfaces", lens.surfaces.size()},
            {"stop", lens.stop() + 1},
            {"focal_length", near_axis.focal_length},
            {"horizontal_focal_length", beside(lens).focal_length},
            {"f_number", near_axis.f_number()},
            {"front_focus", near_axis.front_focus},
            {"back_focus", near_axis.back_focus},
            {"front_principal", near_axis.front_principal},
            {"back_principal", near_axis.back_principal},
            {"entrance_pupil", near_axis.entrance_pupil},
            {"entrance_radius", near_axis.entrance_radius},
            {"exit_pupil", near_axis.exit_pupil},
            {"exit_radius", near_axis.exit_radius},
            {"spots", spots}};
}

}  // namespace balcony::cli

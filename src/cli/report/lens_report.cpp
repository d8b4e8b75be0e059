// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/report/lens_report.hpp"

#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "balcony/names.hpp"

namespace balcony::cli {

namespace {

using camera::FieldSpots;
using camera::ParaxialLens;
using camera::Prescription;
using camera::Spot;

ParaxialLens beside(const Prescription& lens) {
    return camera::paraxial(camera::horizontal_section(lens));
}

// "19.2 mm behind the first surface"
std::string place(double position, std::string_view surface) {
    return fmt::format("{:.4g} mm {} the {} surface", std::abs(position),
                       position < 0.0 ? "in front of" : "behind", surface);
}

std::string spots_text(const Prescription& lens, const std::vector<FieldSpots>& fields) {
    std::string text =
        "\nspots: the root mean square radius in micrometres\n    field   light  distortion";
    for (const double wavelength : camera::spot_wavelengths) {
        text += fmt::format("  {:>5.1f} nm", 1000.0 * wavelength);
    }
    for (const FieldSpots& field : fields) {
        const bool middle = field.degrees == std::array{0.0, 0.0};
        text += fmt::format(
            "\n  {:>3.0f}{:<6} {:>3.0f} %  {:>10}", std::max(field.degrees[0], field.degrees[1]),
            !lens.is_anamorphic() || middle ? " deg"
            : field.degrees[0] > 0.0        ? " aside"
                                            : " up",
            100.0 * field.light, middle ? "" : fmt::format("{:+.2f} %", 100.0 * field.distortion));
        for (const Spot& spot : field.spots) {
            text += fmt::format("  {:>8.4g}", 1000.0 * spot.rms_radius);
        }
    }
    return text + "\n";
}

}  // namespace

std::string to_text(const Prescription& lens, const std::vector<FieldSpots>& fields) {
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
    return text + spots_text(lens, fields);
}

nlohmann::json to_json(const Prescription& lens, const std::vector<FieldSpots>& fields) {
    const ParaxialLens near_axis = camera::paraxial(lens);
    nlohmann::json spots = nlohmann::json::array();
    for (const FieldSpots& field : fields) {
        for (std::size_t i = 0; i < field.spots.size(); ++i) {
            const Spot& spot = field.spots[i];
            spots.push_back({{"field", field.degrees},
                             {"wavelength", 1000.0 * camera::spot_wavelengths[i]},
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

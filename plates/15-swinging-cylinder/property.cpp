// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <stdexcept>

#include "balcony/diagnose.hpp"
#include "measure/measure.hpp"
#include "measure/property.hpp"

namespace balcony::plates {

// The share of the picture that diagnostics report to be folded over.
static double folded_share(const std::string& file, const Overrides& overrides) {
    const auto picture =
        lang::make_picture(std::string(BALCONY_PLATES) + "/" + file, {}, overrides);
    if (!picture || picture->only_camera() == nullptr) {
        throw std::runtime_error("cannot make the camera of " + file);
    }
    analyse::DiagnoseSettings settings;
    settings.width = 320.0;
    settings.height = 160.0;
    settings.max_samples = 4096;
    const auto report = analyse::diagnose(*picture->only_camera(), settings);
    if (!report) {
        throw std::runtime_error(to_text(report.diagnostics));
    }
    double share = 0.0;
    for (const analyse::Finding& finding : report->findings) {
        share += finding.kind == analyse::FindingKind::fold ? finding.share : 0.0;
    }
    return share;
}

// Rays that swing back meet the O a second and a third time along a row of the picture.
static Measurements measure_swing(Studio& studio, const Overrides& overrides) {
    const std::string file = "15-swinging-cylinder/camera.cam";
    const render::Film film =
        studio.look({.scene = "soft", .camera = file, .width = 320, .height = 160}, overrides);
    const Sightings letters = sightings_of(film, "letter ");
    return {{"runs of the O in the row that has the most", max_runs_in_row(film, "letter O"), 2},
            {"letters seen", letters.seen, 4, 4},
            {"share of the picture that folds over", folded_share(file, overrides), 0.1}};
}

// At most at 1, the zoom stretches the middle of the cylinder without running backwards.
Property plate_15() { return {15, measure_swing, {{{"overshoot", "0.4"}}, {{"overshoot", "0"}}}}; }

}  // namespace balcony::plates

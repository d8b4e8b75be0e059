// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Any text → calibrated cameras or errors → the ray of a pixel, finite and of unit length.

#include <cmath>
#include <cstdint>
#include <span>

#include "balcony/data.hpp"
#include "balcony/make_stage.hpp"
#include "demand.hpp"

namespace {

using namespace balcony;

void look_through(const camera::ObjectGenerator& made, double u, double v) {
    expr::Graph graph;
    camera::Emitter emit(graph);
    const camera::ObjectVector d = *made.normal({graph.constant(u), graph.constant(v)}, emit);
    const std::array roots{d.x, d.y, d.z, emit.valid()};
    const std::vector<double> ray = expr::evaluate(roots, {0.0, 0.0, 0.0, {}});
    const double length = std::hypot(ray[0], ray[1], ray[2]);
    // The camera itself takes out what is not finite.
    demand(ray[3] == 0.0 || !std::isfinite(length) || std::abs(length - 1.0) < 1e-9,
           "a ray is not of unit length");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    const auto file = data::read_calibration(
        data::File::in_memory("fuzz.yml", "fuzz.yml", std::span(bytes, count)));
    demand(file.value.has_value() != has_errors(file.diagnostics), "neither cameras nor errors");
    (void)to_text(file.diagnostics);
    if (!file) {
        return 0;
    }
    const auto made = camera::make_stage<camera::ObjectGenerator>(
        "opencv", {{"file", *file}, {"width", 640.0}, {"height", 480.0}});
    demand(made.value.has_value() != has_errors(made.diagnostics), "neither stage nor errors");
    if (made) {
        look_through(**made, 320.5, 240.5);
        look_through(**made, 3.0, 470.0);
    }
    return 0;
}

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Any text → camera or errors → program → 16 rays. What a camera says is a ray must be one: finite,
// of unit length.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "balcony/lang.hpp"
#include "balcony/program.hpp"

namespace {

using namespace balcony;

void demand(bool holds, const char* what) {
    if (!holds) {
        std::fprintf(stderr, "%s\n", what);
        std::abort();
    }
}

void check_rays(const camera::Camera& camera) {
    constexpr std::size_t side = 4;
    constexpr std::size_t points = side * side;
    expr::Graph graph;
    const camera::RayExpressions ray = camera.emit(graph, side, side);
    const std::array roots{ray.origin.x,    ray.origin.y,    ray.origin.z, ray.direction.x,
                           ray.direction.y, ray.direction.z, ray.valid};
    std::array<std::array<double, points>, roots.size()> values{};
    std::array<double*, roots.size()> results{};
    std::transform(values.begin(), values.end(), results.begin(),
                   [](auto& row) { return row.data(); });
    program::Scratch scratch;
    program::run(program::Program(roots), {.width = side, .height = side}, scratch, results);
    const auto& valid = values.back();
    for (std::size_t i = 0; i < points; ++i) {
        demand(valid[i] == 0.0 || valid[i] == 1.0, "validity is neither 0 nor 1");
        if (valid[i] == 1.0) {
            for (std::size_t value = 0; value + 1 < values.size(); ++value) {
                demand(std::isfinite(values[value][i]), "a valid ray is not finite");
            }
            const double length = std::hypot(values[3][i], values[4][i], values[5][i]);
            demand(std::abs(length - 1.0) < 1e-9, "a valid direction is not of unit length");
        }
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    const auto source = std::make_shared<const SourceText>(
        "fuzz.cam", std::string(reinterpret_cast<const char*>(bytes), count));
    const Result<camera::Camera> made = lang::make_camera(source, "", {}, "/nonexistent");
    demand(made.value.has_value() != has_errors(made.diagnostics), "neither camera nor error");
    (void)to_text(made.diagnostics);
    if (made) {
        check_rays(*made);
    }
    const Result<camera::Picture> picture = lang::make_picture(source, "", {}, "/nonexistent");
    demand(picture.value.has_value() != has_errors(picture.diagnostics),
           "neither picture nor error");
    if (picture) {
        expr::Graph graph;
        (void)picture->emit(graph, 4.0, 4.0);
    }
    const Result<std::string> laid_out = lang::format(source);
    if (laid_out) {
        const auto again = lang::format(std::make_shared<const SourceText>("again", *laid_out));
        demand(again && *again == *laid_out, "laid out again it is not as it was");
    }
    return 0;
}

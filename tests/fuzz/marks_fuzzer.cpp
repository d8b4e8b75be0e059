// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Any text → marks or errors → parameters of a camera, within their ranges, or errors.

#include <cstdint>
#include <memory>
#include <string>

#include "balcony/lang.hpp"
#include "balcony/solving.hpp"
#include "demand.hpp"

namespace {

using namespace balcony;

// Larger problems take too long.
constexpr std::size_t most_marks = 8;
constexpr std::size_t most_constraints = 12;
constexpr std::size_t most_iterations = 8;

const char* const photo = R"(
    camera photo(fov = 60deg above 0 to 179deg, yaw = 0deg, pitch = 0deg, height = 1.6) {
        let half = tan(fov/2)
        map    u = half .. -half, v = square
        eye    point
        toward plane((1, 0, 0))
        move   rotate(y, -pitch), rotate(z, yaw), translate(0, 0, height)
    })";

template <class T>
void demand_one_of_both(const Result<T>& result) {
    demand(result.value.has_value() != has_errors(result.diagnostics), "neither value nor error");
    (void)to_text(result.diagnostics);
}

void try_problem(const solve::Problem& problem, const lang::OpenCamera& camera,
                 const app::Marks& marks) {
    solve::Options options;
    options.iterations = most_iterations;
    const auto solution = solve::solve(camera.camera, static_cast<double>(marks.width),
                                       static_cast<double>(marks.height), problem, options);
    demand_one_of_both(solution);
    if (!solution) {
        return;
    }
    demand(solution->misses.size() == problem.constraints.size() &&
               solution->seen.size() == problem.marks.size() &&
               solution->poses.size() == problem.targets.size(),
           "a solution of another problem");
    for (std::size_t i = 0; i < problem.unknowns.size(); ++i) {
        const camera::Range& range = problem.unknowns[i].range;
        demand(solution->values[i] >= range.minimum && solution->values[i] <= range.maximum,
               "a value is outside its range");
        demand(solution->deviations[i] >= 0.0, "a deviation is no number");
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    static const Result<lang::OpenCamera> camera = lang::Workspace().make_open_camera(
        std::make_shared<const SourceText>("photo.cam", photo), "", {});
    demand(camera.value.has_value(), "the camera is wrong");
    const auto source = std::make_shared<const SourceText>(
        "fuzz.yml", std::string(reinterpret_cast<const char*>(bytes), count));
    const Result<app::Marks> marks = app::read_marks(source);
    demand_one_of_both(marks);
    if (!marks) {
        return 0;
    }
    solve::Problem problem = marks->problem;
    if (problem.marks.size() > most_marks || problem.constraints.size() > most_constraints) {
        return 0;
    }
    for (const lang::OpenParameter& one : camera->open) {
        problem.unknowns.push_back({lang::parameter_input(one.name), one.value, one.limits});
    }
    try_problem(problem, *camera, *marks);
    return 0;
}

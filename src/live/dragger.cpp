// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <chrono>
#include <utility>

#include <fmt/format.h>

#include "balcony/drag.hpp"
#include "balcony/names.hpp"
#include "balcony/solve.hpp"

namespace balcony::live {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double near_enough = 0.5;     // In pixels.
constexpr std::size_t iterations = 30;  // What a hand waits for.

const Value* find(const std::vector<Value>& values, std::string_view parameter) {
    const auto found = std::find_if(values.begin(), values.end(),
                                    [&](const Value& one) { return one.parameter == parameter; });
    return found != values.end() ? &*found : nullptr;
}

}  // namespace

struct Dragger::State {
    solve::Solver solver;
    std::vector<lang::OpenParameter> open;
    std::vector<double> last{};  ///< The values that were found last, where they missed least.

    [[nodiscard]] Diagnostics unknown_parameters(const Drag& drag) const;
    [[nodiscard]] solve::Problem problem_of(const Drag& drag, const std::vector<Value>& before,
                                            Axes axes) const;
    [[nodiscard]] Result<solve::Solution> solve(solve::Problem problem,
                                                const std::stop_token& stop);
};

Dragger::Dragger(std::unique_ptr<State> state) : state_(std::move(state)) {}
Dragger::Dragger(Dragger&&) noexcept = default;
Dragger& Dragger::operator=(Dragger&&) noexcept = default;
Dragger::~Dragger() = default;

Result<Dragger> Dragger::make(const lang::OpenPicture& picture, std::size_t layer,
                              const std::array<std::size_t, 2>& size, double time,
                              const std::stop_token& stop) {
    std::vector<std::string> inputs;
    for (const lang::OpenParameter& one : picture.open) {
        inputs.push_back(lang::parameter_input(one.name));
    }
    Result<solve::Solver> solver =
        solve::Solver::make(picture.picture, layer, static_cast<double>(size[0]),
                            static_cast<double>(size[1]), std::move(inputs), time, stop);
    if (!solver) {
        return std::move(solver.diagnostics);
    }
    return Dragger(std::make_unique<State>(State{std::move(*solver), picture.open}));
}

Diagnostics Dragger::State::unknown_parameters(const Drag& drag) const {
    std::vector<std::string> names;
    for (const lang::OpenParameter& one : open) {
        names.push_back(one.name);
    }
    Diagnostics found;
    if (names.empty()) {
        found.push_back(error("the camera has no parameter that can follow", {},
                              "give it parameters that are numbers: camera a(fov = 60deg)"));
    }
    for (const std::string& name : drag.parameters) {
        if (std::find(names.begin(), names.end(), name) == names.end()) {
            found.push_back(error(fmt::format("the parameter '{}' cannot follow a hand", name), {},
                                  suggestion(name, names, "those that can are")));
        }
    }
    return found;
}

solve::Problem Dragger::State::problem_of(const Drag& drag, const std::vector<Value>& before,
                                          Axes axes) const {
    solve::Problem made;
    for (const lang::OpenParameter& one : open) {
        const Value* const given = find(before, one.name);
        const double value = given != nullptr ? given->value : one.value;
        const bool follows = drag.parameters.empty() ||
                             std::find(drag.parameters.begin(), drag.parameters.end(), one.name) !=
                                 drag.parameters.end();
        made.unknowns.push_back({lang::parameter_input(one.name),
                                 value,
                                 follows ? one.limits : camera::Range{value, value},
                                 {},
                                 one.name});
    }
    for (const Pull& pull : drag.pulls) {
        solve::Constraint constraint{solve::ConstraintKind::at, {made.marks.size()}, pull.to};
        solve::Mark mark{turned(pull.point, axes, solver.axes()), pull.at_infinity};
        mark.near = pull.from;
        made.marks.push_back(std::move(mark));
        made.constraints.push_back(std::move(constraint));
    }
    return made;
}

// From the values before the drag, so that the same pull has the same result, or from those that
// were found last, if that leads nearer.
Result<solve::Solution> Dragger::State::solve(solve::Problem problem, const std::stop_token& stop) {
    const solve::Options options{.iterations = iterations};
    Result<solve::Solution> first = solver.solve(problem, options, stop);
    const auto is_good = [](const Result<solve::Solution>& one) {
        return one && std::all_of(one->misses.begin(), one->misses.end(),
                                  [](const auto& miss) { return miss.deviations < near_enough; });
    };
    if (!is_good(first) && last.size() == problem.unknowns.size()) {
        for (std::size_t i = 0; i < last.size(); ++i) {
            solve::Unknown& unknown = problem.unknowns[i];
            const bool is_known = unknown.range.minimum == unknown.range.maximum;
            unknown.value = is_known ? unknown.value : last[i];
        }
        Result<solve::Solution> other = solver.solve(problem, options, stop);
        if (other && (!first || other->cost < first->cost)) {
            first = std::move(other);
        }
    }
    if (first) {
        last = first->values;
    }
    return first;
}

Dragged Dragger::drag(const Drag& drag, const std::vector<Value>& before, Axes axes,
                      const std::stop_token& stop) {
    const Clock::time_point begin = Clock::now();
    Dragged made;
    made.diagnostics = state_->unknown_parameters(drag);
    const solve::Problem problem = state_->problem_of(drag, before, axes);
    std::vector<double> values;
    for (const solve::Unknown& unknown : problem.unknowns) {
        values.push_back(unknown.value);
    }
    for (const Pull& pull : drag.pulls) {
        made.points.push_back({std::nullopt, (pull.to - pull.from).length(), false});
    }
    if (made.diagnostics.empty() && !drag.pulls.empty()) {
        Result<solve::Solution> solution = state_->solve(problem, stop);
        if (solution) {
            values = solution->values;
            for (std::size_t i = 0; i < made.points.size(); ++i) {
                const double miss = solution->misses[i].deviations;
                made.points[i] = {solution->seen[i], miss, miss < near_enough && solution->seen[i]};
            }
        } else {
            made.diagnostics = std::move(solution.diagnostics);
        }
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (problem.unknowns[i].range.minimum < problem.unknowns[i].range.maximum) {
            made.values.push_back({problem.unknowns[i].name, values[i]});
        }
    }
    made.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    return made;
}

}  // namespace balcony::live

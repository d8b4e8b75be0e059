// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/solve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "balcony/progress.hpp"
#include "solve/first_pose.hpp"
#include "solve/minimum.hpp"
#include "solve/outlines.hpp"
#include "solve/problem_check.hpp"
#include "solve/projection_errors.hpp"
#include "solve/system.hpp"

namespace balcony::solve {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

// The problem with the positions that constraints demand as the places where the search for their
// marks begins.
Problem with_positions(Problem problem) {
    for (const Constraint& constraint : problem.constraints) {
        if (constraint.kind == ConstraintKind::at) {
            std::optional<V2d>& near = problem.marks[constraint.marks.front()].near;
            near = near.value_or(constraint.position);
        }
    }
    return problem;
}

// Where the first values of the unknowns show a mark that no constraint has a position for: what
// Newton's iteration finds from places all over the picture, in a fixed order.
std::optional<V2d> found_from_grid(const CameraRays& rays, const Problem& problem, const Mark& mark,
                                   const V2d& size) {
    constexpr int cells = 8;
    Problem alone{problem.unknowns, problem.targets, {mark}, {}};
    for (int cell = 0; cell < cells * cells; ++cell) {
        const V2d at((cell % cells + 0.5) / cells * size.x, (cell / cells + 0.5) / cells * size.y);
        alone.marks.front().near.reset();
        const System system(rays, alone, size, {at});
        const auto seen = system.seen(system.start());
        if (seen.front() && seen.front()->reached && seen.front()->at.x >= 0.0 &&
            seen.front()->at.x <= size.x && seen.front()->at.y >= 0.0 &&
            seen.front()->at.y <= size.y) {
            return seen.front()->at;
        }
    }
    return std::nullopt;
}

std::string name_of(const Mark& mark, std::size_t number) {
    return mark.name.empty() ? fmt::format("mark {}", number + 1)
                             : fmt::format("the mark '{}'", mark.name);
}

std::string name_of(const Unknown& unknown) {
    return unknown.name.empty() ? unknown.input : unknown.name;
}

// Rays that meet points of a target, as if all began at one point.
struct TargetView {
    std::vector<rays::Ray> rays;
    std::vector<V3d> places;
};

// The largest view of a target. The pictures of a rig show its points several times: each ray is of
// the view of the nearest origin among those that do not show its point yet.
TargetView largest_view(std::span<const InputRay> rays, std::span<const V3d> places) {
    std::vector<TargetView> views;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const rays::Ray& ray = rays[i].ray;
        if (!ray.valid) {
            continue;
        }
        TargetView* nearest = nullptr;
        const auto distance = [&](const TargetView& view) {
            return (view.rays.front().origin - ray.origin).length();
        };
        for (TargetView& view : views) {
            const auto& shown = view.places;
            if (std::find(shown.begin(), shown.end(), places[i]) == shown.end() &&
                (nearest == nullptr || distance(view) < distance(*nearest))) {
                nearest = &view;
            }
        }
        TargetView& its = nearest != nullptr ? *nearest : views.emplace_back();
        its.rays.push_back(ray);
        its.places.push_back(places[i]);
    }
    const auto largest = std::max_element(
        views.begin(), views.end(),
        [](const TargetView& a, const TargetView& b) { return a.rays.size() < b.rays.size(); });
    return largest != views.end() ? std::move(*largest) : TargetView{};
}

// The pose in which the first values show the marks of a target where they are demanded.
std::optional<Pose> pose_of_marks(const CameraRays& rays, const Problem& problem,
                                  std::size_t target) {
    std::vector<V2d> at;
    std::vector<V3d> places;
    for (const Constraint& constraint : problem.constraints) {
        const Mark* const mark =
            constraint.marks.empty() ? nullptr : &problem.marks[constraint.marks.front()];
        if (constraint.kind == ConstraintKind::at && mark->target == target) {
            at.push_back(constraint.position);
            places.push_back(mark->place);
        }
    }
    std::vector<double> values;
    for (const Unknown& unknown : problem.unknowns) {
        values.push_back(unknown.value);
    }
    const TargetView view = largest_view(rays.at(at, values, false), places);
    return first_pose(view.rays, view.places);
}

// The problem with a start for each target.
Result<Problem> with_poses(const CameraRays& rays, Problem problem) {
    for (std::size_t i = 0; i < problem.targets.size(); ++i) {
        Target& target = problem.targets[i];
        if (!target.start) {
            target.start = pose_of_marks(rays, problem, i);
        }
        if (!target.start) {
            return error(
                fmt::format("where {} is cannot be seen from its marks",
                            target.name.empty() ? fmt::format("target {}", i + 1)
                                                : fmt::format("the target '{}'", target.name)),
                {},
                "give it a start, or positions of at least 4 marks in a plane or 6 others, which "
                "are not on one line");
        }
    }
    return problem;
}

// By mark: whether a constraint of any kind but one is about it.
std::vector<bool> marks_in_use(const Problem& problem, std::optional<ConstraintKind> except) {
    std::vector<bool> made(problem.marks.size());
    for (const Constraint& constraint : problem.constraints) {
        for (const std::size_t mark : constraint.marks) {
            made[mark] = made[mark] || constraint.kind != except;
        }
    }
    return made;
}

// Where the first values of the unknowns show the points of an outline, which are these marks: from
// one of them, the search leads to the others, also outside of the picture. Nothing if a point is
// seen nowhere.
std::optional<std::vector<V2d>> outline_positions(const CameraRays& rays, const Problem& problem,
                                                  const Outline& outline,
                                                  std::span<const Mark> marks, const V2d& size) {
    const auto from_grid = [&](const Mark& mark) {
        return found_from_grid(rays, problem, mark, size);
    };
    const V3d sum = std::accumulate(outline.points.begin(), outline.points.end(), V3d(0.0));
    std::vector<std::optional<V2d>> found{outline.near};
    if (!outline.near) {
        found.push_back(from_grid({sum / static_cast<double>(outline.points.size())}));
    }
    for (std::size_t i = 0; i < marks.size() && !found.back(); ++i) {
        found.push_back(from_grid(marks[i]));
    }
    const std::optional<V2d>& one = found.back();
    if (!one) {
        return std::nullopt;
    }
    const Problem alone{problem.unknowns, problem.targets, {marks.begin(), marks.end()}, {}};
    const System system(rays, alone, size, std::vector<V2d>(marks.size(), *one));
    const auto seen = system.seen(system.start());
    std::vector<V2d> made;
    for (std::size_t i = 0; i < marks.size(); ++i) {
        const std::optional<V2d> at =
            seen[i] && seen[i]->reached ? std::optional(seen[i]->at) : from_grid(marks[i]);
        if (!at) {
            return std::nullopt;
        }
        made.push_back(*at);
    }
    return made;
}

// Where the search for each mark begins: for `count` marks, and then for those of outlines.
Result<std::vector<V2d>> first_positions(const CameraRays& rays, const Problem& problem,
                                         std::size_t count, const V2d& size) {
    std::vector<V2d> made;
    const std::vector<bool> used = marks_in_use(problem, std::nullopt);
    for (std::size_t i = 0; i < count; ++i) {
        std::optional<V2d> at = problem.marks[i].near
                                    ? problem.marks[i].near
                                    : found_from_grid(rays, problem, problem.marks[i], size);
        at = at || used[i] ? at : 0.5 * size;
        if (!at) {
            return error(
                fmt::format("no ray of the first values meets {}", name_of(problem.marks[i], i)),
                problem.marks[i].written,
                "say where in the picture it is, or begin with values that show it");
        }
        made.push_back(*at);
    }
    for (std::size_t i = 0; i < problem.outlines.size(); ++i) {
        const Outline& outline = problem.outlines[i];
        const auto marks = std::span(problem.marks).subspan(made.size(), outline.points.size());
        const auto at = outline_positions(rays, problem, outline, marks, size);
        if (!at) {
            return error(
                fmt::format("no ray of the first values meets a point of {}",
                            outline.name.empty() ? fmt::format("outline {}", i + 1)
                                                 : fmt::format("the outline '{}'", outline.name)),
                outline.written,
                "begin with values that show all of it, or say where in the picture it is");
        }
        made.insert(made.end(), at->begin(), at->end());
    }
    return made;
}

// The i-th number of the van der Corput sequence of a prime base.
double radical_inverse(std::size_t i, std::size_t base) {
    double part = 1.0;
    double made = 0.0;
    for (; i > 0; i /= base) {
        part /= static_cast<double>(base);
        made += part * static_cast<double>(i % base);
    }
    return made;
}

// Start number 0 is that of the problem; the others are points of Halton's sequence.
Problem started(Problem problem, std::size_t number) {
    constexpr std::array<std::size_t, 10> primes{2, 3, 5, 7, 11, 13, 17, 19, 23, 29};
    for (std::size_t k = 0; number > 0 && k < std::min(problem.unknowns.size(), primes.size());
         ++k) {
        Unknown& unknown = problem.unknowns[k];
        const double width = unknown.range.maximum - unknown.range.minimum;
        if (std::isfinite(width)) {
            unknown.value = unknown.range.minimum + radical_inverse(number, primes[k]) * width;
        }
    }
    return problem;
}

// Nothing if rounding takes a mark out of the picture there.
std::optional<Solution> solution_at(const Minimum& minimum, const System& system,
                                    const Problem& given) {
    const std::size_t inputs = given.unknowns.size();
    std::optional<std::vector<Miss>> misses = system.misses(minimum.unknowns);
    if (!misses) {
        return std::nullopt;
    }
    Solution made;
    made.misses = std::move(*misses);
    made.values = system.inputs_of(minimum.unknowns);
    made.poses = system.poses_of(minimum.unknowns);
    for (const auto& seen : system.seen(minimum.unknowns)) {
        made.seen.push_back(seen && seen->reached ? std::optional(seen->at) : std::nullopt);
    }
    std::size_t first = given.marks.size();
    for (const Outline& outline : given.outlines) {
        std::vector<V2d> at;
        for (std::size_t i = first; i < first + outline.points.size(); ++i) {
            if (made.seen[i]) {
                at.push_back(*made.seen[i]);
            }
        }
        made.outlines.push_back(hull_of(std::move(at)));
        first += outline.points.size();
    }
    made.seen.resize(given.marks.size());
    made.cost = minimum.residuals.values.squaredNorm();
    made.iterations = minimum.iterations;
    made.converged = minimum.converged;
    const Spread spread = spread_of(minimum.residuals);
    for (std::size_t i = 0; i < inputs; ++i) {
        for (std::size_t j = 0; j < inputs; ++j) {
            made.covariance.push_back(
                spread.covariance(static_cast<Index>(i), static_cast<Index>(j)));
        }
        made.deviations.push_back(spread.undetermined[i]
                                      ? std::numeric_limits<double>::infinity()
                                      : std::sqrt(made.covariance[i * inputs + i]));
    }
    return made;
}

constexpr std::size_t most_named = 5;  // In one warning, or in warnings of one kind.

Diagnostics warn_of_freedom(const Problem& problem, const Solution& solution,
                            std::size_t equations) {
    Diagnostics warnings;
    const std::size_t unknowns = problem.unknowns.size() + 6 * problem.targets.size();
    if (equations < unknowns) {
        warnings.push_back(warning(
            fmt::format("the constraints are {}, too few for {}", counted(equations, "equation"),
                        counted(unknowns, "unknown number")),
            {}, "add constraints, leave out unknowns, or give unknowns a deviation"));
    }
    std::vector<std::string> free;
    std::size_t others = 0;
    for (std::size_t i = 0; i < problem.unknowns.size(); ++i) {
        if (!std::isfinite(solution.deviations[i])) {
            if (free.size() < most_named) {
                free.push_back(name_of(problem.unknowns[i]));
            } else {
                ++others;
            }
        }
    }
    if (!free.empty()) {
        warnings.push_back(warning(
            fmt::format("the constraints do not determine {}{}", all_of(free),
                        others > 0 ? fmt::format(", nor {}", counted(others, "other")) : ""),
            {}, "add a constraint that changes with it, or leave it out of the unknowns"));
    }
    return warnings;
}

Diagnostics warn_of_unseen(const Problem& problem, const Solution& solution) {
    Diagnostics warnings;
    std::size_t unseen = 0;
    const std::vector<bool> wanted = marks_in_use(problem, ConstraintKind::outside);
    for (std::size_t i = 0; i < problem.marks.size(); ++i) {
        if (!wanted[i] || solution.seen[i] || ++unseen > most_named) {
            continue;
        }
        warnings.push_back(warning(
            fmt::format("the camera that was found does not show {}", name_of(problem.marks[i], i)),
            problem.marks[i].written,
            "correct its place or its position, or free a parameter that brings it into view"));
        for (const Constraint& constraint : problem.constraints) {
            const auto& marks = constraint.marks;
            if (constraint.written.source &&
                std::find(marks.begin(), marks.end(), i) != marks.end()) {
                warnings.back().notes.push_back({constraint.written, "a constraint on it"});
            }
        }
    }
    if (unseen > most_named) {
        warnings.push_back(
            warning(fmt::format("nor does it show {}", counted(unseen - most_named, "other mark")),
                    {}, "start the unknowns nearer to the camera that is meant"));
    }
    return warnings;
}

// What is doubtful about a solution for which a problem has so many equations.
Diagnostics warnings_of(const Problem& problem, const Solution& solution, std::size_t equations) {
    Diagnostics warnings = warn_of_freedom(problem, solution, equations);
    Diagnostics unseen = warn_of_unseen(problem, solution);
    std::move(unseen.begin(), unseen.end(), std::back_inserter(warnings));
    return warnings;
}

}  // namespace

Problem with_solving(Problem problem) {
    return with_outline_marks(with_positions(std::move(problem)));
}

Result<Solution> solution_of(const CameraRays& rays, const Problem& given, const Problem& problem,
                             const V2d& size, const Options& options, const std::stop_token& stop) {
    std::optional<Solution> best;
    Diagnostics first_found;
    std::size_t equations = 0;
    for (std::size_t number = 0; number < std::max<std::size_t>(options.starts, 1); ++number) {
        Result<Problem> trial = with_poses(rays, started(problem, number));
        Result<std::vector<V2d>> near =
            trial ? first_positions(rays, *trial, given.marks.size(), size)
                  : Result<std::vector<V2d>>(trial.diagnostics);
        if (!near) {
            first_found = number == 0 ? std::move(near.diagnostics) : std::move(first_found);
            continue;
        }
        System system(rays, *trial, size, *near);
        const std::optional<Minimum> minimum =
            minimize([&](const VectorXd& at) { return system.residuals(at); }, system.start(),
                     system.limits(), options.iterations, stop);
        if (minimum && minimum->stopped) {
            return stopped();
        }
        if (!minimum || (best && !(minimum->residuals.values.squaredNorm() < best->cost))) {
            continue;
        }
        if (auto made = solution_at(*minimum, system, given)) {
            best = std::move(*made);
            equations = static_cast<std::size_t>(minimum->residuals.values.size());
            if (options.errors) {
                best->errors = projection_errors(rays, *trial, size, minimum->unknowns,
                                                 spread_of(minimum->residuals), *options.errors);
            }
        }
    }
    if (!best) {
        return first_found.empty()
                   ? Diagnostics{error("the camera has no rays where the constraints are", {},
                                       "begin with other values of the unknowns")}
                   : first_found;
    }
    Diagnostics warnings = warnings_of(given, *best, equations);
    if (!best->converged) {
        warnings.push_back(warning(
            fmt::format("no minimum was found in {}", counted(best->iterations, "iteration")), {},
            "begin nearer to it, or allow more iterations"));
    }
    return {std::move(*best), std::move(warnings)};
}

Result<Solution> solve(const CameraMaker& make, double width, double height, const Problem& given,
                       const Options& options, const std::stop_token& stop) {
    if (Diagnostics found = problems_of(given); !found.empty()) {
        return found;
    }
    const Problem problem = with_solving(given);
    const V2d size(width, height);
    const Result<CameraRays> rays = CameraRays::make(make, size, problem, stop);
    return rays ? solution_of(*rays, given, problem, size, options, stop)
                : Result<Solution>(rays.diagnostics);
}

Result<Solution> solve(const camera::Camera& camera, double width, double height,
                       const Problem& problem, const Options& options,
                       const std::stop_token& stop) {
    const CameraMaker make = [&](std::span<const double> closed) -> Result<camera::Camera> {
        if (!closed.empty()) {
            return error(Kind::internal, "an unknown has no input");
        }
        return camera;
    };
    return solve(make, width, height, problem, options, stop);
}

}  // namespace balcony::solve

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "solve/system.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "rays/approach.hpp"
#include "solve/outlines.hpp"
#include "solve/pose.hpp"
#include "solve/sighting_misses.hpp"

namespace balcony::solve {

namespace {

using Eigen::Index;
using rays::Approach;

constexpr std::size_t pose_size = 6;
// Of a derivative, as a part of the changes that cancel in it.
constexpr double rounding = 1e-12;

// A ray as those that see directions only: they start at the origin.
rays::Ray as_seen(rays::Ray ray, const Mark& mark) {
    if (mark.at_infinity) {
        ray.origin = ray.origin_by_x = ray.origin_by_y = V3d(0.0);
    }
    return ray;
}

}  // namespace

// What one constraint misses, in its unit, with the derivatives by the unknowns in the rows.
struct System::Row {
    Eigen::VectorXd misses;
    Eigen::MatrixXd by_unknown;
};

System::System(const CameraRays& rays, const Problem& problem, const V2d& size,
               std::vector<V2d> near)
    : rays_(rays),
      problem_(problem),
      size_(size),
      count_(problem.unknowns.size() + pose_size * problem.targets.size()),
      near_(std::move(near)) {}

Eigen::VectorXd System::start() const {
    Eigen::VectorXd made(static_cast<Index>(count_));
    Index i = 0;
    for (const Unknown& unknown : problem_.unknowns) {
        made[i++] = unknown.value;
    }
    for (const Target& target : problem_.targets) {
        for (const V3d& part : {target.start->rotation, target.start->translation}) {
            for (const double value : {part.x, part.y, part.z}) {
                made[i++] = value;
            }
        }
    }
    return made;
}

Limits System::limits() const {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    Limits made{Eigen::VectorXd::Constant(static_cast<Index>(count_), -infinite),
                Eigen::VectorXd::Constant(static_cast<Index>(count_), infinite)};
    for (std::size_t i = 0; i < problem_.unknowns.size(); ++i) {
        const camera::Range& range = problem_.unknowns[i].range;
        // A minimum that is excluded is left by a small part of what the number is.
        made.lower[static_cast<Index>(i)] =
            range.minimum + (range.excludes_minimum
                                 ? 1e-6 * std::abs(problem_.unknowns[i].value - range.minimum)
                                 : 0.0);
        made.upper[static_cast<Index>(i)] = range.maximum;
    }
    return made;
}

std::vector<double> System::inputs_of(const Eigen::VectorXd& unknowns) const {
    return {unknowns.data(), unknowns.data() + problem_.unknowns.size()};
}

std::vector<Pose> System::poses_of(const Eigen::VectorXd& unknowns) const {
    std::vector<Pose> made;
    for (std::size_t k = 0; k < problem_.targets.size(); ++k) {
        const double* p = unknowns.data() + problem_.unknowns.size() + k * pose_size;
        made.push_back({{p[0], p[1], p[2]}, {p[3], p[4], p[5]}});
    }
    return made;
}

V3d System::place_of(const Mark& mark, std::span<const Pose> poses) const {
    return mark.target ? poses[*mark.target] * mark.place : mark.place;
}

// Newton's iteration for all marks together, from `at`.
void System::follow(const std::vector<double>& inputs, std::span<const Pose> poses,
                    std::vector<V2d>& at, std::vector<bool>& reached) const {
    constexpr int most_steps = 40;
    const double longest = std::max(size_.x, size_.y);
    std::vector<std::size_t> active(at.size());
    std::vector<V2d> steps(at.size(), V2d(0.0));
    for (std::size_t i = 0; i < active.size(); ++i) {
        active[i] = i;
    }
    reached.assign(at.size(), false);
    for (int n = 0; n < most_steps && !active.empty(); ++n) {
        std::vector<V2d> points;
        for (const std::size_t i : active) {
            points.push_back(at[i]);
        }
        const std::vector<InputRay> there = rays_.at(points, inputs, false);
        std::vector<std::size_t> left;
        for (std::size_t k = 0; k < active.size(); ++k) {
            const std::size_t i = active[k];
            if (!there[k].ray.valid) {
                // Back half of the way, if there was one.
                if (steps[i].length() > 1e-9 * longest) {
                    steps[i] *= 0.5;
                    at[i] -= steps[i];
                    left.push_back(i);
                }
                continue;
            }
            const Mark& mark = problem_.marks[i];
            const Approach approach(as_seen(there[k].ray, mark), place_of(mark, poses));
            V2d step = approach.step_to(approach.offset);
            if (step.length() < 1e-11 * longest) {
                reached[i] = approach.distance > 0.0 &&
                             approach.after(step).length() <= 1e-6 * approach.distance;
                continue;
            }
            if (step.length() > 0.125 * longest) {
                step *= 0.125 * longest / step.length();
            }
            steps[i] = step;
            at[i] += step;
            left.push_back(i);
        }
        active = std::move(left);
    }
}

std::vector<std::optional<SeenMark>> System::seen(const Eigen::VectorXd& unknowns) const {
    const std::vector<double> inputs = inputs_of(unknowns);
    const std::vector<Pose> poses = poses_of(unknowns);
    std::vector<V2d> at = near_;
    std::vector<bool> reached;
    follow(inputs, poses, at, reached);
    for (std::size_t i = 0; i < at.size(); ++i) {
        if (!reached[i]) {
            at[i] = problem_.marks[i].near.value_or(near_[i]);
        }
    }
    const std::vector<InputRay> there = rays_.at(at, inputs, true);
    std::vector<std::optional<SeenMark>> made(at.size());
    for (std::size_t i = 0; i < at.size(); ++i) {
        if (!there[i].ray.valid) {
            continue;
        }
        const Mark& mark = problem_.marks[i];
        const rays::Ray ray = as_seen(there[i].ray, mark);
        const Approach approach(ray, place_of(mark, poses));
        SeenMark seen{reached[i], at[i] + approach.step_to(approach.offset), {}};
        seen.by_unknown.setZero(2, static_cast<Index>(count_));
        const auto set = [&](std::size_t column, const V3d& change) {
            const V2d step = approach.step_to(change - change.dot(ray.direction) * ray.direction);
            seen.by_unknown.col(static_cast<Index>(column)) << step.x, step.y;
        };
        for (std::size_t k = 0; k < inputs.size(); ++k) {
            const RayChange& change = there[i].by_input[k];
            set(k, -((mark.at_infinity ? V3d(0.0) : change.origin) +
                     approach.distance * change.direction));
        }
        if (mark.target) {
            const auto by_pose = pose_derivatives(poses[*mark.target], mark.place);
            for (std::size_t k = 0; k < pose_size; ++k) {
                set(inputs.size() + *mark.target * pose_size + k, by_pose[k]);
            }
        }
        made[i] = std::move(seen);
    }
    return made;
}

// Nothing if a mark is not seen that has no position of its own.
std::optional<System::Row> System::row_of_marks(
    const Constraint& constraint, const std::vector<std::optional<SeenMark>>& marks) const {
    std::vector<V2d> places;
    for (const std::size_t mark : constraint.marks) {
        const std::optional<SeenMark>& seen = marks[mark];
        if (!seen || !(seen->reached || problem_.marks[mark].near)) {
            return std::nullopt;
        }
        places.push_back(seen->at);
    }
    std::vector<std::size_t> about(places.size());
    std::iota(about.begin(), about.end(), std::size_t{0});
    if (constraint.outline) {
        about = outermost(constraint, places);
    }
    std::vector<DualPoint> at;
    for (const std::size_t i : about) {
        const std::size_t number = 2 * at.size();
        at.push_back(
            {Dual::coordinate(places[i].x, number), Dual::coordinate(places[i].y, number + 1)});
    }
    const std::vector<Dual> misses = sighting_misses(constraint, at, size_);
    const auto size = static_cast<Index>(misses.size());
    Row row{Eigen::VectorXd(size), Eigen::MatrixXd::Zero(size, static_cast<Index>(count_))};
    for (Index r = 0; r < size; ++r) {
        const Dual& miss = misses[static_cast<std::size_t>(r)];
        row.misses[r] = miss.value;
        auto by_unknown = row.by_unknown.row(r).array();
        Eigen::ArrayXd moved = Eigen::ArrayXd::Zero(static_cast<Index>(count_));
        for (std::size_t m = 0; m < about.size(); ++m) {
            const double by_x = miss.by[2 * m];
            const double by_y = miss.by[2 * m + 1];
            const auto& by = marks[constraint.marks[about[m]]]->by_unknown;
            by_unknown += (by_x * by.row(0) + by_y * by.row(1)).array();
            moved += (std::abs(by_x) + std::abs(by_y)) *
                     by.cwiseAbs().colwise().maxCoeff().transpose().array();
        }
        // Otherwise, what no row says of an unknown would determine it.
        by_unknown = (by_unknown.abs() > rounding * moved.transpose()).select(by_unknown, 0.0);
    }
    return row;
}

std::optional<std::vector<System::Row>> System::rows(
    const Eigen::VectorXd& unknowns, const std::vector<std::optional<SeenMark>>& marks) const {
    const std::vector<ShapeValues> shapes = rays_.shapes(inputs_of(unknowns));
    std::vector<Row> made;
    std::size_t next_shape = 0;
    for (const Constraint& constraint : problem_.constraints) {
        Row row;
        if (constraint.marks.empty()) {
            const ShapeValues& shape = shapes[next_shape++];
            if (!shape.valid) {
                return std::nullopt;
            }
            const auto size = static_cast<Index>(shape.values.size());
            row.misses = Eigen::Map<const Eigen::VectorXd>(shape.values.data(), size);
            row.by_unknown.setZero(size, static_cast<Index>(count_));
            for (Index r = 0; r < size; ++r) {
                const std::vector<double>& by = shape.by_input[static_cast<std::size_t>(r)];
                for (std::size_t k = 0; k < by.size(); ++k) {
                    row.by_unknown(r, static_cast<Index>(k)) = by[k];
                }
            }
        } else {
            std::optional<Row> of_marks = row_of_marks(constraint, marks);
            if (!of_marks) {
                return std::nullopt;
            }
            row = std::move(*of_marks);
        }
        if (!row.misses.allFinite() || !row.by_unknown.allFinite()) {
            return std::nullopt;
        }
        made.push_back(std::move(row));
    }
    return made;
}

std::optional<Residuals> System::residuals(const Eigen::VectorXd& unknowns) {
    const std::vector<std::optional<SeenMark>> marks = seen(unknowns);
    std::optional<std::vector<Row>> rows = this->rows(unknowns, marks);
    if (!rows) {
        return std::nullopt;
    }
    Index size = 0;
    for (std::size_t i = 0; i < rows->size(); ++i) {
        Row& row = (*rows)[i];
        const Constraint& constraint = problem_.constraints[i];
        row.misses /= constraint.deviation;
        row.by_unknown /= constraint.deviation;
        if (constraint.tolerance && row.misses.squaredNorm() > 0.0) {
            // Cauchy's loss c^2 log(1 + s/c^2) of the square s of the length, as the square of the
            // misses times a factor f(s): with q = s/c^2, f = sqrt(log(1 + q) / q).
            const double squares = row.misses.squaredNorm();
            const double q = squares / (*constraint.tolerance * *constraint.tolerance);
            const double f = std::sqrt(std::log1p(q) / q);
            const double slope = (1.0 / (1.0 + q) - f * f) / (2.0 * f * squares);
            const Eigen::RowVectorXd by_squares = 2.0 * row.misses.transpose() * row.by_unknown;
            row.by_unknown = f * row.by_unknown + slope * row.misses * by_squares;
            row.misses *= f;
        }
        size += row.misses.size();
    }
    Index priors = 0;
    for (const Unknown& unknown : problem_.unknowns) {
        priors += unknown.deviation ? 1 : 0;
    }
    Residuals made{Eigen::VectorXd(size + priors),
                   Eigen::MatrixXd::Zero(size + priors, static_cast<Index>(count_))};
    Index next = 0;
    for (const Row& row : *rows) {
        made.values.segment(next, row.misses.size()) = row.misses;
        made.by_unknown.middleRows(next, row.misses.size()) = row.by_unknown;
        next += row.misses.size();
    }
    for (std::size_t i = 0; i < problem_.unknowns.size(); ++i) {
        if (const auto& deviation = problem_.unknowns[i].deviation) {
            const auto k = static_cast<Index>(i);
            made.values[next] = (unknowns[k] - problem_.unknowns[i].value) / *deviation;
            made.by_unknown(next++, k) = 1.0 / *deviation;
        }
    }
    const double squares = made.values.squaredNorm();
    if (!std::isfinite(squares)) {
        return std::nullopt;
    }
    if (squares < least_squares_) {
        least_squares_ = squares;
        for (std::size_t i = 0; i < marks.size(); ++i) {
            near_[i] = marks[i] && marks[i]->reached ? marks[i]->at : near_[i];
        }
    }
    return made;
}

std::optional<std::vector<Miss>> System::misses(const Eigen::VectorXd& unknowns) const {
    const std::optional<std::vector<Row>> rows = this->rows(unknowns, seen(unknowns));
    if (!rows) {
        return std::nullopt;
    }
    std::vector<Miss> made;
    for (std::size_t i = 0; i < rows->size(); ++i) {
        const Eigen::VectorXd& values = (*rows)[i].misses;
        Miss miss{{},
                  static_cast<std::size_t>(values.size()),
                  values.norm() / problem_.constraints[i].deviation};
        std::copy_n(values.data(), values.size(), miss.by.begin());
        made.push_back(miss);
    }
    return made;
}

}  // namespace balcony::solve

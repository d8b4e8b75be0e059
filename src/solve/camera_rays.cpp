// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "solve/camera_rays.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace balcony::solve {

namespace {

// Of an unknown of size 1 or more. Rays of calibrated lenses are known to 1e-12 or so, which the
// difference divides by the step; the curvature leaves an error of its square.
constexpr double relative_step = 1e-4;

// The values on both sides of a number, within its range.
struct Sides {
    double below, above;

    Sides(const Unknown& unknown, double value) {
        const double step = relative_step * std::max(std::abs(value), 1.0);
        const camera::Range& range = unknown.range;
        above = std::min(value + step, range.maximum);
        below = value - step;
        if (below < range.minimum || (range.excludes_minimum && below <= range.minimum)) {
            below = value;
        }
    }
};

void add_change(const InputRay& above, const InputRay& below, double width, InputRay& ray) {
    ray.ray.valid = ray.ray.valid && above.ray.valid && below.ray.valid;
    ray.by_input.push_back({(above.ray.origin - below.ray.origin) / width,
                            (above.ray.direction - below.ray.direction) / width});
}

}  // namespace

// The values of the unknowns, those with an input and the others.
struct CameraRays::Split {
    std::vector<double> open, closed;
};

CameraRays::CameraRays(const CameraMaker& make, const V2d& size, const Problem& problem,
                       const std::stop_token& stop)
    : make_(&make), problem_(&problem), stop_(stop), size_(size) {
    for (const Unknown& unknown : problem.unknowns) {
        if (unknown.input.empty()) {
            ++closed_;
        } else {
            inputs_.push_back(unknown.input);
        }
    }
    for (const Constraint& constraint : problem.constraints) {
        if (constraint.marks.empty()) {
            shapes_.push_back(&constraint);
        }
    }
}

Result<CameraRays> CameraRays::make(const CameraMaker& make, const V2d& size,
                                    const Problem& problem, const std::stop_token& stop) {
    CameraRays made(make, size, problem, stop);
    std::vector<double> values;
    for (const Unknown& unknown : problem.unknowns) {
        values.push_back(unknown.value);
    }
    const std::vector<double> closed = made.split(values).closed;
    Result<std::shared_ptr<const InputRays>> first = made.made_of(closed);
    if (!first) {
        return std::move(first.diagnostics);
    }
    made.cameras_.emplace(closed, std::move(*first));
    return made;
}

CameraRays::Split CameraRays::split(std::span<const double> values) const {
    Split made;
    for (std::size_t i = 0; i < values.size(); ++i) {
        (problem_->unknowns[i].input.empty() ? made.closed : made.open).push_back(values[i]);
    }
    return made;
}

Result<std::shared_ptr<const InputRays>> CameraRays::made_of(
    const std::vector<double>& closed) const {
    const Result<camera::Camera> camera = (*make_)(closed);
    if (!camera) {
        return camera.diagnostics;
    }
    Result<InputRays> rays = InputRays::make(*camera, size_.x, size_.y, inputs_, shapes_, stop_);
    return rays ? Result<std::shared_ptr<const InputRays>>(
                      std::make_shared<const InputRays>(std::move(*rays)))
                : Result<std::shared_ptr<const InputRays>>(std::move(rays.diagnostics));
}

std::shared_ptr<const InputRays> CameraRays::kept(const std::vector<double>& closed) const {
    const auto found = cameras_.find(closed);
    if (found != cameras_.end()) {
        return found->second;
    }
    // Those of an iteration: in the middle, and on both sides for each number.
    if (cameras_.size() > 4 * closed_ + 2) {
        cameras_.clear();
    }
    return cameras_.emplace(closed, made_of(closed).value.value_or(nullptr)).first->second;
}

std::vector<InputRay> CameraRays::at(std::span<const V2d> points, std::span<const double> values,
                                     bool by_unknown) const {
    const Split numbers = split(values);
    const auto rays_of = [&](const std::vector<double>& closed, bool by_input) {
        const std::shared_ptr<const InputRays> rays = kept(closed);
        return rays ? rays->at(points, numbers.open, by_input)
                    : std::vector<InputRay>(points.size());
    };
    const std::vector<InputRay> middle = rays_of(numbers.closed, by_unknown);
    if (!by_unknown || closed_ == 0) {
        return middle;
    }
    std::vector<InputRay> made = middle;
    for (InputRay& ray : made) {
        ray.by_input.clear();
    }
    std::size_t next_open = 0;
    std::size_t next_closed = 0;
    for (const Unknown& unknown : problem_->unknowns) {
        if (!unknown.input.empty()) {
            for (std::size_t i = 0; i < made.size(); ++i) {
                if (middle[i].ray.valid) {
                    made[i].by_input.push_back(middle[i].by_input[next_open]);
                }
            }
            ++next_open;
            continue;
        }
        const std::size_t k = next_closed++;
        const Sides sides(unknown, numbers.closed[k]);
        const auto beside = [&](double value) {
            std::vector<double> closed = numbers.closed;
            closed[k] = value;
            return rays_of(closed, false);
        };
        const std::vector<InputRay> above = beside(sides.above);
        const std::vector<InputRay> below = beside(sides.below);
        for (std::size_t i = 0; i < made.size(); ++i) {
            add_change(above[i], below[i], sides.above - sides.below, made[i]);
        }
    }
    return made;
}

std::vector<ShapeValues> CameraRays::shapes(std::span<const double> values) const {
    const Split numbers = split(values);
    const auto shapes_of = [&](const std::vector<double>& closed) {
        const std::shared_ptr<const InputRays> rays = kept(closed);
        return rays ? rays->shapes(numbers.open) : std::vector<ShapeValues>(shapes_.size());
    };
    const std::vector<ShapeValues> middle = shapes_of(numbers.closed);
    if (shapes_.empty() || closed_ == 0) {
        return middle;
    }
    std::vector<ShapeValues> made = middle;
    for (ShapeValues& shape : made) {
        for (std::vector<double>& by_input : shape.by_input) {
            by_input.clear();
        }
    }
    std::size_t next_open = 0;
    std::size_t next_closed = 0;
    for (const Unknown& unknown : problem_->unknowns) {
        const bool is_open = !unknown.input.empty();
        const std::size_t k = is_open ? next_open++ : next_closed++;
        const Sides sides(unknown, is_open ? 0.0 : numbers.closed[k]);
        const auto beside = [&](double value) {
            std::vector<double> closed = numbers.closed;
            closed[k] = value;
            return shapes_of(closed);
        };
        const std::vector<ShapeValues> above = is_open ? middle : beside(sides.above);
        const std::vector<ShapeValues> below = is_open ? middle : beside(sides.below);
        for (std::size_t s = 0; s < made.size(); ++s) {
            made[s].valid = made[s].valid && above[s].valid && below[s].valid;
            for (std::size_t r = 0; made[s].valid && r < made[s].values.size(); ++r) {
                made[s].by_input[r].push_back(is_open ? middle[s].by_input[r][k]
                                                      : (above[s].values[r] - below[s].values[r]) /
                                                            (sides.above - sides.below));
            }
        }
    }
    return made;
}

}  // namespace balcony::solve

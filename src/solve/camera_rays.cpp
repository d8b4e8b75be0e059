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

    Sides(const camera::Range& range, double value) {
        const double step = relative_step * std::max(std::abs(value), 1.0);
        above = std::min(value + step, range.maximum);
        below = std::max(value - step, range.minimum);
        if (range.excludes_minimum && below <= range.minimum) {
            below = 0.5 * (range.minimum + value);
        }
    }
};

// What changes by the width; nothing does in a range of one number.
template <class Value>
Value slope(const Value& below, const Value& above, double width) {
    return width > 0.0 ? (above - below) / width : Value(0.0);
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

CameraRays::CameraRays(std::shared_ptr<const InputRays> rays, const V2d& size,
                       const Problem& problem)
    : make_(nullptr), problem_(&problem), size_(size) {
    for (const Unknown& unknown : problem.unknowns) {
        inputs_.push_back(unknown.input);
    }
    cameras_.emplace(std::vector<double>(), std::move(rays));
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
    Result<InputRays> rays = InputRays::make(*camera, size_, closed_ > 0, inputs_, shapes_, stop_);
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

// The numbers that a camera is made of, with one of them on both sides of its value.
struct CameraRays::Beside {
    std::vector<double> below, above;
    double width;  // From one to the other.
};

// Calls open(k) for number k of the unknowns with an input, and closed(beside) for the others, in
// the order of all unknowns.
template <class Open, class Closed>
void CameraRays::for_each_unknown(const Split& numbers, const Open& open,
                                  const Closed& closed) const {
    std::size_t next_open = 0;
    std::size_t next_closed = 0;
    for (const Unknown& unknown : problem_->unknowns) {
        if (!unknown.input.empty()) {
            open(next_open++);
            continue;
        }
        const std::size_t k = next_closed++;
        const Sides sides(unknown.range, numbers.closed[k]);
        Beside beside{numbers.closed, numbers.closed, sides.above - sides.below};
        beside.below[k] = sides.below;
        beside.above[k] = sides.above;
        closed(beside);
    }
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
    const auto open = [&](std::size_t k) {
        for (std::size_t i = 0; i < made.size(); ++i) {
            if (middle[i].ray.valid) {
                made[i].by_input.push_back(middle[i].by_input[k]);
            }
        }
    };
    for_each_unknown(numbers, open, [&](const Beside& beside) {
        const std::vector<InputRay> below = rays_of(beside.below, false);
        const std::vector<InputRay> above = rays_of(beside.above, false);
        for (std::size_t i = 0; i < made.size(); ++i) {
            const rays::Ray& before = below[i].ray;
            const rays::Ray& after = above[i].ray;
            made[i].ray.valid = made[i].ray.valid && after.valid && before.valid;
            made[i].by_input.push_back({slope(before.origin, after.origin, beside.width),
                                        slope(before.direction, after.direction, beside.width)});
        }
    });
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
    const auto open = [&](std::size_t k) {
        for (std::size_t i = 0; i < made.size(); ++i) {
            for (std::size_t r = 0; made[i].valid && r < made[i].values.size(); ++r) {
                made[i].by_input[r].push_back(middle[i].by_input[r][k]);
            }
        }
    };
    for_each_unknown(numbers, open, [&](const Beside& beside) {
        const std::vector<ShapeValues> below = shapes_of(beside.below);
        const std::vector<ShapeValues> above = shapes_of(beside.above);
        for (std::size_t i = 0; i < made.size(); ++i) {
            made[i].valid = made[i].valid && above[i].valid && below[i].valid;
            for (std::size_t r = 0; made[i].valid && r < made[i].values.size(); ++r) {
                made[i].by_input[r].push_back(
                    slope(below[i].values[r], above[i].values[r], beside.width));
            }
        }
    });
    return made;
}

}  // namespace balcony::solve

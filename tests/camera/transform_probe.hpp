// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "support.hpp"

namespace balcony::camera {

/// A parameter transformer at a point, with its derivatives from the graph.
struct WarpSample {
    std::array<double, 2> point{};
    std::array<double, 2> by_u{};
    std::array<double, 2> by_v{};
    bool valid = false;
};

class WarpProbe {
public:
    explicit WarpProbe(const ParameterTransformerPointer& transformer);
    [[nodiscard]] WarpSample operator()(double u, double v) const;
    [[nodiscard]] std::span<const Expr> roots() const { return roots_; }

private:
    std::shared_ptr<Graph> graph_ = std::make_shared<Graph>();
    std::vector<Expr> roots_;
};

/// An object transformer at a point, with its derivatives from the graph.
struct MoveSample {
    Vector point{};
    std::array<Vector, 3> by{};  ///< By x, y and z.
    bool valid = false;
};

class MoveProbe {
public:
    explicit MoveProbe(const ObjectTransformerPointer& transformer);
    [[nodiscard]] MoveSample operator()(const Vector& p, double time = 0.0) const;

private:
    std::shared_ptr<Graph> graph_ = std::make_shared<Graph>();
    std::vector<Expr> roots_;
};

/// A list of points, by their number of coordinates.
PointList points(std::size_t coordinates, std::vector<double> values);

}  // namespace balcony::camera

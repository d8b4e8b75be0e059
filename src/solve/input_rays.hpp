// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Rays at points of the picture, with their derivatives by the point and by inputs of the camera.

#include <cstddef>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "balcony/program.hpp"
#include "balcony/rays.hpp"
#include "balcony/solve.hpp"

namespace balcony::solve {

/// The derivatives of a ray by one number.
struct RayChange {
    V3d origin{0.0};
    V3d direction{0.0};
};

/// A ray with its footprint and its derivatives; valid only if all of these are finite.
struct InputRay {
    rays::Ray ray;
    std::vector<RayChange> by_input;  ///< Only if they were asked for.
};

/// A demand on the shape of the picture at a point, as numbers to be zero.
struct ShapeValues {
    bool valid = false;
    std::vector<double> values;
    std::vector<std::vector<double>> by_input;  ///< By value, then by input.
};

/// What rays are made of: a camera, or a layer of a picture.
struct RaySource {
    std::function<camera::RayExpressions(expr::Graph& graph)> emit;
    Axes axes = Axes::z_up;
    std::string name;
    V2d size;
    double time = 0.0;  ///< In seconds.
    /// Whether it is one of many that give a few rays each, so that simplifying its formulas does
    /// not pay.
    bool is_one_of_many = false;
};

/// The rays of a camera in a picture of one size at one time, for any values of some inputs.
/// Immutable.
class InputRays {
public:
    [[nodiscard]] static Result<InputRays> make(const RaySource& source,
                                                const std::vector<std::string>& inputs,
                                                const std::vector<const Constraint*>& shapes,
                                                const std::stop_token& stop);
    [[nodiscard]] static Result<InputRays> make(const camera::Camera& camera, const V2d& size,
                                                bool is_one_of_many,
                                                const std::vector<std::string>& inputs,
                                                const std::vector<const Constraint*>& shapes,
                                                const std::stop_token& stop);

    /// The rays at some points for these values of the inputs.
    [[nodiscard]] std::vector<InputRay> at(std::span<const V2d> points,
                                           std::span<const double> values, bool by_input) const;
    /// What the shapes that it was made for miss there.
    [[nodiscard]] std::vector<ShapeValues> shapes(std::span<const double> values) const;

private:
    /// What a shape computes, at which point, with how many values.
    struct Shape {
        program::Program program;
        V2d position;
        std::size_t count;
    };

    std::size_t inputs_ = 0;
    double time_ = 0.0;
    std::optional<program::Program> rays_;      ///< Without derivatives by inputs.
    std::optional<program::Program> by_input_;  ///< With them.
    std::vector<Shape> shapes_;
};

}  // namespace balcony::solve

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "balcony/stages.hpp"

namespace balcony::camera {

using Vector3 = std::array<double, 3>;

/// A point of a curve with derivatives by its parameter. NaN where there is no point.
struct CurveSample {
    Vector3 point{};
    Vector3 velocity{};
    Vector3 acceleration{};  ///< Only if requested.
};

[[nodiscard]] double norm(const Vector3& v);
/// Whether two samples are at the same point, up to rounding.
[[nodiscard]] bool at_same_point(const CurveSample& a, const CurveSample& b);

/// Samples a curve, for stages that make tables from it.
class CurveSampler {
public:
    enum class Derivatives : std::uint8_t { first, second };

    /// The curve must not change with time.
    [[nodiscard]] static Result<CurveSampler> make(const ObjectGenerator& curve,
                                                   Derivatives derivatives);

    [[nodiscard]] std::vector<CurveSample> operator()(std::span<const double> parameters) const;

private:
    /// The expressions are a point, its velocity and acceleration; and last the validity.
    CurveSampler(std::shared_ptr<const Graph> graph, std::span<const Expr> expressions);

    std::shared_ptr<const Graph> graph_;
    std::size_t last_;  ///< The number of the last expression.
    expr::BatchEvaluator evaluate_;
};

}  // namespace balcony::camera

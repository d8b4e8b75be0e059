// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "balcony/camera.hpp"

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
    CurveSampler() = default;
    void run(std::span<const double> parameters, std::span<double> values) const;

    std::shared_ptr<Graph> graph_ = std::make_shared<Graph>();
    std::vector<Expr> roots_;          ///< Point, velocity, acceleration, and last the validity.
    std::vector<expr::NodeId> nodes_;  ///< All that the roots need, arguments first.
    std::vector<std::size_t> places_;  ///< By node: its index in nodes_.
};

}  // namespace balcony::camera

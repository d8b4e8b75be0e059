// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Warping by seed points: correspondences between scattered points, in parameter
// space (PCS → PCS) and in object space (OCS → OCS), by thin-plate splines and by inverse-distance
// weighting (D. Shepard 1968).

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "camera/catalogue/families.hpp"
#include "camera/transforms/offset_stages.hpp"
#include "camera/transforms/thin_plate_spline.hpp"

namespace balcony::camera {

namespace {

constexpr std::size_t max_seeds = 1000;
/// The minimum squared distance from a seed, in units of the seeds' spread; smaller distances are
/// replaced by it, so that no logarithm, root or quotient has the argument 0.
constexpr double min_squared_distance = 1e-30;

/// Seeds and their offsets, in coordinates relative to their mean and in units of their spread
/// (the root of the mean squared distance from the mean).
struct Seeds {
    std::size_t dimension = 2;
    std::vector<double> mean;
    double spread = 1.0;
    std::vector<double> places;
    std::vector<double> offsets;

    [[nodiscard]] std::size_t size() const { return places.size() / dimension; }

    [[nodiscard]] std::vector<Expr> normalized(std::span<const Expr> p) const {
        std::vector<Expr> q;
        for (std::size_t k = 0; k < dimension; ++k) {
            q.push_back((p[k] - mean[k]) / spread);
        }
        return q;
    }

    [[nodiscard]] Expr squared_distance(std::size_t seed, std::span<const Expr> q,
                                        const Emitter& emit) const {
        Expr sum = emit(0.0);
        for (std::size_t k = 0; k < dimension; ++k) {
            const Expr d = q[k] - places[seed * dimension + k];
            sum = sum + d * d;
        }
        return sum;
    }
};

Seeds seeds_of(const PointList& points) {
    Seeds seeds;
    seeds.dimension = points.coordinates / 2;
    seeds.mean.resize(seeds.dimension);
    const double count = static_cast<double>(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t k = 0; k < seeds.dimension; ++k) {
            seeds.mean[k] += points[i][k] / count;
        }
    }
    double squared_spread = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t k = 0; k < seeds.dimension; ++k) {
            const double place = points[i][k] - seeds.mean[k];
            seeds.places.push_back(place);
            seeds.offsets.push_back(points[i][seeds.dimension + k] - points[i][k]);
            squared_spread += place * place / count;
        }
    }
    if (squared_spread > 0.0) {
        seeds.spread = std::sqrt(squared_spread);
        for (double& place : seeds.places) {
            place /= seeds.spread;
        }
    }
    return seeds;
}

struct ThinPlateField {
    Seeds seeds;
    ThinPlateSpline spline;

    [[nodiscard]] std::vector<Expr> operator()(std::span<const Expr> p, const Emitter& emit) const {
        const std::vector<Expr> q = seeds.normalized(p);
        const std::size_t dimension = seeds.dimension;
        std::vector<Expr> offset;
        for (std::size_t k = 0; k < dimension; ++k) {
            offset.push_back(emit(spline.affine[k]));
            for (std::size_t i = 0; i < dimension; ++i) {
                offset[k] = offset[k] + spline.affine[(i + 1) * dimension + k] * q[i];
            }
        }
        for (std::size_t i = 0; i < seeds.size(); ++i) {
            const Expr r2 = seeds.squared_distance(i, q, emit);
            const Expr apart = max(r2, emit(min_squared_distance));
            const Expr kernel = dimension == 2 ? r2 * log(apart) : -sqrt(apart);
            for (std::size_t k = 0; k < dimension; ++k) {
                offset[k] = offset[k] + spline.weights[i * dimension + k] * kernel;
            }
        }
        return offset;
    }
};

/// The mean of the seeds' offsets with weights 1/(r^2 + s^2)^(power/2).
struct InverseDistanceField {
    Seeds seeds;
    double power = 2.0;
    double smoothing = 0.0;

    [[nodiscard]] std::vector<Expr> operator()(std::span<const Expr> p, const Emitter& emit) const {
        const std::vector<Expr> q = seeds.normalized(p);
        Expr weights = emit(0.0);
        std::vector<Expr> offset(seeds.dimension, emit(0.0));
        for (std::size_t i = 0; i < seeds.size(); ++i) {
            const Expr r2 = seeds.squared_distance(i, q, emit);
            const Expr apart = max(r2, emit(min_squared_distance)) + smoothing * smoothing;
            const Expr weight = pow(apart, -0.5 * power);
            weights = weights + weight;
            for (std::size_t k = 0; k < seeds.dimension; ++k) {
                offset[k] = offset[k] + seeds.offsets[i * seeds.dimension + k] * weight;
            }
        }
        for (Expr& coordinate : offset) {
            coordinate = coordinate / weights;
        }
        return offset;
    }
};

std::string place_of(const PointList& points, std::size_t i) {
    const auto place = points[i].first(points.coordinates / 2);
    return fmt::format("({})", fmt::join(place, ", "));
}

/// Two seeds at the same position with different targets contradict each other, and even if they do
/// not, the system of equations has no single solution without smoothing.
Diagnostics check_seeds(const PointList& points, double smoothing) {
    if (points.size() > max_seeds) {
        return {error(fmt::format("{} seeds are too many", points.size()), {},
                      fmt::format("give at most {}", max_seeds))};
    }
    const std::size_t dimension = points.coordinates / 2;
    for (std::size_t i = 0; smoothing == 0.0 && i < points.size(); ++i) {
        for (std::size_t k = i + 1; k < points.size(); ++k) {
            if (std::ranges::equal(points[i].first(dimension), points[k].first(dimension))) {
                return {error(fmt::format("seeds {} and {} are both at {}", i + 1, k + 1,
                                          place_of(points, i)),
                              {}, "remove one of them, or use smoothing above 0")};
            }
        }
    }
    return {};
}

template <template <class> class Target>
StageResult thin_plate(const Arguments& a) {
    const PointList& points = a.points("seeds");
    const double smoothing = a.constant("smoothing");
    if (Diagnostics diagnostics = check_seeds(points, smoothing); !diagnostics.empty()) {
        return diagnostics;
    }
    Seeds seeds = seeds_of(points);
    auto spline =
        fit_thin_plate(seeds.places, seeds.dimension, seeds.offsets, seeds.dimension, smoothing);
    if (!spline) {
        return error(fmt::format("the seeds lie on one {}, or some nearly coincide",
                                 seeds.dimension == 2 ? "line" : "plane"),
                     {}, "add a seed away from the others that does not move");
    }
    return made<Target<ThinPlateField>>(ThinPlateField{std::move(seeds), std::move(*spline)},
                                        a.number("amount"));
}

template <template <class> class Target>
StageResult inverse_distance(const Arguments& a) {
    const PointList& points = a.points("seeds");
    const double smoothing = a.constant("smoothing");
    if (Diagnostics diagnostics = check_seeds(points, smoothing); !diagnostics.empty()) {
        return diagnostics;
    }
    return made<Target<InverseDistanceField>>(
        InverseDistanceField{seeds_of(points), a.constant("power"), smoothing}, a.number("amount"));
}

StageParameter seeds_parameter(StageKind kind, std::size_t minimum) {
    const bool plane = kind == StageKind::parameter_transformer;
    return {.name = "seeds",
            .type = PointsParameter{.unit = plane ? Unit::either : Unit::number,
                                    .coordinates = {plane ? std::size_t{4} : std::size_t{6}},
                                    .min_points = minimum},
            .meaning = plane ? "(u, v, u', v'): the picture shows at (u, v) what was at (u', v')"
                             : "(x, y, z, x', y', z'): a point and its new position"};
}

StageParameter smoothing_parameter(std::string_view meaning) {
    return {
        .name = "smoothing",
        .type = NumberParameter{.default_value = 0.0, .range = {.minimum = 0.0}, .constant = true},
        .meaning = meaning};
}

std::vector<StageParameter> thin_plate_parameters(StageKind kind) {
    return {seeds_parameter(kind, kind == StageKind::parameter_transformer ? 3 : 4),
            smoothing_parameter(
                "0 interpolates the seeds; 0.01 smooths slightly, 100 gives the affine map "
                "with the best fit"),
            amount_parameter()};
}

std::vector<StageParameter> inverse_distance_parameters(StageKind kind) {
    return {
        seeds_parameter(kind, 1),
        {.name = "power",
         .type =
             NumberParameter{.default_value = 2.0,
                             .range = {.minimum = 1.0, .maximum = 8.0, .excludes_minimum = true},
                             .constant = true},
         .meaning = "exponent of the distance; a higher value increases the influence of the "
                    "nearest seed"},
        smoothing_parameter("0 interpolates the seeds; otherwise a radius, in units of the seeds' "
                            "spread, that limits the influence of near seeds"),
        amount_parameter()};
}

}  // namespace

std::vector<StageEntry> seed_warps() {
    const StageKind parameter_kind = StageKind::parameter_transformer;
    const StageKind object_kind = StageKind::object_transformer;
    return {
        {.kind = parameter_kind,
         .name = "thin_plate",
         .meaning =
             "the smoothest warp that moves seed points to given positions, like a bent thin plate",
         .formula = R"(
(u′, v′) = (u, v) + amount (a₀ + A p + Σᵢ wᵢ φ(|p − pᵢ|))
φ(r) = r² log r²
p, pᵢ   the point and the n seeds minus the seeds' mean, divided by their spread
        σ = √(mean squared distance of the seeds from their mean)
a₀, A, w   solve, with the seeds' offsets Δᵢ,  Σ wᵢ = 0,  Σ wᵢ pᵢ = 0  and
           a₀ + A pᵢ + Σₖ wₖ φ(|pᵢ − pₖ|) + n smoothing wᵢ = Δᵢ  for all i
As scipy's RBFInterpolator(seeds, offsets, kernel="thin_plate_spline",
smoothing=λ) with λ = smoothing n σ²/2.
)",
         .parameters = thin_plate_parameters(parameter_kind),
         .make = thin_plate<ParameterOffset>,
         .example = R"(camera thin_plate {
    map    u = 1.2 .. -1.2, v = square
    warp   thin_plate([(-1, -0.6, -1, -0.6), (1, -0.6, 1, -0.6), (1, 0.6, 1, 0.6),
                       (-1, 0.6, -1, 0.6), (0.4, 0, 0.1, 0.2), (-0.4, 0, -0.1, -0.2)])
    eye    point
    toward plane((1, 0, 0))
})"},
        {.kind = parameter_kind,
         .name = "inverse_distance",
         .meaning =
             "the mean of the offsets of seed points, weighted by inverse distance (Shepard)",
         .formula = R"(
(u′, v′) = (u, v) + amount Σᵢ wᵢ Δᵢ / Σᵢ wᵢ
wᵢ = (d² + smoothing²)^(−power/2),   d = |(u, v) − pᵢ|/σ
σ   √(mean squared distance of the seeds pᵢ from their mean); Δᵢ their offsets
)",
         .parameters = inverse_distance_parameters(parameter_kind),
         .make = inverse_distance<ParameterOffset>,
         .example = R"(camera inverse_distance {
    map    u = 1.2 .. -1.2, v = square
    warp   inverse_distance([(-1, -0.6, -1, -0.6), (1, -0.6, 1, -0.6), (1, 0.6, 1, 0.6),
                             (-1, 0.6, -1, 0.6), (0, 0, 0.3, 0.2)], smoothing = 0.2)
    eye    point
    toward plane((1, 0, 0))
})"},
        {.kind = object_kind,
         .name = "thin_plate",
         .meaning = "the smoothest deformation of space that moves seed points to given positions",
         .formula = R"(
p′ = p + amount (a₀ + A q + Σᵢ wᵢ φ(|q − qᵢ|))
φ(r) = −r
q, qᵢ   the point and the n seeds minus the seeds' mean, divided by their spread
        σ = √(mean squared distance of the seeds from their mean)
a₀, A, w   solve, with the seeds' offsets Δᵢ,  Σ wᵢ = 0,  Σ wᵢ qᵢ = 0  and
           a₀ + A qᵢ + Σₖ wₖ φ(|qᵢ − qₖ|) + n smoothing wᵢ = Δᵢ  for all i
As scipy's RBFInterpolator(seeds, offsets, kernel="linear", degree=1,
smoothing=λ) with λ = smoothing n σ.
)",
         .parameters = thin_plate_parameters(object_kind),
         .make = thin_plate<ObjectOffset>,
         .example = R"(camera thin_plate {
    map    u = 180deg .. -180deg, v = -90deg .. 90deg
    eye    sphere(1)
    move   thin_plate([(1, 0, 0, 2, 0, 0), (-1, 0, 0, -1, 0, 0), (0, 1, 0, 0, 1, 0.5),
                       (0, -1, 0, 0, -1, 0.5), (0, 0, 1, 0, 0, 1), (0, 0, -1, 0, 0, -1)])
})"},
        {.kind = object_kind,
         .name = "inverse_distance",
         .meaning =
             "a deformation of space: the mean of the offsets of seed points, weighted by inverse "
             "distance",
         .formula = R"(
p′ = p + amount Σᵢ wᵢ Δᵢ / Σᵢ wᵢ
wᵢ = (d² + smoothing²)^(−power/2),   d = |p − pᵢ|/σ
σ   √(mean squared distance of the seeds pᵢ from their mean); Δᵢ their offsets
)",
         .parameters = inverse_distance_parameters(object_kind),
         .make = inverse_distance<ObjectOffset>,
         .example = R"(camera inverse_distance {
    map    u = 180deg .. -180deg, v = -90deg .. 90deg
    eye    sphere(1)
    move   inverse_distance([(1, 0, 0, 2, 0, 0), (-1, 0, 0, -1, 0, 0), (0, 1, 0, 0, 1, 0),
                             (0, -1, 0, 0, -1, 0)], smoothing = 0.5)
})"},
    };
}

}  // namespace balcony::camera

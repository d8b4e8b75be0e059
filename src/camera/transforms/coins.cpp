// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Object transformers, OCS → OCS: centres of interest ("coins") after P. Acquisto and E. Groeller,
// "A Distortion Camera for Ray Tracing" (1995). Points near a centre move towards it, so that rays
// bend towards the centre and things there become larger in the picture.

#include <fmt/format.h>

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"

namespace balcony::camera {

namespace {

enum class FallOff : std::uint8_t { gaussian, inverse, linear, smooth };

constexpr double max_strength = 0.99;

/// Decreases from 1 at the centre to 0 far away; q is the squared distance divided by the squared
/// radius.
Expr fall_off(FallOff kind, Expr q, const Emitter& emit) {
    switch (kind) {
        case FallOff::gaussian: return exp(-q);
        case FallOff::inverse: return 1.0 / (1.0 + q);
        // The slope of the square root is infinite at 0, hence the lower bound of its argument.
        case FallOff::linear: return max(1.0 - sqrt(max(q, emit(1e-24))), emit(0.0));
        case FallOff::smooth: break;
    }
    const Expr inside = max(1.0 - q, emit(0.0));
    return inside * inside * inside;
}

struct Coin {
    Triple at;
    Scalar strength, radius;
};

/// With pull_i = strength_i fall_off_i < 1, a single coin moves a point by that fraction of the way
/// to its centre. Several are combined with w_i = pull_i / (1 - pull_i): the point moves to the
/// mean of itself with weight 1 and the centres with weights w_i. It stays in their convex hull,
/// and the order of the coins does not matter. One coin never folds space, since (distance
/// fall_off)' <= 1.
class Coins final : public ObjectTransformer {
public:
    Coins(std::vector<Coin> coins, FallOff kind) : coins_(std::move(coins)), kind_(kind) {}

    ObjectPoint transform(const ObjectPoint& p, Emitter& emit) const override {
        if (coins_.size() == 1) {
            const ObjectVector way = point_of(coins_[0].at, emit) - p;
            return p + pull(coins_[0], way, emit) * way;
        }
        Expr weights = emit(1.0);
        ObjectVector weighted{emit(0.0), emit(0.0), emit(0.0)};
        for (const Coin& coin : coins_) {
            const ObjectVector way = point_of(coin.at, emit) - p;
            const Expr own = pull(coin, way, emit);
            const Expr weight = own / (1.0 - own);
            weights = weights + weight;
            weighted = weighted + weight * way;
        }
        return p + (1.0 / weights) * weighted;
    }

private:
    [[nodiscard]] Expr pull(const Coin& coin, const ObjectVector& way, const Emitter& emit) const {
        const Expr radius = emit(coin.radius);
        return emit(coin.strength) * fall_off(kind_, dot(way, way) / (radius * radius), emit);
    }

    std::vector<Coin> coins_;
    FallOff kind_;
};

FallOff fall_off_of(const Arguments& a) {
    const std::string& word = a.choice("fall_off");
    return word == "gaussian"  ? FallOff::gaussian
           : word == "inverse" ? FallOff::inverse
           : word == "linear"  ? FallOff::linear
                               : FallOff::smooth;
}

StageResult coins_of(const Arguments& a) {
    const PointList& points = a.points("points");
    std::vector<Coin> coins;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::span<const double> c = points[i];
        Coin coin{{c[0], c[1], c[2]}, a.number("strength"), a.number("radius")};
        if (points.coordinates == 5) {
            if (c[3] < 0.0 || c[3] > max_strength) {
                return error(fmt::format("coin {} has strength {}", i + 1, c[3]), {},
                             fmt::format("a strength must be from 0 to {}", max_strength));
            }
            if (c[4] <= 0.0) {
                return error(fmt::format("coin {} has radius {}", i + 1, c[4]), {},
                             "a radius must be above 0");
            }
            coin.strength = c[3];
            coin.radius = c[4];
        }
        coins.push_back(std::move(coin));
    }
    return made<Coins>(std::move(coins), fall_off_of(a));
}

}  // namespace

std::vector<StageEntry> coins() {
    const StageParameter strength =
        number_parameter("strength", 0.5,
                         "the fraction of the way by which a point near the centre "
                         "moves towards it; enlarges by "
                         "1/(1 - strength) there",
                         {.minimum = 0.0, .maximum = max_strength});
    const StageParameter radius = positive_parameter("radius", 1.0, "range of the effect");
    const StageParameter falloff =
        choice_parameter("fall_off", {"gaussian", "inverse", "linear", "smooth"},
                         "exp(-q), 1/(1 + q), 1 - sqrt(q) or (1 - q)^3 with "
                         "q = (distance/radius)^2; the last two are 0 beyond the radius");
    return {
        {.name = "coin",
         .meaning = "centre of interest: points near it move towards it, so that it appears larger",
         .formula = R"(
p′ = p + s (at − p)
s = strength f(q),   q = |p − at|²/radius²
f = exp(−q) for gaussian, 1/(1 + q) for inverse, max(1 − √q, 0) for linear,
    max(1 − q, 0)³ for smooth
)",
         .parameters = {{.name = "at", .type = TripleParameter{}, .meaning = "the centre"},
                        strength,
                        radius,
                        falloff},
         .make =
             [](const Arguments& a) {
                 return made<Coins>(
                     std::vector{Coin{a.triple("at"), a.number("strength"), a.number("radius")}},
                     fall_off_of(a));
             },
         .example = R"(camera coin {
    map    u = 1.6 .. -1.6, v = square
    eye    point
    toward {
        object plane((2, 0, 0))
        move   coin((2, 0.5, 0.2), strength = 0.8, radius = 0.8)
    }
})"},
        {.name = "coins",
         .meaning = "several centres of interest at once, which share the points between them",
         .formula = R"(
p′ = p + Σᵢ wᵢ (cᵢ − p)/(1 + Σᵢ wᵢ)      cᵢ   the centres
wᵢ = sᵢ/(1 − sᵢ),   sᵢ = strengthᵢ f(qᵢ),   qᵢ = |p − cᵢ|²/radiusᵢ²
f = exp(−q) for gaussian, 1/(1 + q) for inverse, max(1 − √q, 0) for linear,
    max(1 − q, 0)³ for smooth
One centre alone acts as coin does; many together move no point past them.
)",
         .parameters =
             {{.name = "points",
               .type = PointsParameter{.coordinates = {3, 5}},
               .meaning =
                   "the centres (x, y, z), or each with its own (x, y, z, strength, radius)"},
              strength,
              radius,
              falloff},
         .make = coins_of,
         .example = R"(camera coins {
    map    u = 1.6 .. -1.6, v = square
    eye    point
    toward {
        object plane((2, 0, 0))
        move   coins([(2, 0.9, 0.3), (2, -0.9, 0)], strength = 0.8, radius = 0.6, fall_off = smooth)
    }
})"},
    };
}

}  // namespace balcony::camera

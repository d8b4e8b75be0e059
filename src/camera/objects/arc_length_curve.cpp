// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Object generator, PCS → OCS: any curve by its length.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"
#include "camera/curves/arc_length.hpp"
#include "camera/curves/curve_sampler.hpp"
#include "camera/curves/spline_tables.hpp"

namespace balcony::camera {

namespace {

constexpr std::size_t cells = 1024;

/// The point at the fraction u of the curve's length. The parameter comes from a
/// table; points and tangent directions are those of the exact curve. For a curve with continuous
/// curvature that does not slow down by more than ten times the length up to any u is off by less
/// than 1e-6 of the whole.
class ArcLengthCurve final : public ObjectGenerator {
public:
    ArcLengthCurve(ObjectGeneratorPointer curve, TablePointer parameter, bool closed)
        : curve_(std::move(curve)), parameter_(std::move(parameter)), closed_(closed) {}
    int dimension() const override { return 1; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        const Expr fraction = within_unit_range(p.u, closed_, emit);
        return curve_->generate({emit.graph().lookup(parameter_, fraction), p.v}, emit);
    }

private:
    ObjectGeneratorPointer curve_;
    TablePointer parameter_;
    bool closed_;
};

StageResult make_arc_length(const Arguments& a) {
    const ObjectGeneratorPointer curve = a.curve("curve");
    const double from = a.constant("from");
    const double to = a.constant("to");
    const Result<CurveSampler> sampler =
        CurveSampler::make(*curve, CurveSampler::Derivatives::first);
    if (!sampler) {
        return sampler.diagnostics;
    }
    // In fractions of the way from `from` to `to`, so that their order does not matter.
    std::optional<double> without_point;
    const auto speeds = [&](std::span<const double> fractions) {
        std::vector<double> parameters;
        for (const double fraction : fractions) {
            parameters.push_back(std::lerp(from, to, fraction));
        }
        const std::vector<CurveSample> samples = (*sampler)(parameters);
        std::vector<double> made;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const double speed = std::fabs(to - from) * norm(samples[i].velocity);
            // A speed that is infinite at a single point does not contribute to the length.
            made.push_back(std::isfinite(speed) ? speed : 0.0);
            // A curve without points or without length gives no valid parameter.
            if (!without_point && std::isnan(norm(samples[i].point)) &&
                std::isfinite(parameters[i])) {
                without_point = parameters[i];
            }
        }
        return made;
    };
    const Knots knots = parameter_by_length(speeds, 1.0, EndGrading(0.0), cells);
    if (without_point) {
        return error(fmt::format("the curve has no point at its parameter {:.6g}", *without_point),
                     {}, "choose from and to such that the curve is defined between them");
    }
    if (!std::all_of(knots.values.begin(), knots.values.end(),
                     [](double value) { return std::isfinite(value); })) {
        return error(fmt::format("the curve has no length between {:.6g} and {:.6g}", from, to), {},
                     "choose from and to such that the curve has a length between them");
    }
    std::vector<double> values;
    std::vector<double> slopes;
    for (std::size_t i = 0; i <= cells; ++i) {
        values.push_back(std::lerp(from, to, knots.values[i]));
        slopes.push_back((to - from) * knots.slopes[i]);
    }
    const std::vector<CurveSample> ends = (*sampler)(std::array{from, to});
    return made<ArcLengthCurve>(
        curve, std::make_shared<const expr::Table>(expr::hermite_table(0.0, 1.0, values, slopes)),
        at_same_point(ends[0], ends[1]));
}

}  // namespace

std::vector<StageEntry> arc_length_curve() {
    return {
        {.name = "arc_length",
         .meaning =
             "any curve by arc length, for u from 0 to 1: equal steps of u have equal lengths",
         .formula = R"(
p = c(w)      c = curve,   0 ≤ u ≤ 1
∫ |c′| from `from` to w  =  u ∫ |c′| from `from` to `to`
)",
         .parameters =
             {curve_parameter("curve", "the curve; it cannot change with time"),
              {.name = "from",
               .type =
                   NumberParameter{.unit = Unit::either, .default_value = 0.0, .constant = true},
               .meaning = "the curve's own parameter at u = 0"},
              {.name = "to",
               .type =
                   NumberParameter{.unit = Unit::either, .default_value = 1.0, .constant = true},
               .meaning = "the curve's own parameter at u = 1; if the curve is closed there, it is "
                          "periodic"}},
         .make = make_arc_length,
         .dimension = 1,
         .example =
             R"(// Along a long ellipse at constant speed, so that nothing is stretched at its ends.
camera even_ellipse {
    aspect 3
    map  u = 1 .. 0, v = -30deg .. 30deg
    eye  product(arc_length(ellipse(5, 2), from = 0deg, to = 360deg), circle)
    look normal
})"},
    };
}

}  // namespace balcony::camera

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Laws of every transformer in the catalogue.

#include "transform_probe.hpp"

namespace balcony::camera::transformer_laws_test {

namespace {

// With a step of 1e-5 a central difference is off by the third derivative / 6e10 and by roundings
// of size 1e-16 / 1e-5.
constexpr double step = 1e-5;
double tolerance(double slope) { return 1e-8 + 1e-7 * std::fabs(slope); }

/// The stage as its row makes it, and once with each of its choices.
std::vector<Given> variants(const StageEntry& row) {
    std::vector<Given> all{{}};
    for (const StageParameter& parameter : row.parameters) {
        for (const std::string_view choice : choices_of(parameter)) {
            all.push_back({{parameter.name, std::string(choice)}});
        }
        const auto* count = parameter.as<CountParameter>();
        if (count != nullptr && count->range.minimum <= 3.0) {
            all.push_back({{parameter.name, numbers({3.0})}});
        }
    }
    return all;
}

template <class Check>
void for_every(StageKind kind, const Check& check) {
    for (const StageEntry& row : catalogue()) {
        if (row.kind != kind) {
            continue;
        }
        SCOPED_TRACE(row.name);
        for (const Given& given : variants(row)) {
            if (const auto made = row.make(arguments_for(row, given))) {
                check(*made);
            }
        }
    }
}

}  // namespace

TEST(ParameterTransformers, DerivativesAreNeighbourDifferences) {
    for_every(StageKind::parameter_transformer, [](const std::shared_ptr<const Stage>& stage) {
        const WarpProbe probe(std::dynamic_pointer_cast<const ParameterTransformer>(stage));
        // Beside the box of a map there is nothing.
        std::size_t checked = 0;
        for (const auto& [u, v] : {std::array{0.37, 0.23}, {-0.61, 0.87}, {0.53, -0.42}}) {
            const WarpSample here = probe(u, v);
            if (!here.valid) {
                continue;
            }
            ++checked;
            for (std::size_t i = 0; i < 2; ++i) {
                const double by_u =
                    (probe(u + step, v).point[i] - probe(u - step, v).point[i]) / (2.0 * step);
                const double by_v =
                    (probe(u, v + step).point[i] - probe(u, v - step).point[i]) / (2.0 * step);
                EXPECT_NEAR(here.by_u[i], by_u, tolerance(by_u));
                EXPECT_NEAR(here.by_v[i], by_v, tolerance(by_v));
            }
        }
        EXPECT_GT(checked, 0U);
    });
}

TEST(ObjectTransformers, DerivativesAreNeighbourDifferences) {
    for_every(StageKind::object_transformer, [](const std::shared_ptr<const Stage>& stage) {
        const MoveProbe probe(std::dynamic_pointer_cast<const ObjectTransformer>(stage));
        for (const Vector& p : {Vector{0.37, 0.23, 0.31}, {-0.61, 0.87, -0.29}, {1.3, -0.8, 0.6}}) {
            const MoveSample here = probe(p);
            ASSERT_TRUE(here.valid);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                Vector up = p;
                Vector down = p;
                up[axis] += step;
                down[axis] -= step;
                const Vector slope = (0.5 / step) * (probe(up).point - probe(down).point);
                for (std::size_t i = 0; i < 3; ++i) {
                    EXPECT_NEAR(here.by[axis][i], slope[i], tolerance(slope[i]));
                }
            }
        }
    });
}

}  // namespace balcony::camera::transformer_laws_test

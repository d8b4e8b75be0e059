// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <numbers>

#include "support.hpp"

namespace balcony::camera::object_transforms_test {

namespace {

// Values of everyday size, rounded a few times.
constexpr double tolerance = 1e-14;
const Vector p{0.7, -1.3, 2.1};

// The columns of the linear part.
std::array<Vector, 3> linear_part(const ObjectTransformerPointer& transformer) {
    const Vector origin = transformed(transformer, {0.0, 0.0, 0.0});
    return {transformed(transformer, {1.0, 0.0, 0.0}) - origin,
            transformed(transformer, {0.0, 1.0, 0.0}) - origin,
            transformed(transformer, {0.0, 0.0, 1.0}) - origin};
}

double determinant(const std::array<Vector, 3>& m) { return dot(cross(m[0], m[1]), m[2]); }

void expect_orthonormal(const std::array<Vector, 3>& m) {
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(dot(m[i], m[k]), i == k ? 1.0 : 0.0, tolerance);
        }
    }
}

ObjectTransformerPointer rotation(const std::vector<double>& axis, double angle) {
    return move(
        "rotate",
        {{"axis", numbers(axis)}, {"angle", numbers({angle})}, {"at", numbers({0.3, 0.2, -0.5})}});
}

}  // namespace

TEST(Rotate, IsAProperRotationAboutItsPointAndAxis) {
    for (const std::vector<double>& axis : {std::vector{0.0, 0.0, 2.0}, {1.0, -2.0, 0.5}}) {
        for (const double angle : {-2.0, 0.3, 1.0, 3.0}) {
            const auto rotate = rotation(axis, angle);
            const auto linear = linear_part(rotate);
            expect_orthonormal(linear);
            EXPECT_NEAR(determinant(linear), 1.0, tolerance);
            // The trace of a rotation is 1 + 2 cos.
            EXPECT_NEAR(linear[0][0] + linear[1][1] + linear[2][2], 1.0 + 2.0 * std::cos(angle),
                        tolerance);
            const Vector on_axis{0.3 + axis[0], 0.2 + axis[1], -0.5 + axis[2]};
            expect_near(transformed(rotate, on_axis), on_axis, tolerance);
        }
    }
}

TEST(Rotate, IsCounterClockwiseSeenFromTheTip) {
    const auto quarter = move("rotate", {{"axis", numbers({0.0, 0.0, 1.0})},
                                         {"angle", numbers({std::numbers::pi / 2.0})}});
    expect_near(transformed(quarter, {1.0, 0.0, 5.0}), {0.0, 1.0, 5.0}, tolerance);
}

TEST(Rotate, AnglesOfOneAxisAddUp) {
    const std::vector axis{1.0, -2.0, 0.5};
    expect_near(transformed(rotation(axis, 0.7), transformed(rotation(axis, 0.4), p)),
                transformed(rotation(axis, 1.1), p), tolerance);
}

TEST(Mirror, TwiceIsTheIdentityAndOnceTurnsSpaceOver) {
    const auto mirror =
        move("mirror", {{"axis", numbers({1.0, -2.0, 0.5})}, {"at", numbers({0.3, 0.2, -0.5})}});
    expect_near(transformed(mirror, transformed(mirror, p)), p, tolerance);
    expect_orthonormal(linear_part(mirror));
    EXPECT_NEAR(determinant(linear_part(mirror)), -1.0, tolerance);
    expect_near(transformed(mirror, {0.3, 0.2, -0.5}), {0.3, 0.2, -0.5}, tolerance);
}

TEST(ObjectAffine, EachIsItsFormula) {
    const auto at = numbers({0.2, 0.5, 1.0});
    const auto go = [&](const char* name, const Given& given) {
        return transformed(move(name, given), p);
    };
    expect_near(
        go("translate", {{"x", numbers({1.0})}, {"y", numbers({2.0})}, {"z", numbers({3.0})}}),
        {1.7, 0.7, 5.1}, tolerance);
    expect_near(go("scale", {{"factor", numbers({2.0})}, {"at", at}}), {1.2, -3.1, 3.2}, tolerance);
    expect_near(
        go("stretch",
           {{"x", numbers({2.0})}, {"y", numbers({-1.0})}, {"z", numbers({3.0})}, {"at", at}}),
        {1.2, 2.3, 4.3}, tolerance);
    expect_near(go("affine", {{"x", numbers({1.0, 2.0, 3.0})},
                              {"y", numbers({4.0, 5.0, 6.0})},
                              {"z", numbers({7.0, 8.0, 10.0})},
                              {"at", at}}),
                {0.2 + 0.7 - 1.3 * 4.0 + 2.1 * 7.0, 0.5 + 0.7 * 2.0 - 1.3 * 5.0 + 2.1 * 8.0,
                 1.0 + 0.7 * 3.0 - 1.3 * 6.0 + 2.1 * 10.0},
                tolerance);
}

TEST(ObjectAffine, DefaultsChangeNothing) {
    for (const char* name : {"translate", "stretch", "affine"}) {
        expect_near(transformed(move(name), p), p, 0.0);
    }
}

TEST(ObjectAffine, AnAxisNeedsALength) {
    for (const char* name : {"rotate", "mirror"}) {
        const auto made =
            try_stage(StageKind::object_transformer, name, {{"axis", numbers({0.0, 0.0, 0.0})}});
        ASSERT_FALSE(made);
        EXPECT_NE(made.diagnostics.front().message.find("axis"), std::string::npos);
    }
}

}  // namespace balcony::camera::object_transforms_test

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "transform_probe.hpp"

namespace balcony::camera::repeat_test {

namespace {

// A rotation rounds a few times, and this many of them.
constexpr double tolerance = 1e-13;

Arguments::Value list(std::vector<Arguments::StagePointer> stages) { return stages; }

}  // namespace

TEST(Repeat, OfARotationIsTheRotationByAsManyTimesTheAngle) {
    const auto rotate = [](double angle) {
        return warp("rotate", {{"angle", numbers({angle})}, {"at", numbers({0.3, 0.1})}});
    };
    const auto repeat =
        warp("repeat", {{"times", numbers({7.0})}, {"stages", list({rotate(0.2)})}});
    const auto once = warped(rotate(1.4), 0.7, -0.2);
    const auto often = warped(repeat, 0.7, -0.2);
    EXPECT_NEAR(often[0], once[0], tolerance);
    EXPECT_NEAR(often[1], once[1], tolerance);
}

TEST(Repeat, TakesItsStagesInSequence) {
    const auto shift = warp("translate", {{"u", numbers({1.0})}});
    const auto twice = warp("scale", {{"factor", numbers({2.0, 2.0})}});
    const auto repeat =
        warp("repeat", {{"times", numbers({2.0})}, {"stages", list({shift, twice})}});
    EXPECT_EQ(warped(repeat, 0.5, 0.25)[0], ((0.5 + 1.0) * 2.0 + 1.0) * 2.0);
}

TEST(Repeat, WorksInObjectSpaceToo) {
    const auto step = move("translate", {{"z", numbers({0.5})}});
    const auto repeat = move("repeat", {{"times", numbers({64.0})}, {"stages", list({step})}});
    expect_near(transformed(repeat, {1.0, 2.0, 3.0}), {1.0, 2.0, 35.0}, 0.0);
}

TEST(Repeat, WithinRepeatsHasALimit) {
    const auto nested = [](const Arguments::StagePointer& inner) {
        return try_stage(StageKind::parameter_transformer, "repeat",
                         {{"times", numbers({64.0})}, {"stages", list({inner})}});
    };
    const auto maximum = nested(*nested(warp("shear")));
    ASSERT_TRUE(maximum);
    const auto too_many = nested(*maximum);
    ASSERT_FALSE(too_many);
    EXPECT_NE(too_many.diagnostics.front().message.find("262144"), std::string::npos);
}

}  // namespace balcony::camera::repeat_test

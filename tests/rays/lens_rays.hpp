// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "balcony/make_stage.hpp"
#include "balcony/prescription.hpp"
#include "support.hpp"

namespace balcony::rays::test {

/// The stage lens table(...) with these arguments.
inline camera::StageResult table(const std::vector<camera::NamedValue>& values) {
    return camera::make_stage(*camera::catalogue().find(camera::StageKind::lens, "table"), values);
}

/// A camera with a lens that no file has, which looks along x with y to the left; the unit is 1 mm.
inline camera::Camera camera_with(const camera::Prescription& lens,
                                  std::vector<camera::NamedValue> values) {
    EXPECT_EQ(to_text(check(lens)), "");
    values.push_back({"file", std::make_shared<const camera::Prescription>(lens)});
    values.push_back({"unit", 1.0});
    camera::Camera::Parts parts =
        camera_of(
            "camera a { aspect 1  map u = 0.1 .. -0.1, v = square  eye point  toward "
            "plane((1, 0, 0)) }")
            .parts();
    const auto made = table(values);
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    parts.lens = std::static_pointer_cast<const camera::Lens>(*made);
    auto camera = camera::Camera::make(std::move(parts));
    EXPECT_TRUE(camera) << to_text(camera.diagnostics);
    return *camera;
}

inline constexpr double pixels = 400.0;  // The width and height of the picture.

/// The rays of a camera at points of its picture and of its lens.
class LensRaysAt {
public:
    explicit LensRaysAt(const std::string& text) : LensRaysAt(camera_of(text)) {}
    explicit LensRaysAt(const camera::Camera& camera)
        : lens_(compiled(camera, {{std::string(camera::lens_input_x), program::Rate::pixel},
                                  {std::string(camera::lens_input_y), program::Rate::pixel}})),
          central_(compiled(camera, {})) {}

    [[nodiscard]] Ray operator()(const V2d& point, const V2d& lens) const {
        const std::array<std::span<const double>, 2> inputs{std::span(&lens.x, 1),
                                                            std::span(&lens.y, 1)};
        return run(lens_, point, inputs)[0];
    }
    [[nodiscard]] bool blocked(const V2d& point, const V2d& lens) const {
        const std::array<std::span<const double>, 2> inputs{std::span(&lens.x, 1),
                                                            std::span(&lens.y, 1)};
        return run(lens_, point, inputs).blocked(0);
    }
    [[nodiscard]] Ray central(const V2d& point) const { return run(central_, point, {})[0]; }

private:
    static RayProgram compiled(const camera::Camera& camera, std::vector<Input> inputs) {
        auto made = compile(camera, pixels, pixels,
                            {.footprints = true, .points = true, .inputs = std::move(inputs)});
        EXPECT_TRUE(made) << to_text(made.diagnostics);
        return *made;
    }
    static RayBatch run(const RayProgram& program, const V2d& point, program::InputValues inputs) {
        Scratch scratch;
        RayBatch batch;
        program.run(Points{std::span(&point.x, 1), std::span(&point.y, 1), 0.0, inputs}, scratch,
                    batch);
        return batch;
    }

    RayProgram lens_, central_;
};

/// The part of the square of lens samples of a point of the picture that passes: its brightness.
inline double lit_part(const LensRaysAt& rays, const V2d& point) {
    constexpr int side = 100;
    int passed = 0;
    for (int i = 0; i < side * side; ++i) {
        const V2d at((i % side + 0.5) / side * 2.0 - 1.0, (i / side + 0.5) / side * 2.0 - 1.0);
        passed += rays(point, at).valid ? 1 : 0;
    }
    return static_cast<double>(passed) / (side * side);
}

/// Points of the picture, on both axes and beside them.
template <class Check>
void at_points(const Check& check) {
    for (const double x : {200.0, 120.0, 30.0, 310.0}) {
        for (const double y : {200.0, 90.0, 333.0}) {
            check(V2d(x, y));
        }
    }
}

/// Points of the square of lens samples, up to 0.9.
template <class Check>
void at_lens(const Check& check) {
    for (double x = -0.9; x < 1.0; x += 0.45) {
        for (double y = -0.85; y < 1.0; y += 0.34) {
            check(V2d(x, y));
        }
    }
}

}  // namespace balcony::rays::test

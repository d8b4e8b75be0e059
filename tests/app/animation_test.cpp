// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <stop_token>

#include <gtest/gtest.h>

#include "balcony/animation.hpp"
#include "support.hpp"

namespace balcony::app::animation_test {
namespace {

using AnimationTest = test::FolderTest;

// Before the first sample of a frame as well as after it.
TEST_F(AnimationTest, AStopIsNoErrorWhereverItComes) {
    AnimationRequest request;
    request.picture.scene = file("roof.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0.5\nf 1 2 3\n");
    request.picture.size = {.width = 16, .height = 8};
    request.picture.samples = 1;
    request.picture.output = file("f.#.exr");
    request.pattern = *FramePattern::read(request.picture.output.string());
    request.frames = FrameNumbers{1, 2, 3};
    request.turntable = true;
    std::stop_source stopping;
    Observer observer;
    observer.frame = [&](std::size_t frame, std::size_t, std::size_t) {
        if (frame == 2) {
            stopping.request_stop();
        }
    };
    const AnimationReport stopped = animate(request, observer, stopping.get_token());
    EXPECT_TRUE(stopped.interrupted);
    EXPECT_FALSE(has_errors(stopped.diagnostics)) << to_text(stopped.diagnostics);
    EXPECT_EQ(stopped.rendered.size(), 1U);
    const AnimationReport whole = animate(request);
    EXPECT_FALSE(has_errors(whole.diagnostics)) << to_text(whole.diagnostics);
    EXPECT_EQ(whole.skipped, 1U);
    EXPECT_EQ(whole.rendered.size(), 2U);
}

}  // namespace
}  // namespace balcony::app::animation_test

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// A view shows the newest camera, first coarsely, then better and better.

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "../files/temporary_folder.hpp"
#include "balcony/display_pixels.hpp"
#include "balcony/live.hpp"
#include "balcony/prepared_scene.hpp"

namespace balcony::live::test::view_test {
namespace {

using namespace std::chrono_literals;

const std::string fisheye = R"(camera seen(turn = 0deg, width = 120deg) {
    aspect 4/3
    map    u = width/2 .. -width/2, v = square
    eye    point(0, 0, 0)
    toward surface(u, v) = [cos(u)*cos(v), sin(u)*cos(v), sin(v)]
    move   rotate(z, turn)
}
)";

// What a view has told, for the thread of a test.
class Told {
public:
    [[nodiscard]] Observer observer() {
        return {.frame = [this](const Frame& frame) { add(frames_, frame); },
                .scene = [this](const SceneState& state) { add(scenes_, state); },
                .camera = [this](const CameraState& state) { add(cameras_, state); },
                .drag = [this](const Dragged& dragged) { add(drags_, dragged); },
                .rest =
                    [this](std::uint64_t change) {
                        const std::lock_guard lock(mutex_);
                        rest_ = change;
                        changed_.notify_all();
                    }};
    }

    // False if the view does not come to rest.
    [[nodiscard]] bool rests_at(std::uint64_t change) {
        std::unique_lock lock(mutex_);
        return changed_.wait_for(lock, 60s, [&] { return rest_ >= change; });
    }
    // False if the camera of a change does not come.
    [[nodiscard]] bool has_camera_of(std::uint64_t change) {
        std::unique_lock lock(mutex_);
        return changed_.wait_for(
            lock, 60s, [&] { return !cameras_.empty() && cameras_.back().change >= change; });
    }
    // The states of a scene until it is there, or has failed.
    [[nodiscard]] std::vector<SceneState> loading() {
        std::unique_lock lock(mutex_);
        changed_.wait_for(lock, 60s, [&] { return !scenes_.empty() && !scenes_.back().step; });
        return scenes_;
    }
    void forget() {
        const std::lock_guard lock(mutex_);
        frames_.clear();
        cameras_.clear();
        rest_ = 0;
    }
    // The frames so far, of a change.
    [[nodiscard]] std::vector<Frame> frames_of(std::uint64_t change) {
        const std::lock_guard lock(mutex_);
        std::vector<Frame> found;
        for (const Frame& frame : frames_) {
            if (frame.change == change) {
                found.push_back(frame);
            }
        }
        return found;
    }
    // The mistakes of the last camera.
    [[nodiscard]] std::string mistakes() {
        const std::lock_guard lock(mutex_);
        return cameras_.empty() ? "" : to_text(cameras_.back().diagnostics);
    }
    [[nodiscard]] std::vector<Dragged> drags() {
        const std::lock_guard lock(mutex_);
        return drags_;
    }
    [[nodiscard]] std::vector<CameraState> cameras() {
        const std::lock_guard lock(mutex_);
        return cameras_;
    }

private:
    template <class One>
    void add(std::vector<One>& all, const One& one) {
        const std::lock_guard lock(mutex_);
        all.push_back(one);
        changed_.notify_all();
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<Frame> frames_;
    std::vector<SceneState> scenes_;
    std::vector<CameraState> cameras_;
    std::vector<Dragged> drags_;
    std::uint64_t rest_ = 0;
};

class ViewTest : public testing::Test {
protected:
    void SetUp() override {
        std::ofstream(folder_ / "corner.mtl") << "newmtl red\nKd 0.8 0.1 0.1\n"
                                                 "newmtl blue\nKd 0.1 0.1 0.8\n";
        std::ofstream(folder_ / "corner.obj")
            << "mtllib corner.mtl\nusemtl red\nv 2 -2 -2\nv 2 2 -2\nv 2 2 2\nv 2 -2 2\nf 1 2 3 4\n"
               "usemtl blue\nv -2 -2 -2\nv -2 2 -2\nv -2 2 2\nv -2 -2 2\nf 5 6 7 8\n";
        request_.scene = (folder_ / "corner.obj").string();
        request_.samples = 4;
    }

    [[nodiscard]] std::unique_ptr<View> open(const Options& options = {}) {
        Result<app::PreparedScene> scene = app::PreparedScene::make(request_);
        EXPECT_TRUE(scene) << to_text(scene.diagnostics);
        return View::make(std::move(*scene), request_, told_.observer(), options, folder_.path());
    }

    const files::TemporaryFolder folder_;
    app::Request request_;
    Told told_;
};

TEST_F(ViewTest, ImprovesAFrameUntilItRests) {
    const std::unique_ptr<View> view = open({.coarse_seconds = 1e-9});
    const std::uint64_t change = view->change({.text = fisheye, .size = {{64, 48}}});
    EXPECT_EQ(change, 1U);
    ASSERT_TRUE(told_.rests_at(change));
    const std::vector<Frame> frames = told_.frames_of(change);
    ASSERT_EQ(frames.size(), 6U);
    EXPECT_EQ(frames[0].quality, Quality::coarse);
    EXPECT_LT(frames[0].width, 64U);
    EXPECT_EQ(frames[1].quality, Quality::preview);
    for (const std::size_t i : {2U, 3U, 4U}) {
        EXPECT_EQ(frames[i].quality, Quality::paths);
        EXPECT_EQ(frames[i].samples, std::size_t{1} << (i - 2));
    }
    EXPECT_EQ(frames[5].quality, Quality::denoised);
    for (const Frame& frame : frames) {
        EXPECT_EQ(frame.pixels.size(), 3 * frame.width * frame.height);
    }
    EXPECT_EQ(frames[5].width, 64U);
}

// The last frame is what the session renders of the same camera.
TEST_F(ViewTest, EndsWithThePictureOfARender) {
    request_.exposure = 0.0;
    const std::unique_ptr<View> view = open({.denoises = false});
    const std::uint64_t change = view->change({.text = fisheye, .size = {{32, 24}}});
    ASSERT_TRUE(told_.rests_at(change));
    const std::vector<std::uint8_t> live = told_.frames_of(change).back().pixels;
    std::ofstream(folder_ / "seen.cam") << fisheye;
    app::Request same = request_;
    same.camera = (folder_ / "seen.cam").string();
    same.size = {.width = 32, .height = 24};
    app::Session session;
    const app::Report report = session.render(same);
    ASSERT_FALSE(has_errors(report.diagnostics)) << to_text(report.diagnostics);
    EXPECT_EQ(live, render::display_pixels(*session.film()));
}

// A value that moves gives the frames of a text that has it.
TEST_F(ViewTest, MovesOpenParametersWithoutMakingTheCameraAnew) {
    const std::unique_ptr<View> view = open({.traces_paths = false});
    static_cast<void>(view->change({.text = fisheye, .size = {{64, 48}}}));
    const std::uint64_t moved = view->change({.values = {{{"turn", 1.5707963267948966}}}});
    ASSERT_TRUE(told_.rests_at(moved));
    ASSERT_FALSE(told_.frames_of(moved).empty()) << told_.mistakes();
    const std::vector<std::uint8_t> pixels = told_.frames_of(moved).back().pixels;
    std::string text = fisheye;
    text.replace(text.find("0deg"), 4, "90deg");
    const std::uint64_t written =
        view->change({.text = text, .values = std::vector<Value>(), .size = {{64, 48}}});
    ASSERT_TRUE(told_.rests_at(written));
    EXPECT_EQ(told_.frames_of(written).back().pixels, pixels);
    const std::uint64_t back = view->change({.text = fisheye});
    ASSERT_TRUE(told_.rests_at(back));
    EXPECT_NE(told_.frames_of(back).back().pixels, pixels);
}

// The frames of a time are those of a view that begins at this time, in all qualities.
TEST_F(ViewTest, ShowsATime) {
    request_.exposure = 0.0;
    std::string text = fisheye;
    text.replace(text.find("rotate(z, turn)"), 15, "rotate(z, turn + t*1rad)");
    const std::unique_ptr<View> view = open({.denoises = false});
    const std::uint64_t first = view->change({.text = text, .size = {{64, 48}}});
    ASSERT_TRUE(told_.rests_at(first));
    const std::uint64_t later = view->change({.time = 1.5});
    ASSERT_TRUE(told_.rests_at(later));
    ASSERT_EQ(view->shown()->time, 1.5) << told_.mistakes();
    const std::uint64_t back = view->change({.time = 0.0});
    ASSERT_TRUE(told_.rests_at(back));
    EXPECT_EQ(told_.frames_of(back).back().pixels, told_.frames_of(first).back().pixels);
    const std::vector<Frame> moved = told_.frames_of(later);
    EXPECT_NE(moved.back().pixels, told_.frames_of(first).back().pixels);
    told_.forget();
    request_.settings.time = 1.5;
    const std::unique_ptr<View> other = open({.denoises = false});
    const std::uint64_t only = other->change({.text = text, .size = {{64, 48}}});
    ASSERT_TRUE(told_.rests_at(only));
    EXPECT_EQ(other->shown()->time, 1.5);
    const auto pixels_of = [](const std::vector<Frame>& frames, Quality quality) {
        for (const Frame& frame : frames) {
            if (frame.quality == quality) {
                return frame.pixels;
            }
        }
        return std::vector<std::uint8_t>();
    };
    EXPECT_EQ(pixels_of(moved, Quality::preview),
              pixels_of(told_.frames_of(only), Quality::preview));
    EXPECT_EQ(moved.back().pixels, told_.frames_of(only).back().pixels);
    // A hand pulls at the picture of this time. The camera looks 1.5 rad to the left; what was in
    // the middle is pulled to the right, by turning on. The scene has y upwards.
    const Imath::V3d middle(std::cos(1.5), 0.0, -std::sin(1.5));
    for (const double time : {1.5, 1.0}) {
        const std::uint64_t pulled = other->change(
            {.time = time,
             .drag = Drag{.pulls = {{.point = middle, .from = {32, 24}, .to = {40, 24}}},
                          .parameters = {"turn"}}});
        ASSERT_TRUE(told_.rests_at(pulled));
        const Dragged dragged = told_.drags().back();
        ASSERT_EQ(dragged.values.size(), 1U) << to_text(dragged.diagnostics);
        const double pixel = 2.0943951023931953 / 64.0;  // Of 120 degrees.
        EXPECT_NEAR(dragged.values[0].value, 1.5 - time + 8.0 * pixel, 1e-6);
        EXPECT_TRUE(dragged.points[0].follows);
    }
}

// What follows a hand is shown until the drag ends.
// A number that goes from key to key has a value at each time, and a hand may give it another one.
TEST_F(ViewTest, AKeyedNumberMovesUnderTheHand) {
    request_.exposure = 0.0;
    std::string keyed = fisheye;
    keyed.replace(keyed.find("0deg"), 4, "keys((0, 0deg), (2, 1rad))");
    const std::unique_ptr<View> view = open({.traces_paths = false});
    const auto pixels = [&](std::uint64_t change) {
        EXPECT_TRUE(told_.rests_at(change)) << told_.mistakes();
        const std::vector<Frame> frames = told_.frames_of(change);
        return frames.empty() ? std::vector<std::uint8_t>() : frames.back().pixels;
    };
    const auto turn = [&] {
        const CameraState state = told_.cameras().back();
        for (const auto* const some : {&state.open, &state.moving}) {
            for (const lang::OpenParameter& one : *some) {
                if (one.name == "turn") {
                    EXPECT_TRUE(one.is_angle);
                    return one.value;
                }
            }
        }
        ADD_FAILURE() << "there is no turn";
        return 0.0;
    };
    const auto at_start = pixels(view->change({.text = keyed, .size = {{32, 24}}}));
    EXPECT_EQ(turn(), 0.0);
    const auto later = pixels(view->change({.time = 1.5}));
    EXPECT_NEAR(turn(), 0.75, 1e-12);
    EXPECT_NE(at_start, later);
    // One hand moves it, also several times, and beside another number, and lets it go.
    const auto moved = pixels(view->change({.values = {{{"turn", -0.5}}}}));
    EXPECT_NEAR(turn(), -0.5, 1e-12);
    EXPECT_NE(moved, later);
    EXPECT_EQ(pixels(view->change({.values = {{{"turn", 0.75}}}})), later);
    EXPECT_EQ(pixels(view->change({.values = {{{"turn", -0.5}}}})), moved);
    EXPECT_NE(pixels(view->change({.values = {{{"turn", -0.5}, {"width", 1.0}}}})), moved);
    EXPECT_EQ(pixels(view->change({.values = {{{"turn", -0.5}}}})), moved);
    EXPECT_EQ(pixels(view->change({.values = std::vector<Value>()})), later);
    EXPECT_NEAR(turn(), 0.75, 1e-12);
    EXPECT_EQ(pixels(view->change({.time = 0.0})), at_start);
    // It follows a hand on the picture, and is what it was without one.
    const std::uint64_t pulled =
        view->change({.time = 1.5,
                      .drag = Drag{.pulls = {{.point = {std::cos(0.75), 0.0, -std::sin(0.75)},
                                              .from = {16, 12},
                                              .to = {20, 12}}},
                                   .parameters = {"turn"}}});
    EXPECT_NE(pixels(pulled), later);
    ASSERT_EQ(told_.drags().back().values.size(), 1U) << told_.mistakes();
    const double pixel = 2.0943951023931953 / 32.0;  // Of 120 degrees.
    EXPECT_NEAR(told_.drags().back().values[0].value, 0.75 + 4.0 * pixel, 1e-6);
    EXPECT_EQ(pixels(view->change({.drag = Drag()})), later);
}

TEST_F(ViewTest, ShowsWhatFollowsADrag) {
    const std::unique_ptr<View> view = open({.traces_paths = false});
    const std::uint64_t before = view->change({.text = fisheye, .size = {{64, 48}}});
    ASSERT_TRUE(told_.rests_at(before));
    const std::vector<std::uint8_t> unmoved = told_.frames_of(before).back().pixels;
    // 64 pixels are 120 degrees; the scene has y upwards, where the camera has z.
    const Drag drag{{{{1, 0, 0}, true, {32, 24}, {48, 24}}}, {"turn"}};
    const std::uint64_t pulled = view->change({.drag = drag});
    ASSERT_TRUE(told_.rests_at(pulled));
    ASSERT_EQ(told_.drags().size(), 1U);
    const Dragged dragged = told_.drags().front();
    EXPECT_EQ(dragged.change, pulled);
    EXPECT_TRUE(dragged.points.front().follows);
    ASSERT_EQ(dragged.values.size(), 1U);
    EXPECT_NEAR(dragged.values.front().value, 30.0 * 3.14159265358979 / 180.0, 1e-9);
    const std::uint64_t ended = view->change({.drag = Drag()});
    ASSERT_TRUE(told_.rests_at(ended));
    EXPECT_EQ(told_.frames_of(ended).back().pixels, unmoved);
    const std::uint64_t set = view->change({.values = dragged.values});
    ASSERT_TRUE(told_.rests_at(set));
    EXPECT_EQ(told_.frames_of(set).back().pixels, told_.frames_of(pulled).back().pixels);
    EXPECT_NE(told_.frames_of(set).back().pixels, unmoved);
    EXPECT_EQ(told_.drags().size(), 1U);
}

TEST_F(ViewTest, TellsMistakesAndKeepsTheLastGoodCamera) {
    const std::unique_ptr<View> view = open({.traces_paths = false});
    ASSERT_TRUE(told_.rests_at(view->change({.text = fisheye, .size = {{64, 48}}})));
    const std::uint64_t wrong = view->change({.text = "camera seen { eye pont(0, 0, 0) }"});
    ASSERT_TRUE(told_.rests_at(wrong));
    EXPECT_TRUE(told_.frames_of(wrong).empty());
    const CameraState state = told_.cameras().back();
    EXPECT_EQ(state.change, wrong);
    EXPECT_TRUE(has_errors(state.diagnostics));
    EXPECT_TRUE(state.name.empty());
    const std::uint64_t right = view->change({.text = fisheye});
    ASSERT_TRUE(told_.rests_at(right));
    EXPECT_FALSE(told_.frames_of(right).empty());
    EXPECT_EQ(told_.cameras().back().name, "seen");
    EXPECT_EQ(told_.cameras().back().open.size(), 2U);
}

// Of many changes in a row, the last one is shown in full, and no other one after it.
TEST_F(ViewTest, ShowsTheNewestChange) {
    const std::unique_ptr<View> view = open();
    std::uint64_t last = view->change({.text = fisheye, .size = {{160, 120}}});
    for (int i = 1; i <= 200; ++i) {
        last = view->change({.values = {{{"turn", 0.01 * i}}}});
    }
    ASSERT_TRUE(told_.rests_at(last));
    EXPECT_EQ(last, 201U);
    const std::vector<Frame> frames = told_.frames_of(last);
    ASSERT_FALSE(frames.empty());
    EXPECT_EQ(frames.back().quality, Quality::denoised);
    std::uint64_t before = 0;
    for (const CameraState& state : told_.cameras()) {
        EXPECT_GT(state.change, before);
        before = state.change;
    }
}

// Each change comes while the first frame of the one before is made.
TEST_F(ViewTest, ShowsACameraInMotion) {
    for (const double coarse_seconds : {1e-9, 1e9}) {
        const std::unique_ptr<View> view =
            open({.coarse_seconds = coarse_seconds, .traces_paths = false});
        std::uint64_t last = view->change({.text = fisheye, .size = {{640, 480}}});
        for (int i = 1; i <= 8; ++i) {
            ASSERT_TRUE(told_.has_camera_of(last));
            last = view->change({.values = {{{"turn", 0.01 * i}}}});
        }
        ASSERT_TRUE(told_.rests_at(last));
        for (std::uint64_t change = 1; change <= last; ++change) {
            EXPECT_FALSE(told_.frames_of(change).empty()) << change;
        }
        told_.forget();
    }
}

TEST_F(ViewTest, TakesOtherSizes) {
    const std::unique_ptr<View> view = open({.traces_paths = false});
    static_cast<void>(view->change({.text = fisheye}));
    for (std::size_t width = 64; width < 96; ++width) {
        const std::uint64_t change = view->change({.size = {{width, 48}}});
        ASSERT_TRUE(told_.rests_at(change));
        EXPECT_EQ(told_.frames_of(change).back().width, width);
    }
}

// Changes that come before the scene is there are shown as one.
TEST_F(ViewTest, LoadsItsScene) {
    const std::unique_ptr<View> view = View::load(request_, told_.observer(), {}, folder_.path());
    static_cast<void>(view->change({.text = fisheye}));
    const std::uint64_t last = view->change({.size = {{64, 48}}});
    const std::vector<SceneState> states = told_.loading();
    ASSERT_GE(states.size(), 2U);
    EXPECT_EQ(states.front().step, app::Step::reading);
    EXPECT_FALSE(states.back().step);
    EXPECT_FALSE(has_errors(states.back().diagnostics));
    ASSERT_TRUE(told_.rests_at(last));
    EXPECT_EQ(told_.frames_of(last).back().width, 64U);
    EXPECT_EQ(told_.cameras().back().aspect, 4.0 / 3.0);
}

TEST_F(ViewTest, TellsWhyAnotherSceneIsNotLoaded) {
    request_.scene = (folder_ / "missing.obj").string();
    const std::unique_ptr<View> view = View::load(request_, told_.observer(), {}, folder_.path());
    static_cast<void>(view->change({.text = fisheye}));
    const std::vector<SceneState> states = told_.loading();
    ASSERT_FALSE(states.empty());
    EXPECT_NE(to_text(states.back().diagnostics).find("missing.obj"), std::string::npos);
    EXPECT_TRUE(told_.cameras().empty());
}

TEST_F(ViewTest, LoadsASceneAgainWhenItsFileChanges) {
    const std::filesystem::path file = folder_ / "late.obj";
    std::filesystem::remove(file);
    request_.scene = file.string();
    const std::unique_ptr<View> view = View::load(request_, told_.observer(), {}, folder_.path());
    const std::uint64_t change = view->change({.text = fisheye, .size = {{64, 48}}});
    EXPECT_TRUE(has_errors(told_.loading().back().diagnostics));
    EXPECT_FALSE(view->scene());
    std::filesystem::copy_file(folder_ / "corner.obj", folder_ / "made.obj",
                               std::filesystem::copy_options::overwrite_existing);
    std::filesystem::rename(folder_ / "made.obj", file);
    ASSERT_TRUE(told_.rests_at(change));
    EXPECT_FALSE(told_.frames_of(change).empty());
    EXPECT_TRUE(view->scene());
}

TEST_F(ViewTest, EndsInTheMiddleOfAPicture) {
    request_.samples = 100'000;
    std::unique_ptr<View> view = open();
    static_cast<void>(view->change({.text = fisheye, .size = {{320, 240}}}));
    const auto begin = std::chrono::steady_clock::now();
    view.reset();
    EXPECT_LT(std::chrono::steady_clock::now() - begin, 20s);
}

}  // namespace
}  // namespace balcony::live::test::view_test

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Small pictures of many cameras, of which the newest list counts.

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <fstream>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../files/temporary_folder.hpp"
#include "balcony/thumbnails.hpp"

namespace balcony::live::test::thumbnails_test {
namespace {

using namespace std::chrono_literals;

class ThumbnailsTest : public testing::Test {
protected:
    void SetUp() override {
        std::ofstream file(folder_ / "box.obj");
        for (int i = 0; i < 8; ++i) {
            file << "v " << (i & 1) * 4 << " " << (i >> 1 & 1) * 4 << " " << (i >> 2 & 1) * 4
                 << "\n";
        }
        file << "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
        file.close();
        app::Request request;
        request.scene = (folder_ / "box.obj").string();
        const Result<app::PreparedScene> scene = app::PreparedScene::make(request);
        ASSERT_TRUE(scene) << to_text(scene.diagnostics);
        thumbnails_ = std::make_unique<Thumbnails>(*scene, request, [this](const Thumbnail& one) {
            const std::lock_guard lock(mutex_);
            made_.push_back(one);
            changed_.notify_all();
        });
    }
    void TearDown() override { thumbnails_.reset(); }

    // Those so far, when there are as many.
    std::vector<Thumbnail> made(std::size_t count) {
        std::unique_lock lock(mutex_);
        EXPECT_TRUE(changed_.wait_for(lock, 60s, [&] { return made_.size() >= count; }));
        return made_;
    }
    const Thumbnail& of(const std::vector<Thumbnail>& all, const std::string& camera) {
        return *std::find_if(all.begin(), all.end(),
                             [&](const Thumbnail& one) { return one.camera == camera; });
    }

    const files::TemporaryFolder folder_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<Thumbnail> made_;
    std::unique_ptr<Thumbnails> thumbnails_;
};

}  // namespace

TEST_F(ThumbnailsTest, AreAsLargeAsThereIsRoom) {
    thumbnails_->show({"pinhole", "fisheye", "panorama"}, {80, 60});
    const std::vector<Thumbnail> all = made(3);
    for (const Thumbnail& one : all) {
        EXPECT_TRUE(one.diagnostics.empty()) << to_text(one.diagnostics);
        ASSERT_EQ(one.pixels.size(), 3 * one.width * one.height);
        EXPECT_GT(*std::max_element(one.pixels.begin(), one.pixels.end()), 0);
    }
    const auto expect_size = [&](const std::string& camera, std::size_t width, std::size_t height) {
        EXPECT_EQ(of(all, camera).width, width) << camera;
        EXPECT_EQ(of(all, camera).height, height) << camera;
    };
    expect_size("pinhole", 80, 45);
    expect_size("fisheye", 60, 60);
    expect_size("panorama", 80, 40);
}

// The same, whichever thread makes it, and however often.
TEST_F(ThumbnailsTest, AreTheSameEachTime) {
    thumbnails_->show({"pinhole", "fisheye", "panini"}, {40, 40});
    static_cast<void>(made(3));
    thumbnails_->show({"panini", "fisheye", "pinhole"}, {40, 40});
    const std::vector<Thumbnail> all = made(6);
    ASSERT_EQ(all.size(), 6U);
    for (std::size_t i = 3; i < 6; ++i) {
        EXPECT_EQ(all[i].pixels, of(all, all[i].camera).pixels) << all[i].camera;
    }
}

TEST_F(ThumbnailsTest, TheNewestListCounts) {
    thumbnails_->show(std::vector<std::string>(100, "cubist"), {400, 400});
    thumbnails_->show({"pinhole"}, {40, 40});
    std::vector<Thumbnail> all = made(1);
    while (all.back().camera != "pinhole") {
        all = made(all.size() + 1);
    }
    // Of the first list, what was done before the second one came, and nothing after it.
    EXPECT_LT(all.size(), 20U);
    thumbnails_->show({}, {40, 40});
    std::this_thread::sleep_for(200ms);
    const std::lock_guard lock(mutex_);
    EXPECT_EQ(made_.size(), all.size());
}

TEST_F(ThumbnailsTest, SayWhyThereIsNone) {
    thumbnails_->show({"nothing.cam", "pinhole"}, {40, 40});
    const std::vector<Thumbnail> all = made(2);
    const Thumbnail& none = of(all, "nothing.cam");
    EXPECT_EQ(none.width, 0U);
    EXPECT_NE(to_text(none.diagnostics).find("nothing.cam"), std::string::npos);
    EXPECT_GT(of(all, "pinhole").width, 0U);
}

}  // namespace balcony::live::test::thumbnails_test

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What a front end learns of a camera without a picture.

#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "balcony/app.hpp"
#include "balcony/inputs.hpp"
#include "balcony/prepared_scene.hpp"
#include "balcony/studies.hpp"
#include "support.hpp"

namespace balcony::app::studies_test {
namespace {

namespace fs = std::filesystem;

class StudiesTest : public test::FolderTest {
protected:
    // A wall two units before the origin, along -z as in OBJ files with y up.
    std::string wall() const {
        return file("wall.obj", "o wall\nv -9 -9 -2\nv 9 -9 -2\nv 9 9 -2\nv -9 9 -2\nf 1 2 3 4\n");
    }
};

// u turns back at the middle of the picture, so the left half shows the right one again.
constexpr const char* folded = R"(
    camera folded {
        map   u = -1 .. 1, v = -1 .. 1
        warp  formula(u, v) = [abs(u), v]
        eye   point(0, 0, 0)
        toward plane((1, 0, 0))
    }
    camera plain {
        map   u = 1 .. -1, v = -1 .. 1
        eye   point(0, 0, 0)
        toward plane((1, 0, 0))
    })";

TEST_F(StudiesTest, EachCameraOfAFileHasItsDefects) {
    const std::string cameras = file("two.cam", folded);
    std::vector<std::string> told;
    CheckObserver observer;
    observer.file = [&](const FileCheck& found) { told.push_back(found.file); };
    observer.camera = [&](const CameraCheck& found) { told.push_back(found.title()); };
    const CheckReport report = check({.files = {cameras}, .size = {.width = 64}}, observer);
    ASSERT_FALSE(has_errors(report.diagnostics)) << to_text(report.diagnostics);
    ASSERT_EQ(report.files.size(), 1U);
    EXPECT_TRUE(report.files[0].good);
    EXPECT_EQ(report.files[0].cameras, 2U);
    ASSERT_EQ(report.files[0].checks.size(), 2U);
    EXPECT_GT(report.files[0].checks[0].defect_count(), 0U);
    EXPECT_EQ(report.files[0].checks[1].defect_count(), 0U);
    EXPECT_EQ(told, (std::vector<std::string>{cameras, "folded", "plain"}));
}

// A picture in a scene that is loaded has the findings that its file has.
TEST_F(StudiesTest, APictureIsCheckedAsItsFile) {
    const std::string cameras = file("two.cam", folded);
    const std::string scene =
        file("box.obj",
             "o far\nv -9 -9 -20\nv 9 -9 -20\nv 9 9 -20\nf 1 2 3\n"
             "o box\nv -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\n"
             "v -1 1 1\nf 4 7 6 5\nf 8 9 10 11\nf 4 5 9 8\nf 5 6 10 9\nf 6 7 11 10\nf 7 4 8 11\n");
    const CheckReport whole = check(
        {.files = {cameras + ":folded"}, .size = {.width = 64, .height = 48}, .scene = scene});
    ASSERT_FALSE(has_errors(whole.diagnostics)) << to_text(whole.diagnostics);
    const CameraCheck& wanted = whole.files.at(0).checks.at(0);
    Request request;
    request.scene = scene;
    Result<PreparedScene> prepared = PreparedScene::make(request);
    ASSERT_TRUE(prepared) << to_text(prepared.diagnostics);
    const Result<camera::Picture> picture = load_picture(cameras + ":folded", {});
    ASSERT_TRUE(picture);
    const auto checks = check(*picture, *prepared, {64, 48});
    ASSERT_TRUE(checks) << to_text(checks.diagnostics);
    ASSERT_EQ(checks->size(), 1U);
    const CameraCheck& made = checks->front();
    EXPECT_EQ(made.title(), "folded");
    EXPECT_EQ(made.defect_count(), wanted.defect_count());
    ASSERT_EQ(made.report.findings.size(), wanted.report.findings.size());
    for (std::size_t i = 0; i < made.report.findings.size(); ++i) {
        EXPECT_EQ(made.report.findings[i].message, wanted.report.findings[i].message);
        EXPECT_EQ(made.report.findings[i].samples, wanted.report.findings[i].samples);
    }
    const auto in_scene = made.in_scene->findings();
    const auto in_wanted = wanted.in_scene->findings();
    ASSERT_EQ(in_scene.size(), in_wanted.size());
    ASSERT_EQ(in_scene.size(), 2U);
    EXPECT_EQ(in_scene[0].message, "1 object: far");
    EXPECT_EQ(in_scene[1].message, "100 % of the rays start inside 'box'");
    EXPECT_FALSE(in_scene[1].defect);
    EXPECT_EQ(in_scene[1].message, in_wanted[1].message);
    std::stop_source source;
    source.request_stop();
    EXPECT_EQ(kind_of_errors(check(*picture, *prepared, {64, 48}, source.get_token()).diagnostics),
              Kind::interrupted);
}

TEST_F(StudiesTest, APictureIsCheckedWithoutAScene) {
    const std::string cameras = file("two.cam", folded);
    const CheckReport wanted =
        check({.files = {cameras + ":folded"}, .size = {.width = 64, .height = 48}});
    const auto made = check(*load_picture(cameras + ":folded", {}), {64, 48});
    ASSERT_TRUE(made) << to_text(made.diagnostics);
    ASSERT_EQ(made->size(), 1U);
    EXPECT_FALSE(made->front().in_scene);
    EXPECT_GT(made->front().defect_count(), 0U);
    EXPECT_EQ(made->front().defect_count(), wanted.files.at(0).checks.at(0).defect_count());
}

TEST_F(StudiesTest, WhatCannotBeAskedIsUsageAndNothingIsRead) {
    const std::string map = file("map.png");
    const CheckReport report =
        check({.files = {"none.cam"},
               .maps = {{analyse::MapKind::magnification, map}, {analyse::MapKind::seams, map}}});
    EXPECT_EQ(kind_of_errors(report.diagnostics), Kind::usage);
    EXPECT_EQ(report.diagnostics.size(), 1U) << to_text(report.diagnostics);
    EXPECT_TRUE(report.files.empty());
}

TEST_F(StudiesTest, APointBehindAWallIsHiddenByIt) {
    const auto located = locate({.camera = "pinhole",
                                 .set = {"yaw=90deg"},
                                 .placement = {.fit = false},
                                 .size = {.width = 200, .height = 100},
                                 .scene = wall(),
                                 .points = {{0.0, 0.0, -1.0}, {0.0, 0.0, -3.0}, {0.0, 0.0, 1.0}}});
    ASSERT_TRUE(located) << to_text(located.diagnostics);
    EXPECT_EQ(located->axes_from, AxesSource::scene);
    ASSERT_EQ(located->sightings.size(), 2U);
    ASSERT_TRUE(located->obstacles);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(located->sightings[i].point, i);
        EXPECT_NEAR(located->sightings[i].position.x, 100.0, 1e-9);
        EXPECT_NEAR(located->sightings[i].position.y, 50.0, 1e-9);
    }
    EXPECT_FALSE((*located->obstacles)[0]);
    ASSERT_TRUE((*located->obstacles)[1]);
    EXPECT_EQ(located->objects[(*located->obstacles)[1]->object].name, "wall");
    EXPECT_NEAR((*located->obstacles)[1]->distance, 2.0, 1e-6);
}

TEST_F(StudiesTest, BatchesOfPointsAreAnsweredAsAllAtOnce) {
    const LocateRequest request{.camera = "pinhole",
                                .set = {"yaw=90deg"},
                                .placement = {.fit = false},
                                .size = {.width = 200, .height = 100},
                                .scene = wall(),
                                .points = {{0.0, 0.0, -1.0}, {0.0, 0.0, -3.0}, {0.0, 0.0, 1.0}}};
    const auto whole = locate(request);
    auto session = LocateSession::make(request);
    ASSERT_TRUE(session) << to_text(session.diagnostics);
    EXPECT_NE(std::find(session->files().begin(), session->files().end(), fs::path(wall())),
              session->files().end());
    std::size_t next = 0;
    for (const analyse::V3d& point : request.points) {
        const auto one = session->locate({point});
        ASSERT_TRUE(one) << to_text(one.diagnostics);
        for (std::size_t i = 0; i < one->sightings.size(); ++i, ++next) {
            EXPECT_EQ(one->sightings[i].position, whole->sightings[next].position);
            EXPECT_EQ((*one->obstacles)[i].has_value(), (*whole->obstacles)[next].has_value());
        }
    }
    EXPECT_EQ(next, whole->sightings.size());
    EXPECT_TRUE(session->finish().empty());
    // Only what none of the batches shows is explained.
    auto behind = LocateSession::make({.camera = "pinhole"});
    ASSERT_TRUE(behind && behind->locate({{-7.0, 0.1, 0.1}}));
    EXPECT_EQ(behind->finish().size(), 1U);
    ASSERT_TRUE(behind->locate({{5.0, 0.0, 0.0}}));
    EXPECT_TRUE(behind->finish().empty());
}

TEST_F(StudiesTest, ADrawingIsWrittenOrRefusedWithItsKind) {
    const auto drawn = [&](const std::string& output) {
        return draw({.camera = "pinhole", .output = output});
    };
    EXPECT_TRUE(drawn(file("pinhole.svg")).empty());
    EXPECT_GT(fs::file_size(file("pinhole.svg")), 1000U);
    EXPECT_TRUE(drawn(file("pinhole.glb")).empty());
    EXPECT_EQ(kind_of_errors(drawn(file("pinhole.txt"))), Kind::usage);
    EXPECT_FALSE(fs::exists(file("pinhole.txt")));
    EXPECT_EQ(kind_of_errors(draw({.camera = "no-such-camera", .output = file("x.svg")})),
              Kind::input);
}

// A session keeps the scene that it has read, but not the lamps of the last request.
TEST_F(StudiesTest, LampsAreThoseOfTheRequest) {
    Request request;
    request.scene = wall();
    request.camera = "pinhole";
    request.set = {"yaw=90deg"};
    request.placement.fit = false;
    request.size = {.width = 8, .height = 4};
    request.samples = 1;
    request.exposure = 0.0;
    Session session;
    const auto brightness = [&](float intensity) {
        scene::Light lamp;
        lamp.intensity = scene::Color3f(intensity);
        request.light.lamps = {lamp};
        EXPECT_FALSE(has_errors(session.render(request).diagnostics));
        return session.film()->pixel(4, 2).r;
    };
    const float dark = brightness(1.0F);
    EXPECT_GT(dark, 0.0F);
    EXPECT_EQ(brightness(4.0F), 4.0F * dark);
}

TEST_F(StudiesTest, NoCameraFileIsReplacedByItsDrawing) {
    const std::string camera =
        file("camera.svg", "camera a { map u = -1 .. 1, v = square eye sphere(1) look normal }\n");
    EXPECT_EQ(kind_of_errors(draw({.camera = camera + ":a", .output = camera})), Kind::usage);
    EXPECT_LT(fs::file_size(camera), 100U);
}

}  // namespace
}  // namespace balcony::app::studies_test

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Calibrated cameras of files: a line is a whole camera, in the picture and in the world where the
// file has it.

#include <gtest/gtest.h>

#include <cmath>

#include "../files/temporary_folder.hpp"
#include "support.hpp"

namespace balcony::lang::calibrated_test {
namespace {

using camera::Camera;

Camera made(const std::string& text) {
    const Result<Camera> camera = test::make(text);
    EXPECT_TRUE(camera) << to_text(camera.diagnostics);
    EXPECT_EQ(to_text(camera.diagnostics), "");
    return *camera;
}

void expect_equal(const std::array<double, 3>& found, const std::array<double, 3>& wanted) {
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(found[i], wanted[i], 1e-14) << i;
    }
}

const std::string entries = "K: [500, 0, 319.5, 0, 500, 239.5, 0, 0, 1]\nD: [-0.1, 0.01, 0, 0]\n";
const std::string size = "image_width: 640\nimage_height: 480\n";

/// The camera of a file in a folder, or what is wrong with it.
Result<Camera> from_file(const std::string& calibration, const std::string& call) {
    const files::TemporaryFolder folder;
    folder.write("calibration.yml", calibration);
    return make_camera(folder.write("my.cam", "camera my { eye " + call + " }"), "");
}

/// The first error, in front of which is its line in the calibration.
std::string problem(const std::string& calibration, const std::string& call) {
    const Result<Camera> camera = from_file(calibration, call);
    if (camera) {
        return "none";
    }
    const Diagnostic& first = camera.diagnostics.front();
    EXPECT_FALSE(first.remedy.empty()) << first.message;
    const std::string name = std::filesystem::path(first.span.source->name()).filename();
    return name + ": " + first.message.substr(first.message.find("calibration.yml"));
}

}  // namespace

TEST(CalibratedCamera, OfAFileIsWhole) {
    const Camera camera = made("camera webcam { eye opencv(\"webcam.yml\") }");
    EXPECT_EQ(camera.parts().aspect, 1280.0 / 720.0);
    ASSERT_TRUE(camera.fixed_aspect());
    // The centre of the lens, half a pixel from where OpenCV counts.
    const test::Ray axis =
        test::ray(camera, 644.21573208518317 + 0.5, 352.97844011263578 + 0.5, 1280.0, 720.0);
    EXPECT_TRUE(axis.valid);
    expect_equal(axis.direction, {1.0, 0.0, 0.0});
    expect_equal(axis.origin, {0.0, 0.0, 0.0});
}

TEST(CalibratedCamera, IsTheSameInAPictureOfAnySize) {
    const Camera camera = made("camera webcam { eye opencv(\"webcam.yml\") }");
    for (const double x : {0.0, 100.0, 1000.0}) {
        const test::Ray full = test::ray(camera, x, 600.0, 1280.0, 720.0);
        const test::Ray half = test::ray(camera, 0.5 * x, 300.0, 640.0, 360.0);
        EXPECT_TRUE(full.valid);
        expect_equal(half.direction, full.direction);
    }
}

TEST(CalibratedCamera, ShowsAPartByItsPixels) {
    const Camera whole = made("camera webcam { eye opencv(\"webcam.yml\") }");
    const Camera part = made(
        "camera part { aspect 4/3 map u = 320 .. 960, v = 600 .. 120 eye opencv(\"webcam.yml\") }");
    for (const double x : {0.0, 320.0, 640.0}) {
        expect_equal(test::ray(part, x, 100.0, 640.0, 480.0).direction,
                     test::ray(whole, 320.0 + x, 220.0, 1280.0, 720.0).direction);
    }
}

TEST(CalibratedCamera, HasAnAspectAndAMapInABlockToo) {
    const Camera camera = made(
        "camera survey { eye { object colmap(\"cameras.txt\", camera = 3) move translate(0, 0, 2) "
        "} }");
    EXPECT_EQ(camera.parts().aspect, 1600.0 / 900.0);
    const test::Ray middle = test::ray(camera, 800.0, 450.0, 1600.0, 900.0);
    expect_equal(middle.direction, {1.0, 0.0, 0.0});
    expect_equal(middle.origin, {0.0, 0.0, 2.0});
}

// x_camera = R x_world + T with R = ((0, -1, 0), (0, 0, -1), (1, 0, 0)): the camera looks along x
// with z up, and its position is -R^T T.
TEST(CalibratedCamera, IsWhereItsFileHasIt) {
    const std::string pose = "R: [0, -1, 0, 0, 0, -1, 1, 0, 0]\nT: [2, 3, -4]\n";
    const auto posed = from_file(entries + size + pose, "opencv(\"calibration.yml\", pose = file)");
    ASSERT_TRUE(posed) << to_text(posed.diagnostics);
    const auto standard = from_file(entries + size + pose, "opencv(\"calibration.yml\")");
    const test::Ray there = test::ray(*posed, 100.0, 50.0, 640.0, 480.0);
    const test::Ray here = test::ray(*standard, 100.0, 50.0, 640.0, 480.0);
    expect_equal(there.origin, {4.0, 2.0, 3.0});
    expect_equal(there.direction, here.direction);
    expect_equal(here.origin, {0.0, 0.0, 0.0});

    // Looking along y of the world, with z up.
    const auto turned =
        from_file(entries + size + "R: [1, 0, 0, 0, 0, -1, 0, 1, 0]\nT: [0, 0, 0]\n",
                  "opencv(\"calibration.yml\", pose = file)");
    expect_equal(test::ray(*turned, 320.0, 240.0, 640.0, 480.0).direction, {0.0, 1.0, 0.0});
    EXPECT_GT(test::ray(*turned, 420.0, 240.0, 640.0, 480.0).direction[0], 0.1);
    EXPECT_GT(test::ray(*turned, 320.0, 140.0, 640.0, 480.0).direction[2], 0.1);
}

TEST(CalibratedCamera, TakesWhatTheFileDoesNotSay) {
    const auto fisheye = from_file(
        entries, "opencv(\"calibration.yml\", model = fisheye, width = 640, height = 480)");
    ASSERT_TRUE(fisheye) << to_text(fisheye.diagnostics);
    // At θ = 0.5, r = θ - 0.1 θ³ + 0.01 θ⁵.
    const double r = 0.5 - 0.1 * std::pow(0.5, 3) + 0.01 * std::pow(0.5, 5);
    expect_equal(test::ray(*fisheye, 320.0 + 500.0 * r, 240.0, 640.0, 480.0).direction,
                 {std::cos(0.5), -std::sin(0.5), 0.0});
    EXPECT_EQ(fisheye->parts().aspect, 640.0 / 480.0);
}

// What mrcal 2.2 computes of the same file: unproject() of pixels, and the place of the camera.
TEST(CalibratedCamera, OfMrcalsSplinesIsThatOfMrcal) {
    const Camera standard = made("camera drone { eye mrcal(\"drone.cameramodel\") }");
    const auto expect_optical = [](const Camera& camera, double x, double y,
                                   const std::array<double, 3>& d) {
        const test::Ray ray = test::ray(camera, x + 0.5, y + 0.5, 1600.0, 1200.0);
        EXPECT_TRUE(ray.valid);
        // mrcal stops its search where the pixel is met to some 1e-8.
        EXPECT_NEAR(ray.direction[0], d[2], 1e-9);
        EXPECT_NEAR(ray.direction[1], -d[0], 1e-9);
        EXPECT_NEAR(ray.direction[2], -d[1], 1e-9);
    };
    expect_optical(standard, 0, 0, {-0.7680742518741377, -0.5675881519179524, 0.2964888419660123});
    expect_optical(standard, 1599, 1199,
                   {0.7575608025498992, 0.5792109112554505, 0.3010254984591559});
    expect_optical(standard, 400, 900,
                   {-0.4708478474660859, 0.35147292459874097, 0.8091780322095758});
    const Camera posed = made("camera drone { eye mrcal(\"drone.cameramodel\", pose = file) }");
    expect_equal(test::ray(posed, 800.0, 600.0, 1600.0, 1200.0).origin,
                 {-0.9576856124142508, -1.8809600530124722, 0.8915310127786127});
}

TEST(CalibratedCamera, SaysWhatIsMissing) {
    EXPECT_EQ(problem(entries, "opencv(\"calibration.yml\")"),
              "my.cam: calibration.yml' has no entry image_width");
    EXPECT_EQ(problem(entries + size + "fisheye_model: 1\n",
                      "opencv(\"calibration.yml\", model = pinhole)"),
              "my.cam: calibration.yml' says that its model is opencv_fisheye");
    EXPECT_EQ(problem(entries + size, "opencv(\"calibration.yml\", pose = file)"),
              "my.cam: calibration.yml' has no position and orientation of the camera");
    EXPECT_EQ(problem("K: [1, 1, 1, 1]\nD: [0, 0, 0, 0, 0]\n",
                      "opencv(\"calibration.yml\", model = fisheye, width = 2, height = 2)"),
              "my.cam: calibration.yml' has 5 distortion coefficients, but this model has 4");
    EXPECT_EQ(
        problem("1 PINHOLE 2 2 1 1 1 1\n4 PINHOLE 2 2 1 1 1 1\n", "colmap(\"calibration.yml\")"),
        "my.cam: calibration.yml' has 2 cameras");
    EXPECT_EQ(problem("1 PINHOLE 2 2 1 1 1 1\n4 PINHOLE 2 2 1 1 1 1\n",
                      "colmap(\"calibration.yml\", camera = 2)"),
              "my.cam: calibration.yml' has no camera 2");
}

}  // namespace balcony::lang::calibrated_test

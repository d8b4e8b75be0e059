// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Calibrations in OpenCV's YAML, COLMAP's cameras.txt and mrcal's .cameramodel: what is read, and
// what is said of what cannot be.

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "balcony/data.hpp"

namespace balcony::data::calibration_test {
namespace {

using camera::Calibration;
using camera::CalibrationFile;

Result<std::shared_ptr<const CalibrationFile>> read(const std::string& text,
                                                    const std::string& name = "file.yml") {
    const std::span bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
    return read_calibration(File::in_memory(name, name, bytes));
}

/// Model and numbers of the first camera.
std::string shown(const std::string& text) {
    const auto file = read(text);
    if (!file) {
        return to_text(file.diagnostics);
    }
    const Calibration& first = (*file)->cameras.front();
    std::string all = first.model + ":";
    for (const Calibration::Number& one : first.numbers) {
        all += fmt::format(" {} {:g}", one.name, one.value);
    }
    if (!first.distortion.empty()) {
        all += fmt::format(" d {:g}", fmt::join(first.distortion, " "));
    }
    return all;
}

std::string opencv_file(const std::string& matrix, const std::string& distortion,
                        const std::string& more = "image_width: 640\nimage_height: 480\n") {
    return fmt::format(
        "%YAML:1.0\n---\n{}camera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n"
        "   dt: d\n   data: [ {} ]\ndistortion_coefficients: [ {} ]\n",
        more, matrix, distortion);
}

const std::string good_matrix = "500., 0., 321., 0., 501., 239., 0., 0., 1.";

/// Line and message of the first error.
std::string problem(const std::string& text) {
    const auto file = read(text);
    if (file) {
        return "none";
    }
    const Diagnostic& first = file.diagnostics.front();
    EXPECT_FALSE(first.remedy.empty()) << first.message;
    if (!first.span.source) {
        return first.message;
    }
    return fmt::format("{}: {}", first.span.source->locate(first.span.begin).line, first.message);
}

}  // namespace

TEST(OpenCVCalibration, IsReadAsFileStorageWritesIt) {
    EXPECT_EQ(shown(opencv_file(good_matrix, "-0.1, 0.02, 0.001, -0.002, 0.5")),
              ": width 640 height 480 fx 500 fy 501 cx 321 cy 239 d -0.1 0.02 0.001 -0.002 0.5");
    const auto file = read(opencv_file(good_matrix, "0, 0, 0, 0"));
    ASSERT_TRUE(file);
    EXPECT_EQ((*file)->cameras.front().origin, "pixel_center");
    EXPECT_FALSE((*file)->cameras.front().id);
}

TEST(OpenCVCalibration, HasTheOtherUsualNamesAndForms) {
    const std::string all = ": width 640 height 480 fx 500 fy 501 cx 321 cy 239 d 0.1 0 0 0";
    EXPECT_EQ(shown("K: [[500, 0, 321], [0, 501, 239], [0, 0, 1]]\nD: [[0.1, 0, 0, 0]]\n"
                    "image_size: [640, 480]\n"),
              all);
    EXPECT_EQ(shown("cameraMatrix: [500, 0, 321, 0, 501, 239, 0, 0, 1]\ndistCoeffs:\n  - 0.1\n"
                    "  - 0\n  - 0\n  - 0\nimage_Width: 640\nimage_Height: 480\n"),
              all);
    EXPECT_EQ(shown("intrinsics: [500, 501, 321, 239]\ndist_coeffs: [+1e-1, 0, 0, 0]\n"
                    "resolution: [640, 480]\n"),
              all);
    // ROS's camera_info, whose rectification and projection are not of the lens.
    EXPECT_EQ(shown("image_width: 640\nimage_height: 480\ncamera_name: front\n"
                    "camera_matrix:\n  rows: 3\n  cols: 3\n"
                    "  data: [500, 0, 321, 0, 501, 239, 0, 0, 1]\n"
                    "distortion_model: plumb_bob\n"
                    "distortion_coefficients:\n  rows: 1\n  cols: 4\n  data: [0.1, 0, 0, 0]\n"
                    "rectification_matrix:\n  rows: 3\n  cols: 3\n"
                    "  data: [1, 0, 0, 0, 1, 0, 0, 0, 1]\n"),
              "opencv_pinhole" + all);
}

TEST(OpenCVCalibration, KnowsTheModel) {
    const auto model = [](const std::string& more, const std::string& d = "0, 0, 0, 0") {
        return shown(opencv_file(good_matrix, d, more)).substr(0, 7);
    };
    EXPECT_EQ(model("fisheye_model: 1\n"), "opencv_");
    EXPECT_EQ(shown(opencv_file(good_matrix, "0, 0, 0, 0", "fisheye_model: 1\n")),
              "opencv_fisheye: fx 500 fy 501 cx 321 cy 239 d 0 0 0 0");
    EXPECT_EQ(shown(opencv_file(good_matrix, "0, 0, 0, 0", "distortion_model: equidistant\n")),
              "opencv_fisheye: fx 500 fy 501 cx 321 cy 239 d 0 0 0 0");
    EXPECT_EQ(shown(opencv_file(good_matrix, "0, 0, 0, 0", "xi: 0.8\n")),
              "omnidirectional: xi 0.8 fx 500 fy 501 cx 321 cy 239 d 0 0 0 0");
    EXPECT_EQ(shown(opencv_file("500., 3., 321., 0., 501., 239., 0., 0., 1.", "0, 0, 0, 0",
                                "xi: [0.8]\n")),
              "omnidirectional: xi 0.8 skew 3 fx 500 fy 501 cx 321 cy 239 d 0 0 0 0");
}

TEST(OpenCVCalibration, HasAPoseAsMatrixOrVector) {
    const auto pose = [](const std::string& entries) {
        const auto file = read(opencv_file(good_matrix, "0, 0, 0, 0", entries));
        EXPECT_TRUE(file) << to_text(file.diagnostics);
        return file ? (*file)->cameras.front().pose : std::nullopt;
    };
    const auto matrix = pose("R: [0, -1, 0, 1, 0, 0, 0, 0, 1]\nT: [1, 2, 3]\n");
    const auto vector = pose("rvec: [0, 0, 1.5707963267948966]\ntvec: [1, 2, 3]\n");
    ASSERT_TRUE(matrix && vector);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(vector->translation[i], matrix->translation[i]);
        for (std::size_t j = 0; j < 3; ++j) {
            EXPECT_NEAR(vector->rotation[i][j], matrix->rotation[i][j], 1e-15);
        }
    }
    EXPECT_FALSE(pose("T: [1, 2, 3]\n"));
}

TEST(OpenCVCalibration, NamesTheEntryThatIsWrong) {
    const std::string d = "0, 0, 0, 0";
    EXPECT_EQ(problem("image_width: 640\n"), "1: 'file.yml' has no entry camera_matrix");
    EXPECT_EQ(problem("K: [500, 501, 320, 240]\n"),
              "1: 'file.yml' has no entry distortion_coefficients");
    EXPECT_EQ(problem(opencv_file("-500, 0, 321, 0, 501, 239, 0, 0, 1", d)),
              "9: the focal length fx must be above 0, but is -500");
    EXPECT_EQ(problem(opencv_file("500, 0, 321, 0, 0, 239, 0, 0, 1", d)),
              "9: the focal length fy must be above 0, but is 0");
    // The focal length and the centre in each other's place, and the transposed matrix.
    EXPECT_EQ(problem(opencv_file("321, 0, 900, 0, 239, 901, 0, 0, 1", d)),
              "9: the centre cx = 900 is outside of the image, whose width is 640");
    EXPECT_EQ(problem(opencv_file("500, 0, 0, 0, 501, 0, 321, 239, 1", d)),
              "9: number 7 of 'camera_matrix' must be 0, but is 321");
    EXPECT_EQ(problem(opencv_file("500, 0, 321, 0, 501, 239, 0, 0", d)),
              "5: the matrix 'camera_matrix' has 3 rows and 3 columns, but 8 numbers");
    EXPECT_EQ(problem(opencv_file(good_matrix, "0, 0, 0")),
              "10: 'distortion_coefficients' must have 4, 5, 8, 12 or 14 numbers, but has 3");
    EXPECT_EQ(problem(opencv_file(good_matrix, "0, 0, 0, 0, 0", "fisheye_model: 1\n")),
              "9: 'distortion_coefficients' must have 4 numbers, but has 5");
    EXPECT_EQ(problem(opencv_file(good_matrix, "0, .Nan, 0, 0")),
              "10: 'distortion_coefficients' has something else than a finite number");
    EXPECT_EQ(problem(opencv_file(good_matrix, "0, 1e999, 0, 0")),
              "10: 'distortion_coefficients' has something else than a finite number");
    EXPECT_EQ(problem(opencv_file(good_matrix, d, "image_width: 640.5\n")),
              "3: the width of the image cannot be 640.5 pixels");
    EXPECT_EQ(problem(opencv_file(good_matrix, d, "image_width: [1, 2]\n")),
              "3: 'image_width' must be one number");
    EXPECT_EQ(problem(opencv_file(good_matrix, d, "image_size: [640]\n")),
              "3: 'image_size' must be two numbers");
    EXPECT_EQ(problem(opencv_file(good_matrix, d, "K: [1, 2, 3, 4]\n")),
              "4: 'camera_matrix' is the same entry as 'K'");
    EXPECT_EQ(problem(opencv_file(good_matrix, d, "distortion_model: bent\n")),
              "3: there is no distortion model 'bent'");
    EXPECT_EQ(problem(opencv_file(good_matrix, d, "xi: -1\n")),
              "3: xi must not be negative, but is -1");
    EXPECT_EQ(problem(opencv_file(good_matrix, d, "distortion_model: omnidir\n")),
              "1: 'file.yml' has no entry xi");
    EXPECT_EQ(
        problem(opencv_file(good_matrix, d, "R: [1, 0, 0, 0, 1, 0, 0, 0, -1]\nT: [0, 0, 0]\n")),
        "3: 'R' is not a rotation");
    EXPECT_EQ(problem(opencv_file(good_matrix, d, "R: [1, 0, 0, 0]\nT: [0, 0, 0]\n")),
              "3: 'R' has a wrong number of numbers");
}

TEST(OpenCVCalibration, WarnsOfWhatIsProbablySwapped) {
    const auto said = [](const std::string& matrix, const std::string& more) {
        const auto file = read(opencv_file(matrix, "0, 0, 0, 0", more));
        EXPECT_TRUE(file) << to_text(file.diagnostics);
        return file.diagnostics.empty() ? "" : file.diagnostics.front().message;
    };
    EXPECT_EQ(said(good_matrix, "image_width: 640\nimage_height: 480\n"), "");
    EXPECT_EQ(said("900, 0, 640, 0, 900, 360, 0, 0, 1", "image_width: 720\nimage_height: 1280\n"),
              "the centre cx = 640 is far from the middle of the image, whose width is 720");
    EXPECT_EQ(said("900, 0, 320, 0, 240, 300, 0, 0, 1", ""),
              "the focal lengths fx = 900 and fy = 240 are very different");
    EXPECT_EQ(said("500, 2, 321, 0, 501, 239, 0, 0, 1", ""),
              "OpenCV's pinhole model ignores the skew of the camera matrix");
}

TEST(OpenCVCalibration, RefusesWhatIsNotYaml) {
    EXPECT_EQ(problem("<?xml version=\"1.0\"?>\n"), "1: 'file.yml' is XML, which is not read");
    EXPECT_EQ(problem("a: [1, 2\nb: 3\n").substr(0, 20), "2: this is not YAML:");
    EXPECT_EQ(problem(std::string("K: [1\0]", 7)),
              "'file.yml' is not a text file: its byte 6 is zero");
    EXPECT_EQ(problem("---\n- 1\n"), "1: 'file.yml' has no entries");
    EXPECT_NE(problem("a: " + std::string(100'000, '[')), "none");
    EXPECT_EQ(problem(""), "1: 'file.yml' has no cameras");
    const std::string large(max_calibration + 1, ' ');
    EXPECT_EQ(problem(large), "'file.yml' is larger than 4 MB");
}

TEST(ColmapCameras, AreReadByNumberAndModel) {
    const auto file = read(
        "# a comment\n\n3 RADIAL 640 480 500 320 240 -0.1 0.02\r\n"
        "7 OPENCV_FISHEYE 640 480 300 301 320 240 0.1 0.2 0.3 0.4\n",
        "cameras.txt");
    ASSERT_TRUE(file) << to_text(file.diagnostics);
    ASSERT_EQ((*file)->cameras.size(), 2U);
    EXPECT_EQ((*file)->cameras[0].id, 3U);
    EXPECT_EQ((*file)->cameras[1].id, 7U);
    EXPECT_EQ((*file)->cameras[1].model, "opencv_fisheye");
    EXPECT_EQ((*file)->cameras[0].origin, "pixel_corner");
    EXPECT_EQ(shown("3 RADIAL 640 480 500 320 240 -0.1 0.02"),
              "opencv_pinhole: k1 -0.1 k2 0.02 width 640 height 480 fx 500 fy 500 cx 320 cy 240");
}

// COLMAP's documentation of its models.
TEST(ColmapCameras, HaveAllModels) {
    for (const auto& [model, row, numbers] :
         {std::tuple("SIMPLE_PINHOLE", "opencv_pinhole", 3),
          std::tuple("PINHOLE", "opencv_pinhole", 4),
          std::tuple("SIMPLE_RADIAL", "opencv_pinhole", 4),
          std::tuple("RADIAL", "opencv_pinhole", 5), std::tuple("OPENCV", "opencv_pinhole", 8),
          std::tuple("FULL_OPENCV", "opencv_pinhole", 12),
          std::tuple("OPENCV_FISHEYE", "opencv_fisheye", 8),
          std::tuple("SIMPLE_RADIAL_FISHEYE", "opencv_fisheye", 4),
          std::tuple("RADIAL_FISHEYE", "opencv_fisheye", 5), std::tuple("FOV", "field_of_view", 5),
          std::tuple("THIN_PRISM_FISHEYE", "thin_prism_fisheye", 12)}) {
        std::string line = fmt::format("1 {} 900 900", model);
        for (int i = 0; i < numbers; ++i) {
            line += fmt::format(" {}", 400 + i);
        }
        const auto file = read(line);
        ASSERT_TRUE(file) << to_text(file.diagnostics);
        const Calibration& made = (*file)->cameras.front();
        EXPECT_EQ(made.model, row);
        const camera::StageEntry* entry =
            camera::catalogue().find(camera::StageKind::object_generator, made.model);
        ASSERT_NE(entry, nullptr);
        for (const Calibration::Number& number : made.numbers) {
            EXPECT_TRUE(std::any_of(entry->parameters.begin(), entry->parameters.end(),
                                    [&](const auto& one) { return one.name == number.name; }))
                << number.name;
        }
        EXPECT_NE(problem(line + " 1"), "none");
    }
}

TEST(ColmapCameras, NameTheEntryThatIsWrong) {
    EXPECT_EQ(problem("# one\n1 PINHOLE 640 480 500 501 320\n"),
              "2: the model PINHOLE has 4 parameters, but this line has 3");
    EXPECT_EQ(problem("1 PINHOL 640 480 500 501 320 240\n"),
              "1: there is no camera model 'PINHOL'");
    EXPECT_EQ(problem("1 PINHOLE 640 480 0 501 320 240\n"),
              "1: the focal length fx must be above 0, but is 0");
    EXPECT_EQ(problem("1 PINHOLE 640 480 320 240 900 901\n"),
              "1: the centre cx = 900 is outside of the image, whose width is 640");
    EXPECT_EQ(problem("1 PINHOLE 640 480 500 nan 320 240\n"), "1: fy is not a finite number");
    EXPECT_EQ(problem("1 PINHOLE 640 x 500 501 320 240\n"), "1: the height is not a finite number");
    EXPECT_EQ(problem("-1 PINHOLE 640 480 500 501 320 240\n"),
              "1: the number of a camera must be a whole number from 0 to 1000000");
    EXPECT_EQ(problem("1 PINHOLE 640 480 500 501 320 240\n1 PINHOLE 640 480 500 501 320 240\n"),
              "2: there are two cameras with the number 1");
    EXPECT_EQ(problem("1 PINHOLE 640\n"), "1: this line has too few entries for a camera");
    EXPECT_EQ(problem("# nothing\n"), "1: 'file.yml' has no cameras");
}

// Nothing but a diagnostic comes of any damage to a file.
std::string mrcal_file(const std::string& lens, const std::string& intrinsics) {
    return fmt::format(
        "# made by hand\n{{\n    'lensmodel':  '{}',\n\n    # all\n    'intrinsics': [ {},],\n"
        "    'extrinsics': [ 0, 0, 0, 1, 2, 3,],\n    'imagersize': [ 640, 480,],\n"
        "    'icam_intrinsics': 0,\n    'optimization_inputs': b'a: {{[\\'x, ]',\n}}\n",
        lens, intrinsics);
}

TEST(MrcalModel, IsReadWithoutWhatItWasMadeFrom) {
    EXPECT_EQ(shown(mrcal_file("LENSMODEL_OPENCV4", "500, 501, 320, 240, -0.1, 0.2, 1e-3, 2e-3")),
              "opencv_pinhole: width 640 height 480 fx 500 fy 501 cx 320 cy 240 d -0.1 0.2 0.001 "
              "0.002");
    EXPECT_EQ(shown(mrcal_file("LENSMODEL_PINHOLE", "500, 501, 320, 240")),
              "opencv_pinhole: width 640 height 480 fx 500 fy 501 cx 320 cy 240");
    std::string grid = "500, 501, 320, 240";
    for (int i = 0; i < 2 * 5 * 4; ++i) {
        grid += fmt::format(", {}", 0.01 * i);
    }
    const auto file =
        read(mrcal_file("LENSMODEL_SPLINED_STEREOGRAPHIC_order=3_Nx=5_Ny=4_fov_x_deg=90", grid));
    ASSERT_TRUE(file) << to_text(file.diagnostics);
    const Calibration& made = (*file)->cameras.front();
    EXPECT_EQ(made.model, "splined_stereographic");
    ASSERT_EQ(made.points.size(), 20U);
    EXPECT_EQ(made.points[1], (std::array{0.02, 0.03}));
    EXPECT_EQ(made.origin, "pixel_center");
    EXPECT_EQ(made.pose->translation, (std::array{1.0, 2.0, 3.0}));
}

TEST(MrcalModel, NamesTheEntryThatIsWrong) {
    EXPECT_EQ(problem(mrcal_file("LENSMODEL_CAHVOR", "1, 1, 1, 1")),
              "3: the lens model 'LENSMODEL_CAHVOR' is not read");
    EXPECT_EQ(problem(mrcal_file("LENSMODEL_OPENCV7", "1, 1, 1, 1")),
              "3: the lens model 'LENSMODEL_OPENCV7' is not read");
    EXPECT_EQ(problem(mrcal_file("LENSMODEL_OPENCV5", "500, 501, 320, 240")),
              "6: the lens model LENSMODEL_OPENCV5 has 9 intrinsics, but this file has 4");
    EXPECT_EQ(problem(mrcal_file("LENSMODEL_PINHOLE", "500, 501, nan, 240")),
              "6: 'intrinsics' has something else than a finite number");
    EXPECT_EQ(problem(mrcal_file("LENSMODEL_SPLINED_STEREOGRAPHIC_order=3_Nx=5", "1, 1, 1, 1")),
              "3: this is no splined model of mrcal");
    EXPECT_EQ(problem(mrcal_file("LENSMODEL_SPLINED_STEREOGRAPHIC_order=3_Nx=4_Ny=4.5_fov_x_deg=90",
                                 "1, 1, 1, 1")),
              "3: this is no splined model of mrcal");
    for (const char* const text : {"'lensmodel'", "['lensmodel', 3]"}) {
        EXPECT_EQ(problem(text), "1: 'file.yml' is no dictionary of mrcal");
    }
    EXPECT_EQ(problem("{'lensmodel': 'LENSMODEL_PINHOLE'"),
              "1: this is no dictionary of mrcal: end of map flow not found");
    EXPECT_EQ(problem("{'lensmodel': 'LENSMODEL_PINHOLE'}"),
              "1: 'file.yml' has no list 'imagersize'");
}

TEST(Calibrations, SurviveMutations) {
    const std::array<std::string, 3> good{
        opencv_file(good_matrix, "-0.1, 0.02, 0.001, -0.002, 0.5",
                    "image_size: [640, 480]\nrvec: [0, 0, 1]\ntvec: [1, 2, 3]\nxi: 1\n"),
        "1 RADIAL 640 480 500 320 240 -0.1 0.02\n2 FOV 640 480 300 301 320 240 0.9\n",
        mrcal_file("LENSMODEL_OPENCV4", "500, 501, 320, 240, -0.1, 0.2, 1e-3, 2e-3")};
    constexpr std::string_view letters = "[]{}:,-!&*#?|>%@`'\"\n\t .0e9\\";
    std::mt19937_64 random(29);
    const auto below = [&random](std::size_t n) {
        return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
    };
    for (int i = 0; i < 6000; ++i) {
        std::string text = good[below(good.size())];
        for (std::size_t k = below(4) + 1; k > 0; --k) {
            const std::size_t at = below(text.size());
            switch (below(4)) {
                case 0: text[at] = letters[below(letters.size())]; break;
                case 1: text.insert(at, 1, letters[below(letters.size())]); break;
                case 2: text.erase(at, below(8)); break;
                default: text.insert(at, text.substr(below(text.size()), below(40)));
            }
        }
        const auto file = read(text);
        EXPECT_EQ(file.value.has_value(), !has_errors(file.diagnostics)) << text;
        if (file) {
            for (const Calibration::Number& number : (*file)->cameras.front().numbers) {
                EXPECT_TRUE(std::isfinite(number.value)) << text;
            }
        }
        (void)to_text(file.diagnostics);
    }
}

TEST(Calibration, KalibrsChainHasACameraEach) {
    const std::string chain =
        "cam0:\n  camera_model: pinhole\n  distortion_coeffs: [-0.021, 0.004, -0.0013, 0.0001]\n"
        "  distortion_model: equidistant\n  intrinsics: [200.5, 200.1, 318.2, 241.7]\n"
        "  resolution: [640, 480]\n  rostopic: /cam0/image_raw\n"
        "cam1:\n  T_cn_cnm1:\n  - [0, -1, 0, 0.1]\n  - [1, 0, 0, 0.2]\n  - [0, 0, 1, 0.3]\n"
        "  - [0, 0, 0, 1]\n  camera_model: omni\n  distortion_coeffs: [0.1, 0.2, 0.3, 0.4]\n"
        "  distortion_model: radtan\n  intrinsics: [1.5, 300, 301, 320, 240]\n"
        "  resolution: [640, 480]\n"
        "cam2:\n  T_cn_cnm1: [[1, 0, 0, 1], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]\n"
        "  camera_model: pinhole\n  distortion_coeffs: []\n  distortion_model: none\n"
        "  intrinsics: [200, 200, 320, 240]\n  resolution: [640, 480]\n";
    EXPECT_EQ(shown(chain),
              "opencv_fisheye: width 640 height 480 fx 200.5 fy 200.1 cx 318.2 cy 241.7 d -0.021 "
              "0.004 -0.0013 0.0001");
    const auto file = read(chain);
    ASSERT_TRUE(file) << to_text(file.diagnostics);
    const std::vector<Calibration>& cameras = (*file)->cameras;
    ASSERT_EQ(cameras.size(), 3U);
    EXPECT_EQ(cameras[1].id, 1U);
    EXPECT_EQ(cameras[1].model, "omnidirectional");
    EXPECT_EQ(cameras[1].numbers.front().value, 1.5);
    EXPECT_EQ(cameras[1].distortion, (std::vector{0.1, 0.2, 0.3, 0.4}));
    EXPECT_EQ(cameras[1].pose->translation, (std::array{0.1, 0.2, 0.3}));
    EXPECT_EQ(cameras[2].pose->translation, (std::array{1.1, 0.2, 0.3}));
    EXPECT_EQ(cameras[2].pose->rotation[0], (std::array{0.0, -1.0, 0.0}));
    EXPECT_TRUE(cameras[2].distortion.empty());
}

TEST(Calibration, MistakesInKalibrsChain) {
    const std::string camera =
        "  distortion_coeffs: [0, 0, 0, 0]\n  intrinsics: [200, 200, 320, 240]\n"
        "  resolution: [640, 480]\n";
    EXPECT_NE(problem("cam0:\n  camera_model: eucm\n" + camera).find("'eucm' is not read"),
              std::string::npos);
    EXPECT_NE(problem("cam0:\n" + camera + "cam1:\n" + camera).find("no T_cn_cnm1"),
              std::string::npos);
    EXPECT_NE(problem("cam0:\n  camera_model: omni\n" + camera).find("must have 5 numbers"),
              std::string::npos);
}

TEST(Calibration, TheTextMayBeginWithAByteOrderMarkAndIsNotUtf16) {
    EXPECT_EQ(shown("\xef\xbb\xbf" + opencv_file(good_matrix, "0, 0, 0, 0")),
              shown(opencv_file(good_matrix, "0, 0, 0, 0")));
    std::string wide = "\xff\xfe";
    for (const char c : opencv_file(good_matrix, "0, 0, 0, 0")) {
        wide += std::string{c, '\0'};
    }
    EXPECT_NE(problem(wide).find("'file.yml' is UTF-16"), std::string::npos) << problem(wide);
}

}  // namespace balcony::data::calibration_test

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// From a camera to a ray map and back to a camera: the rays between the pixels of the map.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "../files/temporary_folder.hpp"
#include "balcony/lang.hpp"
#include "balcony/ray_difference.hpp"
#include "balcony/ray_maps.hpp"

namespace balcony::bridge::ray_map_round_trip_test {
namespace {

namespace fs = std::filesystem;

class RoundTrip : public testing::TestWithParam<std::string> {
protected:
    /// The camera of a map of a picture.
    [[nodiscard]] camera::Camera through_map(const camera::Picture& picture, std::size_t width,
                                             std::size_t height, const std::string& file) const {
        const auto grid = RayGrid::make(picture, {.width = width, .height = height});
        EXPECT_TRUE(grid) << to_text(grid.diagnostics);
        const RaysWritten written =
            write_ray_map(*grid, folder_ / file,
                          file.ends_with(".exr") ? NumberFormat::single_precision
                                                 : NumberFormat::double_precision);
        EXPECT_TRUE(written.problems.empty()) << to_text(written.problems);
        const auto text = std::make_shared<const SourceText>(
            "map.cam", "camera map_of_it {\n map u = 0 .. 1, v = 0 .. 1\n eye ray_map(\"" + file +
                           "\")\n toward ray_map(\"" + file + "\", targets)\n}\n");
        lang::Workspace workspace;
        auto made = workspace.make_camera(lang::CameraSource(text, folder_.path()));
        EXPECT_TRUE(made) << to_text(made.diagnostics);
        return std::move(*made);
    }

    const files::TemporaryFolder folder_;
};

/// A pole of a panorama, where a whole row of the picture is one ray.
bool is_pole(const rays::Ray& ray) {
    return ray.origin_by_x.length() + ray.direction_by_x.length() < 1e-12;
}

/// The largest distance between rays of two cameras in pixels of the map, at places between its
/// pixels and on its border.
double largest_difference(const camera::Camera& exact, const camera::Camera& other, double width,
                          double height, double distance) {
    const auto compiled = [&](const camera::Camera& camera, bool footprints) {
        return rays::compile(camera, width, height,
                             {.footprints = footprints, .tiles = false, .points = true});
    };
    const auto one = compiled(exact, true);
    const auto two = compiled(other, false);
    rays::Scratch scratch;
    rays::RayBatch first;
    rays::RayBatch second;
    std::vector<double> x;
    std::vector<double> y;
    for (double row = 0.0; row <= height; row += 0.25 + height / 40.0) {
        for (double column = 0.0; column <= width; column += 0.25 + width / 60.0) {
            x.push_back(column);
            y.push_back(row);
        }
    }
    one->run(rays::Points{x, y}, scratch, first);
    two->run(rays::Points{x, y}, scratch, second);
    double largest = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        EXPECT_EQ(first.valid(i), second.valid(i)) << x[i] << ", " << y[i];
        if (first.valid(i) && second.valid(i) && !is_pole(first[i])) {
            largest = std::max(largest, rays::pixels_between(first[i], second[i], distance));
        }
    }
    return largest;
}

// The interpolation is off by about the third derivative of the rays times the cube of a pixel,
// divided by 12 or so within the map; a pixel is the first derivative. So a camera whose rays turn
// by 6 radians over 512 pixels is off by some (6/512)^2/12, 1e-5 pixel. Within a picture of these
// cameras the turn by a pixel varies by less than a factor of three, and the error with its square:
// 1e-4. A file of floats rounds unit directions by up to 2^-24, 6e-8 / (2/512) = 2e-5 of a pixel.
TEST_P(RoundTrip, IsExactBetweenThePixels) {
    const auto picture = lang::make_picture(GetParam(), "");
    ASSERT_TRUE(picture);
    const camera::Camera* const camera = picture->only_camera();
    const std::size_t width = 512;
    const auto height = static_cast<std::size_t>(std::lround(512.0 / camera->parts().aspect));
    for (const char* file : {"rays.npy", "rays.exr"}) {
        const camera::Camera other = through_map(*picture, width, height, file);
        for (const double distance : {2.0, std::numeric_limits<double>::infinity()}) {
            const double pixels =
                largest_difference(*camera, other, double{512}, static_cast<double>(height),
                                   GetParam() == "orthographic" ? 2.0 : distance);
            EXPECT_LT(pixels, 1.2e-4) << file << " at " << distance;
            RecordProperty(std::string(file) + (distance > 2.0 ? "_far" : "_near"),
                           std::to_string(pixels));
            std::printf("%s %s at %g: %.2g pixel\n", GetParam().c_str(), file, distance, pixels);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(BuiltInCameras, RoundTrip,
                         testing::Values("pinhole", "fisheye", "panorama", "cylinder",
                                         "orthographic", "hyperbolic"),
                         [](const auto& one) { return one.param; });

}  // namespace
}  // namespace balcony::bridge::ray_map_round_trip_test

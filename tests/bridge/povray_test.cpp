// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What `balcony pov` gives POV-Ray and what it reads from it, without POV-Ray.

#include "balcony/povray.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <set>

#include "balcony/lang.hpp"
#include "balcony/ray_difference.hpp"
#include "bridge/povray/camera_mesh.hpp"
#include "bridge/povray/messages.hpp"
#include "bridge/povray/process.hpp"
#include "bridge/povray/scene_axes.hpp"

namespace balcony::bridge::povray::povray_test {
namespace {

constexpr std::size_t width = 150;
constexpr std::size_t height = 100;
constexpr std::size_t any_number = 1'000'000;

render::PictureSamples samples_of(const std::string& camera) {
    const auto picture = lang::make_picture(camera, "");
    EXPECT_TRUE(picture) << to_text(picture.diagnostics);
    auto samples = render::PictureSamples::make(picture->with_fit(camera::Fit::stretch),
                                                {.width = width, .height = height});
    EXPECT_TRUE(samples) << to_text(samples.diagnostics);
    return std::move(*samples.value);
}

// The ray that POV-Ray makes of the first face around a place, by its documented rule.
std::optional<rays::Ray> ray_at(const CameraMesh& mesh, const MeshFrame& frame, const V2d& place) {
    for (const Face& face : mesh.faces) {
        const V2d a = mesh.places[face[0]] - place;
        const V2d b = mesh.places[face[1]] - place;
        const V2d c = mesh.places[face[2]] - place;
        const double area = (b - a).cross(c - a);
        const V3d weight(b.cross(c) / area, c.cross(a) / area, a.cross(b) / area);
        if (weight.x < 0.0 || weight.y < 0.0 || weight.z < 0.0) {
            continue;
        }
        V3d vertex(0.0);
        V3d normal(0.0);
        for (std::size_t k = 0; k < 3; ++k) {
            vertex += weight[static_cast<int>(k)] * V3d(mesh.vertices[face[k]]);
            normal += weight[static_cast<int>(k)] * V3d(mesh.normals[face[k]]);
        }
        rays::Ray ray;
        ray.origin = vertex - frame.offset * normal + frame.center;
        ray.direction = normal.normalized();
        return ray;
    }
    return std::nullopt;
}

// How many of the rays of a pass the mesh gives, each within the tolerance.
void expect_exact_mesh(const std::string& camera, std::size_t pass) {
    render::PictureSamples samples = samples_of(camera);
    const MeshFrame frame = mesh_frame(samples, width, height);
    std::vector<std::uint8_t> seen;
    const CameraMesh mesh =
        make_camera_mesh(samples, 0, pass, width, height, frame, any_number, seen);
    ASSERT_EQ(seen.size(), width * height);
    EXPECT_LE(mesh.largest_error, povray_tolerance);
    rays::RayBatch exact;
    std::vector<std::uint8_t> wanted;
    samples.find_rays(0, pass, {0, 0, width, height}, exact, wanted);
    EXPECT_EQ(seen, wanted) << camera;
    // A prime number of pixels from one to the next, since a look-up goes through all faces.
    for (std::size_t i = 0; i < seen.size(); i += 13) {
        if (seen[i] == 0) {
            continue;
        }
        const V2d place(static_cast<double>(i % width), static_cast<double>(i / width));
        const auto ray = ray_at(mesh, frame, place);
        ASSERT_TRUE(ray) << camera << " at " << place;
        EXPECT_LE(rays::pixels_between(exact[i], *ray, 10.0 * frame.extent),
                  povray_tolerance * (1.0 + 1e-6))
            << camera << " at " << place;
    }
}

}  // namespace

TEST(CameraMesh, GivesEachRayWithinTheTolerance) {
    for (const char* camera :
         {"pinhole", "orthographic", "panorama", "cylinder", "superelliptic"}) {
        for (const std::size_t pass : {0U, 5U}) {
            expect_exact_mesh(camera, pass);
        }
    }
}

TEST(CameraMesh, OfSingleFacesIsTheRays) {
    render::PictureSamples samples = samples_of("superelliptic");
    const MeshFrame frame = mesh_frame(samples, width, height);
    const render::Region region{0, 30, width, 20};
    std::vector<std::uint8_t> seen;
    const CameraMesh mesh = make_single_faces(samples, 0, 1, region, frame, seen);
    rays::RayBatch exact;
    std::vector<std::uint8_t> wanted;
    samples.find_rays(0, 1, region, exact, wanted);
    ASSERT_EQ(mesh.faces.size(), region.size());
    for (std::size_t i = 0; i < region.size(); ++i) {
        const auto vertex = [&](std::size_t k) { return V3d(mesh.vertices[mesh.faces[i][k]]); };
        rays::Ray ray;
        ray.origin = (vertex(0) + vertex(1) + vertex(2)) / 3.0 + frame.center;
        ray.direction = ((vertex(2) - vertex(0)) % (vertex(1) - vertex(0))).normalized();
        EXPECT_LT(rays::pixels_between(exact[i], ray, frame.extent), povray_tolerance) << i;
    }
}

TEST(CameraMesh, GivesUpAtTooManyFaces) {
    render::PictureSamples samples = samples_of("panorama");
    const MeshFrame frame = mesh_frame(samples, width, height);
    std::vector<std::uint8_t> seen;
    EXPECT_FALSE(make_camera_mesh(samples, 0, 0, width, height, frame, 10, seen).complete);
    EXPECT_EQ(seen.size(), width * height);
}

TEST(SceneAxes, KeepLengthsAndHaveTheirHandedness) {
    std::set<std::string_view> names;
    for (const PovrayAxes& axes : povray_axes()) {
        EXPECT_TRUE(names.insert(axes.name).second);
        const AxesRow* const row = find_axes(axes.name);
        ASSERT_NE(row, nullptr);
        const V3d x = row->from_y_up({1.0, 0.0, 0.0});
        const V3d y = row->from_y_up({0.0, 1.0, 0.0});
        const V3d z = row->from_y_up({0.0, 0.0, 1.0});
        EXPECT_EQ((x % y) ^ z, axes.name.ends_with("_right") ? 1.0 : -1.0) << axes.name;
        EXPECT_EQ(axes.name.starts_with("y_up") ? y.y : y.z, 1.0) << axes.name;
    }
    EXPECT_EQ(find_axes("x_up"), nullptr);
}

TEST(Messages, HaveTheirPlaceInTheUsersFile) {
    const ScenePlaces places{std::make_shared<const SourceText>("my.pov", "#version 3.7;\nbox {\n"),
                             "/tmp/x/scene.pov", "/nowhere"};
    const Diagnostics found = read_messages(
        "File '/tmp/x/scene.pov' line 2: Parse Error: No matching } in\n 'box', End of File\n"
        "Fatal error in parser: Cannot parse input.\nRender failed\n"
        "File 'lost.inc' line 4: Parse Warning: Odd.\n",
        places);
    ASSERT_EQ(found.size(), 2U) << to_text(found);
    EXPECT_EQ(found[0].message, "POV-Ray: No matching } in 'box', End of File");
    EXPECT_EQ(found[0].severity, Severity::error);
    EXPECT_EQ(found[0].span.source, places.scene);
    EXPECT_EQ(places.scene->locate(found[0].span.begin).line, 2U);
    EXPECT_EQ(found[1].message, "POV-Ray: Odd ('lost.inc' line 4)");
    EXPECT_EQ(found[1].severity, Severity::warning);
}

TEST(Messages, OmitTheCameraOfBalcony) {
    EXPECT_TRUE(
        read_messages("File 's' line 9: Parse Warning: More than one camera in scene. "
                      "Ignoring previous\n camera(s).\nParse Warning: This rendering uses "
                      "the following experimental feature(s): mesh\n camera. It may change.\n",
                      {})
            .empty());
}

TEST(Messages, TellTheProgress) {
    EXPECT_EQ(read_progress("Rendered 50 of 200 pixels (25%)\rRendered 100 of 200 pixels (50%)"),
              0.5);
    EXPECT_EQ(read_progress("Parsing"), std::nullopt);
}

TEST(Process, PassesWordsAsTheyAre) {
    const ProcessResult result = run_process({"/bin/echo", {"a b", "$HOME", "'\"", "*"}, "/"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.output, "a b $HOME '\" *\n");
    EXPECT_EQ(run_process({"/no/such/program", {}}).exit_code, std::nullopt);
}

}  // namespace balcony::bridge::povray::povray_test

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/gallery/gallery.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>
#include <set>

#include <sys/wait.h>

#include "../scene/glb_file.hpp"
#include "balcony/images.hpp"

namespace balcony::plates::gallery_builder_test {

namespace {

using Imath::Box3d;
using Imath::V2f;
using Imath::V3d;
using Imath::V3f;
using nlohmann::json;
using scene::testing::elements_of;
using scene::testing::GlbFile;
using scene::testing::read_glb;

// Small textures: all else does not depend on their size.
constexpr double small = 0.04;

std::vector<std::uint8_t> gallery_bytes(bool pictures_and_walls) {
    const Result<scene::Scene> gallery = make_gallery({pictures_and_walls, small});
    return gallery ? to_glb(*gallery) : std::vector<std::uint8_t>{};
}

GlbFile gallery_file(bool pictures_and_walls = true) {
    GlbFile file;
    read_glb(gallery_bytes(pictures_and_walls), file);
    return file;
}

bool begins(const std::string& name, const char* with) { return name.rfind(with, 0) == 0; }

std::vector<json> nodes_named(const GlbFile& file, const char* begin) {
    std::vector<json> found;
    for (const json& node : file.document["nodes"]) {
        if (begins(node["name"], begin)) {
            found.push_back(node);
        }
    }
    return found;
}

// Of a box before a wall: which wall, and the extent along it.
struct OnWall {
    std::string wall;
    double nearest;  // Distances from the wall's plane.
    double furthest;
    double low_along, high_along, low_up, high_up;
    double half_length;
};

OnWall on_wall(const Box3d& box) {
    const V3d middle = box.center();
    const bool long_wall = room_half_y - std::abs(middle.y) < room_half_x - std::abs(middle.x);
    const unsigned across = long_wall ? 1 : 0;
    const unsigned along = long_wall ? 0 : 1;
    const double plane = long_wall ? room_half_y : room_half_x;
    const bool plus = middle[across] > 0.0;
    return {std::string(plus ? "+" : "-") + (long_wall ? "y" : "x"),
            plane - (plus ? box.max[across] : -box.min[across]),
            plane - (plus ? box.min[across] : -box.max[across]),
            box.min[along],
            box.max[along],
            box.min.z,
            box.max.z,
            long_wall ? room_half_x : room_half_y};
}

TEST(Gallery, IsAWellFormedGlb) {
    const GlbFile file = gallery_file();
    EXPECT_EQ(file.document["asset"]["version"], "2.0");
    ASSERT_EQ(file.document["buffers"].size(), 1U);
    EXPECT_EQ(file.document["buffers"][0]["byteLength"], file.binary.size());
    for (const json& view : file.document["bufferViews"]) {
        const auto offset = view["byteOffset"].get<std::size_t>();
        EXPECT_EQ(offset % 4, 0U);
        EXPECT_LE(offset + view["byteLength"].get<std::size_t>(), file.binary.size());
    }
    const std::map<std::string, std::size_t> size{{"SCALAR", 4}, {"VEC2", 8}, {"VEC3", 12}};
    for (const json& accessor : file.document["accessors"]) {
        const json& view = file.document["bufferViews"][accessor["bufferView"].get<std::size_t>()];
        EXPECT_EQ(accessor["count"].get<std::size_t>() * size.at(accessor["type"]),
                  view["byteLength"].get<std::size_t>());
    }
    for (const json& image : file.document["images"]) {
        const json& view = file.document["bufferViews"][image["bufferView"].get<std::size_t>()];
        const auto* bytes = &file.binary[view["byteOffset"].get<std::size_t>()];
        const std::string start(bytes, bytes + 4);
        EXPECT_TRUE(start == "\x89PNG" || start.starts_with("\xff\xd8")) << image["name"];
    }
}

TEST(Gallery, MeshesAreWoundLikeTheirNormals) {
    const GlbFile file = gallery_file();
    for (const json& mesh : file.document["meshes"]) {
        const json& primitive = mesh["primitives"][0];
        const json& attributes = primitive["attributes"];
        const auto at = elements_of<V3f>(file, attributes["POSITION"].get<std::size_t>());
        const auto normals = elements_of<V3f>(file, attributes["NORMAL"].get<std::size_t>());
        const auto triangles = elements_of<std::array<std::uint32_t, 3>>(
            file, primitive["indices"].get<std::size_t>());
        ASSERT_EQ(at.size(), normals.size());
        for (const auto& [a, b, c] : triangles) {
            ASSERT_LT(std::max({a, b, c}), at.size());
            const V3f normal = (at[b] - at[a]).cross(at[c] - at[a]).normalized();
            // Flat faces agree; cylinders of 24 sides turn by up to 7.5 degrees to a corner.
            EXPECT_GT(normal.dot(normals[a]), 0.99F) << mesh["name"];
            EXPECT_NEAR(normals[a].length(), 1.0F, 1e-6F);
        }
    }
}

TEST(Gallery, NamesEveryPictureOnceAndEveryNodeDifferently) {
    const GlbFile file = gallery_file();
    std::set<std::string> names;
    for (const json& node : file.document["nodes"]) {
        EXPECT_TRUE(names.insert(node["name"]).second) << node["name"];
    }
    for (int number = 1; number <= 7; ++number) {
        EXPECT_EQ(names.count("picture " + std::to_string(number)), 1U);
        EXPECT_EQ(names.count("frame " + std::to_string(number)), 1U);
    }
    EXPECT_EQ(nodes_named(file, "picture ").size(), 7U);
}

TEST(Gallery, InstancesShareTheirMeshes) {
    const GlbFile file = gallery_file();
    std::set<int> meshes;
    for (const json& node : nodes_named(file, "box ")) {
        meshes.insert(node["mesh"].get<int>());
    }
    EXPECT_EQ(meshes.size(), 1U);
    meshes.clear();
    for (const json& node : nodes_named(file, "cylinder ")) {
        meshes.insert(node["mesh"].get<int>());
    }
    EXPECT_EQ(meshes.size(), 3U);
}

// Where the superelliptic camera of half axes 45, 25, 25 looks at the walls nearly straight on.
TEST(Gallery, PicturesHangWhereTheCameraLooksStraight) {
    const GlbFile file = gallery_file();
    for (const json& node : nodes_named(file, "picture ")) {
        const OnWall at = on_wall(bounds_z_up(file, node));
        const double max_along = at.half_length == room_half_x ? 35.0 : 16.0;
        EXPECT_GE(at.low_along, -max_along) << node["name"];
        EXPECT_LE(at.high_along, max_along) << node["name"];
        EXPECT_GE(at.low_up, -16.0) << node["name"];
        EXPECT_LE(at.high_up, 16.0) << node["name"];
    }
}

TEST(Gallery, FramesDoNotOverlap) {
    const GlbFile file = gallery_file();
    std::vector<OnWall> frames;
    for (const json& node : nodes_named(file, "frame ")) {
        frames.push_back(on_wall(bounds_z_up(file, node)));
    }
    ASSERT_EQ(frames.size(), 7U);
    std::map<std::string, int> on;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        ++on[frames[i].wall];
        for (std::size_t k = 0; k < i; ++k) {
            const bool apart = frames[i].wall != frames[k].wall ||
                               frames[i].low_along >= frames[k].high_along ||
                               frames[k].low_along >= frames[i].high_along;
            EXPECT_TRUE(apart) << i + 1 << " and " << k + 1;
        }
    }
    EXPECT_EQ(on, (std::map<std::string, int>{{"+y", 3}, {"+x", 1}, {"-y", 2}, {"-x", 1}}));
}

TEST(Gallery, TheGridDoesNotTouchPictures) {
    const GlbFile file = gallery_file();
    double furthest = 0.0;
    for (const char* part : {"box ", "cylinder "}) {
        for (const json& node : nodes_named(file, part)) {
            const Box3d box = bounds_z_up(file, node);
            const double x = std::max(std::abs(box.min.x), std::abs(box.max.x));
            const double y = std::max(std::abs(box.min.y), std::abs(box.max.y));
            // Of the walls that it stands in, if any: as far as it stands out.
            furthest =
                std::max(furthest, std::min(std::abs(x - room_half_x), std::abs(y - room_half_y)));
        }
    }
    EXPECT_GT(furthest, 1.0);
    for (const json& node : nodes_named(file, "picture ")) {
        const OnWall at = on_wall(bounds_z_up(file, node));
        EXPECT_GT(at.nearest, furthest) << node["name"];
        EXPECT_LT(at.furthest - at.nearest, 1e-9) << node["name"];
    }
}

// The upper left corner of the image, seen from inside, is the upper left corner of the picture.
TEST(Gallery, NoPictureIsMirroredOrUpsideDown) {
    const GlbFile file = gallery_file();
    for (const json& node : nodes_named(file, "picture ")) {
        const json& attributes =
            file.document["meshes"][node["mesh"].get<std::size_t>()]["primitives"][0]["attributes"];
        const auto uv = elements_of<V2f>(file, attributes["TEXCOORD_0"].get<std::size_t>());
        const std::vector<V3d> at = vertices_z_up(file, node);
        ASSERT_EQ(uv.size(), 4U);
        const Box3d box = bounds_z_up(file, node);
        const V3d forward = V3d(box.size().x < 1e-9 ? box.center().x : 0.0,
                                box.size().y < 1e-9 ? box.center().y : 0.0, 0.0)
                                .normalized();
        const V3d right = forward.cross(V3d(0, 0, 1));
        for (std::size_t i = 0; i < 4; ++i) {
            const V3d from_middle = at[i] - box.center();
            EXPECT_EQ(uv[i].x, from_middle.dot(right) > 0.0 ? 1.0F : 0.0F) << node["name"];
            EXPECT_EQ(uv[i].y, from_middle.z > 0.0 ? 0.0F : 1.0F) << node["name"];
        }
    }
}

TEST(Gallery, PicturesHaveTheShapeOfTheirFrames) {
    const Result<scene::Scene> gallery = make_gallery({true, small});
    ASSERT_TRUE(gallery);
    for (const Hanging& hanging : hangings()) {
        const auto texture = std::find_if(
            gallery->textures.begin(), gallery->textures.end(),
            [&](const scene::Texture& candidate) { return candidate.name == hanging.name; });
        ASSERT_NE(texture, gallery->textures.end()) << hanging.name;
        const auto image = images::ImageFile::open(texture->name, *texture->bytes);
        ASSERT_TRUE(image) << hanging.name;
        const double pixels = double((*image)->width()) / double((*image)->height());
        // Half a pixel in 600 of either side.
        EXPECT_NEAR(pixels / (hanging.width / hanging.height), 1.0, 0.5 / 600) << hanging.name;
    }
}

TEST(Gallery, WallsFloorAndCeilingCloseTheRoom) {
    const GlbFile file = gallery_file();
    const std::map<std::string, Box3d> sides{
        {"wall +y", {{-49, 29, -24}, {49, 29, 24}}}, {"wall -y", {{-49, -29, -24}, {49, -29, 24}}},
        {"wall +x", {{49, -29, -24}, {49, 29, 24}}}, {"wall -x", {{-49, -29, -24}, {-49, 29, 24}}},
        {"floor", {{-49, -29, -24}, {49, 29, -24}}}, {"ceiling", {{-49, -29, 24}, {49, 29, 24}}}};
    for (const auto& [name, expected] : sides) {
        const auto found = nodes_named(file, name.c_str());
        ASSERT_EQ(found.size(), 1U) << name;
        const Box3d box = bounds_z_up(file, found[0]);
        EXPECT_EQ(box.min, expected.min) << name;
        EXPECT_EQ(box.max, expected.max) << name;
    }
}

// The radiance of a white diffuse sheet under the spot lights of the file, with the falloff of
// KHR_lights_punctual.
TEST(Gallery, SpotLightsShineOnThePictures) {
    const Result<scene::Scene> gallery = make_gallery({false, small});
    ASSERT_TRUE(gallery);
    const auto white = [&](const V3d& point, const V3d& normal) {
        double sum = 0.0;
        for (const scene::Light& light : gallery->lights) {
            const V3d to = light.position - point;
            const double inner = std::cos(light.inner_cone);
            const double outer = std::cos(light.outer_cone);
            const double cone = std::clamp(
                (-to.normalized().dot(light.direction) - outer) / (inner - outer), 0.0, 1.0);
            sum += light.intensity.x * cone * cone * std::max(0.0, to.dot(normal)) /
                   std::pow(to.length(), 3);
        }
        return sum / std::numbers::pi;
    };
    for (const Hanging& hanging : hangings()) {
        const M44d placed = room_from_wall(hanging.wall);
        V3d normal;
        placed.multDirMatrix(V3d(0, 0, 1), normal);
        for (const double s : {-0.5, -0.25, 0.0, 0.25, 0.5}) {
            for (const double t : {-0.5, -0.25, 0.0, 0.25, 0.5}) {
                const V3d point = V3d(hanging.right + s * hanging.width,
                                      hanging.up + t * hanging.height, picture_offset) *
                                  placed;
                EXPECT_GT(white(point, normal), 0.08) << hanging.name << point;
                EXPECT_LT(white(point, normal), 1.2) << hanging.name << point;
            }
        }
    }
}

TEST(Gallery, IsTheSameEachTime) { EXPECT_EQ(gallery_bytes(true), gallery_bytes(true)); }

TEST(Gallery, WithoutPicturesAndWallsOnlyTheGridAndLightsRemain) {
    const GlbFile whole = gallery_file();
    const GlbFile file = gallery_file(false);
    for (const json& node : file.document["nodes"]) {
        const std::string name = node["name"];
        EXPECT_TRUE(begins(name, "box ") || begins(name, "cylinder ") || begins(name, "spot "))
            << name;
    }
    for (const char* part : {"box ", "cylinder ", "spot "}) {
        EXPECT_FALSE(nodes_named(file, part).empty());
        EXPECT_EQ(nodes_named(file, part).size(), nodes_named(whole, part).size());
    }
    EXPECT_FALSE(file.document.contains("images"));
}

int exit_code(const std::string& arguments) {
    const std::string command = std::string(BUILD_SCENE) + " " + arguments + " >/dev/null 2>&1";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(BuildScene, ExitCodeTellsTheKindOfError) {
    EXPECT_EQ(exit_code("--help"), 0);
    EXPECT_EQ(exit_code(""), 2);
    EXPECT_EQ(exit_code("--no-such-option"), 2);
    EXPECT_EQ(exit_code("no_such_scene /nonexistent/folder/room.glb"), 1);
    EXPECT_EQ(exit_code("gallery /nonexistent/folder/room.glb --without-pictures-and-walls"), 3);
}

}  // namespace

}  // namespace balcony::plates::gallery_builder_test

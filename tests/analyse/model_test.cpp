// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Cameras as scenes: written as GLB, read back, and measured.

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "../files/temporary_folder.hpp"
#include "balcony/drawing.hpp"
#include "balcony/scene.hpp"
#include "support.hpp"

namespace balcony::analyse::model_test {
namespace {

using scene::V3f;

scene::Scene modelled(const camera::Camera& camera, const Depiction& depiction = {}) {
    auto made = model(camera, depiction);
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    return made ? std::move(*made) : scene::Scene{};
}

// The meshes by the names of their objects.
std::map<std::string, const scene::Mesh*> parts_of(const scene::Scene& scene) {
    std::map<std::string, const scene::Mesh*> parts;
    for (const scene::Instance& instance : scene.instances) {
        parts[scene.objects[instance.object].name] = &*scene.meshes[instance.mesh.value()];
    }
    return parts;
}

camera::Camera ball() {
    return test::camera_of(R"(camera ball {
        map  u = 180deg .. -180deg, v = -90deg .. 90deg
        eye  sphere(2)
        look normal
    })");
}

TEST(Model, ColorsItsArrows) {
    const scene::Scene scene = modelled(ball(), {.color = DrawingColor{255, 255, 0}});
    for (const scene::Material& material : scene.materials) {
        EXPECT_EQ(material.base_color == scene::Color3f(1.0F, 1.0F, 0.0F), material.name == "rays");
    }
}

TEST(Model, HasASurfaceWithNormalsAndParameters) {
    const scene::Scene scene = modelled(ball());
    const auto parts = parts_of(scene);
    ASSERT_EQ(parts.size(), 3U);
    const scene::Mesh& surface = *parts.at("surface");
    ASSERT_EQ(surface.normals.size(), surface.positions.size());
    ASSERT_EQ(surface.texture_coordinates[0].size(), surface.positions.size());
    for (std::size_t i = 0; i < surface.positions.size(); ++i) {
        const V3f& p = surface.positions[i];
        const auto& uv = surface.texture_coordinates[0][i];
        EXPECT_NEAR(p.length(), 2.0, 1e-5);
        EXPECT_NEAR(std::abs(surface.normals[i].dot(p)), 2.0, 1e-4);
        EXPECT_NEAR(p.z, 2.0 * std::sin(uv.y), 1e-5);
        EXPECT_NEAR(p.x, 2.0 * std::cos(uv.y) * std::cos(uv.x), 1e-5);
    }
    EXPECT_GT(surface.triangles.size(), 9000U);
}

TEST(Model, WritesAndLoads) {
    const scene::Scene scene = modelled(test::standard("pinhole"));
    const files::TemporaryFolder folder;
    const auto bytes = scene::to_glb(scene);
    const auto loaded = scene::load(
        folder.write("model.glb", {reinterpret_cast<const char*>(bytes.data()), bytes.size()}));
    ASSERT_TRUE(loaded) << to_text(loaded.diagnostics);
    EXPECT_TRUE(loaded.diagnostics.empty()) << to_text(loaded.diagnostics);
    ASSERT_EQ(loaded->objects.size(), 4U);
    EXPECT_EQ(loaded->axes, Axes::y_up);
    const auto parts = parts_of(scene);
    const auto read = parts_of(*loaded);
    for (const auto& [name, mesh] : parts) {
        ASSERT_EQ(read.count(name), 1U) << name;
        EXPECT_EQ(read.at(name)->triangles.size(), mesh->triangles.size()) << name;
    }
    EXPECT_EQ(loaded->materials[read.at("rays")->material.value()].name, "rays");
    // z up becomes y up: the picture is at x = 1, and its arrows end at 1.25.
    EXPECT_NEAR(loaded->bounds().max.x, 1.25, 1e-5);
    // The ball at the frame's corner stands out by 0.012 of the whole's extent of 2.2.
    EXPECT_NEAR(loaded->bounds().min.y, -loaded->bounds().max.y, 0.03);
    EXPECT_LT(loaded->bounds().max.y, loaded->bounds().max.z);
}

TEST(Model, HasNoTrianglesAcrossASeam) {
    const scene::Scene scene = modelled(test::camera_of(R"(camera torn {
        map  u = 1 .. -1, v = -1 .. 1
        eye  surface(u, v) = [v, u, if(u > 0.03, 10, 0)]
        look normal
    })"));
    const scene::Mesh& surface = *parts_of(scene).at("surface");
    for (const auto& corner : surface.triangles) {
        EXPECT_EQ(surface.positions[corner[0]].z, surface.positions[corner[1]].z);
        EXPECT_EQ(surface.positions[corner[0]].z, surface.positions[corner[2]].z);
    }
}

TEST(Model, ArrowsAreClosedAndFaceOutwards) {
    const scene::Scene scene = modelled(ball(), {.rays = 4, .length = 1.0});
    const scene::Mesh& rays = *parts_of(scene).at("rays");
    // By the divergence theorem; a mesh with a hole or a turned triangle has another volume.
    double volume = 0.0;
    for (const auto& corner : rays.triangles) {
        const V3f& a = rays.positions[corner[0]];
        const V3f& b = rays.positions[corner[1]];
        const V3f& c = rays.positions[corner[2]];
        volume += a.dot(b.cross(c)) / 6.0F;
        EXPECT_GE((b - a).cross(c - a).dot(rays.normals[corner[0]] + rays.normals[corner[1]] +
                                           rays.normals[corner[2]]),
                  -1e-6F);
    }
    EXPECT_GT(volume, 0.0);
}

TEST(Model, OfAPointAndACurveIsSolid) {
    for (const char* object : {"point(1, 2, 3)", "circle(2)"}) {
        const scene::Scene scene =
            modelled(test::camera_of("camera c { map u = 180deg .. -180deg, v = -1 .. 1 eye " +
                                     std::string(object) + " toward sphere(9) }"));
        EXPECT_GT(parts_of(scene).at("surface")->triangles.size(), 20U) << object;
    }
}

TEST(Model, KeepsTheCamerasAxes) {
    const scene::Scene scene = modelled(test::camera_of(R"(camera upright {
        axes y_up
        map  u = -1 .. 1, v = -2 .. 2
        eye  surface(u, v) = [u, v, 0]
    })"),
                                        {.rays = 0, .frame = false});
    EXPECT_EQ(scene.axes, Axes::y_up);
    EXPECT_NEAR(scene.bounds().max.y, 2.0, 0.02);
    EXPECT_NEAR(scene.bounds().max.z, 0.0, 1e-6);
}

TEST(Model, TurnsDepthWithTheCamerasAxes) {
    const scene::Scene scene = modelled(test::camera_of(R"(camera upright {
        axes y_up
        map  u = -1 .. 1, v = -2 .. 2
        eye  surface(u, v) = [u, v, 3 + u]
    })"),
                                        {.rays = 0, .frame = false});
    EXPECT_NEAR(scene.bounds().min.z, 2.0, 0.02);
    EXPECT_NEAR(scene.bounds().max.z, 4.0, 0.02);
}

TEST(Model, TrianglesFaceLikeTheirNormals) {
    const scene::Scene scene = modelled(ball(), {.rays = 0, .frame = false});
    const scene::Mesh& surface = *parts_of(scene).at("surface");
    int with = 0;
    int against = 0;
    for (const auto& corner : surface.triangles) {
        const V3f& a = surface.positions[corner[0]];
        const V3f across =
            (surface.positions[corner[1]] - a).cross(surface.positions[corner[2]] - a);
        // At a pole a triangle has no area.
        const float facing = across.dot(surface.normals[corner[0]]);
        with += facing > 1e-6F ? 1 : 0;
        against += facing < -1e-6F ? 1 : 0;
    }
    EXPECT_EQ(std::min(with, against), 0);
    EXPECT_GT(std::max(with, against), 1000);
}

TEST(Model, ShortArrowsBeginWhereTheirRaysDo) {
    const scene::Scene scene = modelled(ball(), {.rays = 4, .length = 0.01});
    for (const V3f& position : parts_of(scene).at("rays")->positions) {
        ASSERT_GT(position.length(), 2.0F - 1e-3F);
    }
}

TEST(Model, OnlyTheTargetIsTransparent) {
    const scene::Scene scene =
        modelled(test::camera_of("camera c { map u = 1 .. -1, v = -1 .. 1 eye plane((-1, 0, 0))\n"
                                 "toward plane((1, 0, 0)) }"));
    for (const scene::Material& material : scene.materials) {
        EXPECT_EQ(material.alpha_mode == scene::AlphaMode::blend, material.name == "target")
            << material.name;
    }
}

}  // namespace
}  // namespace balcony::analyse::model_test

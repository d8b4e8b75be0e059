// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What is computed for the rays of a packet together, against the same for one ray.

#include "shading/surfaces/surface_lanes.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "balcony/rays.hpp"
#include "render/job/camera_rays.hpp"
#include "support.hpp"

namespace balcony::render::surface_lanes_test {

namespace {

using namespace test;
using embree::Packet;

// The derivatives of the origin by x and by y leave the range of Embree at some places.
TEST(PacketLanes, DifferentialsAreThoseOfEachRay) {
    const auto origin = [](const camera::ParameterPoint& p, camera::Emitter& emit) {
        return camera::ObjectPoint{exp(emit(60.0) * p.v), exp(emit(60.0) * p.u), sin(p.v)};
    };
    const auto direction = [](const camera::ParameterPoint& p, camera::Emitter& emit) {
        return camera::ObjectVector{sin(p.v), cos(p.u), emit(-2.0)};
    };
    constexpr std::size_t width = 22;
    constexpr std::size_t height = 11;
    const auto program =
        rays::compile(test::make_camera({origin, direction}), width, height, {.footprints = true});
    ASSERT_TRUE(program);
    rays::Scratch scratch;
    rays::RayBatch batch;
    program->run(rays::Tile{.width = width, .height = height}, scratch, batch);
    constexpr double part = 0.37;
    std::size_t out_of_range = 0;
    packet_lanes::Differentials found;
    for (std::size_t top = 0; top < height; top += Packet::side) {
        for (std::size_t left = 0; left < width; left += Packet::side) {
            set_differentials(batch, {width, left, top}, {}, part, found);
            for (std::size_t lane = 0; lane < Packet::size; ++lane) {
                const std::size_t x = left + lane % Packet::side;
                const std::size_t y = top + lane / Packet::side;
                if (x >= width || y >= height) {
                    continue;
                }
                const RayDifferentials expected = differentials(batch, y * width + x, 0, part);
                EXPECT_EQ(found.of(lane).origin_x, expected.origin_x);
                EXPECT_EQ(found.of(lane).origin_y, expected.origin_y);
                EXPECT_EQ(found.of(lane).direction_x, expected.direction_x);
                EXPECT_EQ(found.of(lane).direction_y, expected.direction_y);
                out_of_range += expected.origin_x == V3f(0.0F) ? 1 : 0;
            }
        }
    }
    EXPECT_GT(out_of_range, 0U);
    EXPECT_LT(out_of_range, batch.size());
}

// A strip of triangles with coordinates in an image, none of them thin.
scene::Mesh strip(std::mt19937& random) {
    std::uniform_real_distribution<float> shift(-0.2F, 0.2F);
    scene::Mesh mesh;
    for (std::uint32_t i = 0; i < 12; ++i) {
        const auto along = static_cast<float>(i / 2);
        const auto across = static_cast<float>(i % 2);
        mesh.positions.emplace_back(along + shift(random), across + shift(random), shift(random));
        mesh.texture_coordinates[0].emplace_back(along + shift(random), shift(random) - across);
    }
    for (std::uint32_t i = 0; i + 2 < mesh.positions.size(); ++i) {
        mesh.triangles.push_back({i, i + 1, i + 2});
    }
    return mesh;
}

V3f random_vector(std::mt19937& random) {
    std::normal_distribution<float> component;
    return {component(random), component(random), component(random)};
}

// Rays from random places to random points of one triangle or of several, and
// the mesh in the world or placed by a matrix.
TEST(SurfaceLanes, FootprintsAreThoseOfEachRay) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> share(0.0F, 0.5F);
    for (int trial = 0; trial < 40; ++trial) {
        scene::Scene scene;
        scene::M44d matrix;
        matrix.setScale(V3d(2.0, 0.5, -1.5));
        matrix.rotate(V3d(0.4, -0.3, 0.8));
        add(scene, strip(random), white(), matrix);
        const SurfaceFinder surfaces(scene);
        const PlacedMesh mesh = *surfaces.mesh_at_rest(0);
        scene::TextureUse use;
        use.offset = {0.3F, -0.7F};
        use.u_axis = {0.8F, 0.6F};
        use.v_axis = {-1.2F, 0.9F};

        const bool is_placed = trial % 2 == 0;
        const bool one_triangle = trial % 4 < 2;
        const std::uint32_t lanes = trial % 8 < 4 ? 0xffffU : 0x5e1bU;
        Packet packet;
        packet_lanes::Differentials differentials;
        for (std::size_t lane = 0; lane < Packet::size; ++lane) {
            packet.valid[lane] = -1;
            packet.geometry[lane] = 0;
            packet.placement[lane] = is_placed ? 0 : embree::Hit::nothing;
            packet.triangle[lane] =
                one_triangle ? 3
                             : static_cast<std::uint32_t>(random() % mesh.mesh->triangles.size());
            packet.u[lane] = share(random);
            packet.v[lane] = share(random);
            const Surface surface = surfaces.find(packet.hit(lane), V3f(0.0F, 0.0F, 1.0F));
            V3f direction;
            do {
                direction = random_vector(random).normalized();
            } while (std::abs(direction.dot(surface.geometric_normal)) < 0.2F);
            packet.set(lane, {.origin = surface.position - (1.0F + share(random)) * direction,
                              .direction = direction});
            differentials.set(lane, {random_vector(random), random_vector(random),
                                     random_vector(random), random_vector(random)});
        }

        on_each_target([&] {
            texture_lanes::Footprints found;
            surface_lanes::set_footprints(packet, lanes, mesh, differentials, use, found);
            for (std::size_t lane = 0; lane < Packet::size; ++lane) {
                SCOPED_TRACE(lane);
                const std::size_t like = (lanes >> lane & 1U) != 0
                                             ? lane
                                             : static_cast<std::size_t>(std::countr_zero(lanes));
                const DifferentialRay ray{packet.origin(like), packet.direction(like),
                                          differentials.of(like)};
                const Surface surface = surfaces.find(packet.hit(like), ray.direction);
                const TextureFootprint expected = surface.in_mesh.texture_footprint(
                    use, surface.triangle_footprint(surface.transfer(ray)));
                EXPECT_NE(expected.along_x, V2f(0.0F));
                EXPECT_EQ(found.at.of(lane), expected.at);
                EXPECT_EQ(found.along_x.of(lane), expected.along_x);
                EXPECT_EQ(found.along_y.of(lane), expected.along_y);
            }
        });
    }
}

// Among the normals of corners are some that face away from the viewer, are short, or cancel.
TEST(SurfaceLanes, CosinesAreThoseOfEachRay) {
    std::mt19937 random(17);
    std::uniform_real_distribution<float> share(0.0F, 0.5F);
    scene::M44d matrix;
    matrix.setScale(V3d(2.0, 0.5, -1.5));
    matrix.rotate(V3d(0.4, -0.3, 0.8));
    std::size_t bent = 0;
    for (int trial = 0; trial < 60; ++trial) {
        SCOPED_TRACE(trial);
        scene::Scene scene;
        scene::Mesh mesh = strip(random);
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            mesh.normals.push_back((trial % 5 == 0 ? 1e-15F : 1.0F) * random_vector(random));
        }
        add(scene, mesh, white(), trial % 2 == 0 ? matrix : scene::M44d());
        const SurfaceFinder surfaces(scene);
        surface_lanes::Look look;
        look.is_plain = look.is_smooth = true;
        look.base_color = Imath::Color3f(1.0F);
        look.mesh = *surfaces.mesh_at_rest(0);
        Packet packet;
        std::array<float, Packet::size> expected{};
        for (std::size_t lane = 0; lane < Packet::size; ++lane) {
            packet.set(lane,
                       {.origin = V3f(0.0F), .direction = random_vector(random).normalized()});
            packet.geometry[lane] = 0;
            packet.placement[lane] = embree::Hit::nothing;
            packet.triangle[lane] =
                trial % 3 == 0 ? 3 : static_cast<std::uint32_t>(random() % mesh.triangles.size());
            packet.u[lane] = share(random);
            packet.v[lane] = share(random);
            const V3f direction = packet.direction(lane);
            const Surface surface = surfaces.find(packet.hit(lane), direction);
            const V3f normal = surface.edge_1.cross(surface.edge_2);
            packet.normal_x[lane] = normal.x;
            packet.normal_y[lane] = normal.y;
            packet.normal_z[lane] = normal.z;
            expected[lane] = std::abs(surface.smooth_normal.dot(direction));
            bent += expected[lane] < 1.1e-3F ? 1 : 0;
        }
        on_each_target([&] {
            surface_lanes::Lit lit{};
            surface_lanes::Radiances radiances{};
            surface_lanes::light(packet, std::span(&look, 1), lit, radiances);
            EXPECT_EQ(radiances.color.x, expected);
        });
    }
    EXPECT_GT(bent, 50U);
}

TEST(SurfaceLanes, EachHitIsInTheGroupOfItsInstance) {
    std::mt19937 random(8);
    const auto below = [&](std::uint32_t count) {
        return static_cast<std::uint32_t>(random() % count);
    };
    for (int trial = 0; trial < 100; ++trial) {
        Packet packet;
        for (std::size_t lane = 0; lane < Packet::size; ++lane) {
            packet.geometry[lane] = below(5) != 0 ? below(3) : embree::Hit::nothing;
            packet.placement[lane] = below(2) != 0 ? 1 + below(4) : embree::Hit::nothing;
        }
        surface_lanes::Groups groups;
        surface_lanes::find_groups(packet, groups);
        std::array<int, Packet::size> times{};
        for (const surface_lanes::Group& group : groups.all()) {
            for (std::size_t lane = 0; lane < Packet::size; ++lane) {
                if (group.has(lane)) {
                    ++times[lane];
                    EXPECT_EQ(group.instance, packet.instance(lane));
                }
            }
        }
        for (std::size_t lane = 0; lane < Packet::size; ++lane) {
            EXPECT_EQ(times[lane], packet.any(lane) ? 1 : 0);
        }
    }
}

}  // namespace

}  // namespace balcony::render::surface_lanes_test

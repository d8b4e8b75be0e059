// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Packets are set, prepared, lit, written and summed in registers of any width with the same bits.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "film/sums/sample_sums.hpp"
#include "render/embree/packet_setup.hpp"
#include "render/job/camera_rays.hpp"
#include "shading/surfaces/surface_lanes.hpp"
#include "shading/textures/texture_lanes.hpp"
#include "support.hpp"

namespace balcony::render::lanes_test {

namespace {

using namespace test;
using embree::Packet;

template <class T>
std::vector<std::byte> bytes_of(const T& value) {
    std::vector<std::byte> bytes(sizeof(T));
    std::memcpy(bytes.data(), &value, sizeof(T));
    return bytes;
}

TEST(SampleSums, TheFirstSamplesAreThoseAddedToZero) {
    constexpr float infinite = std::numeric_limits<float>::infinity();
    const std::array<Color4f, 5> samples{Color4f(-0.0F, 0.0F, 1.0F, 0.1F),
                                         Color4f(1e-42F, -3e38F, infinite, -infinite),
                                         Color4f(0.3F), Color4f(-7.25F), Color4f(-0.0F)};
    on_each_target([&] {
        for (std::size_t count = 0; count <= samples.size(); ++count) {
            std::vector<Color4d> first(count + 1, Color4d(5.0));
            std::vector<Color4d> added(count + 1, Color4d(0.0));
            added[count] = Color4d(5.0);
            set_first_samples(samples.data(), count, first.data());
            finish_first_samples();
            add_samples(samples.data(), count, added.data());
            for (std::size_t i = 0; i < count; ++i) {
                EXPECT_EQ(bytes_of(added[i]), bytes_of(Color4d(0.0) + Color4d(samples[i])));
            }
            for (std::size_t i = 0; i <= count; ++i) {
                EXPECT_EQ(bytes_of(first[i]), bytes_of(added[i])) << i << " of " << count;
            }
        }
    });
}

// Rays that leave the range of Embree, are not there or have no direction at some places.
TEST(PacketLanes, RaysAreThoseOfEachPoint) {
    const auto origin = [](const camera::ParameterPoint& p, camera::Emitter& emit) {
        emit.require(p.u < emit(0.8));
        return camera::ObjectPoint{exp(emit(60.0) * p.v), cos(p.u), sin(p.v)};
    };
    const auto direction = [](const camera::ParameterPoint& p, camera::Emitter& emit) {
        return camera::ObjectVector{sin(p.v), cos(p.u), emit(-2.0)};
    };
    constexpr std::size_t width = 30;
    constexpr std::size_t height = 10;
    const auto program = rays::compile(test::make_camera({origin, direction}), width, height, {});
    ASSERT_TRUE(program);
    rays::Scratch scratch;
    rays::RayBatch batch;
    program->run(rays::Tile{.width = width, .height = height}, scratch, batch);
    on_each_target([&] {
        std::size_t found = 0;
        for (std::size_t top = 0; top < height; top += Packet::side) {
            std::array<Packet, (width + Packet::side - 1) / Packet::side> packets;
            set_packets(batch, {width, 0, top}, {}, 0.25F, packets);
            for (std::size_t x = 0; x < packets.size() * Packet::side; ++x) {
                for (std::size_t row = 0; row < Packet::side; ++row) {
                    const Packet& packet = packets[x / Packet::side];
                    const std::size_t lane = row * Packet::side + x % Packet::side;
                    const std::size_t i = (top + row) * width + x;
                    const bool expected = x < width && top + row < height && traceable(batch, i);
                    ASSERT_EQ(packet.valid[lane], expected ? -1 : 0) << x << ", " << top + row;
                    if (expected) {
                        ++found;
                        EXPECT_EQ(packet.origin(lane), V3f(batch.origin(i)));
                        EXPECT_EQ(packet.direction(lane), V3f(batch.direction(i)));
                        EXPECT_EQ(packet.time[lane], 0.25F);
                        EXPECT_EQ(packet.farthest[lane], std::numeric_limits<float>::infinity());
                    }
                }
            }
        }
        EXPECT_GT(found, width * height / 4);
        EXPECT_LT(found, 9 * width * height / 10);
    });
}

TEST(PacketSetup, WhatCannotBeTracedHasANegativeLength) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float reach = 100.0F;
    const embree::Ray good{.origin = {1.0F, -reach, 3.0F}, .direction = {0.6F, -1e-30F, 0.8F}};
    std::vector<embree::Ray> bad(8, good);
    bad[0].origin.x = 1.01F * reach;
    bad[1].origin.z = nan;
    bad[2].direction.y = nan;
    bad[3].direction.z = 2.0F * embree::max_coordinate;
    bad[4].time = 1.5F;
    bad[5].time = -0.1F;
    bad[6].farthest = -1.0F;
    bad[7].origin.y = -1.01F * reach;
    on_each_target([&] {
        Packet packet;
        for (std::size_t lane = 0; lane < bad.size(); ++lane) {
            packet.set(lane, good);
            packet.set(lane + bad.size(), bad[lane]);
        }
        packet.valid[1] = 0;
        embree::prepare(std::span(&packet, 1), reach);
        for (std::size_t lane = 0; lane < Packet::size; ++lane) {
            EXPECT_EQ(packet.farthest[lane] < 0.0F, lane == 1 || lane >= bad.size()) << lane;
            EXPECT_TRUE(embree::in_range(packet.origin(lane)));
            EXPECT_TRUE(embree::in_range(packet.direction(lane)));
            EXPECT_FALSE(packet.any(lane));
        }
        EXPECT_EQ(packet.origin(0), good.origin);
        EXPECT_EQ(packet.direction(0), V3f(0.6F, -embree::min_component, 0.8F));
    });
}

// A mesh of random triangles, with normals or without; one vertex has none.
scene::Mesh random_mesh(std::mt19937& random, bool with_normals) {
    std::normal_distribution<float> component;
    const auto vector = [&] {
        return V3f(component(random), component(random), component(random));
    };
    scene::Mesh mesh;
    for (std::uint32_t i = 0; i < 12; ++i) {
        mesh.positions.push_back(vector());
        if (with_normals) {
            mesh.normals.push_back(i < 3 ? V3f(0.0F) : vector());
        }
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

// Hits of random instances below a number; the last one stands for nothing.
Packet random_packet(std::mt19937& random, std::uint32_t instances, bool one_triangle) {
    std::uniform_real_distribution<float> share(0.0F, 0.5F);
    const auto triangle = [&] { return static_cast<std::uint32_t>(random() % 10); };
    const std::uint32_t one = triangle();
    Packet packet;
    for (std::size_t lane = 0; lane < Packet::size; ++lane) {
        packet.set(lane, {.origin = V3f(0.0F), .direction = random_vector(random).normalized()});
        packet.valid[lane] = random() % 8 != 0 ? -1 : 0;
        const auto instance = static_cast<std::uint32_t>(random() % instances);
        packet.geometry[lane] = instance + 1 < instances ? instance : embree::Hit::nothing;
        packet.placement[lane] = embree::Hit::nothing;
        packet.triangle[lane] = one_triangle ? one : triangle();
        packet.u[lane] = share(random);
        packet.v[lane] = share(random);
        const V3f normal = random_vector(random);
        packet.normal_x[lane] = normal.x;
        packet.normal_y[lane] = normal.y;
        packet.normal_z[lane] = normal.z;
    }
    return packet;
}

// Calls check() on each instruction set; it returns bytes, which must be the same on all.
void expect_same_bytes(const std::function<std::vector<std::byte>()>& check) {
    std::vector<std::byte> expected;
    on_each_target([&] {
        const std::vector<std::byte> found = check();
        if (expected.empty()) {
            expected = found;
        }
        EXPECT_EQ(found, expected);
    });
}

TEST(SurfaceLanes, LightIsTheSameOnAllMachines) {
    std::mt19937 random(11);
    const scene::Mesh flat = random_mesh(random, false);
    const scene::Mesh smooth = random_mesh(random, true);
    std::array<surface_lanes::Look, 3> looks{};  // The last one is not plain.
    looks[0].is_plain = looks[1].is_plain = looks[1].is_smooth = true;
    looks[0].base_color = {0.8F, 0.5F, 0.2F};
    looks[0].emission = {0.1F, 0.0F, 2.0F};
    looks[0].mesh.mesh = &flat;
    looks[1].base_color = {0.3F, 0.9F, 0.7F};
    looks[1].mesh.mesh = &smooth;
    for (int trial = 0; trial < 50; ++trial) {
        const Packet packet = random_packet(random, 4, trial % 3 == 0);
        SCOPED_TRACE(trial);
        expect_same_bytes([&] {
            surface_lanes::Lit lit{};
            surface_lanes::Radiances radiances{};
            surface_lanes::light(packet, looks, lit, radiances);
            radiances.set(5, {std::numeric_limits<float>::quiet_NaN(), 1.0F, 1.0F, 1.0F});
            std::array<Color4f, Packet::size> colors;
            std::uint64_t broken = 0;
            constexpr LaneBits counted = 0x7ff3U;
            const auto counts = surface_lanes::write(packet, radiances, counted, Packet::side,
                                                     colors.data(), broken);
            EXPECT_EQ(broken, 1U);
            EXPECT_EQ(colors[5], Color4f(0.0F));
            std::size_t missing = 0;
            std::size_t shown = 0;
            for (std::size_t lane = 0; lane < Packet::size; ++lane) {
                const bool counts_here = (counted >> lane & 1U) != 0;
                missing += counts_here && packet.valid[lane] == 0 ? 1 : 0;
                shown += counts_here && colors[lane].a > 0.0F ? 1 : 0;
                if (lane != 5) {
                    EXPECT_EQ(colors[lane].a, packet.geometry[lane] < 2 ? 1.0F : 0.0F);
                }
            }
            EXPECT_EQ(counts.missing, missing);
            EXPECT_EQ(counts.shown, shown);
            return bytes_of(colors);
        });
    }
}

// All inside an image of 64 by 64 texels, or some of them beyond its border.
TEST(TextureLanes, MeansAreTheSameOnAllMachines) {
    std::mt19937 random(3);
    ImageLevels levels{.width = 64, .height = 64, .last = 6};
    std::int32_t count = 0;
    for (std::int32_t level = 0; level <= levels.last; ++level) {
        levels.first[static_cast<std::size_t>(level)] = count;
        count += 1 << 2 * (levels.last - level);
    }
    const TexelBlock texels(4 * static_cast<std::size_t>(count));
    std::generate_n(texels.data(), 4 * count, [&] { return static_cast<std::byte>(random()); });
    for (int trial = 0; trial < 100; ++trial) {
        const float border = trial % 2 == 0 ? 0.4F : -1.0F;
        levels.interpolated = trial % 4 < 2;
        std::uniform_real_distribution<float> place(border, 1.0F - border);
        std::uniform_real_distribution<float> change(-0.06F, 0.06F);
        texture_lanes::Footprints asked;
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
            asked.at.set(lane, {place(random), place(random)});
            asked.along_x.set(lane, {change(random), change(random)});
            asked.along_y.set(lane, {change(random), change(random)});
        }
        SCOPED_TRACE(trial);
        expect_same_bytes([&] {
            LaneVectors colors;
            texture_lanes::set_means(levels, texels, ByteScale::of(TextureEncoding::srgb), asked,
                                     colors);
            return bytes_of(colors);
        });
    }
}

}  // namespace

}  // namespace balcony::render::lanes_test

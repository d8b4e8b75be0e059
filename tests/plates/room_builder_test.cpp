// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The furnished room: what its README states of it.

#include "scenes/room/room.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace balcony::plates::room_builder_test {

namespace {

using Imath::Box3f;
using Imath::V3d;

const scene::Scene& room() {
    static const Result<scene::Scene> made = make_room({.texture_scale = 0.04});
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    return *made;
}

// The distance of a segment from the z axis, seen from above.
double distance_from_axis(const V3d& a, const V3d& b) {
    const V3d from(a.x, a.y, 0.0);
    const V3d way = V3d(b.x, b.y, 0.0) - from;
    const double along =
        way.length2() > 0.0 ? std::clamp(-from.dot(way) / way.length2(), 0.0, 1.0) : 0.0;
    return (from + way * along).length();
}

TEST(RoomBuilder, IsLeanAndHasNamedObjects) {
    EXPECT_LT(room().triangle_count(), 300'000U);
    std::set<std::string> names;
    for (const scene::Object& object : room().objects) {
        EXPECT_TRUE(names.insert(object.name).second) << object.name;
    }
    for (const char* name : {"fireplace", "dresser", "globe", "clock", "curtain 4", "plant",
                             "armchair", "table", "chair 2", "bowl", "sofa", "coffee table", "vase",
                             "magazine", "floor lamp", "bookcase", "poster", "door", "rug"}) {
        EXPECT_TRUE(names.contains(name)) << name;
    }
}

TEST(RoomBuilder, IsAsLargeAsStated) {
    // Behind the windows of the wall y = 2.5 are the panes with their frames.
    const Box3f bounds = room().bounds();
    EXPECT_NEAR(bounds.min.x, -3.5, 1e-5);
    EXPECT_NEAR(bounds.max.x, 3.5, 1e-5);
    EXPECT_NEAR(bounds.min.y, -2.5, 1e-5);
    EXPECT_NEAR(bounds.max.y, 2.74, 1e-5);
    EXPECT_NEAR(bounds.min.z, 0.0, 1e-5);
    EXPECT_NEAR(bounds.max.z, 2.9, 1e-5);
}

TEST(RoomBuilder, LeavesItsMiddleFree) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const scene::Instance& instance : room().instances) {
        const scene::Mesh& mesh = room().meshes[instance.mesh.value()];
        for (const auto& triangle : mesh.triangles) {
            for (std::size_t k = 0; k < 3; ++k) {
                V3d a = V3d(mesh.positions[triangle[k]]) * instance.world_from_mesh;
                V3d b = V3d(mesh.positions[triangle[(k + 1) % 3]]) * instance.world_from_mesh;
                if (std::max(a.z, b.z) > 0.5 && std::min(a.z, b.z) < 2.8) {
                    nearest = std::min(nearest, distance_from_axis(a, b));
                }
            }
        }
    }
    EXPECT_GE(nearest, 0.8);
}

}  // namespace

}  // namespace balcony::plates::room_builder_test

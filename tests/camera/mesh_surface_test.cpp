// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// The surface of a mesh: the right triangle at every point, its affine map, its normals.

#include <numbers>
#include <random>

#include "support.hpp"

namespace balcony::camera::mesh_surface_test {

namespace {

using Corner = TexturedMesh::Corner;
using Triangle = std::array<Corner, 3>;

Given mesh_of(std::vector<Triangle> triangles, std::string_view normals = "smooth") {
    return {{"file", std::make_shared<const TexturedMesh>(TexturedMesh{std::move(triangles)})},
            {"normals", std::string(normals)}};
}

/// What a mesh says at (u, v), by the scalar definitions.
class MeshProbe {
public:
    explicit MeshProbe(const Given& given) : points_(object("mesh", given)) {
        Emitter emit(graph_);
        const auto n =
            object("mesh", given)->normal({graph_.picture_x(), graph_.picture_y()}, emit);
        roots_ = {n->x, n->y, n->z};
    }
    [[nodiscard]] Sample operator()(double u, double v) const { return points_(u, v); }
    [[nodiscard]] Vector normal(double u, double v) const {
        const std::vector<double> r = expr::evaluate(roots_, {u, v, 0.0, {}});
        return {r[0], r[1], r[2]};
    }

private:
    GeneratorProbe points_;
    Graph graph_;
    std::vector<Expr> roots_;
};

/// The unit square cut into an irregular grid of triangles, with corners placed by a function.
template <class CornerOf>
std::vector<Triangle> square(std::size_t side, const CornerOf& corner_of) {
    const auto knot = [side](std::size_t i) {
        const double s = static_cast<double>(i) / static_cast<double>(side);
        return s * (0.4 + 0.6 * s);
    };
    std::vector<Triangle> made;
    for (std::size_t i = 0; i < side; ++i) {
        for (std::size_t k = 0; k < side; ++k) {
            const Corner a = corner_of(knot(i), knot(k));
            const Corner b = corner_of(knot(i + 1), knot(k));
            const Corner c = corner_of(knot(i + 1), knot(k + 1));
            const Corner d = corner_of(knot(i), knot(k + 1));
            made.push_back({a, b, c});
            made.push_back({c, d, a});
        }
    }
    return made;
}

Corner on_plane(double u, double v) {
    return {{1.0 + 2.0 * u - v, 3.0 * v, 0.5 * u}, {0.0, 0.0, 1.0}, {u, v}};
}

Corner on_cylinder(double u, double v) {
    const double angle = 2.0 * std::numbers::pi * u;
    return {{std::cos(angle), std::sin(angle), v}, {std::cos(angle), std::sin(angle), 0.0}, {u, v}};
}

}  // namespace

TEST(MeshSurface, ARuledPlaneIsThePlaneEverywhere) {
    const MeshProbe mesh(mesh_of(square(7, on_plane)));
    // Steps of a third of a knot meet corners and edges as well as insides; the ends belong to it.
    for (int i = 0; i <= 300; ++i) {
        for (int k = 0; k <= 30; ++k) {
            const double u = i / 300.0;
            const double v = k / 30.0;
            const Sample s = mesh(u, v);
            ASSERT_TRUE(s.valid) << u << ' ' << v;
            // Some ten operations on numbers below 10.
            expect_near(s.point, on_plane(u, v).position, 2e-14);
            expect_near(s.along_u, {2.0, 0.0, 0.5}, 2e-13);
            expect_near(s.along_v, {-1.0, 3.0, 0.0}, 2e-13);
        }
    }
}

TEST(MeshSurface, ThereAreNoGapsAlongEdgesAndAtCorners) {
    const std::vector<Triangle> triangles = square(9, on_plane);
    const MeshProbe mesh(mesh_of(triangles));
    for (const Triangle& t : triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            const auto& a = t[i].uv;
            const auto& b = t[(i + 1) % 3].uv;
            for (const double s : {0.0, 1e-12, 0.3, 0.5, 0.77}) {
                EXPECT_TRUE(mesh(a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])).valid);
            }
        }
    }
}

TEST(MeshSurface, OutsideOfItsTrianglesThereIsNothing) {
    std::vector<Triangle> triangles = square(7, on_plane);
    const MeshProbe whole(mesh_of(triangles));
    for (const double outside : {-1e-6, 1.0 + 1e-6, 1e300, -1e300}) {
        EXPECT_FALSE(whole(outside, 0.5).valid);
        EXPECT_FALSE(whole(0.5, outside).valid);
    }
    EXPECT_FALSE(whole(std::nan(""), 0.5).valid);
    const Triangle missing = triangles[31];
    triangles.erase(triangles.begin() + 31);
    const auto middle = [&missing](std::size_t k) {
        return (missing[0].uv[k] + missing[1].uv[k] + missing[2].uv[k]) / 3.0;
    };
    EXPECT_TRUE(whole(middle(0), middle(1)).valid);
    EXPECT_FALSE(MeshProbe(mesh_of(triangles))(middle(0), middle(1)).valid);
}

// Against a search through all triangles, with small ones and ones that cover half of the square,
// one over the other: the first of the file counts.
TEST(MeshSurface, OfTrianglesThatOverlapTheFirstCounts) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> place(0.0, 1.0);
    std::vector<Triangle> triangles;
    for (int i = 0; i < 300; ++i) {
        const double size = i % 10 == 0 ? 1.0 : 0.05;
        const double u = place(random), v = place(random);
        Triangle t;
        for (Corner& corner : t) {
            // The height tells the triangle's number.
            const std::array uv{u + size * place(random), v + size * place(random)};
            corner = {{uv[0], uv[1], static_cast<double>(i)}, {0.0, 0.0, 1.0}, uv};
        }
        triangles.push_back(t);
    }
    const auto contains = [](const Triangle& t, double u, double v) {
        const auto turn = [&](std::size_t a, std::size_t b) {
            return (t[b].uv[0] - t[a].uv[0]) * (v - t[a].uv[1]) -
                   (t[b].uv[1] - t[a].uv[1]) * (u - t[a].uv[0]);
        };
        const double x = turn(0, 1), y = turn(1, 2), z = turn(2, 0);
        return (x > 0.0 && y > 0.0 && z > 0.0) || (x < 0.0 && y < 0.0 && z < 0.0);
    };
    const MeshProbe mesh(mesh_of(triangles));
    int found = 0;
    for (int i = 0; i < 20'000; ++i) {
        const double u = 2.0 * place(random), v = 2.0 * place(random);
        const auto first = std::find_if(triangles.begin(), triangles.end(),
                                        [&](const Triangle& t) { return contains(t, u, v); });
        const Sample s = mesh(u, v);
        ASSERT_EQ(s.valid, first != triangles.end()) << u << ' ' << v;
        if (s.valid) {
            ++found;
            // Slivers have steep maps: some 1e5 units of rounding of a number up to 300.
            ASSERT_NEAR(s.point[2], static_cast<double>(first - triangles.begin()), 1e-8);
        }
    }
    EXPECT_GT(found, 5000);
}

TEST(MeshSurface, SmoothNormalsAreThoseOfTheCorners) {
    const std::vector<Triangle> triangles = square(6, on_cylinder);
    const MeshProbe mesh(mesh_of(triangles));
    for (const Triangle& t : triangles) {
        for (const Corner& corner : t) {
            expect_near(mesh.normal(corner.uv[0], corner.uv[1]), corner.normal, 1e-7);
        }
        const auto middle = [&](std::size_t k) { return (t[0].uv[k] + t[1].uv[k]) / 2.0; };
        const Vector between = 0.5 * (Vector(t[0].normal) - (-1.0 * Vector(t[1].normal)));
        expect_near(mesh.normal(middle(0), middle(1)), between, 1e-7);
    }
}

TEST(MeshSurface, FlatNormalsAreAcrossTheFaceOnTheSideOfTheCorners) {
    std::vector<Triangle> triangles = square(6, on_cylinder);
    // Winding does not matter, here or in texture coordinates.
    std::swap(triangles[5][0], triangles[5][2]);
    const MeshProbe mesh(mesh_of(triangles, "flat"));
    for (const Triangle& t : triangles) {
        const double u = (t[0].uv[0] + t[1].uv[0] + t[2].uv[0]) / 3.0;
        const double v = (t[0].uv[1] + t[1].uv[1] + t[2].uv[1]) / 3.0;
        const Vector normal = mesh.normal(u, v);
        const Sample s = mesh(u, v);
        EXPECT_NEAR(length(normal), 1.0, 1e-14);
        EXPECT_NEAR(dot(normal, s.along_u), 0.0, 1e-13 * length(s.along_u));
        EXPECT_NEAR(dot(normal, s.along_v), 0.0, 1e-13 * length(s.along_v));
        EXPECT_GT(dot(normal, t[0].normal), 0.5);
    }
}

TEST(MeshSurface, WhatHasNoAreaIsLeftOut) {
    std::vector<Triangle> triangles = square(3, on_plane);
    const double nan = std::nan("");
    Triangle flat = triangles[0], thin = triangles[1], broken = triangles[2];
    flat[1].uv = flat[0].uv;
    thin[1].position = thin[0].position;
    broken[2].position[1] = nan;
    const std::vector<Triangle> wrong{flat, thin, broken};
    EXPECT_FALSE(try_stage(StageKind::object_generator, "mesh", mesh_of(wrong)));
    triangles.insert(triangles.begin(), wrong.begin(), wrong.end());
    const MeshProbe mesh(mesh_of(triangles));
    expect_near(mesh(0.05, 0.02).point, on_plane(0.05, 0.02).position, 1e-14);
}

}  // namespace balcony::camera::mesh_surface_test

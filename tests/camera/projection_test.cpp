// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The object transformer `project`, the surfaces that it projects onto, and walls.

#include <algorithm>
#include <functional>

#include "support.hpp"

namespace balcony::camera::projection_test {

namespace {

constexpr double width = 60.0;
constexpr double height = 40.0;
const Vector from{-1.0, 0.4, 0.3};

Arguments::Value surface(std::string_view name, const Given& given = {}) {
    return std::static_pointer_cast<const Stage>(object(name, given));
}

/// Rays that start where points of the plane x = 0 are projected, with the vector from there.
CameraProbe projected(const Given& given) {
    Camera::Parts parts;
    parts.name = "test";
    parts.eye = {range(0.8, -0.8, -0.5, 0.5), {}, object("plane"), {move("project", given)}};
    parts.toward = Path{range(0.8, -0.8, -0.5, 0.5), {}, object("plane"), {}};
    parts.look = look("relative");
    return {camera(std::move(parts)), width, height};
}

Vector plane_point(double x, double y) { return {0.0, 0.8 - 1.6 * x / width, 0.5 - y / height}; }

/// Checks every ray against an independent search: distances s along from + s way, all of them.
void expect_hits(const Given& given,
                 const std::function<std::vector<double>(const Vector& way)>& all,
                 bool last = false) {
    const CameraProbe probe = projected(given);
    int hits = 0;
    for (double x = 0.5; x < width; x += 1.0) {
        for (double y = 0.5; y < height; y += 3.0) {
            const Vector way = plane_point(x, y) - from;
            std::vector<double> s = all(way);
            s.erase(std::remove_if(s.begin(), s.end(), [](double a) { return !(a > 1e-9); }),
                    s.end());
            const Ray ray = probe(x, y);
            ASSERT_EQ(ray.valid, !s.empty()) << x << ", " << y;
            if (!s.empty()) {
                const double wanted = last ? *std::max_element(s.begin(), s.end())
                                           : *std::min_element(s.begin(), s.end());
                expect_near(ray.origin - from, wanted * way, 1e-9);
                ++hits;
            }
        }
    }
    EXPECT_GT(hits, 50);
}

/// A grid over the surface x = 3 + waves.
TexturedMesh waves() {
    const auto corner = [](int i, int k) {
        const double y = 2.0 - 0.1 * i, z = -1.5 + 0.1 * k;
        TexturedMesh::Corner made;
        made.position = {3.0 + std::sin(5.0 * y) + 0.3 * z, y, z};
        made.normal = {-1.0, 0.0, 0.0};
        made.uv = {0.025 * i, 0.03 * k};
        return made;
    };
    TexturedMesh made;
    for (int i = 0; i < 40; ++i) {
        for (int k = 0; k < 30; ++k) {
            made.triangles.push_back({corner(i, k), corner(i + 1, k), corner(i + 1, k + 1)});
            made.triangles.push_back({corner(i, k), corner(i + 1, k + 1), corner(i, k + 1)});
        }
    }
    return made;
}

/// By three areas seen from the origin of the ray, without a tree.
std::vector<double> distances(const TexturedMesh& mesh, const Vector& way) {
    std::vector<double> all;
    for (const auto& t : mesh.triangles) {
        const Vector a = t[0].position - from, b = t[1].position - from, c = t[2].position - from;
        const double ab = dot(cross(a, b), way), bc = dot(cross(b, c), way),
                     ca = dot(cross(c, a), way);
        if ((ab >= 0.0 && bc >= 0.0 && ca >= 0.0) || (ab <= 0.0 && bc <= 0.0 && ca <= 0.0)) {
            const Vector n = cross(b - a, c - a);
            all.push_back(dot(n, a) / dot(n, way));
        }
    }
    return all;
}

std::vector<double> roots(double a, double b, double c) {
    const double discriminant = b * b - 4.0 * a * c;
    if (discriminant < 0.0) {
        return {};
    }
    return {(-b - std::sqrt(discriminant)) / (2.0 * a), (-b + std::sqrt(discriminant)) / (2.0 * a)};
}

std::string error_of(StageKind kind, std::string_view name, const Given& given) {
    const auto made = try_stage(kind, name, given);
    EXPECT_FALSE(made);
    return made.diagnostics.empty() ? "" : made.diagnostics.front().message;
}

Given wall_of(const Vector& lower_left, const Vector& lower_right, const Vector& upper_left) {
    const auto triple = [](const Vector& a) { return numbers({a[0], a[1], a[2]}); };
    return {{"lower_left", triple(lower_left)},
            {"lower_right", triple(lower_right)},
            {"upper_left", triple(upper_left)}};
}

}  // namespace

TEST(Project, ReachesTheFirstOrLastPointOfAQuadricAlongTheLine) {
    const Vector at{0.5, 0.1, -0.2};
    const Vector o = from - at;
    for (const bool last : {false, true}) {
        for (const double radius : {0.5, 4.0}) {
            Given given{{"from", numbers({from[0], from[1], from[2]})},
                        {"at", numbers({at[0], at[1], at[2]})},
                        {"hit", std::string(last ? "last" : "first")},
                        {"onto", surface("sphere", {{"radius", numbers({radius})}})}};
            expect_hits(
                given,
                [&](const Vector& d) {
                    return roots(dot(d, d), 2.0 * dot(o, d), dot(o, o) - radius * radius);
                },
                last);
            given.insert_or_assign("onto", surface("cylinder", {{"radius", numbers({radius})}}));
            expect_hits(
                given,
                [&](const Vector& d) {
                    return roots(d[0] * d[0] + d[1] * d[1], 2.0 * (o[0] * d[0] + o[1] * d[1]),
                                 o[0] * o[0] + o[1] * o[1] - radius * radius);
                },
                last);
        }
    }
}

TEST(Project, ReachesPlanesAndWallsOnlyAhead) {
    const Vector at{1.0, 0.0, 0.0}, u{0.4, 1.0, 0.0}, v{0.2, 0.0, 1.0};
    const Vector n = cross(u, v);
    const auto distance = [&](const Vector& d) { return dot(n, at - from) / dot(n, d); };
    const Arguments::Value origin = numbers({from[0], from[1], from[2]});
    expect_hits({{"from", origin},
                 {"onto", surface("plane", {{"at", numbers({at[0], at[1], at[2]})},
                                            {"along_u", numbers({u[0], u[1], u[2]})},
                                            {"along_v", numbers({v[0], v[1], v[2]})}})}},
                [&](const Vector& d) { return std::vector{distance(d)}; });
    // The wall x = 2 from y = 1.03 to -0.51 and z = -0.3 to 0.6.
    expect_hits({{"from", origin},
                 {"onto", surface("wall", wall_of({2.0, 1.03, -0.3}, {2.0, -0.51, -0.3},
                                                  {2.0, 1.03, 0.6}))}},
                [&](const Vector& d) {
                    const double s = (2.0 - from[0]) / d[0];
                    const double y = from[1] + s * d[1], z = from[2] + s * d[2];
                    const bool on = -0.51 <= y && y <= 1.03 && -0.3 <= z && z <= 0.6;
                    return on ? std::vector{s} : std::vector<double>{};
                });
}

TEST(Project, ReachesThePanelsOfAFoldedScreenWithoutGaps) {
    const std::vector<std::array<double, 2>> points{
        {2.0, 3.0}, {3.0, 0.5}, {1.0, 0.2}, {4.0, 0.0}, {1.0, -3.0}};
    PointList list{2, {}};
    for (const auto& p : points) {
        list.values.insert(list.values.end(), p.begin(), p.end());
    }
    for (const bool last : {false, true}) {
        expect_hits(
            {{"from", numbers({from[0], from[1], from[2]})},
             {"hit", std::string(last ? "last" : "first")},
             {"onto", surface("folded_screen", {{"points", list}})}},
            [&](const Vector& d) {
                std::vector<double> all;
                for (std::size_t i = 0; i + 1 < points.size(); ++i) {
                    const auto& a = points[i];
                    const auto& b = points[i + 1];
                    // The ends of the panel are on different sides of the ray, from above.
                    const auto side = [&](const std::array<double, 2>& p) {
                        return d[0] * (p[1] - from[1]) - d[1] * (p[0] - from[0]);
                    };
                    if (side(a) * side(b) <= 0.0) {
                        const double t = side(a) / (side(a) - side(b));
                        const double x = a[0] + t * (b[0] - a[0]), y = a[1] + t * (b[1] - a[1]);
                        all.push_back(((x - from[0]) * d[0] + (y - from[1]) * d[1]) /
                                      (d[0] * d[0] + d[1] * d[1]));
                    }
                }
                return all;
            },
            last);
    }
}

TEST(Project, ReachesTheTriangleThatASearchOfAllFinds) {
    const TexturedMesh mesh = waves();
    for (const bool last : {false, true}) {
        expect_hits(
            {{"from", numbers({from[0], from[1], from[2]})},
             {"hit", std::string(last ? "last" : "first")},
             {"onto", surface("mesh", {{"file", std::make_shared<const TexturedMesh>(mesh)}})}},
            [&](const Vector& way) { return distances(mesh, way); }, last);
    }
}

TEST(Project, HasTheSlopesOfTheTriangleThatItReaches) {
    const TexturedMesh mesh = waves();
    Camera::Parts parts;
    parts.name = "test";
    parts.eye = {
        range(0.8, -0.8, -0.5, 0.5),
        {},
        object("plane"),
        {move(
            "project",
            {{"from", numbers({from[0], from[1], from[2]})},
             {"onto", surface("mesh", {{"file", std::make_shared<const TexturedMesh>(mesh)}})}})}};
    parts.look = look("normal");
    const CameraProbe probe(camera(std::move(parts)), width, height);
    int compared = 0;
    for (double x = 0.5; x < width; x += 1.7) {
        for (double y = 0.5; y < height; y += 2.3) {
            const Vector way = plane_point(x, y) - from;
            const Ray ray = probe(x, y);
            for (const auto& t : mesh.triangles) {
                // The triangle whose plane has the point inside its three edges.
                const Vector a = t[0].position, b = t[1].position, c = t[2].position;
                const Vector n = cross(b - a, c - a);
                const auto inside = [&](const Vector& p, const Vector& q) {
                    return dot(cross(q - p, ray.origin - p), n) > 1e-6;
                };
                if (ray.valid && std::abs(dot(n, ray.origin - a)) < 1e-10 && inside(a, b) &&
                    inside(b, c) && inside(c, a)) {
                    const double facing = dot(n, way) < 0.0 ? 1.0 : -1.0;
                    expect_near(cross((facing / length(n)) * n, ray.direction), {}, 1e-9);
                    ++compared;
                }
            }
        }
    }
    EXPECT_GT(compared, 200);
}

TEST(Project, SaysThatTheProjectorDoesNotSeeTheBackdrop) {
    Camera::Parts parts;
    parts.name = "blind";
    parts.eye = {range(0.8, -0.8, -0.5, 0.5), {}, object("point"), {}};
    const auto onto = [](Arguments::Value target) {
        return Path{range(0.8, -0.8, -0.5, 0.5),
                    {},
                    object("plane"),
                    {move("project", {{"from", numbers({-1.0, 0.0, 0.0})}, {"onto", target}})}};
    };
    parts.look = look("relative");
    const PointList beside{2, {5.0, 20.0, 5.0, 30.0}};
    TexturedMesh above = waves();
    for (auto& triangle : above.triangles) {
        for (auto& corner : triangle) {
            corner.position[2] += 20.0;
        }
    }
    for (const Arguments::Value& target :
         {surface("plane", {{"at", numbers({-3.0, 0.0, 0.0})}}),
          surface("wall", wall_of({2.0, 9.0, 0.0}, {2.0, 7.0, 0.0}, {2.0, 9.0, 2.0})),
          surface("folded_screen", {{"points", beside}}),
          surface("mesh", {{"file", std::make_shared<const TexturedMesh>(above)}})}) {
        parts.toward = onto(target);
        const Result<Camera> made = Camera::make(parts);
        ASSERT_FALSE(made);
        EXPECT_NE(to_text(made.diagnostics).find("the backdrop cannot be seen from there"),
                  std::string::npos);
    }
    // A part of the backdrop is enough.
    parts.toward =
        onto(surface("wall", wall_of({2.0, 9.0, 0.0}, {2.0, 0.0, 0.0}, {2.0, 9.0, 2.0})));
    EXPECT_TRUE(Camera::make(parts));
}

TEST(Project, RefusesASurfaceThatRaysCannotBeFollowedTo) {
    EXPECT_EQ(error_of(StageKind::object_transformer, "project",
                       {{"from", numbers({0.0, 0.0, 0.0})}, {"onto", surface("torus")}}),
              "'project' cannot follow rays to this surface");
}

TEST(Wall, IsTheRectangleOfItsCornersByLengths) {
    const Vector a{1.0, 2.0, 0.5}, b{4.0, -2.0, 0.5}, c{1.0, 2.0, 3.5};
    const GeneratorProbe probe(object("wall", wall_of(a, b, c)));
    expect_near(probe(0.0, 0.0).point, a, 1e-14);
    expect_near(probe(5.0, 0.0).point, b, 1e-14);
    expect_near(probe(0.0, 3.0).point, c, 1e-14);
    expect_near(probe(2.5, 1.5).along_u, {0.6, -0.8, 0.0}, 1e-14);
    const auto own = object("wall", wall_of(a, b, c))->own_picture();
    ASSERT_TRUE(own);
    EXPECT_DOUBLE_EQ(own->u_last, 5.0);
    EXPECT_DOUBLE_EQ(own->v_last, 3.0);
}

TEST(Wall, RefusesCornersOfNoPlaneOrNoRectangle) {
    const auto error = [](Given given) {
        return error_of(StageKind::object_generator, "wall", given);
    };
    const Vector a{1.0, 2.0, 0.0}, b{1.0, -2.0, 0.0}, c{1.0, 2.0, 3.0};
    const std::string line = "the corners of the wall are in one line and span no plane";
    EXPECT_EQ(error(wall_of(a, a, c)), line);
    EXPECT_EQ(error(wall_of(a, b, b)), line);
    EXPECT_EQ(error(wall_of(a, b, {1.0, 5.0, 0.0})), line);
    EXPECT_NE(error(wall_of(a, b, {1.0, 1.9, 3.0})).find("the angle at (1, 2, 0) is 88.1 degrees"),
              std::string::npos);
    Given four = wall_of(a, b, c);
    const auto fourth = [&](const Vector& d) {
        four.insert_or_assign("upper_right", numbers({d[0], d[1], d[2]}));
        return four;
    };
    EXPECT_NE(error(fourth({1.2, -2.0, 3.0})).find("(1.2, -2, 3) is 0.2 away from the plane"),
              std::string::npos);
    EXPECT_NE(error(fourth({1.0, -2.0, 2.5})).find("would be (1, -2, 3), not (1, -2, 2.5)"),
              std::string::npos);
    // A tape measure is not exact.
    EXPECT_TRUE(try_stage(StageKind::object_generator, "wall", fourth({1.01, -2.0, 3.01})));
}

TEST(FoldedScreen, RunsAlongItsPanelsByLength) {
    const PointList points{2, {0.0, 0.0, 3.0, 4.0, 3.0, 6.0}};
    const GeneratorProbe probe(object("folded_screen", {{"points", points}}));
    expect_near(probe(2.5, 1.0).point, {1.5, 2.0, 1.0}, 1e-14);
    expect_near(probe(6.0, -1.0).point, {3.0, 5.0, -1.0}, 1e-14);
    expect_near(probe(6.0, 0.0).along_u, {0.0, 1.0, 0.0}, 1e-14);
    EXPECT_TRUE(probe(7.0, 0.0).valid);
    EXPECT_FALSE(probe(7.001, 0.0).valid);
    EXPECT_FALSE(probe(-0.001, 0.0).valid);
    EXPECT_EQ(error_of(StageKind::object_generator, "folded_screen",
                       {{"points", PointList{2, {0.0, 0.0, 1.0, 1.0, 1.0, 1.0}}}}),
              "the points 2 and 3 of the folded screen are equal");
}

}  // namespace balcony::camera::projection_test

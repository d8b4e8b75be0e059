// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The direction rules: sides of normals, tangents, fixed vectors and blends of two rules.

#include <functional>
#include <numbers>

#include "support.hpp"

namespace balcony::camera::direction_rules_test {

namespace {

using std::numbers::pi;
constexpr double width = 80.0;
constexpr double height = 45.0;
constexpr double tolerance = 1e-12;  // unit directions after some dozen roundings

Camera::Parts seen(const ObjectGeneratorPointer& eye, const PictureMapperPointer& mapper,
                   const DirectionRulePointer& rule) {
    Camera::Parts parts;
    parts.name = "test";
    parts.eye = {mapper, {}, eye, {}};
    parts.look = rule;
    return parts;
}

DirectionRulePointer normal(const char* side) {
    return look("normal", {{"side", std::string(side)}});
}

void at_pixels(const std::function<void(double x, double y)>& check) {
    for (double x = 0.5; x < width; x += 7.0) {
        for (double y = 0.5; y < height; y += 5.0) {
            check(x, y);
        }
    }
}

Formula weight(const std::function<Expr(Expr u, Expr v)>& of) {
    return formula(2,
                   [&](Graph&, const std::vector<Expr>& p) { return std::vector{of(p[0], p[1])}; });
}

DirectionRulePointer blend(const DirectionRulePointer& first, const DirectionRulePointer& second,
                           const std::function<Expr(Expr u, Expr v)>& of,
                           const char* by = "mixing") {
    return look("blend", {{"first", Arguments::StagePointer(first)},
                          {"second", Arguments::StagePointer(second)},
                          {"weight", weight(of)},
                          {"by", std::string(by)}});
}

DirectionRulePointer along(const Vector& vector) {
    return look("along", {{"direction", numbers({vector[0], vector[1], vector[2]})}});
}

double angle_between(const Vector& a, const Vector& b) {
    return std::atan2(length(cross(a, b)), dot(a, b));
}

// Objects with their fronts on either side, where their pictures show them, and a point inside.
struct Sided {
    ObjectGeneratorPointer object;
    std::array<double, 4> map;
    Vector inside;
};

std::vector<Sided> sided_objects() {
    const auto by = [](const char* name, const char* choice) {
        return object(name, {{"by", std::string(choice)}});
    };
    return {
        {object("sphere"), {-3.1, 3.1, -1.5, 1.5}, {0.0, 0.0, 0.0}},
        {object("sphere"), {0.2, 1.0, 0.3, 0.9}, {0.0, 0.0, 0.0}},
        {object("superellipsoid", {{"gamma_u", numbers({0.25})}}), {3.1, -3.1, -1.5, 1.5}, {}},
        {object("cylinder"), {3.1, -3.1, -1.0, 1.0}, {0.0, 0.0, 0.0}},
        {by("paraboloid", "polar"), {-3.1, 3.1, 0.1, 1.0}, {0.0, 0.0, 2.0}},
        {by("paraboloid", "cartesian"), {-1.0, 1.0, -1.0, 1.0}, {0.0, 0.0, 4.0}},
        {object("hyperboloid_two"), {-1.0, 1.0, -1.0, 1.0}, {9.0, 0.0, 0.0}},
    };
}

}  // namespace

TEST(NormalRule, OutwardLooksAwayFromTheInsideWhereverTheFrontIs) {
    for (const Sided& sided : sided_objects()) {
        const auto& [first, last, bottom, top] = sided.map;
        for (const auto& mapper :
             {range(first, last, bottom, top), range(last, first, bottom, top)}) {
            const CameraProbe out(camera(seen(sided.object, mapper, normal("outward"))), width,
                                  height);
            const CameraProbe in(camera(seen(sided.object, mapper, normal("inward"))), width,
                                 height);
            at_pixels([&](double x, double y) {
                const Ray ray = out(x, y);
                ASSERT_TRUE(ray.valid);
                EXPECT_GT(dot(ray.direction, ray.origin - sided.inside), 0.0);
                expect_near(in(x, y).direction, -1.0 * ray.direction, 0.0);
            });
        }
    }
}

// The torus is neither convex nor a star seen from a point: both halves of its tube look out.
TEST(NormalRule, OutwardIsOneSideOfTheWholeSurface) {
    const auto torus = object("torus", {{"major", numbers({4.0})}});
    const CameraProbe out(camera(seen(torus, range(-pi, pi, -pi, pi), normal("outward"))), width,
                          height);
    const CameraProbe front(camera(seen(torus, range(-pi, pi, -pi, pi), normal("front"))), width,
                            height);
    at_pixels(
        [&](double x, double y) { expect_near(out(x, y).direction, front(x, y).direction, 0.0); });
}

// Parametrisations that go on beyond their poles, round and back, with a point inside and the part
// of a torus's tube that lies on the far side of its axis.
TEST(NormalRule, OutwardStaysOnItsSideBeyondThePoles) {
    const auto by = [](const char* name, const char* choice) {
        return object(name, {{"by", std::string(choice)}});
    };
    const ObjectGeneratorPointer sphere = object("sphere");
    const ObjectGeneratorPointer box =
        object("superellipsoid", {{"a", numbers({3.0})}, {"gamma_v", numbers({0.5})}});
    const ObjectGeneratorPointer product =
        object("product", {{"g", object("circle")}, {"h", object("circle")}});
    for (const auto& [eye, v_from, v_to] :
         {std::tuple(sphere, -0.5 * pi, 1.5 * pi), std::tuple(sphere, -3.0 * pi, 0.3),
          std::tuple(object("ellipsoid", {{"c", numbers({2.0})}}), -0.5 * pi, 1.5 * pi),
          std::tuple(box, -0.4 * pi, 1.6 * pi), std::tuple(product, -4.0, 9.0),
          std::tuple(by("paraboloid", "polar"), -1.0, 1.0)}) {
        const bool open = eye != sphere && std::fabs(v_to) == 1.0;
        const Vector inside = open ? Vector{0.0, 0.0, 2.0} : Vector{0.0, 0.0, 0.0};
        for (const auto& [side, sign] : {std::pair("outward", 1.0), std::pair("inward", -1.0)}) {
            const CameraProbe rays(camera(seen(eye, range(-pi, pi, v_from, v_to), normal(side))),
                                   width, height);
            at_pixels([&, sign = sign](double x, double y) {
                const Ray ray = rays(x, y);
                ASSERT_TRUE(ray.valid);
                EXPECT_GT(sign * dot(ray.direction, ray.origin - inside), 0.0);
            });
        }
    }
}

// A smooth surface that passes through the axis: from ray to ray along v, the direction turns and
// does not jump.
TEST(NormalRule, OutwardDoesNotJumpWhereATubeGoesThroughItsAxis) {
    const ObjectGeneratorPointer torus =
        object("torus", {{"major", numbers({1.0})}, {"minor", numbers({2.0})}});
    const CameraProbe rays(camera(seen(torus, range(-0.1, 0.1, -pi, pi), normal("outward"))), width,
                           400.0);
    for (double y = 0.5; y < 399.0; y += 1.0) {
        const double turn = angle_between(rays(40.5, y).direction, rays(40.5, y + 1.0).direction);
        EXPECT_NEAR(turn, 2.0 * pi / 400.0, 1e-6);
    }
}

// A mirrored surface has its front inside.
TEST(NormalRule, OutwardStaysOutwardThroughMoves) {
    for (const auto& transformer : {move("mirror", {{"axis", numbers({1.0, 0.0, 0.0})}}),
                                    move("translate", {{"x", numbers({1e4})}})}) {
        Camera::Parts parts = seen(object("sphere"), range(-pi, pi, -1.5, 1.5), normal("outward"));
        parts.eye.object_transformers = {transformer};
        const CameraProbe rays(camera(parts), width, height);
        const Vector middle = transformed(transformer, {0.0, 0.0, 0.0});
        at_pixels([&](double x, double y) {
            EXPECT_GT(dot(rays(x, y).direction, rays(x, y).origin - middle), 0.9);
        });
    }
}

// The side is that of the part that the camera's own picture shows, wherever that is placed.
TEST(NormalRule, OutwardDoesNotDependOnThePlaceOfThePicture) {
    Camera::Parts parts = seen(object("paraboloid", {{"by", std::string("cartesian")}}),
                               range(-1.0, 1.0, -1.0, 1.0), normal("outward"));
    const CameraProbe whole(camera(parts), width, height);
    parts.arrangers = {
        stage<PictureArranger>(StageKind::picture_arranger, "place",
                               {{"from", numbers({0.9, 0.9})}, {"to", numbers({1.0, 1.0})}})};
    const CameraProbe placed(camera(parts), 10.0 * width, 10.0 * height);
    at_pixels([&](double x, double y) {
        const Ray ray = placed(9.0 * width + x, 9.0 * height + y);
        ASSERT_TRUE(ray.valid);
        expect_near(ray.direction, whole(x, y).direction, tolerance);
    });
}

TEST(NormalRule, OutwardIsTheFrontOfAPlane) {
    const auto plane = object("plane", {{"at", numbers({3.0, -7.0, 0.3})}});
    for (const char* side : {"outward", "front"}) {
        const CameraProbe rays(camera(seen(plane, range(1.0, -1.3, -2.0, 1.0), normal(side))),
                               width, height);
        at_pixels([&](double x, double y) {
            expect_near(rays(x, y).direction, {1.0, 0.0, 0.0}, 0.0);
        });
    }
}

// By angle and distance the tangents have no cross product at the apex, and one to the other side
// beyond it.
TEST(NormalRule, HasTheFrontOfAParaboloidOutsideAtItsApexAndBeyond) {
    const CameraProbe rays(
        camera(seen(object("paraboloid"), range(-pi, pi, -1.0, 1.0), normal("front"))), width,
        height);
    at_pixels([&](double x, double y) {
        const Ray ray = rays(x, y);
        ASSERT_TRUE(ray.valid);
        const Vector outside{2.0 * ray.origin[0], 2.0 * ray.origin[1], -1.0};
        expect_near(ray.direction, (1.0 / length(outside)) * outside, tolerance);
    });
    const Ray apex = rays(12.5, 0.5 * height);
    ASSERT_TRUE(apex.valid);
    expect_near(apex.origin, {0.0, 0.0, 0.0}, tolerance);
    expect_near(apex.direction, {0.0, 0.0, -1.0}, tolerance);
}

TEST(TangentRule, IsTheTangentOfTheEyeObject) {
    const auto torus = object("torus", {{"major", numbers({4.0})}});
    const GeneratorProbe surface(torus);
    for (const char* parameter : {"u", "v"}) {
        for (const char* sense : {"forward", "backward"}) {
            const CameraProbe rays(camera(seen(torus, range(3.0, -3.0, -3.0, 3.0),
                                               look("tangent", {{"along", std::string(parameter)},
                                                                {"sense", std::string(sense)}}))),
                                   width, height);
            at_pixels([&](double x, double y) {
                const Ray ray = rays(x, y);
                const Sample s = surface(ray.parameters[0], ray.parameters[1]);
                const Vector t = *parameter == 'u' ? s.along_u : s.along_v;
                const double sign = *sense == 'f' ? 1.0 : -1.0;
                expect_near(ray.direction, (sign / length(t)) * t, tolerance);
            });
        }
    }
}

TEST(TangentRule, ServesCurvesAlongUAlone) {
    const auto circle = object("circle");
    const CameraProbe rays(camera(seen(circle, range(0.0, 6.0, 0.0, 1.0), look("tangent"))), width,
                           height);
    at_pixels([&](double x, double y) {
        EXPECT_NEAR(dot(rays(x, y).direction, rays(x, y).origin), 0.0, tolerance);
    });
    EXPECT_FALSE(Camera::make(
        seen(circle, range(0.0, 6.0, 0.0, 1.0), look("tangent", {{"along", std::string("v")}}))));
    EXPECT_FALSE(Camera::make(seen(object("point"), range(0.0, 6.0, 0.0, 1.0), look("tangent"))));
}

TEST(AlongRule, IsOneVectorWhateverTheObjectAndItsMoves) {
    Camera::Parts parts =
        seen(object("circle"), range(0.0, 6.0, 0.0, 1.0), along({0.0, 3.0, -4.0}));
    parts.eye.object_transformers = {
        move("rotate", {{"axis", numbers({1.0, 2.0, -1.0})}, {"angle", numbers({0.7})}})};
    const CameraProbe rays(camera(parts), width, height);
    at_pixels([&](double x, double y) {
        expect_near(rays(x, y).direction, {0.0, 0.6, -0.8}, 1e-15);
    });
}

TEST(AlongRule, NeedsAVector) {
    const auto made =
        try_stage(StageKind::direction_rule, "along", {{"direction", numbers({0.0, 0.0, 0.0})}});
    ASSERT_FALSE(made);
    EXPECT_FALSE(made.diagnostics.front().remedy.empty());
}

TEST(BlendRule, IsItsRulesAtTheWeightsZeroAndOne) {
    const auto sphere = object("sphere");
    const auto mapper = range(3.0, -3.0, -1.4, 1.4);
    for (const char* by : {"mixing", "angle"}) {
        const auto normals = normal("front");
        const auto tangents = look("tangent");
        const CameraProbe first(camera(seen(sphere, mapper, normals)), width, height);
        const CameraProbe second(camera(seen(sphere, mapper, tangents)), width, height);
        for (const double w : {0.0, 1.0}) {
            const auto rule = blend(
                normals, tangents, [&](Expr u, Expr) { return w + 0.0 * u; }, by);
            const CameraProbe rays(camera(seen(sphere, mapper, rule)), width, height);
            at_pixels([&](double x, double y) {
                expect_near(rays(x, y).direction, (w == 0.0 ? first : second)(x, y).direction,
                            tolerance);
            });
        }
    }
}

// Unit vectors are mixed, for any lengths of the rules' vectors: half and half is the bisector.
TEST(BlendRule, MixesUnitVectorsByItsFormula) {
    const auto plane = object("plane");
    const auto rule =
        blend(along({5.0, 0.0, 0.0}), along({0.0, 0.1, 0.0}), [](Expr u, Expr v) { return u * v; });
    const CameraProbe rays(camera(seen(plane, range(2.0, -2.0, -1.0, 1.0), rule)), width, height);
    at_pixels([&](double x, double y) {
        const Ray ray = rays(x, y);
        const double w = ray.parameters[0] * ray.parameters[1];  // below 0 and above 1 too
        const Vector mixed{1.0 - w, w, 0.0};
        expect_near(ray.direction, (1.0 / length(mixed)) * mixed, tolerance);
    });
}

TEST(BlendRule, ByAngleTurnsInProportionToItsWeight) {
    const Vector a{0.6, 0.0, 0.8};
    const Vector b{0.0, -1.0, 0.0};
    const auto rule = blend(
        along(a), along(b), [](Expr u, Expr) { return u; }, "angle");
    const CameraProbe rays(camera(seen(object("plane"), range(1.4, -0.4, -1.0, 1.0), rule)), width,
                           height);
    at_pixels([&](double x, double y) {
        const double w = rays(x, y).parameters[0];
        const Vector d = rays(x, y).direction;
        EXPECT_NEAR(angle_between(a, d), std::fabs(w) * pi / 2.0, tolerance);
        EXPECT_NEAR(dot(d, cross(a, b)), 0.0, tolerance);
        EXPECT_NEAR(dot(d, b), std::sin(w * pi / 2.0), tolerance);
    });
}

TEST(BlendRule, ByAngleOfTwoEqualDirectionsIsThatDirection) {
    const auto rule = blend(
        along({0.0, 0.0, 2.0}), along({0.0, 0.0, 1.0}), [](Expr u, Expr) { return u; }, "angle");
    const CameraProbe rays(camera(seen(object("plane"), range(1.0, 0.0, -1.0, 1.0), rule)), width,
                           height);
    at_pixels([&](double x, double y) {
        EXPECT_TRUE(rays(x, y).valid);
        expect_near(rays(x, y).direction, {0.0, 0.0, 1.0}, tolerance);
    });
}

TEST(BlendRule, ByAngleKnowsNoWayBetweenOppositeDirections) {
    const auto rule = blend(
        along({0.6, 0.0, 0.8}), along({-0.6, 0.0, -0.8}), [](Expr u, Expr) { return u; }, "angle");
    const CameraProbe rays(camera(seen(object("plane"), range(1.0, 0.0, -1.0, 1.0), rule)), width,
                           height);
    at_pixels([&](double x, double y) { EXPECT_FALSE(rays(x, y).valid); });
}

TEST(BlendRule, NeedsWhatItsRulesNeed) {
    const auto half = [](Expr u, Expr) { return 0.5 + 0.0 * u; };
    EXPECT_TRUE(blend(along({1.0, 0.0, 0.0}), look("relative"), half)->needs_direction_object());
    EXPECT_TRUE(blend(look("absolute"), along({1.0, 0.0, 0.0}), half)->needs_direction_object());
    EXPECT_FALSE(blend(look("tangent"), along({1.0, 0.0, 0.0}), half)->needs_direction_object());
    EXPECT_EQ(blend(look("tangent"), along({1.0, 0.0, 0.0}), half)->min_eye_dimension(), 1);
    EXPECT_EQ(blend(along({1.0, 0.0, 0.0}), normal("front"), half)->min_eye_dimension(), 2);
    const auto nested = blend(blend(look("tangent"), look("relative"), half), normal("back"), half);
    EXPECT_TRUE(nested->needs_direction_object());
    EXPECT_EQ(nested->min_eye_dimension(), 2);
}

}  // namespace balcony::camera::direction_rules_test

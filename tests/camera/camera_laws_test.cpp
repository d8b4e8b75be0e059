// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Laws of whole paths and cameras.

#include <functional>
#include <numbers>

#include "support.hpp"

namespace balcony::camera::camera_laws_test {

namespace {

constexpr double width = 160.0;
constexpr double height = 90.0;
// Unit directions and points of size 1 to 50 after some dozen roundings.
constexpr double tolerance = 1e-12;

Camera::Parts normal_camera(ObjectGeneratorPointer eye, PictureMapperPointer mapper) {
    Camera::Parts parts;
    parts.name = "test";
    parts.eye = {std::move(mapper), {}, std::move(eye), {}};
    parts.look = look("normal");
    return parts;
}

Camera::Parts with_direction_object(const char* rule) {
    Camera::Parts parts;
    parts.name = "test";
    parts.eye = {
        range(0.0, 1.5, -3.0, 3.0), {}, object("circle", {{"radius", numbers({10.0})}}), {}};
    parts.toward = Path{range(0.0, 1.5, -3.0, 3.0),
                        {},
                        object("torus", {{"major", numbers({10.0})}, {"minor", numbers({2.0})}}),
                        {}};
    parts.look = look(rule);
    return parts;
}

ObjectGeneratorPointer superellipsoid() {
    const auto half_axes = [](double a, double b) {
        return object("superellipse",
                      {{"a", numbers({a})}, {"b", numbers({b})}, {"gamma", numbers({0.25})}});
    };
    return object("product", {{"g", half_axes(1.0, 25.0 / 45.0)}, {"h", half_axes(45.0, 25.0)}});
}

std::vector<ObjectTransformerPointer> some_moves() {
    return {
        move("rotate", {{"axis", numbers({1.0, 2.0, -1.0})}, {"angle", numbers({0.7})}}),
        move("translate", {{"x", numbers({3.0})}, {"y", numbers({-2.0})}, {"z", numbers({5.0})}})};
}

void at_pixels(const std::function<void(double x, double y)>& check) {
    for (double x = 0.5; x < width; x += 11.0) {
        for (double y = 0.5; y < height; y += 7.0) {
            check(x, y);
        }
    }
}

std::size_t pixel_operations(std::span<const Expr> roots) {
    std::size_t count = 0;
    for (const expr::NodeId id : expr::reachable(roots.front().graph(), roots)) {
        const Expr node(roots.front().graph(), id);
        count += expr::operation(node.op()).arity > 0 && node.rate() == expr::Rate::pixel ? 1 : 0;
    }
    return count;
}

std::string message_of(Camera::Parts parts) {
    const Result<Camera> made = Camera::make(std::move(parts));
    EXPECT_FALSE(made);
    return made ? std::string() : made.diagnostics.front().message;
}

}  // namespace

TEST(NormalRule, IsOrthogonalToBothTangentsOfTheEyeObject) {
    for (const ObjectGeneratorPointer& eye :
         {object("sphere"), object("torus", {{"major", numbers({3.0})}}), superellipsoid()}) {
        const GeneratorProbe surface(eye);
        const CameraProbe rays(camera(normal_camera(eye, range(-3.0, 3.0, -1.4, 1.4))), width,
                               height);
        at_pixels([&](double x, double y) {
            const Ray ray = rays(x, y);
            ASSERT_TRUE(ray.valid);
            const Sample s = surface(ray.parameters[0], ray.parameters[1]);
            expect_near(ray.origin, s.point, tolerance);
            EXPECT_NEAR(length(ray.direction), 1.0, 1e-15);
            EXPECT_NEAR(dot(ray.direction, s.along_u) / length(s.along_u), 0.0, tolerance);
            EXPECT_NEAR(dot(ray.direction, s.along_v) / length(s.along_v), 0.0, tolerance);
            EXPECT_GT(dot(ray.direction, cross(s.along_u, s.along_v)), 0.0);
        });
    }
}

// What a warp does to the parameters moves points along the surface and leaves it the same.
TEST(NormalRule, IsOfTheObjectWhateverTheWarp) {
    Camera::Parts parts = normal_camera(object("sphere"), range(-3.0, 3.0, -1.4, 1.4));
    parts.eye.parameter_transformers = {
        warp("zoom", {{"strength", numbers({0.35})}, {"radius", numbers({1.0, 1.0})}}),
        warp("shear")};
    const CameraProbe rays(camera(parts), width, height);
    at_pixels([&](double x, double y) {
        // On a sphere of radius 1 the outward normal is the point, even where the zoom folds.
        expect_near(rays(x, y).direction, rays(x, y).origin, tolerance);
    });
}

TEST(NormalRule, BackIsAgainstFront) {
    Camera::Parts parts = normal_camera(object("sphere"), range(-3.0, 3.0, -1.4, 1.4));
    const CameraProbe front(camera(parts), width, height);
    parts.look = look("normal", {{"side", std::string("back")}});
    const CameraProbe back(camera(parts), width, height);
    at_pixels([&](double x, double y) {
        expect_near(back(x, y).direction, -1.0 * front(x, y).direction, 0.0);
    });
}

TEST(RelativeRule, GoesFromTheEyePointToTheDirectionPoint) {
    const Camera::Parts parts = with_direction_object("relative");
    const GeneratorProbe circle(parts.eye.generator);
    const GeneratorProbe torus(parts.toward->generator);
    const CameraProbe rays(camera(parts), width, height);
    at_pixels([&](double x, double y) {
        const Ray ray = rays(x, y);
        const auto [u, v] = ray.parameters;
        const Vector d = torus(u, v).point - circle(u, v).point;
        expect_near(ray.origin, circle(u, v).point, tolerance);
        expect_near(ray.direction, (1.0 / length(d)) * d, tolerance);
    });
}

TEST(AbsoluteRule, IsTheDirectionObjectSeenFromItsOrigin) {
    Camera::Parts parts = with_direction_object("absolute");
    const GeneratorProbe torus(parts.toward->generator);
    const CameraProbe rays(camera(parts), width, height);
    at_pixels([&](double x, double y) {
        const Ray ray = rays(x, y);
        const Vector d = torus(ray.parameters[0], ray.parameters[1]).point;
        expect_near(ray.direction, (1.0 / length(d)) * d, tolerance);
    });
}

TEST(AbsoluteRule, IsLeftByTranslationAndTurnsWithRotation) {
    Camera::Parts parts = with_direction_object("absolute");
    const CameraProbe still(camera(parts), width, height);
    parts.toward->object_transformers = {move("translate", {{"x", numbers({7.0})}})};
    const CameraProbe translated(camera(parts), width, height);
    const auto rotate =
        move("rotate", {{"axis", numbers({1.0, 2.0, -1.0})}, {"angle", numbers({0.7})}});
    parts.toward->object_transformers = {rotate};
    const CameraProbe rotated(camera(parts), width, height);
    at_pixels([&](double x, double y) {
        const Vector d = still(x, y).direction;
        expect_near(translated(x, y).direction, d, tolerance);
        expect_near(rotated(x, y).direction, transformed(rotate, d), tolerance);
    });
}

TEST(Camera, AMoveOfAllPartsMovesTheRaysRigidly) {
    for (const char* rule : {"absolute", "relative", "normal"}) {
        Camera::Parts parts = std::string_view(rule) == "normal"
                                  ? normal_camera(superellipsoid(), range(-3.0, 3.0, -1.4, 1.4))
                                  : with_direction_object(rule);
        const CameraProbe still(camera(parts), width, height);
        parts.eye.object_transformers = some_moves();
        if (parts.toward) {
            parts.toward->object_transformers = some_moves();
        }
        const CameraProbe moved(camera(parts), width, height);
        at_pixels([&](double x, double y) {
            Vector origin = still(x, y).origin;
            for (const auto& transformer : some_moves()) {
                origin = transformed(transformer, origin);
            }
            expect_near(moved(x, y).origin, origin, tolerance);
            expect_near(moved(x, y).direction,
                        transformed(some_moves().front(), still(x, y).direction), tolerance);
        });
    }
}

// From a point through a plane at x = 1: to the left edge of the picture u is largest, since y
// points to the left when x points forward and z up.
TEST(Camera, APointAndAPlaneAreThePinhole) {
    const double tangent = std::tan(0.5);
    Camera::Parts parts;
    parts.name = "pinhole";
    const auto square =
        stage<PictureMapper>(StageKind::picture_mapper, "square_v",
                             {{"u_first", numbers({tangent})}, {"u_last", numbers({-tangent})}});
    parts.eye = {square, {}, object("point"), {}};
    parts.toward = Path{square, {}, object("plane", {{"at", numbers({1.0, 0.0, 0.0})}}), {}};
    parts.look = look("relative");
    const CameraProbe rays(camera(parts), width, height);
    at_pixels([&](double x, double y) {
        const Vector wanted{1.0, -tangent * (2.0 * x - width) / width,
                            tangent * (height - 2.0 * y) / width};
        expect_near(rays(x, y).direction, (1.0 / length(wanted)) * wanted, 1e-15);
        expect_near(rays(x, y).origin, {0.0, 0.0, 0.0}, 0.0);
    });
}

TEST(Camera, APlaneAndItsNormalsAreTheOrthographicCamera) {
    const CameraProbe rays(camera(normal_camera(object("plane"), range(8.0, -8.0, -4.5, 4.5))),
                           width, height);
    at_pixels([&](double x, double y) {
        expect_near(rays(x, y).direction, {1.0, 0.0, 0.0}, 0.0);
        expect_near(rays(x, y).origin, {0.0, 8.0 - 0.1 * x, 4.5 - 0.1 * y}, 1e-14);
    });
}

TEST(Camera, ChangesWithTime) {
    Camera::Parts parts = normal_camera(object("plane"), range(-1.0, 1.0, -1.0, 1.0));
    Given along;
    along["z"] = std::vector<Scalar>{Scalar(formula(0, [](Graph& graph, const std::vector<Expr>&) {
        return std::vector{3.0 * graph.time()};
    }))};
    parts.eye.object_transformers = {move("translate", along)};
    const CameraProbe rays(camera(parts), width, height);
    EXPECT_NEAR(rays(10.0, 20.0, 2.0).origin[2] - rays(10.0, 20.0, 0.0).origin[2], 6.0, 1e-15);
}

// z = sqrt(1 - u^2 - v^2): the sum of the squares of the point is 1 even where z does not exist.
TEST(Camera, HasNoRayWhereACoordinateDoesNotExist) {
    Arguments arguments;
    arguments.set_formula(formula(2, [](Graph&, const std::vector<Expr>& p) {
        return std::vector{p[0], p[1], sqrt(1.0 - (p[0] * p[0] + p[1] * p[1]))};
    }));
    const auto made = catalogue().find(StageKind::object_generator, "surface")->make(arguments);
    Camera::Parts parts = normal_camera(std::dynamic_pointer_cast<const ObjectGenerator>(*made),
                                        range(-2.0, 2.0, -2.0, 2.0));
    for (const bool relative : {false, true}) {
        if (relative) {
            parts.toward = Path{range(0.0, 1.0, 0.0, 1.0), {}, object("point"), {}};
            parts.look = look("relative");
        }
        const CameraProbe rays(camera(parts), width, height);
        at_pixels([&](double x, double y) {
            const Ray ray = rays(x, y);
            const bool inside = std::hypot(ray.parameters[0], ray.parameters[1]) < 1.0;
            EXPECT_EQ(ray.valid, inside);
        });
    }
}

TEST(Camera, HasNoRayWhereItsObjectStatesThatItEnds) {
    Camera::Parts parts = with_direction_object("relative");
    parts.eye = {range(-3.0, 3.0, 0.0, 1.0),
                 {},
                 object("superhyperbola", {{"by", std::string("trigonometric")}}),
                 {}};
    const CameraProbe rays(camera(parts), width, height);
    at_pixels([&](double x, double y) {
        EXPECT_EQ(rays(x, y).valid, std::cos(rays(x, y).parameters[0]) > 0.0);
    });
}

TEST(Camera, HasNoRayOfNoDirection) {
    Camera::Parts parts = with_direction_object("relative");
    parts.toward = parts.eye;
    const CameraProbe rays(camera(parts), width, height);
    at_pixels([&](double x, double y) { EXPECT_FALSE(rays(x, y).valid); });
}

TEST(Camera, DirectionsAreOfUnitLengthHoweverSmallTheObject) {
    for (const double size : {1e-150, 1e-140, 1e-30, 1e30, 1e150}) {
        Camera::Parts parts = normal_camera(object("plane"), range(-1.0, 1.0, -1.0, 1.0));
        parts.toward = Path{
            range(-1.0, 1.0, -1.0, 1.0), {}, object("sphere", {{"radius", numbers({size})}}), {}};
        parts.look = look("absolute");
        const CameraProbe rays(camera(parts), width, height);
        at_pixels([&](double x, double y) {
            if (rays(x, y).valid) {
                EXPECT_NEAR(length(rays(x, y).direction), 1.0, 1e-15) << size;
            }
            EXPECT_EQ(rays(x, y).valid, size > 1e-144) << size;
        });
    }
}

// Two products for the origin, six for the direction, three operations for its squared length, a
// root, a division, and six for the test that all of this exists.
TEST(Camera, OfNormalsOfASuperellipsoidCostsLittleAtAPoint) {
    for (const char* by : {"angle_centre", "arc_length"}) {
        const auto half_axes = [&](double a, double b) {
            return object("superellipse", {{"a", numbers({a})},
                                           {"b", numbers({b})},
                                           {"gamma", numbers({0.25})},
                                           {"by", std::string(by)}});
        };
        const auto eye =
            object("product", {{"g", half_axes(1.0, 25.0 / 45.0)}, {"h", half_axes(45.0, 25.0)}});
        const CameraProbe rays(camera(normal_camera(eye, range(-3.0, 3.0, -1.4, 1.4))), width,
                               height);
        EXPECT_LE(pixel_operations(rays.roots()), 19U) << by;
    }
}

TEST(CameraMake, SaysWhatIsMissing) {
    const Camera::Parts whole = normal_camera(object("sphere"), range(-3.0, 3.0, -1.0, 1.0));
    Camera::Parts parts = whole;
    parts.eye.mapper = nullptr;
    EXPECT_EQ(message_of(parts), "camera 'test' has no picture mapper for its eye object");
    parts = whole;
    parts.eye.generator = nullptr;
    EXPECT_EQ(message_of(parts), "camera 'test' has no eye object");
    parts = whole;
    parts.look = nullptr;
    EXPECT_EQ(message_of(parts), "camera 'test' has no direction rule");
    parts = whole;
    parts.look = look("relative");
    EXPECT_EQ(message_of(parts), "camera 'test': this direction rule needs a direction object");
    parts = with_direction_object("relative");
    parts.toward->generator = nullptr;
    EXPECT_EQ(message_of(parts), "camera 'test' has no direction object");
}

TEST(CameraMake, SaysWhatDoesNotFit) {
    Camera::Parts parts = normal_camera(object("circle"), range(-3.0, 3.0, -1.0, 1.0));
    EXPECT_NE(message_of(parts).find("needs a surface, but the eye object is a curve"),
              std::string::npos);
    parts.eye.generator = object("point");
    EXPECT_NE(message_of(parts).find("needs a surface, but the eye object is a point"),
              std::string::npos);
    parts.eye.generator = object("sphere");
    for (const double aspect : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
        parts.aspect = aspect;
        EXPECT_NE(message_of(parts).find("aspect"), std::string::npos);
    }
}

TEST(CameraMake, WarnsOfADirectionObjectThatIsNotUsed) {
    Camera::Parts parts = with_direction_object("relative");
    EXPECT_TRUE(Camera::make(parts).diagnostics.empty());
    parts.eye.generator = object("sphere");
    parts.look = look("normal");
    const Result<Camera> made = Camera::make(parts);
    ASSERT_TRUE(made);
    ASSERT_EQ(made.diagnostics.size(), 1U);
    EXPECT_EQ(made.diagnostics.front().severity, Severity::warning);
    EXPECT_FALSE(made->parts().toward);
}

TEST(CameraMake, SaysAllAtOnce) {
    const Result<Camera> made = Camera::make({});
    ASSERT_FALSE(made);
    EXPECT_EQ(made.diagnostics.size(), 3U);
}

}  // namespace balcony::camera::camera_laws_test

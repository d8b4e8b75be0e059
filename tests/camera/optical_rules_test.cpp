// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The direction rules of geometrical optics: reflection and refraction.

#include <functional>

#include "support.hpp"

namespace balcony::camera::optical_rules_test {

namespace {

constexpr double width = 80.0;
constexpr double height = 45.0;
constexpr double tolerance = 1e-12;  // unit directions after some dozen roundings
const Vector viewer{3.0, -4.0, 5.0};

DirectionRulePointer optical(const char* name, Given given) {
    if (std::string_view(name) == "refract" && given.count("index") == 0) {
        given["index"] = numbers({1.5});
    }
    return look(name, given);
}

/// A viewer and a surface; the surface is where the rule says that it is.
Camera::Parts looking_at(const ObjectGeneratorPointer& surface, bool at_eye,
                         const DirectionRulePointer& rule) {
    const auto point = object(
        "point",
        {{"x", numbers({viewer[0]})}, {"y", numbers({viewer[1]})}, {"z", numbers({viewer[2]})}});
    const auto mapper = range(2.0, -2.0, -1.3, 1.3);
    Camera::Parts parts;
    parts.name = "test";
    parts.eye = {mapper, {}, at_eye ? surface : point, {}};
    parts.toward = Path{mapper, {}, at_eye ? point : surface, {}};
    parts.look = rule;
    return parts;
}

void at_pixels(const std::function<void(double x, double y)>& check) {
    for (double x = 0.5; x < width; x += 7.0) {
        for (double y = 0.5; y < height; y += 5.0) {
            check(x, y);
        }
    }
}

double angle_between(const Vector& a, const Vector& b) {
    return std::atan2(length(cross(a, b)), dot(a, b));
}

/// The direction that arrives, and the normal on the side that it goes to.
struct Meeting {
    Vector incident, normal;
};

Meeting meeting_at(const Sample& surface) {
    Vector incident = surface.point - viewer;
    incident = (1.0 / length(incident)) * incident;
    Vector normal = cross(surface.along_u, surface.along_v);
    normal = (1.0 / length(normal)) * normal;
    return {incident, dot(normal, incident) < 0.0 ? -1.0 * normal : normal};
}

const std::vector<ObjectGeneratorPointer>& surfaces() {
    static const std::vector<ObjectGeneratorPointer> all{
        object("sphere"), object("torus", {{"major", numbers({4.0})}}), object("paraboloid")};
    return all;
}

/// All rays at a surface, as eye object and as direction object.
void for_all_rays(const char* name, const Given& given,
                  const std::function<void(const Ray&, const Meeting&, bool at_eye)>& check) {
    for (const ObjectGeneratorPointer& surface : surfaces()) {
        const GeneratorProbe probe(surface);
        for (const bool at_eye : {true, false}) {
            Given all = given;
            all["at"] = std::string(at_eye ? "eye" : "toward");
            const CameraProbe rays(camera(looking_at(surface, at_eye, optical(name, all))), width,
                                   height);
            at_pixels([&](double x, double y) {
                const Ray ray = rays(x, y);
                const Sample s = probe(ray.parameters[0], ray.parameters[1]);
                check(ray, meeting_at(s), at_eye);
                if (ray.valid) {
                    expect_near(ray.origin, at_eye ? s.point : viewer, tolerance);
                }
            });
        }
    }
}

}  // namespace

// The angles are equal, and the directions lie in one plane with the normal.
TEST(ReflectRule, HasTheAngleOfIncidence) {
    for_all_rays("reflect", {}, [](const Ray& ray, const Meeting& m, bool) {
        ASSERT_TRUE(ray.valid);
        EXPECT_NEAR(dot(ray.direction, m.normal), -dot(m.incident, m.normal), tolerance);
        expect_near(cross(ray.direction, m.normal), cross(m.incident, m.normal), tolerance);
    });
}

TEST(RefractRule, KeepsSnellsLaw) {
    for (const double index : {1.5, 1.0, 1.0 / 1.33}) {
        std::size_t refracted = 0;
        std::size_t reflected = 0;
        for_all_rays("refract", {{"index", numbers({index})}},
                     [&](const Ray& ray, const Meeting& m, bool) {
                         const Vector before = cross(m.incident, m.normal);
                         EXPECT_EQ(ray.valid, length(before) < index);
                         ++(ray.valid ? refracted : reflected);
                         if (ray.valid) {
                             EXPECT_GT(dot(ray.direction, m.normal), 0.0);
                             expect_near(index * cross(ray.direction, m.normal), before, tolerance);
                         }
                     });
        EXPECT_GT(refracted, 0U);
        EXPECT_EQ(reflected > 0U, index < 1.0) << "total internal reflection";
    }
}

TEST(RefractRule, OfIndexOneGoesStraightOn) {
    for_all_rays("refract", {{"index", numbers({1.0})}},
                 [](const Ray& ray, const Meeting& m, bool) {
                     expect_near(ray.direction, m.incident, tolerance);
                 });
}

// A ray that is refracted into a medium and out of it through a parallel face has its direction.
TEST(RefractRule, IsUndoneByTheInverseIndex) {
    const auto arriving = look("along", {{"direction", numbers({0.6, 0.0, 0.8})}});
    const auto refract = [](double index, const DirectionRulePointer& incident) {
        return optical("refract", {{"index", numbers({index})},
                                   {"incident", Arguments::StagePointer(incident)}});
    };
    Camera::Parts parts =
        looking_at(object("sphere"), true, refract(1.0 / 1.7, refract(1.7, arriving)));
    parts.toward.reset();
    const CameraProbe rays(camera(parts), width, height);
    at_pixels([&](double x, double y) {
        expect_near(rays(x, y).direction, {0.6, 0.0, 0.8}, 1e-9);  // near grazing: 1e-16 / cosine
    });
}

// The focus of a parabolic mirror: parallel light meets there.
TEST(ReflectRule, TakesParallelLightToTheFocusOfAParaboloid) {
    const auto bowl = object("paraboloid", {{"by", std::string("cartesian")}});
    Camera::Parts parts = looking_at(
        bowl, true,
        optical("reflect", {{"incident", Arguments::StagePointer(look(
                                             "along", {{"direction", numbers({0, 0, -2.0})}}))}}));
    parts.toward.reset();
    const CameraProbe rays(camera(parts), width, height);
    const Sample rim = GeneratorProbe(bowl)(1.0, 0.0);
    const double focus = rim.point[0] * rim.point[0] / (4.0 * rim.point[2]);
    at_pixels([&](double x, double y) {
        const Ray ray = rays(x, y);
        const Vector to_focus = Vector{0.0, 0.0, focus} - ray.origin;
        EXPECT_NEAR(angle_between(ray.direction, to_focus), 0.0, 1e-7);  // acos of 1 - 1e-15
    });
}

TEST(OpticalRules, SayWhatTheyNeed) {
    for (const char* name : {"reflect", "refract"}) {
        const auto at = [&](const char* place, Given given = {}) {
            given["at"] = std::string(place);
            return optical(name, given);
        };
        const Given parallel{{"incident", Arguments::StagePointer(
                                              look("along", {{"direction", numbers({1, 0, 0})}}))}};
        EXPECT_TRUE(at("eye")->needs_direction_object());
        EXPECT_FALSE(at("eye", parallel)->needs_direction_object());
        EXPECT_TRUE(at("toward", parallel)->needs_direction_object());
        EXPECT_EQ(at("eye")->min_eye_dimension(), 2);
        EXPECT_EQ(at("toward")->min_eye_dimension(), 0);
        EXPECT_EQ(at("toward")->min_direction_dimension(), 2);
        const Result<Camera> made = Camera::make(looking_at(object("circle"), false, at("toward")));
        ASSERT_FALSE(made);
        EXPECT_NE(
            made.diagnostics.front().message.find("needs a surface, but the direction object"),
            std::string::npos);
    }
}

}  // namespace balcony::camera::optical_rules_test

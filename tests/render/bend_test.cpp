// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Pictures along bent rays: where they meet the scene and how long they are; the same as straight
// rays where they are straight; the same bits for any region and number of threads.

#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "balcony/inverse.hpp"
#include "balcony/lang.hpp"
#include "balcony/probe.hpp"
#include "support.hpp"

namespace balcony::render::test::bend_test {
namespace {

// Not multiples of the sides of packets and tiles.
constexpr std::size_t width = 75;
constexpr std::size_t height = 75;

// A camera that looks along -z; its picture spans -1 .. 1 at the distance 1.
camera::Camera bent(const std::string& bend) {
    const std::string text =
        "camera a { axes y_up aspect 1 map u = -1 .. 1, v = -1 .. 1 eye point "
        "toward surface(u, v) = [u, v, -1] " +
        bend + " }";
    const auto made = lang::make_camera(std::make_shared<const SourceText>("test.cam", text), "");
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    return *made;
}

// Falls by 5 s² on the way of 10 s, up to s = 1.2.
const std::string parabola =
    "bend curve(point(s, x, y, z, dx, dy, dz) = "
    "[x + 12*s*dx, y + 12*s*dy - 7.2*s^2, z + 12*s*dz], tolerance = 0.0001)";
const std::string straight =
    "bend curve(point(s, x, y, z, dx, dy, dz) = [x + 10*s*dx, y + 10*s*dy, z + 10*s*dz], "
    "parts = 7)";

// A textured wall, spheres in front of it, and a lamp.
scene::Scene varied_scene() {
    scene::Scene scene;
    scene::Material checked = white();
    checked.base_color_texture.index =
        add_texture(scene, encode_png(32, 32, 3, [](int x, int y) {
                        return std::vector<std::uint8_t>(3, (x / 4 + y / 4) % 2 == 0 ? 255 : 40);
                    }));
    add(scene, wall(-6.0F, 8.0F), checked);
    scene::M44d place;
    place.setTranslation(V3d(0.5, -0.5, -3.0));
    add(scene, coarse_sphere(0.8F, 16, 8), white(), place);
    scene::Light lamp;
    lamp.position = V3d(1.0, 3.0, 1.0);
    lamp.intensity = Color3f(40.0F);
    scene.lights.push_back(lamp);
    return scene;
}

// How many pixels differ by more than a rounding.
std::size_t differences(const Film& a, const Film& b) {
    std::size_t found = 0;
    for (std::size_t i = 0; i < a.sum.size(); ++i) {
        const Color4f by = a.sum[i] - b.sum[i];
        found += std::abs(by.r) + std::abs(by.g) + std::abs(by.b) + std::abs(by.a) > 2e-4F ? 1 : 0;
    }
    return found;
}

double sum_of(const Film& film) {
    double sum = 0.0;
    for (const Color4d& pixel : film.sum) {
        sum += pixel.g;
    }
    return sum;
}

bool same_bits(const Film& a, std::size_t i, const Film& b, std::size_t j) {
    const auto same = [](const auto& p, const auto& q) {
        return std::memcmp(&p, &q, sizeof(p)) == 0;
    };
    return same(a.sum[i], b.sum[j]) && same(a.layers->ray_length[i], b.layers->ray_length[j]) &&
           same(a.layers->position[i], b.layers->position[j]) &&
           same(a.layers->magnification[i], b.layers->magnification[j]);
}

}  // namespace

TEST(BentPicture, StraightPartsShowWhatStraightRaysShow) {
    const scene::Scene scene = varied_scene();
    for (const char* integrator : {"preview", "direct", "path"}) {
        Request wanted = request(width, height, integrator, 2);
        wanted.layout.layers = {LayerId::magnification};
        const Rendered exact = render(scene, bent(""), wanted);
        const Rendered found = render(scene, bent(straight), wanted);
        if (wanted.integrator == "path") {
            // A rounding may send a path elsewhere, or change what a first look finds. That changes
            // the noise of a tenth of the pixels, which is below 5 % of each: over all, less than
            // a thousandth.
            EXPECT_NEAR(sum_of(found.film) / sum_of(exact.film), 1.0, 1e-3);
        } else {
            EXPECT_EQ(differences(exact.film, found.film), 0U) << integrator;
        }
        EXPECT_EQ(exact.summary.layers[0].hits, found.summary.layers[0].hits);
        for (std::size_t i = 0; i < exact.film.sum.size(); ++i) {
            EXPECT_NEAR(exact.film.layers->ray_length[i], found.film.layers->ray_length[i], 1e-5);
            EXPECT_NEAR(exact.film.layers->magnification[i], found.film.layers->magnification[i],
                        1e-3);
        }
    }
}

// With direction d of unit length, the wall z = -6 is met where 10 s d_z = -6.
TEST(BentPicture, AParabolaMeetsAWallAtThePointAndLengthOfItsFormula) {
    scene::Scene scene;
    add(scene, wall(-6.0F, 30.0F), white());
    for (const char* integrator : {"preview", "direct", "path"}) {
        const Rendered found = render(scene, bent(parabola), request(width, height, integrator));
        for (std::size_t y = 0; y < height; y += 3) {
            for (std::size_t x = 0; x < width; x += 2) {
                const V3d d = V3d(2.0 * (static_cast<double>(x) + 0.5) / width - 1.0,
                                  1.0 - 2.0 * (static_cast<double>(y) + 0.5) / height, -1.0)
                                  .normalized();
                const double s = -0.6 / d.z;
                const V3d p = 10.0 * s * d - V3d(0.0, 5.0 * s * s, 0.0);
                const std::size_t i = y * width + x;
                // The tolerance across the curve, whose angle to the wall is above 18 degrees.
                EXPECT_LT((V3d(found.film.layers->position[i]) - p).length(), 3.3e-4);
                // The length of the curve by Simpson's rule.
                double length = 0.0;
                constexpr int steps = 200;
                for (int k = 0; k <= steps; ++k) {
                    const double at = s * k / steps;
                    const double speed = (10.0 * d - V3d(0.0, 10.0 * at, 0.0)).length();
                    length += (k == 0 || k == steps ? 1.0 : k % 2 == 1 ? 4.0 : 2.0) * speed;
                }
                length *= s / steps / 3.0;
                EXPECT_NEAR(found.film.layers->ray_length[i], length, 3.3e-4);
                const V3d tangent = V3d(found.film.layers->direction[i]) - d;
                EXPECT_LT(tangent.length(), 0.01) << "the direction is that at the origin";
            }
        }
    }
}

// What is seen at a hit is seen along the last part: the preview's light is the cosine there.
TEST(BentPicture, SurfacesAreSeenInTheDirectionOfTheLastPart) {
    scene::Scene scene;
    add(scene, wall(-6.0F, 30.0F), white());
    const Rendered found = render(scene, bent(parabola), request(width, height, "preview"));
    const std::size_t middle = (height / 2) * width + width / 2;
    const double s = 0.6;
    const V3d tangent = V3d(0.0, -10.0 * s, -10.0).normalized();
    // Half of the turn of one of 192 parts, 14.4 / (2 * 192 * 12), by the sine of 31 degrees.
    EXPECT_NEAR(found.film.sum[middle].g, -tangent.z, 0.0017);
}

TEST(BentPicture, RegionsAndThreadsGiveTheSameBits) {
    const scene::Scene scene = varied_scene();
    const Renderer renderer = renderer_of(scene);
    for (const char* integrator : {"preview", "direct", "path"}) {
        const auto rendered = [&](std::optional<Region> window, std::size_t threads) {
            Request wanted = request(width, height, integrator, 2);
            wanted.layout.window = window;
            wanted.layout.layers = {LayerId::magnification};
            wanted.threads = threads;
            Film film = *make_film(wanted.layout);
            EXPECT_TRUE(render::render(renderer, bent(parabola), wanted, film));
            return film;
        };
        const Film whole = rendered({}, 1);
        const Film threaded = rendered({}, 3);
        for (std::size_t i = 0; i < whole.sum.size(); ++i) {
            ASSERT_TRUE(same_bits(whole, i, threaded, i)) << integrator;
        }
        const Region window{13, 7, 41, 22};
        const Film part = rendered(window, 1);
        for (std::size_t y = window.y; y < window.y + window.height; ++y) {
            for (std::size_t x = window.x; x < window.x + window.width; ++x) {
                ASSERT_TRUE(same_bits(part, part.index(x, y), whole, whole.index(x, y)))
                    << integrator;
            }
        }
    }
}

// No light comes through between two parts, on a floor along which they lie.
TEST(BentPicture, NothingIsBetweenTheParts) {
    scene::Scene scene;
    add(scene, wall(-3.0F, 30.0F), white());
    // Knots on the wall itself, up to rounding.
    const camera::Camera camera = bent(
        "bend curve(point(s, x, y, z, dx, dy, dz) = "
        "[x - 6*s*dx/dz, y - 6*s*dy/dz, z - 6*s], parts = 2)");
    const Rendered found = render(scene, camera, request(width, height, "preview"));
    for (std::size_t i = 0; i < found.film.sum.size(); ++i) {
        ASSERT_GT(found.film.sum[i].a, 0.99F);
        ASSERT_NEAR(found.film.layers->position[i].z, -3.0, 1e-5);
    }
}

// A fully transparent place does not end a bent ray, which goes on along its bend.
TEST(BentPicture, RaysAreBentBehindWhatIsTransparent) {
    scene::Scene scene;
    scene::Material clear = white();
    clear.alpha_mode = scene::AlphaMode::blend;
    clear.alpha = 0.0F;
    add(scene, wall(-2.0F, 30.0F), clear);
    add(scene, wall(-6.0F, 30.0F), white());
    for (const char* integrator : {"preview", "path"}) {
        const Rendered found = render(scene, bent(parabola), request(width, height, integrator));
        const std::size_t middle = (height / 2) * width + width / 2;
        EXPECT_NEAR(found.film.layers->position[middle].y, -5.0 * 0.36, 3.3e-4);
    }
}

// A layer beside one with straight rays is what each of them shows by itself.
TEST(BentPicture, ALayerStandsBesideStraightOnes) {
    const std::string text =
        "camera one { axes y_up aspect 1 map u = -1 .. 1, v = -1 .. 1 eye point "
        "toward surface(u, v) = [u, v, -1] " +
        parabola +
        " } camera two { axes y_up aspect 1 map u = -1 .. 1, v = -1 .. 1 eye point "
        "toward surface(u, v) = [u, v, -1] } "
        "picture both { aspect 2 layer one { place (0, 0) .. (1/2, 1) } "
        "layer two { place (1/2, 0) .. (1, 1) } }";
    const auto picture =
        lang::make_picture(std::make_shared<const SourceText>("test.cam", text), "both");
    ASSERT_TRUE(picture) << to_text(picture.diagnostics);
    const scene::Scene scene = varied_scene();
    const Rendered all = render(scene, *picture, request(2 * width, width, "direct"));
    const Rendered left = render(scene, bent(parabola), request(width, width, "direct"));
    const Rendered right = render(scene, bent(""), request(width, width, "direct"));
    std::size_t different = 0;
    for (std::size_t y = 0; y < width; ++y) {
        for (std::size_t x = 0; x < width; ++x) {
            const auto differs = [](const Color4f& a, const Color4f& b) {
                return std::abs(a.g - b.g) > 1e-3F;
            };
            different += differs(all.film.sum[y * 2 * width + x], left.film.sum[y * width + x]);
            different +=
                differs(all.film.sum[y * 2 * width + width + x], right.film.sum[y * width + x]);
        }
    }
    EXPECT_EQ(different, 0U);
}

// The points of still surfaces are exact, as they are on their rays.
TEST(BentPicture, NothingMovesInTheMotionLayer) {
    // Few parts, as the inverse searches each by itself.
    const camera::Camera camera =
        bent(parabola.substr(0, parabola.find("tolerance")) + "parts = 16)");
    const auto inverse = analyse::Locator::make(camera, width, height, 0.0);
    ASSERT_TRUE(inverse) << to_text(inverse.diagnostics);
    Request wanted = request(width, height, "preview");
    wanted.layout.layers = {LayerId::motion};
    wanted.frames.duration = 0.04;
    wanted.frames.previous = std::make_shared<const analyse::Locator>(*inverse);
    wanted.frames.next = wanted.frames.previous;
    const Rendered still = render(varied_scene(), camera, wanted);
    EXPECT_EQ(still.summary.unknown_motion, 0U);
    for (const V4f& motion : still.film.layers->motion) {
        // The accuracy of the inverse.
        ASSERT_LT(motion.length(), 1e-6F);
    }
}

TEST(BentPicture, AProbeFollowsBends) {
    scene::Scene scene;
    add(scene, wall(-6.0F, 30.0F), white());
    const Renderer renderer = renderer_of(scene);
    ProbeSettings settings;
    settings.width = width;
    settings.height = height;
    const auto found = probe(renderer, bent(parabola), settings);
    ASSERT_TRUE(found) << to_text(found.diagnostics);
    EXPECT_TRUE(found->objects[0].seen);
    ASSERT_TRUE(found->median_distance);
    const auto direct = probe(renderer, bent(""), settings);
    EXPECT_GT(*found->median_distance, *direct->median_distance + 0.1);
}

}  // namespace balcony::render::test::bend_test

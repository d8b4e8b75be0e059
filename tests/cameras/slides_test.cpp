// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Slides for backdrops: the projection is simulated step by step, with the backdrop as the border
// between what is in front of it and what is beyond.

#include <array>
#include <fstream>
#include <functional>
#include <sstream>

#include <fmt/format.h>

#include "support.hpp"

namespace balcony::cameras::test::slides_test {

namespace {

using Beyond = std::function<bool(const V3d& point)>;

const V3d seat(-0.5, 0.8, 0.3);
const V3d projector(-3.0, 4.0, 3.0);
const V3d aim(10.0, 0.5, 0.2);

/// Where light from the projector crosses the border, by small steps and bisection.
V3d thrown(const V3d& direction, const Beyond& beyond) {
    constexpr double step = 0.01;
    double s = 0.0;
    while (!beyond(projector + (s + step) * direction) && s < 60.0) {
        s += step;
    }
    double low = s, high = s + step;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (beyond(projector + middle * direction) ? high : low) = middle;
    }
    return projector + low * direction;
}

/// The slide's point at (x, y) goes to a point of the backdrop. The camera must show there what the
/// seat sees behind it.
void expect_undistorted(const std::string& name, const Beyond& beyond,
                        std::vector<lang::Override> set = {}, double tolerance = 1e-8) {
    const auto text = [](const V3d& a) { return fmt::format("({}, {}, {})", a.x, a.y, a.z); };
    set.insert(set.end(), {{"seat", text(seat)},
                           {"projector", text(projector)},
                           {"aim", text(aim)},
                           {"throw", "30deg"}});
    const Rays slide(name, set);
    EXPECT_NEAR(slide.width() / slide.height(), 1.5, 1e-12);
    const V3d ahead = (aim - projector).normalized();
    const V3d right = ahead.cross(V3d(0.0, 0.0, 1.0)).normalized();
    const V3d up = right.cross(ahead);
    const double half = std::tan(15.0 * degree);
    int lit = 0;
    for (double x = 0.03; x < 1.0; x += 0.047) {
        for (double y = 0.03; y < 1.0; y += 0.071) {
            const V3d out =
                ahead + right * (half * (2.0 * x - 1.0)) + up * (half / 1.5 * (1.0 - 2.0 * y));
            const V3d point = thrown(out.normalized(), beyond);
            const Ray ray = slide.at(x, y);
            if (!ray.valid) {
                continue;
            }
            expect_near(ray.origin, seat, 1e-12);
            expect_near(ray.direction, (point - seat).normalized(), tolerance);
            ++lit;
        }
    }
    EXPECT_GT(lit, 200);
}

/// The mesh of a file as a height field: x above (y, z).
class Cloth {
public:
    explicit Cloth(const std::string& file) {
        std::ifstream stream(file);
        std::vector<V3d> points;
        for (std::string line; std::getline(stream, line);) {
            std::istringstream words(line);
            std::string keyword;
            words >> keyword;
            if (keyword == "v") {
                V3d p;
                words >> p.x >> p.y >> p.z;
                points.emplace_back(p.x, -p.z, p.y);  // The file has y up.
            } else if (keyword == "f") {
                std::vector<V3d> corners;
                for (std::string corner; words >> corner;) {
                    corners.push_back(points.at(std::stoul(corner) - 1));
                }
                for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
                    triangles_.push_back({corners[0], corners[i], corners[i + 1]});
                }
            }
        }
    }
    [[nodiscard]] std::size_t size() const { return triangles_.size(); }
    [[nodiscard]] bool is_behind(const V3d& p) const {
        for (const auto& [a, b, c] : triangles_) {
            const auto area = [](const V3d& o, const V3d& q, const V3d& r) {
                return (q.y - o.y) * (r.z - o.z) - (q.z - o.z) * (r.y - o.y);
            };
            const double all = area(a, b, c);
            const double wb = area(a, p, c) / all, wc = area(a, b, p) / all;
            if (wb >= 0.0 && wc >= 0.0 && wb + wc <= 1.0) {
                return p.x > a.x + wb * (b.x - a.x) + wc * (c.x - a.x);
            }
        }
        return false;
    }

private:
    std::vector<std::array<V3d, 3>> triangles_;
};

}  // namespace

TEST(Slide, LooksUndistortedOnAPlane) {
    for (const auto& [turn, lean] : {std::pair(20.0, 0.0), std::pair(-35.0, 15.0)}) {
        const double a = turn * degree, b = lean * degree;
        // Ahead is the normal of the back side: turned to the left, then leaning back.
        const V3d ahead(std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), -std::sin(b));
        expect_undistorted("slide_flat",
                           [&](const V3d& p) { return (p - V3d(9.0, 1.0, 0.0)).dot(ahead) > 0.0; },
                           {{"at", "(9, 1, 0)"},
                            {"turn", fmt::format("{}deg", turn)},
                            {"lean", fmt::format("{}deg", lean)}});
    }
}

TEST(Slide, LooksUndistortedOnACylinder) {
    const auto outside = [](const V3d& p) { return std::hypot(p.x - 2.0, p.y - 0.5) > 7.5; };
    expect_undistorted("slide_curved", outside, {{"radius", "7.5"}, {"axis", "(2, 0.5)"}});
}

TEST(Slide, LooksUndistortedOnAFoldedScreen) {
    const std::vector<V2d> screen{{9.0, 6.0}, {11.0, 2.0}, {9.0, 0.0}, {11.0, -2.0}, {9.0, -6.0}};
    const auto behind = [&](const V3d& p) {
        for (std::size_t i = 0; i + 1 < screen.size(); ++i) {
            const V2d &a = screen[i], &b = screen[i + 1];
            if (a.y >= p.y && p.y >= b.y) {
                return p.x > a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x);
            }
        }
        return false;
    };
    expect_undistorted("slide_folded", behind,
                       {{"screen", "[(9, 6), (11, 2), (9, 0), (11, -2), (9, -6)]"}});
}

TEST(Slide, LooksUndistortedOnAMesh) {
    const Cloth cloth(std::string(BALCONY_SOURCE_DIR) + "/cameras/data/backdrop.obj");
    ASSERT_GT(cloth.size(), 100U);
    // A scene has positions in single precision: half a unit in the last place of 10 units is 5e-7,
    // seen from a distance of 10.
    constexpr double tolerance = 5e-8;
    expect_undistorted(
        "slide_mesh", [&](const V3d& p) { return cloth.is_behind(p); }, {}, tolerance);
}

TEST(Slide, IsReportedIfTheProjectorCannotSeeTheBackdrop) {
    for (const char* name : {"slide_flat", "slide_folded", "slide_mesh"}) {
        const auto made = lang::make_camera(name, "", {lang::Override{"aim", "(-30, 4, 3)"}});
        ASSERT_FALSE(made) << name;
        EXPECT_NE(to_text(made.diagnostics).find("the backdrop cannot be seen from there"),
                  std::string::npos);
    }
    // The whole cylinder is behind the projector.
    const auto made = lang::make_camera("slide_curved", "",
                                        {{"projector", "(-30, 0, 0)"}, {"aim", "(-60, 0, 0)"}});
    ASSERT_FALSE(made);
}

}  // namespace balcony::cameras::test::slides_test

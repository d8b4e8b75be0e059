// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <numbers>

#include "measure/measure.hpp"
#include "measure/property.hpp"
#include "scenes/dancer/figure.hpp"

namespace balcony::plates {

static double distance_to(const std::vector<V3d>& path, const V3d& point) {
    double least = 1e9;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const V3d along = path[i + 1] - path[i];
        const double t = std::clamp((point - path[i]).dot(along) / along.length2(), 0.0, 1.0);
        least = std::min(least, (point - path[i] - t * along).length());
    }
    return least;
}

constexpr double expected_turns = 1.5;

// A place of the dancer that a row of the picture shows, where it is while she stands still.
static V3d turned_back(const render::Film& film, std::size_t pixel) {
    const double y =
        (static_cast<double>(pixel / film.width) + 0.5) / static_cast<double>(film.height);
    const double angle = dancer_start + 2.0 * std::numbers::pi * expected_turns * (1.0 - y);
    const V3d seen(film.layers->position[pixel]);
    return {std::cos(angle) * seen.x + std::sin(angle) * seen.y,
            std::cos(angle) * seen.y - std::sin(angle) * seen.x, seen.z};
}

// The pixels of the objects whose names begin alike, row by row.
static std::vector<std::size_t> pixels_of(const render::Film& film, const std::string& begin) {
    std::vector<std::size_t> pixels;
    for (std::size_t pixel = 0; pixel < film.layers->object.size(); ++pixel) {
        const std::uint32_t id = film.layers->object[pixel];
        if (id != 0 && film.objects[id - 1].compare(0, begin.size(), begin) == 0) {
            pixels.push_back(pixel);
        }
    }
    return pixels;
}

// How often an object is in the column in the middle of the picture, in front of the z axis:
// neighbouring rows are one time.
static std::size_t passes(const render::Film& film, const std::vector<std::size_t>& pixels) {
    std::size_t count = 0;
    std::size_t next_row = film.height;
    for (const std::size_t pixel : pixels) {
        if (pixel % film.width == film.width / 2 && film.layers->position[pixel].y < 0.0F) {
            const std::size_t row = pixel / film.width;
            count += row == next_row ? 0 : 1;
            next_row = row + 1;
        }
    }
    return count;
}

// The dancer turns while the picture is read from its foot to its top. So what a row shows of the
// golden edge of a veil, turned back by the angle of the row's time, is the edge of the veil that
// stands still: within its radius, and the 0.0004 that the outermost point is off its circle
// in the middle of one of the 128 steps of its movement. Each turn, the edge of each veil passes
// once in front of her.
static Measurements measure_twist(Studio& studio, const Overrides& overrides) {
    const render::Film film = studio.look({.scene = "dancer",
                                           .camera = "17-fourth-dimension/camera.cam",
                                           .name = "slit_scan",
                                           .width = 240,
                                           .height = 360},
                                          overrides);
    double farthest = 0.0;
    std::size_t passed = 0;
    for (const double side : {-1.0, 1.0}) {
        const auto pixels = pixels_of(film, side < 0.0 ? "edge left" : "edge right");
        const std::vector<V3d> still = dancer_veil_edge(side);
        for (const std::size_t pixel : pixels) {
            farthest = std::max(farthest, distance_to(still, turned_back(film, pixel)));
        }
        passed += passes(film, pixels);
    }
    return {{"distance of a veil's edge from its place at the time of the row", farthest, 0,
             dancer_edge_radius + 0.0005},
            {"times that an edge passes in front of the dancer", passed, 2, 3}};
}

// Read at once, or at another speed.
Property plate_17() { return {17, measure_twist, {{{"turns", "0"}}, {{"turns", "1.4"}}}}; }

}  // namespace balcony::plates

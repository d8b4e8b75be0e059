// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstddef>
#include <limits>
#include <set>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include "balcony/lang.hpp"
#include "balcony/rays.hpp"
#include "measure/measure.hpp"
#include "measure/property.hpp"
#include "scenes/lane/lane.hpp"

namespace balcony::plates {

namespace three_corners_plate {

const char* const camera_file = BALCONY_PLATES "/22-three-corners/camera.cam";

// The longest step between the same knots of the paths of neighbouring pixels, in metres.
double longest_step(const camera::Camera& camera, std::size_t height) {
    const auto width =
        static_cast<std::size_t>(static_cast<double>(height) * camera.parts().aspect);
    const auto program = rays::compile(camera, static_cast<double>(width),
                                       static_cast<double>(height), {.bends = true});
    if (!program) {
        throw std::runtime_error(to_text(program.diagnostics));
    }
    rays::Scratch scratch;
    rays::RayBatch row;
    std::vector<scene::V3d> above;
    double longest = 0.0;
    for (std::size_t y = 0; y < height; ++y) {
        program->run(rays::Tile{0.5, static_cast<double>(y) + 0.5, 1.0, width, 1}, scratch, row);
        const std::size_t parts = row.part_count();
        std::vector<scene::V3d> knots;
        for (std::size_t x = 0; x < width; ++x) {
            for (std::size_t part = 0; part < parts; ++part) {
                knots.push_back(row.part(x, part).origin);
                if (x > 0) {
                    longest = std::max(longest,
                                       (knots.back() - knots[knots.size() - 1 - parts]).length());
                }
            }
        }
        for (std::size_t i = 0; i < above.size(); ++i) {
            longest = std::max(longest, (knots[i] - above[i]).length());
        }
        above = std::move(knots);
    }
    return longest;
}

// Houses of both sides of all legs are seen, and the clock behind the last corner; the paths of
// rays have no cut.
Measurements measure(Studio& studio, const Overrides& overrides) {
    const render::Film film = studio.look(
        {.scene = "lane", .camera = "22-three-corners/camera.cam", .width = 640, .height = 400},
        overrides);
    std::size_t rows = 0;
    for (std::size_t leg = 1; leg <= lane::legs; ++leg) {
        for (const char* side : {"left", "right"}) {
            rows += sightings_of(film, fmt::format("{} house {}.", side, leg)).pixels > 20 ? 1 : 0;
        }
    }
    const ObjectPixels clock = object_pixels(film, "clock face");
    const auto id = static_cast<std::uint32_t>(
        std::find(film.objects.begin(), film.objects.end(), "clock face") - film.objects.begin() +
        1);
    double way = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < film.layers->object.size(); ++i) {
        if (film.layers->object[i] == id) {
            way = std::min(way, static_cast<double>(film.layers->ray_length[i]));
        }
    }
    const auto camera = lang::make_camera(camera_file, "three_corners", overrides);
    if (!camera) {
        throw std::runtime_error(to_text(camera.diagnostics));
    }
    return {{"rows of houses that are seen, of the eight on both sides of four legs", rows, 7},
            {"share of the picture's height that the clock takes",
             static_cast<double>(clock.max_y - clock.min_y + 1) / 400.0, 0.02},
            {"length in metres of the way to the clock", way, 140.0, 170.0},
            {"longest step between the paths of neighbouring pixels at twice the resolution",
             longest_step(*camera, 400) / longest_step(*camera, 200), 0.0, 0.6}};
}

}  // namespace three_corners_plate

Property plate_22() {
    return {22, three_corners_plate::measure, {{{"distance", "0.3"}}, {{"eye_height", "30"}}}};
}

}  // namespace balcony::plates

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Whole frames of the gallery of plates 1 to 3, on one core: the share of the camera in them, and
// an extended camera against a pinhole.

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string_view>

#include <fmt/core.h>

#include "balcony/render.hpp"
#include "bench_case.hpp"
#include "gallery/gallery.hpp"

namespace balcony::bench {

namespace {

constexpr int runs = 5;

struct FrameCase {
    const char* name;
    const char* text;
};

// The pinhole looks along the room with the plate's own field; the zoomed camera is the one that
// costs most a ray.
constexpr FrameCase frame_cases[]{
    {"pinhole",
     "camera pinhole { map u = 1 .. -1, v = square eye point(0, 0, 0) toward plane((1, 0, 0)) }"},
    {"superelliptic (plate 2)",
     "camera superelliptic {"
     "    aspect 5 map u = 210.85deg .. -149.15deg, v = -36deg .. 36deg"
     "    eye product(superellipse(1, 25/45, 1/4, by = arc_length),"
     "                superellipse(45, 25, 1/4, by = arc_length)) }"},
    {"superelliptic, local zoom",
     "camera zoomed {"
     "    aspect 5 map u = 210.85deg .. -149.15deg, v = -36deg .. 36deg"
     "    warp zoom(at = (0, 0), radius = 0.5, strength = 2)"
     "    eye product(superellipse(1, 25/45, 1/4, by = arc_length),"
     "                superellipse(45, 25, 1/4, by = arc_length)) }"},
};

render::Summary fastest_frame(const render::Renderer& renderer, const camera::Camera& camera,
                              std::string_view integrator) {
    render::Settings settings;
    settings.samples = 2;
    settings.threads = 1;
    settings.integrator = integrator;
    render::Summary fastest;
    fastest.seconds = std::numeric_limits<double>::infinity();
    for (int run = 0; run < runs; ++run) {
        render::Film film =
            *render::make_film({.width = 1500, .height = 300, .data_layers = false});
        const auto summary = render::render(renderer, camera, settings, film);
        if (!summary) {
            throw std::runtime_error(to_text(summary.diagnostics));
        }
        if (summary->seconds < fastest.seconds) {
            fastest = *summary;
        }
    }
    return fastest;
}

render::Renderer make_renderer() {
    auto gallery = plates::make_gallery({.painting_scale = 0.1});
    if (!gallery) {
        throw std::runtime_error(to_text(gallery.diagnostics));
    }
    auto renderer =
        render::Renderer::make(std::make_shared<const scene::Scene>(std::move(*gallery)));
    if (!renderer) {
        throw std::runtime_error(to_text(renderer.diagnostics));
    }
    return std::move(*renderer);
}

}  // namespace

void print_frames() {
    const render::Renderer renderer = make_renderer();
    fmt::print(
        "\nwhole frames of the gallery, one core, 1500 x 300, 2 rays a pixel\n"
        "(the last column: the frame against itself if its rays cost what a pinhole's do)\n\n");
    fmt::print("{:<28}{:<12}{:>12}{:>14}{:>16}{:>12}\n", "camera", "integrator", "Mrays/s",
               "camera share", "against pinhole", "same rays");
    for (const std::string_view integrator : {"preview", "direct"}) {
        std::optional<render::Summary> pinhole;
        for (const FrameCase& row : frame_cases) {
            const render::Summary frame =
                fastest_frame(renderer, make_camera(row.text), integrator);
            if (!pinhole) {
                pinhole = frame;
            }
            const double with_pinhole_rays = frame.seconds * (1.0 - frame.camera_share) +
                                             pinhole->seconds * pinhole->camera_share;
            fmt::print("{:<28}{:<12}{:>12.2f}{:>12.2f} %{:>14.2f} x{:>10.2f} x\n", row.name,
                       integrator, 1e-6 * static_cast<double>(frame.camera_rays) / frame.seconds,
                       100.0 * frame.camera_share, frame.seconds / pinhole->seconds,
                       frame.seconds / with_pinhole_rays);
        }
    }
}

}  // namespace balcony::bench

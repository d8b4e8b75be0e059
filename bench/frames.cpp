// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Whole frames on one core: the share of the camera in them, an extended camera against a pinhole,
// and a preview against Embree's packets by themselves, on the same rays.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include "balcony/render.hpp"
#include "bare_embree.hpp"
#include "bench_case.hpp"
#include "scenes/gallery/gallery.hpp"
#include "timing.hpp"

namespace balcony::bench {

namespace {

constexpr int runs = 7;

struct FrameCase {
    const char* name;
    const char* text;
};

// The pinhole looks along the room with the plate's own field; the zoomed camera is the one that
// costs most a ray. Plate 3 has the camera of plate 2.
constexpr FrameCase frame_cases[]{
    {"pinhole",
     "camera pinhole { map u = 1 .. -1, v = square eye point(0, 0, 0) toward plane((1, 0, 0)) }"},
    {"pinhole (plate 1)",
     "camera pinhole { map u = tan(37.5deg) .. -tan(37.5deg), v = square eye point(0, 0, 0)"
     "    toward plane((1, 0, 0)) move rotate(z, 28deg), translate(-40, -20, 0) }"},
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

constexpr std::size_t frame_width = 1500;
constexpr std::size_t frame_height = 300;

template <class Value>
Value checked(Result<Value> result) {
    if (!result) {
        throw std::runtime_error(to_text(result.diagnostics));
    }
    return std::move(*result);
}

// The fastest of several frames, which have a ray through the centre of each pixel, and the least
// time in which Embree's packets trace these rays by themselves. They take turns, so that whatever
// disturbs the machine for a while disturbs both.
struct Measured {
    render::Summary frame;
    double bare_seconds = std::numeric_limits<double>::infinity();
};

Measured measure(const render::Renderer& renderer, const BareEmbree& world,
                 const camera::Camera& camera, Axes axes, std::string_view integrator) {
    const auto rays = checked(rays::compile(camera, static_cast<double>(frame_width),
                                            static_cast<double>(frame_height),
                                            rays::CompileOptions{.axes = axes}));
    const auto tiles = tiles_of_picture(frame_width, frame_height, render::tile_height);
    static_assert(render::tile_width == program::max_tile_width);
    render::Settings settings;
    settings.samples = 1;
    settings.threads = 1;
    settings.integrator = integrator;
    Measured fastest;
    fastest.frame.seconds = std::numeric_limits<double>::infinity();
    for (int run = 0; run < runs; ++run) {
        render::Film film = checked(render::make_film(
            {.width = frame_width, .height = frame_height, .data_layers = false}));
        const auto summary = checked(render::render(renderer, camera, settings, film));
        if (summary.seconds < fastest.frame.seconds) {
            fastest.frame = summary;
        }
        fastest.bare_seconds = std::min(fastest.bare_seconds, world.seconds(rays, tiles));
    }
    return fastest;
}

scene::Scene gallery() { return checked(plates::make_gallery({.texture_scale = 0.5})); }

scene::Scene without_textures(scene::Scene scene) {
    for (scene::Material& material : scene.materials) {
        for (const auto use : scene::texture_uses) {
            (material.*use).index = {};
        }
    }
    return scene;
}

// A ball of radius 1 with waves on it, in rings and segments of triangles.
scene::Mesh wavy_ball(std::size_t rings, std::size_t segments) {
    using std::numbers::pi;
    scene::Mesh mesh;
    for (std::size_t i = 0; i <= rings; ++i) {
        for (std::size_t j = 0; j <= segments; ++j) {
            const double polar = pi * static_cast<double>(i) / static_cast<double>(rings);
            const double turn = 2.0 * pi * static_cast<double>(j) / static_cast<double>(segments);
            const double radius = 1.0 + 0.03 * std::sin(20.0 * polar) * std::sin(18.0 * turn);
            const Imath::V3d out(std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn),
                                 std::cos(polar));
            mesh.positions.emplace_back(radius * out);
            mesh.normals.emplace_back(out);
        }
    }
    const auto row = static_cast<std::uint32_t>(segments + 1);
    for (std::uint32_t i = 0; i < rings; ++i) {
        for (std::uint32_t j = 0; j < segments; ++j) {
            const std::uint32_t corner = i * row + j;
            mesh.triangles.push_back({corner, corner + row, corner + 1});
            mesh.triangles.push_back({corner + 1, corner + row, corner + row + 1});
        }
    }
    return mesh;
}

// The gallery with seven balls of two million triangles in all.
scene::Scene crowded_room() {
    scene::Scene scene = without_textures(gallery());
    constexpr int balls = 7;
    for (int ball = 0; ball < balls; ++ball) {
        const double turn = 2.0 * std::numbers::pi * ball / balls;
        scene::Mesh mesh = wavy_ball(270, 540);
        mesh.material = scene::MaterialIndex(0);
        scene.meshes.push_back(std::move(mesh));
        scene::Instance instance;
        instance.mesh = scene::MeshIndex(scene.meshes.size() - 1);
        instance.world_from_mesh.setScale(7.0);
        instance.world_from_mesh[3][0] = 30.0 * std::cos(turn);
        instance.world_from_mesh[3][1] = 18.0 * std::sin(turn);
        scene.instances.push_back(instance);
    }
    return scene;
}

void print_frames_of(std::string_view name, scene::Scene built,
                     std::initializer_list<std::string_view> integrators) {
    const auto scene = std::make_shared<const scene::Scene>(std::move(built));
    const render::Renderer renderer = checked(render::Renderer::make(scene));
    const BareEmbree world(*scene);
    for (const std::string_view integrator : integrators) {
        std::optional<render::Summary> pinhole;
        for (const FrameCase& row : frame_cases) {
            const camera::Camera camera = make_camera(row.text);
            const auto [frame, bare_seconds] =
                measure(renderer, world, camera, scene->axes, integrator);
            if (!pinhole) {
                pinhole = frame;
            }
            const double with_pinhole_rays = frame.seconds * (1.0 - frame.camera_share) +
                                             pinhole->seconds * pinhole->camera_share;
            const double rays_per_second = static_cast<double>(frame.camera_rays) / frame.seconds;
            const double bare = static_cast<double>(frame.camera_rays) / bare_seconds;
            fmt::print(
                "{:<20}{:<28}{:<10}{:>9.2f}{:>10.2f}{:>8.0f} %{:>12.2f} %{:>14.2f} x"
                "{:>10.2f} x\n",
                name, row.name, integrator, 1e-6 * rays_per_second, 1e-6 * bare,
                100.0 * rays_per_second / bare, 100.0 * frame.camera_share,
                frame.seconds / pinhole->seconds, frame.seconds / with_pinhole_rays);
        }
    }
}

}  // namespace

void print_frames() {
    fmt::print(
        "\nwhole frames, one core, {} x {}, 1 ray a pixel, in million rays a second\n"
        "(bare: Embree's packets by themselves with the same rays; the last column: the frame\n"
        "against itself if its rays cost what a pinhole's do)\n\n",
        frame_width, frame_height);
    fmt::print("{:<20}{:<28}{:<10}{:>9}{:>10}{:>10}{:>14}{:>16}{:>12}\n", "scene", "camera",
               "integrator", "Mrays/s", "bare", "of it", "camera share", "against pinhole",
               "same rays");
    print_frames_of("gallery", gallery(), {"preview", "direct"});
    print_frames_of("without textures", without_textures(gallery()), {"preview"});
    print_frames_of("grid alone", checked(plates::make_gallery({.pictures_and_walls = false})),
                    {"preview"});
    print_frames_of("2 million triangles", crowded_room(), {"preview"});
}

}  // namespace balcony::bench

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The same cameras in the camera language, as users write them.

#include <memory>
#include <stdexcept>

#include <fmt/format.h>

#include "balcony/lang.hpp"
#include "bench_case.hpp"

namespace balcony::bench {

namespace {

std::string superelliptic_text(const std::string& warp) {
    const Superelliptic camera;
    return fmt::format(
        "camera superelliptic {{\n"
        "    map  u = -{0} .. {0}, v = -{1} .. {1}\n"
        "    eye  product(superellipse(1, {3}/{2}, 2/{5}), superellipse({2}, {4}, 2/{5}))\n"
        "    {6}\n"
        "    look normal\n"
        "}}\n",
        camera.max_u, camera.max_v, camera.a, camera.b, camera.c, camera.exponent, warp);
}

std::string zoom_text() {
    const Zoom zoom;
    return fmt::format("warp zoom(at = ({}, {}), radius = {}, strength = {})", zoom.u, zoom.v,
                       zoom.radius, zoom.strength);
}

std::string pinhole_text() {
    const Pinhole camera;
    return fmt::format(
        "camera pinhole {{\n"
        "    map    u = {0} .. -{0}, v = -{1} .. {1}\n"
        "    eye    point(0, 0, 0)\n"
        "    toward plane((1, 0, 0))\n"
        "}}\n",
        camera.half_width, camera.half_height);
}

}  // namespace

camera::Camera make_camera(const std::string& text) {
    auto made = lang::make_camera(std::make_shared<const SourceText>("bench", text), "");
    if (!made) {
        throw std::runtime_error(to_text(made.diagnostics));
    }
    return std::move(*made);
}

program::Program compile(const camera::Camera& camera, std::size_t width, std::size_t height) {
    expr::Graph graph;
    const auto ray = camera.emit(graph, static_cast<double>(width), static_cast<double>(height));
    const std::vector<expr::Expr> roots{ray.origin.x,    ray.origin.y,    ray.origin.z,
                                        ray.direction.x, ray.direction.y, ray.direction.z,
                                        ray.valid};
    return program::Program(roots);
}

std::vector<Case> cases() {
    std::vector<Case> rows;
    const auto add = [&rows](const char* name, const std::string& text, PlainLoop loop) {
        rows.push_back({name, compile(make_camera(text), picture_width, picture_height), loop});
    };
    add("superelliptic (plate 2)", superelliptic_text(""), plain_superelliptic);
    add("superelliptic, local zoom", superelliptic_text(zoom_text()), plain_zoomed_superelliptic);
    add("pinhole", pinhole_text(), plain_pinhole);
    return rows;
}

}  // namespace balcony::bench

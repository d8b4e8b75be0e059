// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#pragma once

// Small scenes and cameras made by hand.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "balcony/camera.hpp"
#include "balcony/render.hpp"
#include "balcony/scene.hpp"

namespace balcony::render::test {

using Imath::V3d;

/// Runs a check on each instruction set of this machine that Balcony promises the same bits for.
void on_each_target(const std::function<void()>& check);

// ------------------------------------------------------------------------------------ cameras

/// A ray of a test camera as formulas of u = -1 .. 1 (left to right), v = -1 .. 1 (bottom to top).
struct RayFormula {
    std::function<camera::ObjectPoint(const camera::ParameterPoint&, camera::Emitter&)> origin;
    std::function<camera::ObjectVector(const camera::ParameterPoint&, camera::Emitter&)> direction;
};

[[nodiscard]] camera::Camera make_camera(RayFormula formula, Axes axes = Axes::y_up);

/// Where a camera stands, whose picture spans -1 .. 1 along right and up.
struct View {
    V3d eye;
    V3d forward;
    V3d right;
    V3d up;
};

/// Looks along -z from (x, y, z).
[[nodiscard]] View view_down_z(double x, double y, double z);

/// Rays through eye + forward + u right + v up.
[[nodiscard]] camera::Camera pinhole(const View& view, Axes axes = Axes::y_up);
/// Rays from eye + u right + v up along forward.
[[nodiscard]] camera::Camera orthographic(const View& view, Axes axes = Axes::y_up);

// ------------------------------------------------------------------------------------- scenes

/// A parallelogram: corner, corner + right, corner + up, texture upright as seen from the side
/// where right × up points.
[[nodiscard]] scene::Mesh parallelogram(V3f corner, V3f right, V3f up);

/// Adds a mesh as an object of its own with a material of its own; gives the object's id.
std::uint32_t add(scene::Scene& scene, scene::Mesh mesh, scene::Material material,
                  const scene::M44d& world_from_mesh = {});

/// A wall in the plane z = z, from -half to half in x and y.
[[nodiscard]] scene::Mesh wall(float z, float half);

/// A sphere around the origin, of few facets with the normals of a sphere.
[[nodiscard]] scene::Mesh coarse_sphere(float radius, std::uint32_t columns, std::uint32_t rows);

[[nodiscard]] scene::Material white();

/// That of a scene without faults.
[[nodiscard]] Renderer renderer_of(const scene::Scene& scene);

/// A scene that can stand at a time, as it stands then.
[[nodiscard]] std::shared_ptr<const scene::Scene> at_time(const scene::Scene& scene, double time);

/// An image as PNG, 3 or 4 channels of 8 bits.
using Pixels = std::function<std::vector<std::uint8_t>(int x, int y)>;
[[nodiscard]] std::vector<std::uint8_t> encode_png(int width, int height, int channels,
                                                   const Pixels& pixels);
scene::TextureIndex add_texture(scene::Scene& scene, std::vector<std::uint8_t> bytes);

// ------------------------------------------------------------------------------------ pictures

/// What is asked of a render, and of the film that it is for.
struct Request : Settings {
    FilmLayout layout;
};

/// No ambient light, all data layers, and the exact estimator of `path`.
[[nodiscard]] Request request(std::size_t width, std::size_t height, std::string integrator,
                              std::size_t samples = 1);

struct Rendered {
    Film film;
    Summary summary;
};

/// Renders; fails the test on any diagnostic.
[[nodiscard]] Rendered render(const scene::Scene& scene, const camera::Picture& wanted,
                              const Request& request);

}  // namespace balcony::render::test

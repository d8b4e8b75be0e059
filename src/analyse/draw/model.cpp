// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "analyse/draw/camera_geometry.hpp"
#include "analyse/draw/drawing_items.hpp"
#include "balcony/drawing.hpp"

namespace balcony::analyse {

namespace {

// Not if two corners coincide, as at a pole or at the tip of a cone.
void add_triangle(scene::Mesh& mesh, const std::array<std::uint32_t, 3>& corners) {
    const auto& [a, b, c] = corners;
    const auto& at = mesh.positions;
    if (at[a] != at[b] && at[b] != at[c] && at[c] != at[a]) {
        mesh.triangles.push_back(corners);
    }
}

using scene::Mesh;
using scene::V2f;
using scene::V3f;

constexpr double surface_cells = 96.0 * 54.0;
constexpr int round_sides = 10;  // Number of sides that approximate a circle.
// The maximum number of corners of all tubes of a model; each takes about 10 kB.
constexpr std::size_t max_tube_corners = 1U << 15U;

/// Bodies of revolution, each a separate closed part of one mesh.
class Solids {
public:
    explicit Solids(Mesh& mesh) : mesh_(mesh) {}

    /// A frustum between two circles, either of which may be a point. The ends are closed.
    void add_frustum(const V3d& from, const V3d& to, double from_radius, double to_radius) {
        const V3d along = (to - from).normalized();
        const V3d aside =
            (std::abs(along.z) < 0.9 ? V3d(0, 0, 1) : V3d(1, 0, 0)).cross(along).normalized();
        const V3d across = along.cross(aside);
        const double slope = (from_radius - to_radius) / (to - from).length();
        const auto side = [&](int corner) {
            const double angle = 2.0 * std::numbers::pi * corner / round_sides;
            return std::cos(angle) * aside + std::sin(angle) * across;
        };
        for (int i = 0; i < round_sides; ++i) {
            const V3d a = side(i);
            const V3d b = side(i + 1);
            const V3d normal_a = (a + slope * along).normalized();
            const V3d normal_b = (b + slope * along).normalized();
            const auto near_a = add_vertex(from + from_radius * a, normal_a);
            const auto near_b = add_vertex(from + from_radius * b, normal_b);
            const auto far_a = add_vertex(to + to_radius * a, normal_a);
            const auto far_b = add_vertex(to + to_radius * b, normal_b);
            add_triangle(mesh_, {near_a, near_b, far_b});
            add_triangle(mesh_, {near_a, far_b, far_a});
            close(from, from_radius, b, a, -along);
            close(to, to_radius, a, b, along);
        }
    }

    /// A tube along a line, with balls at the joints.
    void add_tube(const Polyline& line, double radius) {
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            if ((line[i + 1] - line[i]).length() > 0.0) {
                add_frustum(line[i], line[i + 1], radius, radius);
            }
            add_ball(line[i], radius);
        }
        if (!line.empty()) {
            add_ball(line.back(), radius);
        }
    }

    void add_ball(const V3d& center, double radius) {
        constexpr int rings = round_sides / 2;
        for (int ring = 0; ring < rings; ++ring) {
            for (int i = 0; i < round_sides; ++i) {
                const auto vertex = [&](int up, int round) {
                    const double polar = std::numbers::pi * up / rings;
                    const double angle = 2.0 * std::numbers::pi * round / round_sides;
                    const V3d n(std::sin(polar) * std::cos(angle),
                                std::sin(polar) * std::sin(angle), std::cos(polar));
                    return add_vertex(center + radius * n, n);
                };
                const auto a = vertex(ring, i);
                const auto b = vertex(ring + 1, i);
                const auto c = vertex(ring + 1, i + 1);
                const auto d = vertex(ring, i + 1);
                if (ring + 1 < rings) {
                    add_triangle(mesh_, {a, b, c});
                }
                if (ring > 0) {
                    add_triangle(mesh_, {a, c, d});
                }
            }
        }
    }

private:
    void close(const V3d& center, double radius, const V3d& a, const V3d& b, const V3d& normal) {
        if (radius > 0.0) {
            const auto middle = add_vertex(center, normal);
            const auto first = add_vertex(center + radius * a, normal);
            const auto last = add_vertex(center + radius * b, normal);
            add_triangle(mesh_, {middle, first, last});
        }
    }

    std::uint32_t add_vertex(const V3d& position, const V3d& normal) {
        mesh_.positions.emplace_back(position);
        mesh_.normals.emplace_back(normal);
        return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
    }

    Mesh& mesh_;
};

/// The part of a surface that the picture covers: two triangles per complete grid cell.
void add_surface(ProjectionObject& object, double aspect, Mesh& mesh) {
    const PictureGrid grid = PictureGrid::of_cells(surface_cells, aspect);
    const auto crossing = [&](std::size_t column, std::size_t row) {
        return grid.at(static_cast<double>(column), static_cast<double>(row));
    };
    std::vector<std::optional<std::uint32_t>> vertices;
    for (std::size_t row = 0; row <= grid.rows; ++row) {
        for (std::size_t column = 0; column <= grid.columns; ++column) {
            const auto point = object.at(crossing(column, row));
            vertices.push_back(
                point ? std::optional(static_cast<std::uint32_t>(mesh.positions.size()))
                      : std::nullopt);
            if (point) {
                mesh.positions.emplace_back(point->position);
                mesh.normals.emplace_back(point->normal);
                mesh.texture_coordinates[0].emplace_back(point->parameters);
            }
        }
    }
    // Whether the line from each crossing to its right and lower neighbour is uninterrupted.
    const std::size_t stride = grid.columns + 1;
    std::vector<std::array<bool, 2>> joined(vertices.size(), {false, false});
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const std::size_t column = i % stride;
        const std::size_t row = i / stride;
        const V2d here = crossing(column, row);
        joined[i] = {column < grid.columns && object.joined(here, crossing(column + 1, row)),
                     row < grid.rows && object.joined(here, crossing(column, row + 1))};
    }
    for (std::size_t i = 0; i + stride + 1 < vertices.size(); ++i) {
        if (i % stride < grid.columns && joined[i][0] && joined[i][1] && joined[i + 1][1] &&
            joined[i + stride][0]) {
            const std::uint32_t a = *vertices[i];
            const std::uint32_t b = *vertices[i + 1];
            const std::uint32_t c = *vertices[i + stride + 1];
            const std::uint32_t d = *vertices[i + stride];
            add_triangle(mesh, {a, d, c});
            add_triangle(mesh, {a, c, b});
        }
    }
}

/// Where the formula has no normal, as at the poles of a sphere, uses the adjacent triangles.
void complete_normals(Mesh& mesh) {
    std::vector<V3d> sums(mesh.positions.size(), V3d(0.0));
    for (const auto& corner : mesh.triangles) {
        const V3d a(mesh.positions[corner[0]]);
        const V3d across =
            (V3d(mesh.positions[corner[1]]) - a).cross(V3d(mesh.positions[corner[2]]) - a);
        for (const std::uint32_t vertex : corner) {
            sums[vertex] += across;
        }
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
        if (mesh.normals[i].length2() == 0.0F) {
            mesh.normals[i] = V3f(sums[i].length2() > 0.0 ? sums[i].normalized() : V3d(0, 0, 1));
        }
    }
}

/// In linear light.
struct CameraColors {
    scene::Color3f eye{0.16F, 0.42F, 0.66F};
    scene::Color3f toward{0.10F, 0.48F, 0.34F};
    scene::Color3f ray{0.66F, 0.11F, 0.005F};
};

/// A power of 2.2 approximates sRGB's curve.
scene::Color3f linear(const DrawingColor& drawn) {
    const auto level = [](std::uint8_t byte) {
        return std::pow(static_cast<float>(byte) / 255.0F, 2.2F);
    };
    return {level(drawn[0]), level(drawn[1]), level(drawn[2])};
}

/// The colours of the camera with a number, or of the only one (0), as in the drawing.
CameraColors colors_of(std::size_t camera, const Depiction& depiction) {
    CameraColors colors;
    if (camera > 0) {
        const scene::Color3f own = linear(camera_color(camera));
        colors = {own, own, 0.5F * own};
    }
    if (depiction.color) {
        colors.ray = linear(*depiction.color);
    }
    return colors;
}

class Modeller {
public:
    Modeller(const std::string& name, const PictureGeometry& whole)
        : own_axes_(whole.axes), size_(whole.extent() > 0.0 ? whole.extent() : 1.0) {
        scene_.name = name;
        scene_.format = "camera";
        scene_.axes = own_axes_;
        scene_.default_light = true;
    }

    /// Warns of lines for which the model has no room.
    Diagnostics add(const PictureGeometry::Part& camera, const CameraColors& colors,
                    const Depiction& depiction) {
        tubes_left_out_ = false;
        const CameraGeometry& geometry = camera.geometry;
        const std::string prefix = camera.title.empty() ? "" : camera.title + ": ";
        if (depiction.eye) {
            add(object_mesh(*geometry.eye, geometry.aspect), prefix + "surface", colors.eye);
        }
        if (depiction.toward && geometry.toward) {
            add(object_mesh(*geometry.toward, geometry.aspect), prefix + "target", colors.toward,
                0.4F);
        }
        if (!geometry.rays.empty()) {
            add(ray_mesh(geometry.rays), prefix + "rays", colors.ray);
        }
        if (ProjectionObject* screen = geometry.screen(); screen != nullptr && depiction.frame) {
            add(frame_mesh(*screen), prefix + "frame", {0.02F, 0.02F, 0.02F});
        }
        return tubes_left_out_ ? Diagnostics{warning(
                                     fmt::format("of camera '{}', lines are too long for a "
                                                 "model and are left out",
                                                 geometry.name),
                                     {}, "draw it as a picture, or check the ranges of its map")}
                               : Diagnostics{};
    }

    scene::Scene take() { return std::move(scene_); }

private:
    Mesh object_mesh(ProjectionObject& object, double aspect) {
        Mesh mesh;
        if (object.dimension() == 2) {
            add_surface(object, aspect, mesh);
            complete_normals(mesh);
            return mesh;
        }
        Solids solids(mesh);
        constexpr double ball = 0.012;
        constexpr double tube = 0.006;
        const auto middle = object.at(V2d(0.5));
        if (middle && object.dimension() == 0) {
            solids.add_ball(middle->position, ball * size_);
        } else if (object.dimension() == 1) {
            const PictureGrid grid;
            add_tubes(solids, object, grid.at(0, 0), grid.at(1, 0), tube);
            add_tubes(solids, object, grid.at(1, 0), grid.at(1, 1), tube);
        }
        return mesh;
    }

    Mesh ray_mesh(const std::vector<Arrow>& rays) const {
        Mesh mesh;
        Solids solids(mesh);
        for (const Arrow& ray : rays) {
            const double length = (ray.to - ray.from).length();
            if (!(length > 0.0)) {
                continue;
            }
            const double size = 0.035 * size_;
            const double head = ray.has_head ? std::min(size, 0.5 * length) : 0.0;
            const double thick = 0.09 * (ray.has_head ? head : size);
            const V3d neck = ray.to - head / length * (ray.to - ray.from);
            solids.add_frustum(ray.from, neck, thick, thick);
            if (ray.has_head) {
                solids.add_frustum(neck, ray.to, 0.3 * head, 0.0);
            }
        }
        return mesh;
    }

    Mesh frame_mesh(ProjectionObject& screen) {
        Mesh mesh;
        Solids solids(mesh);
        const PictureGrid grid;
        constexpr double tube = 0.004;
        constexpr double corner = 0.012;
        const std::array<V2d, 4> corners{grid.at(0, 0), grid.at(1, 0), grid.at(1, 1),
                                         grid.at(0, 1)};
        for (std::size_t i = 0; i < corners.size(); ++i) {
            add_tubes(solids, screen, corners[i], corners[(i + 1) % corners.size()], tube);
        }
        if (const auto top_left = screen.at(corners[0])) {
            solids.add_ball(top_left->position, corner * size_);
        }
        return mesh;
    }

    void add_tubes(Solids& solids, ProjectionObject& object, const V2d& from, const V2d& to,
                   double radius) {
        constexpr double tolerance = 0.001;
        const auto pieces = object.trace(from, to, tolerance * size_);
        if (!pieces) {
            return;
        }
        for (const Polyline& piece : *pieces) {
            if (piece.size() > tube_corners_left_) {
                tubes_left_out_ = true;
                continue;
            }
            tube_corners_left_ -= piece.size();
            solids.add_tube(piece, radius * size_);
        }
    }

    // The geometry is z up; the scene has the camera's axes.
    void add(Mesh mesh, const std::string& name, const scene::Color3f& color, float alpha = 1.0F) {
        if (mesh.triangles.empty()) {
            return;
        }
        for (std::vector<V3f>* vectors : {&mesh.positions, &mesh.normals}) {
            for (V3f& v : *vectors) {
                v = turned(v, Axes::z_up, own_axes_);
            }
        }
        mesh.name = name;
        mesh.material = scene::MaterialIndex(scene_.materials.size());
        scene::Material material;
        material.name = name;
        material.base_color = color;
        material.alpha = alpha;
        material.alpha_mode = alpha < 1.0F ? scene::AlphaMode::blend : scene::AlphaMode::opaque;
        material.roughness = 0.6F;
        scene_.materials.push_back(material);
        scene::Instance instance;
        instance.mesh = scene::MeshIndex(scene_.meshes.size());
        instance.object = static_cast<std::uint32_t>(scene_.objects.size());
        scene_.instances.push_back(instance);
        scene_.objects.push_back({name});
        scene_.meshes.push_back(std::move(mesh));
    }

    Axes own_axes_;
    double size_;
    std::size_t tube_corners_left_ = max_tube_corners;
    bool tubes_left_out_ = false;  ///< Of the camera that is being added.
    scene::Scene scene_;
};

Result<scene::Scene> model_of(const camera::Picture& picture, const Depiction& depiction,
                              const Work& work) {
    auto geometry = measure_geometry(picture, depiction, work.part(0.0, 0.2));
    if (!geometry) {
        return geometry.diagnostics;
    }
    const std::vector<PictureGeometry> film = measure_film(picture, depiction, work.part(0.2, 0.4));
    geometry->bounds = film.empty() ? geometry->bounds : film.front().bounds;
    const bool several = picture.only_camera() == nullptr;
    Diagnostics diagnostics = geometry.diagnostics;
    const auto add_diagnostics = [&diagnostics](const Diagnostics& more) {
        diagnostics.insert(diagnostics.end(), more.begin(), more.end());
    };
    Modeller modeller(picture.name(), *geometry);
    for (std::size_t i = 0; i < geometry->cameras.size(); ++i) {
        work.done(0.4 +
                  0.6 * static_cast<double>(i) / static_cast<double>(geometry->cameras.size()));
        add_diagnostics(modeller.add(geometry->cameras[i],
                                     colors_of(several ? i + 1 : 0, depiction), depiction));
    }
    add_diagnostics(omissions(*geometry));
    work.done(1.0);
    return {modeller.take(), std::move(diagnostics)};
}

}  // namespace

Result<scene::Scene> model(const camera::Picture& picture, const Depiction& depiction,
                           const PartDone& progress, std::stop_token stop) {
    return unless_stopped(
        [&] { return model_of(picture, depiction, Work(progress, std::move(stop))); });
}

}  // namespace balcony::analyse

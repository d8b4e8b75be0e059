// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "balcony/scene.hpp"
#include "data/files.hpp"

namespace balcony::data {

namespace {

using camera::TexturedMesh;
using Corner = TexturedMesh::Corner;
using Triangle = std::array<Corner, 3>;

std::array<double, 3> with_z_up(const scene::V3d& v, Axes axes) {
    const scene::V3d up = turned(v, axes, Axes::z_up);
    return {up.x, up.y, up.z};
}

bool has_area_in_texture(const Triangle& t) {
    const auto side = [&t](std::size_t i, std::size_t k) { return t[i].uv[k] - t[0].uv[k]; };
    const double area = side(1, 0) * side(2, 1) - side(1, 1) * side(2, 0);
    return std::isfinite(area) && area != 0.0;
}

bool has_area_in_space(const Triangle& t) {
    const auto point = [&t](std::size_t i) {
        return scene::V3d(t[i].position[0], t[i].position[1], t[i].position[2]);
    };
    const double area = (point(1) - point(0)).cross(point(2) - point(0)).length();
    return std::isfinite(area) && area > 0.0;
}

/// Combines the meshes of a scene.
class Merger {
public:
    explicit Merger(const scene::Scene& scene) : scene_(scene) {}

    Result<std::shared_ptr<const TexturedMesh>> run(const File& file) {
        made_.triangles.reserve(scene_.triangle_count());
        for (const scene::Instance& instance : scene_.instances) {
            add(instance);
        }
        if (made_.triangles.empty()) {
            const bool none = without_texture_ > 0 && flat_in_texture_ + flat_in_space_ == 0;
            return error(
                fmt::format("'{}' has no triangle {}", file.name,
                            none ? "with texture coordinates" : "that contains a point (u, v)"),
                {}, "unwrap the mesh in the modelling program and export it again");
        }
        Diagnostics diagnostics;
        const auto warn = [&](std::size_t count, std::string_view which) {
            if (count > 0) {
                diagnostics.push_back(
                    warning(fmt::format("{} of {} triangles of '{}' {} and are skipped", count,
                                        scene_.triangle_count(), file.name, which)));
            }
        };
        warn(without_texture_, "have no texture coordinates");
        warn(flat_in_texture_, "have no area in texture coordinates");
        warn(flat_in_space_, "have no area in space");
        return {std::make_shared<const TexturedMesh>(std::move(made_)), std::move(diagnostics)};
    }

private:
    void add(const scene::Instance& instance) {
        const scene::Mesh& mesh = scene_.meshes[instance.mesh.value()];
        if (mesh.texture_coordinates[0].empty()) {
            without_texture_ += mesh.triangles.size();
            return;
        }
        const scene::M44d& world_from_mesh = instance.world_from_mesh;
        const scene::M44d for_normals = world_from_mesh.inverse().transposed();
        const bool mirrored = world_from_mesh.determinant() < 0.0;
        for (const auto& indices : mesh.triangles) {
            Triangle made;
            for (std::size_t i = 0; i < 3; ++i) {
                // Mirroring reverses the winding.
                const std::uint32_t index = indices[mirrored ? 2 - i : i];
                made[i] = corner(mesh, index, world_from_mesh, for_normals);
            }
            if (!has_area_in_texture(made)) {
                ++flat_in_texture_;
            } else if (!has_area_in_space(made)) {
                ++flat_in_space_;
            } else {
                made_.triangles.push_back(made);
            }
        }
    }

    [[nodiscard]] Corner corner(const scene::Mesh& mesh, std::uint32_t index,
                                const scene::M44d& world_from_mesh,
                                const scene::M44d& for_normals) const {
        scene::V3d position;
        world_from_mesh.multVecMatrix(scene::V3d(mesh.positions[index]), position);
        scene::V3d normal;
        for_normals.multDirMatrix(scene::V3d(mesh.normals[index]), normal);
        // The scene counts v from the top of the image.
        const scene::V2f& at = mesh.texture_coordinates[0][index];
        return {with_z_up(position, scene_.axes),
                with_z_up(normal.normalized(), scene_.axes),
                {double{at.x}, 1.0 - double{at.y}}};
    }

    const scene::Scene& scene_;
    TexturedMesh made_;
    std::size_t without_texture_ = 0;
    std::size_t flat_in_texture_ = 0;
    std::size_t flat_in_space_ = 0;
};

}  // namespace

Result<std::shared_ptr<const TexturedMesh>> read_mesh(const File& file) {
    const Result<std::uintmax_t> size = size_of(file);
    if (!size) {
        return size.diagnostics;
    }
    if (*size > max_mesh_file) {
        return error(fmt::format("'{}' is larger than {} MB", file.name, max_mesh_file / 1'000'000),
                     {}, "simplify the mesh: a camera needs its shape, not its details");
    }
    const Result<scene::Scene> scene =
        file.bytes ? scene::load(file.path, *file.bytes) : scene::load(file.path);
    if (!scene) {
        return scene.diagnostics;
    }
    if (scene->triangle_count() > max_triangles) {
        return error(fmt::format("'{}' has {} triangles, more than {} million", file.name,
                                 scene->triangle_count(), max_triangles / 1'000'000),
                     {}, "simplify the mesh: a camera needs its shape, not its details");
    }
    return Merger(*scene).run(file);
}

}  // namespace balcony::data

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "shading/surfaces/surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "shading/geometry/placed.hpp"
#include "shading/lanes/scalar.hpp"

namespace balcony::render {

namespace {

#include "shading/surfaces/surface.inl"

float max_coordinate(const V3f& p) {
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

// A corner of the triangle, and its share in the point that is hit.
struct Corner {
    V3f position;
    V3f normal;  // Of the mesh, of any length.
    float share;
};

// The vector from a point of a triangle to the smooth surface that the normals of the corners
// describe: Hanika, "Hacking the Shadow Terminator", Ray Tracing Gems II (2021), chapter 4. The
// point is projected to the tangent planes of the corners, where it is below them, and the
// projections are interpolated; the shares of the unprojected points cancel. Where the surface is
// flat or concave, the vector is 0.
V3f to_smooth_surface(const std::array<Corner, 3>& corners, const Imath::M33f& normal_from_mesh,
                      const V3f& position, float side) {
    V3f total(0.0F);
    for (const Corner& corner : corners) {
        const V3f normal = side * placed(corner.normal, normal_from_mesh);
        const float below = std::min((position - corner.position).dot(normal), 0.0F);
        const float square = normal.length2();
        total -= square > 0.0F ? corner.share * below / square * normal : V3f(0.0F);
    }
    return total;
}

// Whether the normals of the corners are that of the triangle, as on walls.
bool is_flat(const std::array<Corner, 3>& corners, const V3f& normal, const V3f& outside) {
    constexpr float same = 1.0F - 5e-7F;  // A tilt of a thousandth.
    return corners[0].normal == corners[1].normal && corners[0].normal == corners[2].normal &&
           normal.dot(outside) > same;
}

// Sets what the normals of the corners tell, unless they cancel.
void set_normals(const std::array<Corner, 3>& corners, const Imath::M33f& normal_from_mesh,
                 const V3f& to_viewer, Surface& surface) {
    const V3f sum = placed(interpolated(corners[1].share, corners[2].share, corners[0].normal,
                                        corners[1].normal, corners[2].normal),
                           normal_from_mesh);
    if (!has_length(sum)) {
        return;
    }
    const V3f outside = surface.mesh_normal;
    const V3f normal = unit_of(sum);
    surface.mesh_normal = normal;
    surface.smooth_normal = shading_normal(normal, surface.geometric_normal, to_viewer);
    surface.normal = surface.coat_normal = surface.smooth_normal;
    if (is_flat(corners, normal, outside)) {
        return;
    }
    const float side = side_to_viewer(normal, surface.geometric_normal, to_viewer);
    const V3f out = to_smooth_surface(corners, normal_from_mesh, surface.position, side);
    if (std::isfinite(out.length2())) {
        surface.rounding_out = out;
    }
}

}  // namespace

std::array<V2f, 2> MeshPoint::texture_edges(const scene::TextureUse& use) const {
    const std::vector<V2f>& coordinates = mesh->texture_coordinates[use.coordinates];
    if (coordinates.empty()) {
        return {V2f(0.0F), V2f(0.0F)};
    }
    const auto& corners = mesh->triangles[triangle];
    const V2f& first = coordinates[corners[0]];
    return {use.difference(coordinates[corners[1]] - first),
            use.difference(coordinates[corners[2]] - first)};
}

TextureFootprint MeshPoint::texture_footprint(const scene::TextureUse& use,
                                              const TriangleFootprint& footprint) const {
    const std::vector<V2f>& coordinates = mesh->texture_coordinates[use.coordinates];
    const V2f first = coordinates.empty() ? V2f(0.0F) : coordinates[mesh->triangles[triangle][0]];
    const std::array<V2f, 2> edges = texture_edges(use);
    return {point_on(use.place(first), u, v, edges[0], edges[1]),
            slope_in_image(footprint.along_x, edges[0], edges[1]),
            slope_in_image(footprint.along_y, edges[0], edges[1])};
}

scene::Color4f MeshPoint::color() const {
    if (mesh->colors.empty()) {
        return {1.0F, 1.0F, 1.0F, 1.0F};
    }
    const auto& corners = mesh->triangles[triangle];
    return interpolated(u, v, mesh->colors[corners[0]], mesh->colors[corners[1]],
                        mesh->colors[corners[2]]);
}

V3f Surface::start(const V3f& direction) const {
    return position +
           (direction.dot(geometric_normal) >= 0.0F ? offset : -offset) * geometric_normal;
}

V3f Surface::start_to_light() const { return position + rounding_out + offset * geometric_normal; }

PositionDifferentials Surface::transfer(const DifferentialRay& ray) const {
    const float along_normal = ray.direction.dot(geometric_normal);
    const float length = (position - ray.origin).dot(ray.direction);
    const auto on_plane = [&](const V3f& origin, const V3f& direction) {
        return moved_on_plane(origin, direction, length, ray.direction, geometric_normal,
                              along_normal);
    };
    const RayDifferentials& d = ray.differentials;
    return {on_plane(d.origin_x, d.direction_x), on_plane(d.origin_y, d.direction_y)};
}

TriangleFootprint Surface::triangle_footprint(const PositionDifferentials& moved) const {
    return {in_triangle(moved.along_x, edge_1, edge_2), in_triangle(moved.along_y, edge_1, edge_2)};
}

// The tangent points to the right of the image, the bitangent to its top, where v is least. Both
// are the derivatives of the position by the image's coordinates, perpendicular to the normal.
V3f Surface::mapped_normal(const V3f& in_tangent_space, const scene::TextureUse& use,
                           const V3f& to_viewer) const {
    V3f right(tangent.x, tangent.y, tangent.z);
    float handedness = tangent.w;
    if (right == V3f(0.0F)) {
        const auto [along_1, along_2] = in_mesh.texture_edges(use);
        const float area = along_1.x * along_2.y - along_1.y * along_2.x;
        right = (along_2.y * edge_1 - along_1.y * edge_2) / area;
        const V3f down = (along_1.x * edge_2 - along_2.x * edge_1) / area;
        handedness = mesh_normal.cross(right).dot(down) > 0.0F ? -1.0F : 1.0F;
    }
    right = (right - right.dot(mesh_normal) * mesh_normal).normalized();
    const V3f up = handedness * mesh_normal.cross(right);
    const V3f mapped =
        (in_tangent_space.x * right + in_tangent_space.y * up + in_tangent_space.z * mesh_normal)
            .normalized();
    // Without coordinates there is no tangent; nothing is mapped then.
    if (!std::isfinite(mapped.length2()) || !(mapped.length2() > 0.0F)) {
        return smooth_normal;
    }
    return bent_to_viewer(side_to_viewer(mesh_normal, geometric_normal, to_viewer) * mapped,
                          to_viewer);
}

SurfaceFinder::SurfaceFinder(const scene::Scene& scene, const scene::Movement& movement)
    : scene_(&scene), moving_(movement), shapes_(movement) {
    placements_.reserve(scene.instances.size());
    for (const scene::Instance& instance : scene.instances) {
        const scene::M44d& m = instance.world_from_mesh;
        const Imath::M33d linear(m[0][0], m[0][1], m[0][2], m[1][0], m[1][1], m[1][2], m[2][0],
                                 m[2][1], m[2][2]);
        placements_.push_back({Imath::M44f(m), Imath::M33f(linear.inverse().transposed()),
                               &*scene.meshes[instance.mesh.value()],
                               linear.determinant() < 0.0 ? -1.0F : 1.0F});
    }
}

SurfaceFinder::Placement SurfaceFinder::placement_at(std::uint32_t instance, float time) const {
    const std::optional<Imath::M44f> moved = moving_.world_from_mesh(instance, time);
    if (!moved) {
        return placements_[instance];
    }
    const Imath::M44f& m = *moved;
    const Imath::M33f linear(m[0][0], m[0][1], m[0][2], m[1][0], m[1][1], m[1][2], m[2][0], m[2][1],
                             m[2][2]);
    return {m, linear.inverse().transposed(), placements_[instance].mesh,
            linear.determinant() < 0.0F ? -1.0F : 1.0F};
}

// The bitangent is mirrored with the placement, which its formula by normal and tangent is not.
V4f SurfaceFinder::placed_tangent(const MeshPoint& point, const Placement& placement) {
    const auto& corners = point.mesh->triangles[point.triangle];
    const V4f& first = point.mesh->tangents[corners[0]];
    const V4f sum = interpolated(point.u, point.v, first, point.mesh->tangents[corners[1]],
                                 point.mesh->tangents[corners[2]]);
    V3f placed;
    placement.world_from_mesh.multDirMatrix(V3f(sum.x, sum.y, sum.z), placed);
    return {placed.x, placed.y, placed.z, placement.side * first.w};
}

void SurfaceFinder::request_triangle(const embree::Hit& hit) const {
    __builtin_prefetch(placements_[hit.instance].mesh->triangles.data() + hit.triangle);
}

void SurfaceFinder::request_corners(const embree::Hit& hit) const {
    const scene::Mesh& mesh = *placements_[hit.instance].mesh;
    for (const std::uint32_t corner : mesh.triangles[hit.triangle]) {
        __builtin_prefetch(mesh.positions.data() + corner);
        if (!mesh.normals.empty()) {
            __builtin_prefetch(mesh.normals.data() + corner);
        }
    }
}

Surface SurfaceFinder::find(const embree::Hit& hit, const V3f& direction, float time) const {
    Surface surface;
    surface.in_mesh = mesh_point(hit);
    const scene::Mesh& m = *surface.in_mesh.mesh;
    std::optional<Placement> moved;
    if (!moving_.empty()) {
        moved = placement_at(hit.instance, time);
    }
    const Placement& placement = moved ? *moved : placements_[hit.instance];
    const auto& triangle = m.triangles[hit.triangle];
    std::optional<MeshCorners> shape;
    if (!shapes_.empty()) {
        shape = shapes_.corners(scene_->instances[hit.instance].mesh, triangle, time);
    }
    const auto position = [&](std::size_t i) {
        return placed(shape ? shape->positions[i] : m.positions[triangle[i]],
                      placement.world_from_mesh);
    };
    const V3f p0 = position(0);
    const V3f p1 = position(1);
    const V3f p2 = position(2);

    surface.edge_1 = p1 - p0;
    surface.edge_2 = p2 - p0;
    surface.position = point_on(p0, hit.u, hit.v, surface.edge_1, surface.edge_2);
    // Eight rounding errors of the largest number used to compute the point or to intersect the
    // triangle from it.
    surface.offset = 8.0F * std::numeric_limits<float>::epsilon() *
                     std::max({max_coordinate(p0), max_coordinate(p1), max_coordinate(p2),
                               max_coordinate(surface.edge_1), max_coordinate(surface.edge_2)});

    const V3f outside = placement.side * surface.edge_1.cross(surface.edge_2).normalized();
    surface.entering = outside.dot(direction) <= 0.0F;
    surface.geometric_normal = surface.entering ? outside : -outside;
    surface.normal = surface.coat_normal = surface.smooth_normal = surface.geometric_normal;
    surface.mesh_normal = outside;
    surface.rounding_out = V3f(0.0F);
    if (!m.normals.empty()) {
        const auto corner = [&](std::size_t i, const V3f& p, float share) {
            return Corner{p, shape ? shape->normals[i] : m.normals[triangle[i]], share};
        };
        set_normals(
            {corner(0, p0, 1.0F - hit.u - hit.v), corner(1, p1, hit.u), corner(2, p2, hit.v)},
            placement.normal_from_mesh, -direction, surface);
    }
    if (!m.tangents.empty()) {
        surface.tangent = placed_tangent(surface.in_mesh, placement);
    }
    surface.material = &scene_->materials[m.material.value()];
    surface.object = scene_->instances[hit.instance].object;
    surface.instance = hit.instance;
    return surface;
}

std::optional<PlacedMesh> SurfaceFinder::mesh_at_rest(std::uint32_t instance) const {
    if (moving_.step_count(instance) > 1 ||
        shapes_.step_count(scene_->instances[instance].mesh) > 1) {
        return std::nullopt;
    }
    const Placement& placement = placements_[instance];
    return PlacedMesh{placement.mesh, placement.world_from_mesh, placement.normal_from_mesh};
}

}  // namespace balcony::render

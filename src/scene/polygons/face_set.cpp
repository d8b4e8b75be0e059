// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scene/polygons/face_set.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "scene/geometry.hpp"
#include "scene/polygons/polygon.hpp"
#include "scene/polygons/triple_numbers.hpp"

namespace balcony::scene {

namespace {

// More would not have 32-bit numbers for their corners.
constexpr std::size_t max_faces = 1U << 30U;

// The numbers of the faces, section by section, and where each section begins.
struct SectionOrder {
    std::vector<std::uint32_t> faces;
    std::vector<std::size_t> begins;
};

SectionOrder in_sections(const FaceSet& set) {
    SectionOrder order{std::vector<std::uint32_t>(set.faces.size()),
                       std::vector<std::size_t>(set.sections.size() + 1, 0)};
    for (const Face& face : set.faces) {
        ++order.begins[face.section + 1];
    }
    for (std::size_t i = 0; i < set.sections.size(); ++i) {
        order.begins[i + 1] += order.begins[i];
    }
    std::vector<std::size_t> next(order.begins.begin(), order.begins.end() - 1);
    for (std::uint32_t i = 0; i < set.faces.size(); ++i) {
        order.faces[next[set.faces[i].section]++] = i;
    }
    return order;
}

// Corners with the same indices become one vertex. `first` faces are in the sections before.
Mesh merged(const FaceSet& set, std::span<const std::uint32_t> faces, std::size_t first,
            Import& import) {
    Mesh mesh;
    TripleNumbers vertices;
    bool has_coordinates = false;
    mesh.triangles.reserve(faces.size());
    import.report(first, set.faces.size());
    for (const std::uint32_t face : faces) {
        import.go_on(first + mesh.triangles.size(), set.faces.size());
        auto& triangle = mesh.triangles.emplace_back();
        for (std::size_t i = 0; i < 3; ++i) {
            const Corner& corner = set.faces[face].corners[i];
            triangle[i] =
                vertices.number({corner.position, corner.texture_coordinate, corner.normal});
            has_coordinates = has_coordinates || corner.texture_coordinate != no_index;
        }
    }
    import.check_stop();
    const std::size_t count = vertices.triples().size();
    mesh.positions.reserve(count);
    mesh.normals.reserve(count);
    mesh.colors.reserve(set.colors.empty() ? 0 : count);
    std::vector<V2f>& coordinates = mesh.texture_coordinates[0];
    coordinates.reserve(has_coordinates ? count : 0);
    for (const auto& [position, coordinate, normal] : vertices.triples()) {
        mesh.positions.push_back(set.positions[position]);
        mesh.normals.push_back(set.normals[normal]);
        if (!set.colors.empty()) {
            const Color3f& color = set.colors[position];
            mesh.colors.emplace_back(color.x, color.y, color.z, 1.0F);
        }
        if (has_coordinates) {
            coordinates.push_back(coordinate == no_index ? V2f(0.0F)
                                                         : set.texture_coordinates[coordinate]);
        }
    }
    return mesh;
}

}  // namespace

void FaceSet::add_polygon(std::span<Corner> corners, SmoothingGroup smoothing,
                          std::uint32_t section) {
    if (corners.size() < 3 || corners.size() > max_polygon_corners) {
        ++malformed_;
        return;
    }
    polygon_.clear();
    for (const Corner& corner : corners) {
        if (corner.position >= positions.size()) {
            ++out_of_range_;
            return;
        }
        polygon_.push_back(positions[corner.position]);
    }
    if (!std::all_of(polygon_.begin(), polygon_.end(), usable)) {
        ++not_usable_;
        return;
    }
    for (const auto index : {&Corner::texture_coordinate, &Corner::normal}) {
        if (std::any_of(corners.begin(), corners.end(),
                        [index](const Corner& corner) { return corner.*index == no_index; })) {
            for (Corner& corner : corners) {
                corner.*index = no_index;
            }
        }
    }
    triangles_.clear();
    triangulate(polygon_, triangles_);
    if (faces.size() + triangles_.size() > max_faces) {
        throw ReadError{error(fmt::format("the file has more than {} triangles", max_faces), {},
                              "divide it into several files")};
    }
    for (const auto& [a, b, c] : triangles_) {
        faces.push_back({{corners[a], corners[b], corners[c]}, smoothing, section});
    }
}

void FaceSet::warn_of_skipped(Import& import) const {
    const auto skipped = [&](std::size_t count, const std::string& reason) {
        if (count > 0) {
            import.warn(fmt::format("{} skipped {}", counted(count, "face"), reason));
        }
    };
    skipped(out_of_range_, "because of a vertex index out of range");
    skipped(not_usable_, "because of a vertex that is not finite or too large");
    skipped(malformed_,
            fmt::format("with fewer than 3 or more than {} corners", max_polygon_corners));
}

void add_to_scene(FaceSet set, Import& import) {
    add_missing_normals(set, import);
    import.begin_phase(meshes_begin, 1.0);
    const SectionOrder order = in_sections(set);
    std::map<std::uint32_t, std::uint32_t> objects;
    Scene& scene = import.scene;
    for (std::size_t i = 0; i < set.sections.size(); ++i) {
        const FaceSet::Section& section = set.sections[i];
        const std::size_t begin = order.begins[i];
        Mesh mesh = merged(set, std::span(order.faces).subspan(begin, order.begins[i + 1] - begin),
                           begin, import);
        mesh.name = section.object;
        mesh.material = section.material;
        auto finished = finish_mesh(std::move(mesh), import);
        if (!finished) {
            continue;
        }
        const auto [object, is_new] = objects.try_emplace(
            section.object_number, static_cast<std::uint32_t>(scene.objects.size()));
        if (is_new) {
            scene.objects.push_back({section.object});
        }
        scene.meshes.push_back(std::move(*finished));
        scene.instances.push_back({MeshIndex(scene.meshes.size() - 1), M44d(), object->second});
    }
}

}  // namespace balcony::scene

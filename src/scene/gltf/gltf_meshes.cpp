// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <numeric>
#include <span>

#include <fmt/format.h>

#include "scene/geometry.hpp"
#include "scene/gltf/gltf_reader.hpp"
#include "scene/placement.hpp"

namespace balcony::scene {

namespace {

// glTF 2.0, section 5.24.4.
enum class Mode : std::uint8_t {
    points = 0,
    lines = 1,
    line_strip = 3,
    triangles = 4,
    triangle_strip = 5,
    triangle_fan = 6,
};

// The attributes of a primitive, all with as many elements as it has positions.
class Attributes {
public:
    Attributes(GltfDocument& document, const Json& primitive)
        : document_(document), json_(member(primitive, "attributes")) {
        const auto position = index_in(json_, "POSITION");
        if (!position) {
            throw PartError{"it has no positions"};
        }
        count_ = document.accessor(*position, 3).count();
    }

    /// The number of vertices.
    [[nodiscard]] std::size_t count() const { return count_; }

    /// The attribute of these vertices; empty if the primitive has none with this name.
    template <class Vector>
    [[nodiscard]] std::vector<Vector> read(const std::string& key,
                                           std::span<const std::uint32_t> vertices) const {
        const auto index = index_in(json_, key);
        if (!index) {
            return {};
        }
        const GltfAccessor& found = document_.accessor(*index, Vector::dimensions());
        if (found.count() != count_) {
            throw PartError{fmt::format("it has {} and {} of another attribute",
                                        counted(count_, "position"), found.count())};
        }
        std::vector<Vector> elements(vertices.size());
        found.read(vertices, reinterpret_cast<float*>(elements.data()));
        return elements;
    }

    /// COLOR_0 may have alpha.
    [[nodiscard]] std::vector<Color4f> colors(std::span<const std::uint32_t> vertices) const {
        const auto index = index_in(json_, "COLOR_0");
        if (index && text_in(element(document_.root(), "accessors", *index), "type") == "VEC4") {
            const auto read_colors = read<V4f>("COLOR_0", vertices);
            std::vector<Color4f> colors;
            colors.reserve(read_colors.size());
            for (const V4f& color : read_colors) {
                colors.emplace_back(color.x, color.y, color.z, color.w);
            }
            return colors;
        }
        const auto read_colors = read<V3f>("COLOR_0", vertices);
        std::vector<Color4f> colors;
        colors.reserve(read_colors.size());
        for (const V3f& color : read_colors) {
            colors.emplace_back(color.x, color.y, color.z, 1.0F);
        }
        return colors;
    }

private:
    GltfDocument& document_;
    const Json& json_;
    std::size_t count_ = 0;
};

}  // namespace

const std::vector<MeshIndex>& GltfReader::meshes(std::size_t gltf_mesh,
                                                 std::optional<std::size_t> deformer) {
    const auto [known, is_new] = meshes_.try_emplace({gltf_mesh, deformer});
    if (is_new) {
        const Json& mesh = element(root_, "meshes", gltf_mesh);
        const std::string name = text_in(mesh, "name", fmt::format("mesh {}", gltf_mesh));
        for (std::size_t i = 0; i < array_size(mesh, "primitives"); ++i) {
            try {
                read_primitive(mesh["primitives"][i], name, deformer, known->second);
            } catch (const PartError& fault) {
                import_.warn(fmt::format("mesh {}: primitive {} is skipped: {}", in_quotes(name), i,
                                         fault.reason));
            }
        }
    }
    return known->second;
}

void GltfReader::read_primitive(const Json& primitive, const std::string& name,
                                std::optional<std::size_t> deformer, std::vector<MeshIndex>& made) {
    const std::size_t mode = count_in(primitive, "mode", static_cast<std::size_t>(Mode::triangles));
    if (mode == static_cast<std::size_t>(Mode::points)) {
        ++dropped_points_;
        return;
    }
    if (mode <= static_cast<std::size_t>(Mode::line_strip)) {
        ++dropped_lines_;
        return;
    }
    if (member(member(primitive, "extensions"), "KHR_draco_mesh_compression").is_object() &&
        !index_in(member(primitive, "attributes"), "POSITION")) {
        throw PartError{"it is compressed with Draco"};
    }
    const GltfMaterial& shaded = materials_.material(index_in(primitive, "material"));
    std::vector<std::uint32_t> elements;
    Mesh mesh = read_mesh(primitive, mode, shaded, name, elements);
    mesh.material = shaded.index;
    std::vector<std::uint32_t> vertices;
    auto finished = finish_mesh(std::move(mesh), import_, deformer ? &vertices : nullptr);
    if (!finished) {
        return;
    }
    boxes_.push_back(box_of(finished->positions));
    scene_.meshes.push_back(std::move(*finished));
    made.emplace_back(scene_.meshes.size() - 1);
    if (deformer) {
        std::transform(vertices.begin(), vertices.end(), vertices.begin(),
                       [&](std::uint32_t vertex) { return elements[vertex]; });
        deform(primitive, *deformer, made.back(), vertices);
    }
}

// Tangents are not deformed; those of the texture coordinates replace them.
void GltfReader::deform(const Json& primitive, std::size_t deformer, MeshIndex mesh,
                        std::span<const std::uint32_t> elements) {
    try {
        animations_.deform(deformer, primitive, mesh, elements);
        scene_.meshes[mesh.value()].edit().tangents.clear();
    } catch (const PartError& fault) {
        import_.warn(fmt::format("mesh {} is shown as stored, without deformation: {}",
                                 in_quotes(scene_.meshes[mesh.value()]->name), fault.reason));
    }
}

// Only the vertices used by the triangles: primitives may share accessors much larger than they
// need.
Mesh GltfReader::read_mesh(const Json& primitive, std::size_t mode, const GltfMaterial& shaded,
                           const std::string& name, std::vector<std::uint32_t>& elements) {
    const Attributes attributes(document_, primitive);
    Mesh mesh;
    mesh.name = name;
    mesh.triangles = read_triangles(primitive, mode, attributes.count());
    elements = number_vertices(mesh.triangles, attributes.count());
    mesh.positions = attributes.read<V3f>("POSITION", elements);
    mesh.normals = attributes.read<V3f>("NORMAL", elements);
    mesh.colors = attributes.colors(elements);
    for (std::size_t set = 0; set < shaded.coordinate_sets.size(); ++set) {
        const std::string key = fmt::format("TEXCOORD_{}", shaded.coordinate_sets[set]);
        mesh.texture_coordinates[set] = attributes.read<V2f>(key, elements);
        if (shaded.has_textures && mesh.texture_coordinates[set].empty()) {
            import_.warn(fmt::format("mesh {} has no {}, which the textures of its material use",
                                     in_quotes(name), key));
        }
    }
    if (shaded.has_normal_map) {
        mesh.tangents = attributes.read<V4f>("TANGENT", elements);
    }
    return mesh;
}

// Numbers the vertices in the order of their first use; an index out of range remains out of range.
std::vector<std::uint32_t> GltfReader::number_vertices(
    std::vector<std::array<std::uint32_t, 3>>& triangles, std::size_t count) {
    constexpr std::uint32_t none = 0xffffffffU;
    std::vector<std::uint32_t> used;
    vertex_numbers_.resize(std::max(vertex_numbers_.size(), count), none);
    for (auto& triangle : triangles) {
        for (std::uint32_t& vertex : triangle) {
            if (vertex >= count) {
                vertex = none;
                continue;
            }
            std::uint32_t& number = vertex_numbers_[vertex];
            if (number == none) {
                number = static_cast<std::uint32_t>(used.size());
                used.push_back(vertex);
            }
            vertex = number;
        }
    }
    for (const std::uint32_t vertex : used) {
        vertex_numbers_[vertex] = none;
    }
    return used;
}

std::vector<std::array<std::uint32_t, 3>> GltfReader::read_triangles(const Json& primitive,
                                                                     std::size_t mode,
                                                                     std::size_t vertices) {
    const auto accessor = index_in(primitive, "indices");
    const GltfAccessor* const indices = accessor ? &document_.accessor(*accessor, 1) : nullptr;
    const std::size_t count = indices != nullptr ? indices->count() : vertices;
    corners_.take(count);
    std::vector<std::uint32_t> corners(count);
    if (indices != nullptr) {
        indices->read_integers(corners);
    } else {
        std::iota(corners.begin(), corners.end(), 0U);
    }
    std::vector<std::array<std::uint32_t, 3>> triangles;
    const std::size_t step = mode == static_cast<std::size_t>(Mode::triangles) ? 3 : 1;
    triangles.reserve(count / step);
    for (std::size_t i = 0; i + 2 < count; i += step) {
        switch (static_cast<Mode>(std::min<std::size_t>(mode, 255))) {
            case Mode::triangles:
                triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
                break;
            case Mode::triangle_strip:
                // Every second triangle of a strip is reversed to face the same side.
                triangles.push_back({corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2]});
                break;
            case Mode::triangle_fan:
                triangles.push_back({corners[i + 1], corners[i + 2], corners[0]});
                break;
            default: throw PartError{fmt::format("its mode {} is unknown", mode)};
        }
    }
    return triangles;
}

}  // namespace balcony::scene

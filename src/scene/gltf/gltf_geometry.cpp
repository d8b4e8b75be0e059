// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include <Imath/ImathQuat.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scene/gltf/gltf_reader.hpp"

namespace balcony::scene {

namespace {

// glTF 2.0, section 3.5.3: matrices have no perspective. Writers may round the values 0 and 1.
M44d affine(M44d matrix) {
    constexpr double rounding = 1e-6;
    const bool is_affine =
        std::abs(matrix[0][3]) <= rounding && std::abs(matrix[1][3]) <= rounding &&
        std::abs(matrix[2][3]) <= rounding && std::abs(matrix[3][3] - 1.0) <= rounding;
    if (!is_affine) {
        throw PartError{"its 'matrix' is not affine: the last row must be 0, 0, 0, 1"};
    }
    matrix[0][3] = matrix[1][3] = matrix[2][3] = 0.0;
    matrix[3][3] = 1.0;
    return matrix;
}

// A node's own transform. glTF stores matrices for column vectors column by column, which read row
// by row is the matrix for row vectors.
M44d local_transform(const Json& node) {
    M44d local;
    if (!member(node, "matrix").is_null()) {
        const auto numbers = numbers_in(node, "matrix", std::vector<double>(16, 0.0));
        for (std::size_t i = 0; i < 16; ++i) {
            local[static_cast<int>(i / 4)][i % 4] = numbers[i];
        }
        return affine(local);
    }
    const auto scale = numbers_in(node, "scale", {1.0, 1.0, 1.0});
    const auto rotation = numbers_in(node, "rotation", {0.0, 0.0, 0.0, 1.0});
    const auto translation = numbers_in(node, "translation", {0.0, 0.0, 0.0});
    const Imath::Quatd turn(rotation[3], rotation[0], rotation[1], rotation[2]);
    if (!(turn.length() > 0.0 && std::isfinite(turn.length()))) {
        throw PartError{"its 'rotation' has length 0"};
    }
    local.setScale(V3d(scale[0], scale[1], scale[2]));
    M44d moved;
    moved.setTranslation(V3d(translation[0], translation[1], translation[2]));
    return local * turn.normalized().toMatrix44() * moved;
}

bool finite(const M44d& matrix) {
    const double* numbers = matrix.getValue();
    return std::all_of(numbers, numbers + 16, [](double number) { return std::isfinite(number); });
}

// Whether a matrix is not singular: relative to the lengths of its rows, so that units do not
// matter.
bool invertible(const M44d& matrix) {
    const V3d x(matrix[0][0], matrix[0][1], matrix[0][2]);
    const V3d y(matrix[1][0], matrix[1][1], matrix[1][2]);
    const V3d z(matrix[2][0], matrix[2][1], matrix[2][2]);
    constexpr double flattest = 1e-12;
    return std::abs(x.cross(y).dot(z)) > flattest * x.length() * y.length() * z.length();
}

// Whether the linear part of an affine matrix is within max_scale.
bool scale_fits(const M44d& matrix) {
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            if (!(std::abs(matrix[row][column]) <= max_scale)) {
                return false;
            }
        }
    }
    return true;
}

bool is_within_range(const V3d& point) {
    const auto fits = [](double value) { return std::abs(value) <= max_coordinate; };
    return fits(point.x) && fits(point.y) && fits(point.z);
}

// Throws PartError unless a mesh with these bounds can be placed with this matrix.
void check_placement(const Box3f& box, const M44d& world_from_mesh) {
    if (!invertible(world_from_mesh)) {
        throw PartError{"its transform is singular"};
    }
    if (!scale_fits(world_from_mesh) || !scale_fits(world_from_mesh.inverse())) {
        throw PartError{
            fmt::format("its transform scales beyond {:g} .. {:g}", 1.0 / max_scale, max_scale)};
    }
    for (unsigned corner = 0; corner < 8; ++corner) {
        const auto side = [&](unsigned axis) {
            const V3f& end = (corner >> axis & 1U) != 0 ? box.max : box.min;
            return double{end[static_cast<int>(axis)]};
        };
        if (!is_within_range(V3d(side(0), side(1), side(2)) * world_from_mesh)) {
            throw PartError{
                fmt::format("it reaches further than {:g} from the origin", max_coordinate)};
        }
    }
}

std::string node_name(const Json& node, std::size_t index) {
    const std::string name = text_in(node, "name");
    return name.empty() ? fmt::format("node {}", index) : name;
}

bool is_read(std::string_view extension) {
    constexpr std::array<std::string_view, 4> others{"EXT_texture_webp", "KHR_lights_punctual",
                                                     "KHR_mesh_quantization",
                                                     "KHR_texture_transform"};
    const auto materials = gltf_material_extensions();
    return std::find(others.begin(), others.end(), extension) != others.end() ||
           std::any_of(materials.begin(), materials.end(),
                       [&](const GltfMaterialExtension& known) { return known.name == extension; });
}

std::vector<std::string> unread_extensions(const Json& root, const char* list) {
    std::vector<std::string> unread;
    for (std::size_t i = 0; i < array_size(root, list); ++i) {
        const Json& extension = member(root, list)[i];
        if (extension.is_string() && !is_read(extension.get<std::string>())) {
            unread.push_back(in_quotes(extension.get<std::string>()));
        }
    }
    return unread;
}

// Geometry that is compressed by an extension cannot be read at all.
void refuse_compressed(const Json& root, const std::filesystem::path& file) {
    for (const std::string& extension : unread_extensions(root, "extensionsRequired")) {
        if (extension == "'KHR_draco_mesh_compression'" ||
            extension == "'EXT_meshopt_compression'") {
            throw ReadError{
                error(fmt::format("{} requires the extension {}, which is not supported",
                                  in_quotes(file.string()), extension),
                      {}, "export the file without mesh compression")};
        }
    }
}

}  // namespace

void read_gltf(Import& import) {
    GltfDocument document(import);
    refuse_compressed(document.root(), import.file);
    import.scene.format = document.is_binary() ? "glTF 2.0 binary" : "glTF 2.0";
    GltfReader(document, import).read();
}

// Each byte of a file may be a separate index, and small files may share more than that; small
// models may have more instances than bytes.
GltfReader::GltfReader(GltfDocument& document, Import& import)
    : document_(document),
      root_(document.root()),
      import_(import),
      scene_(import.scene),
      materials_(document, import),
      corners_(document.size() + (std::size_t{1} << 22U),
               "the file's meshes have more corners than a file of its size may have"),
      instances_(std::clamp<std::size_t>(document.size(), 1U << 16U, 1U << 22U),
                 "the file has more instances than a file of its size may have") {}

void GltfReader::read() {
    std::vector<Node> pending;
    for (const std::size_t root : root_nodes()) {
        pending.push_back({root, M44d()});
    }
    std::reverse(pending.begin(), pending.end());
    while (!pending.empty()) {
        const Node node = pending.back();
        pending.pop_back();
        read_node(node, pending);
    }
    warn_of_what_is_not_read();
}

std::vector<std::size_t> GltfReader::root_nodes() const {
    const std::size_t nodes = array_size(root_, "nodes");
    try {
        if (array_size(root_, "scenes") > 0) {
            return indices_in(element(root_, "scenes", count_in(root_, "scene", 0)), "nodes");
        }
    } catch (const PartError& fault) {
        import_.warn(fmt::format("the file's scene cannot be used: {}; all nodes are used instead",
                                 fault.reason));
    }
    // Without a scene, uses all nodes without a parent.
    std::vector<bool> is_child(nodes, false);
    for (std::size_t i = 0; i < nodes; ++i) {
        const Json& children = member(member(root_, "nodes")[i], "children");
        for (std::size_t k = 0; children.is_array() && k < children.size(); ++k) {
            if (children[k].is_number_unsigned() && children[k].get<std::size_t>() < nodes) {
                is_child[children[k].get<std::size_t>()] = true;
            }
        }
    }
    std::vector<std::size_t> roots;
    for (std::size_t i = 0; i < nodes; ++i) {
        if (!is_child[i]) {
            roots.push_back(i);
        }
    }
    return roots;
}

void GltfReader::read_node(const Node& visit, std::vector<Node>& pending) {
    std::string name = fmt::format("node {}", visit.index);
    try {
        const Json& node = element(root_, "nodes", visit.index);
        name = node_name(node, visit.index);
        // The nodes form a tree; a node reached twice would be a cycle or a shared child.
        if (!visited_nodes_.insert(visit.index).second) {
            throw PartError{"it has more than one parent, or is its own parent"};
        }
        const M44d world_from_node = local_transform(node) * visit.world_from_parent;
        if (!finite(world_from_node)) {
            throw PartError{"its transform is not finite"};
        }
        const std::vector<std::size_t> children = indices_in(node, "children");
        for (auto child = children.rbegin(); child != children.rend(); ++child) {
            pending.push_back({*child, world_from_node});
        }
        place_light(node, world_from_node);
        place_camera(node, world_from_node);
        place_mesh(node, visit.index, world_from_node);
    } catch (const PartError& fault) {
        import_.warn(fmt::format("node {} is skipped: {}", in_quotes(name), fault.reason));
    }
}

void GltfReader::place_mesh(const Json& node, std::size_t node_index, const M44d& world_from_node) {
    const auto gltf_mesh = index_in(node, "mesh");
    if (!gltf_mesh) {
        return;
    }
    const std::vector<MeshIndex>& parts = meshes(*gltf_mesh);
    if (parts.empty()) {
        return;
    }
    for (const MeshIndex part : parts) {
        check_placement(boxes_[part.value()], world_from_node);
    }
    instances_.take(parts.size());
    skinned_ += member(node, "skin").is_null() ? 0 : 1;
    std::string name = text_in(node, "name");
    if (name.empty()) {
        name = text_in(element(root_, "meshes", *gltf_mesh), "name");
    }
    scene_.objects.push_back({name.empty() ? node_name(node, node_index) : name});
    const auto object = static_cast<std::uint32_t>(scene_.objects.size() - 1);
    for (const MeshIndex part : parts) {
        scene_.instances.push_back({part, world_from_node, object});
    }
}

void GltfReader::warn_of_what_is_not_read() {
    const auto dropped = [&](std::size_t count, const char* kind) {
        if (count > 0) {
            import_.warn(fmt::format("{} of {} skipped: only triangles are rendered",
                                     counted(count, "primitive"), kind));
        }
    };
    dropped(dropped_points_, "points");
    dropped(dropped_lines_, "lines");
    if (skinned_ > 0) {
        import_.warn(fmt::format("{} shown as stored, without skinning",
                                 counted(skinned_, "skinned object")));
    }
    const std::vector<std::string> unread = unread_extensions(root_, "extensionsUsed");
    if (!unread.empty()) {
        import_.warn(fmt::format("the file uses extensions that are not supported: {}",
                                 fmt::join(unread, ", ")));
    }
}

}  // namespace balcony::scene

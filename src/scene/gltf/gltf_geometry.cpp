// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scene/gltf/gltf_reader.hpp"
#include "scene/placement.hpp"

namespace balcony::scene {

namespace {

bool is_read(std::string_view extension) {
    constexpr std::array<std::string_view, 4> others{"EXT_texture_webp", "KHR_lights_punctual",
                                                     "KHR_mesh_quantization",
                                                     "KHR_texture_transform"};
    const auto materials = gltf_material_extensions();
    return std::find(others.begin(), others.end(), extension) != others.end() ||
           std::any_of(materials.begin(), materials.end(),
                       [&](const GltfMaterialExtension& known) { return known.name == extension; });
}

std::set<std::string> unread_extensions(const Json& root, const char* list) {
    std::set<std::string> unread;
    for (std::size_t i = 0; i < array_size(root, list); ++i) {
        const Json& extension = member(root, list)[i];
        if (extension.is_string() && !is_read(extension.get<std::string>())) {
            unread.insert(in_quotes(extension.get<std::string>()));
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

// Whether Blender has exported the file, in a version that converts the units of lights. The mode
// of this conversion is not in the file; that of all its defaults is assumed.
bool is_of_blender(const Json& root) {
    constexpr std::string_view exporter = "Khronos glTF Blender I/O v";
    constexpr std::array first{3, 4};
    const Json& written = member(member(root, "asset"), "generator");
    const std::string generator = written.is_string() ? written.get<std::string>() : "";
    if (!generator.starts_with(exporter)) {
        return false;
    }
    std::array<int, 2> version{};
    const char* at = generator.data() + exporter.size();
    const char* const end = generator.data() + generator.size();
    for (int& part : version) {
        at = std::min(std::from_chars(at, end, part).ptr + 1, end);
    }
    return version >= first;
}

}  // namespace

void read_gltf(Import& import) {
    GltfDocument document(import);
    refuse_compressed(document.root(), import.file);
    import.is_of_blender = is_of_blender(document.root());
    import.scene.has_unit = true;
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
      animations_(document, import),
      corners_(document.size() + (std::size_t{1} << 22U),
               "the file's meshes have more corners than a file of its size may have"),
      instances_(std::clamp<std::size_t>(document.size(), 1U << 16U, 1U << 22U),
                 "the file has more instances than a file of its size may have") {}

void GltfReader::read() {
    import_.begin_phase(0.5, 1.0);
    const std::size_t nodes = array_size(root_, "nodes");
    std::vector<Node> pending;
    for (const std::size_t root : root_nodes()) {
        pending.push_back({root, M44d(), {}});
    }
    std::reverse(pending.begin(), pending.end());
    while (!pending.empty()) {
        const Node node = pending.back();
        pending.pop_back();
        import_.report(visited_nodes_.size(), nodes);
        read_node(node, pending);
    }
    animations_.finish();
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
        const NodeIndex moving =
            animations_.visit(visit.index, visit.moving_parent, visit.world_from_parent);
        const M44d world_from_node = moving.valid()
                                         ? animations_.world_from_node(moving)
                                         : local_transform(node) * visit.world_from_parent;
        if (!is_finite(world_from_node)) {
            throw PartError{"its transform is not finite"};
        }
        const std::vector<std::size_t> children = indices_in(node, "children");
        for (auto child = children.rbegin(); child != children.rend(); ++child) {
            pending.push_back({*child, world_from_node, moving});
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
    const std::vector<MeshIndex>& parts =
        meshes(*gltf_mesh, animations_.deforms(node) ? std::optional(node_index) : std::nullopt);
    if (parts.empty()) {
        return;
    }
    // Joints place a skinned mesh.
    const auto placement = [&](MeshIndex part) {
        return animations_.is_skinned(part) ? M44d() : world_from_node;
    };
    for (const MeshIndex part : parts) {
        if (auto fault = fault_of_placement(boxes_[part.value()], placement(part))) {
            throw PartError{std::move(*fault)};
        }
    }
    instances_.take(parts.size());
    std::string name = text_in(node, "name");
    if (name.empty()) {
        name = text_in(element(root_, "meshes", *gltf_mesh), "name");
    }
    scene_.objects.push_back({name.empty() ? node_name(node, node_index) : name});
    const auto object = static_cast<std::uint32_t>(scene_.objects.size() - 1);
    for (const MeshIndex part : parts) {
        scene_.instances.push_back({part, placement(part), object});
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
    std::set<std::string> unread;
    for (const char* const list : {"extensionsUsed", "extensionsRequired"}) {
        unread.merge(unread_extensions(root_, list));
    }
    if (!unread.empty()) {
        import_.warn(fmt::format("the file uses extensions that are not supported: {}",
                                 fmt::join(unread, ", ")));
    }
}

}  // namespace balcony::scene

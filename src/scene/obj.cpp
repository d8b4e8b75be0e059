// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <charconv>
#include <map>
#include <optional>

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>
#include <assimp/Importer.hpp>

#include "scene/geometry.hpp"
#include "scene/obj_materials.hpp"
#include "scene/obj_text.hpp"

namespace balcony::scene {

namespace {

// Faces that meet at a sharper angle have an edge if the file has no normals.
constexpr float smoothing_angle_in_degrees = 45.0F;

// The number in a section name of the checked text; nothing for a name from Assimp.
std::optional<std::size_t> number_of(const aiString& name) {
    std::size_t number = 0;
    const char* end = name.data + name.length;
    const auto [stop, code] = std::from_chars(name.data, end, number);
    return code == std::errc() && stop == end && name.length > 0 ? std::optional(number)
                                                                 : std::nullopt;
}

// OBJ counts v from the bottom of the image, Scene from its top.
Mesh to_mesh(const aiMesh& source) {
    Mesh mesh;
    for (unsigned i = 0; i < source.mNumVertices; ++i) {
        const aiVector3D& position = source.mVertices[i];
        mesh.positions.emplace_back(position.x, position.y, position.z);
        if (source.HasNormals()) {
            const aiVector3D& normal = source.mNormals[i];
            mesh.normals.emplace_back(normal.x, normal.y, normal.z);
        }
        if (source.HasTextureCoords(0)) {
            const aiVector3D& coordinate = source.mTextureCoords[0][i];
            mesh.texture_coordinates.emplace_back(coordinate.x, 1.0F - coordinate.y);
        }
    }
    for (unsigned i = 0; i < source.mNumFaces; ++i) {
        const aiFace& face = source.mFaces[i];
        if (face.mNumIndices == 3) {
            mesh.triangles.push_back({face.mIndices[0], face.mIndices[1], face.mIndices[2]});
        }
    }
    return mesh;
}

class ObjReader {
public:
    ObjReader(const ObjText& text, const aiScene& source, Import& import)
        : text_(text),
          source_(source),
          import_(import),
          materials_(text.material_libraries, import) {}

    void read() {
        for (unsigned i = 0; i < source_.mNumMeshes; ++i) {
            const aiMesh& mesh = *source_.mMeshes[i];
            const auto section = number_of(mesh.mName);
            if (section && *section < text_.sections.size()) {
                read_mesh(mesh, text_.sections[*section]);
            }
        }
    }

private:
    void read_mesh(const aiMesh& source, const ObjText::Section& section) {
        Mesh mesh = to_mesh(source);
        mesh.name = section.object;
        mesh.material = material(section.material);
        auto finished = finish_mesh(std::move(mesh), import_);
        if (!finished) {
            return;
        }
        Scene& scene = import_.scene;
        const auto [known, is_new] = objects_.try_emplace(section.object, scene.objects.size());
        if (is_new) {
            scene.objects.push_back({section.object});
        }
        scene.meshes.push_back(std::move(*finished));
        scene.instances.push_back({MeshIndex(scene.meshes.size() - 1), M44d(),
                                   static_cast<std::uint32_t>(known->second)});
    }

    MaterialIndex material(const std::string& name) {
        const auto known = material_indices_.find(name);
        if (known != material_indices_.end()) {
            return known->second;
        }
        return material_indices_.emplace(name, materials_.add_to_scene(name)).first->second;
    }

    const ObjText& text_;
    const aiScene& source_;
    Import& import_;
    ObjMaterials materials_;
    std::map<std::string, std::size_t> objects_;
    std::map<std::string, MaterialIndex> material_indices_;
};

}  // namespace

void read_obj(Import& import) {
    import.scene.format = "Wavefront OBJ";
    const std::vector<std::uint8_t> bytes = import.bytes();
    const ObjText text = check_obj({reinterpret_cast<const char*>(bytes.data()), bytes.size()},
                                   import.file.stem().string(), import);
    if (text.sections.empty()) {
        return;
    }
    Assimp::Importer importer;
    importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, smoothing_angle_in_degrees);
    const aiScene* source = importer.ReadFileFromMemory(
        text.text.data(), text.text.size(),
        aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_GenSmoothNormals |
            aiProcess_JoinIdenticalVertices,
        "obj");
    if (source == nullptr) {
        throw ReadError{error(fmt::format("{} cannot be read: {}", in_quotes(import.file.string()),
                                          importer.GetErrorString()))};
    }
    ObjReader(text, *source, import).read();
}

}  // namespace balcony::scene

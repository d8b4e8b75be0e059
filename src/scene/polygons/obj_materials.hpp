// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scene/import.hpp"
#include "scene/polygons/mtl.hpp"

namespace balcony::scene {

/// The materials in an OBJ file's material libraries, by name.
class ObjMaterials {
public:
    /// Reads the libraries next to the OBJ file; warns about missing ones.
    ObjMaterials(const std::vector<std::string>& libraries, Import& import);

    /// Adds a material with its textures to the scene. A material in no library is grey, with a
    /// warning. An empty name means faces without a material: grey without a warning.
    MaterialIndex add_to_scene(const std::string& name);

private:
    struct Source {
        MtlMaterial material;
        std::filesystem::path library;
    };

    void read_library(const std::filesystem::path& file);
    [[nodiscard]] std::optional<std::string> nearest_source(const std::string& name) const;
    void add_maps(const Source& source, Material& material);
    TextureIndex add_texture(const Source& source, const MtlMapArguments& map);

    Import& import_;
    std::map<std::string, Source, std::less<>>
        sources_;  // By name; the last one with a name applies.
    std::map<std::pair<std::filesystem::path, Wrap>, TextureIndex> textures_;
};

}  // namespace balcony::scene

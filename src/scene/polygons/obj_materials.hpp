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
        Material material;
        std::string color_map;  // The arguments of map_Kd as written.
        std::string emission_map;
        std::string opacity_map;
        std::filesystem::path library;
    };

    void read_library(const std::filesystem::path& file);
    static void read_line(Source& source, std::string_view keyword, std::string_view arguments);
    [[nodiscard]] std::optional<std::string> nearest_source(const std::string& name) const;
    TextureIndex add_texture(const Source& source, const std::string& map);

    Import& import_;
    std::map<std::string, Source, std::less<>>
        sources_;  // By name; the last one with a name applies.
    std::map<std::pair<std::filesystem::path, Wrap>, TextureIndex> textures_;
};

}  // namespace balcony::scene

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scene/import.hpp"

namespace balcony::scene {

namespace {

// Formats that are not read, and the programs that convert them.
struct OtherFormat {
    std::string_view extensions;  // Each between blanks.
    std::string_view advice;
};

constexpr std::array other_formats{
    OtherFormat{" .blend .blend1 ",
                "in Blender, use File > Export > glTF 2.0 (.glb), with Cameras and Punctual "
                "Lights included"},
    OtherFormat{" .fbx .dae .abc .usd .usda .usdc .usdz .x3d .wrl .x3dv .3ds .bvh .dxf ",
                "import it into Blender and use File > Export > glTF 2.0 (.glb)"},
    OtherFormat{" .max .ma .mb .c4d .hip .hiplc .lwo .lws .lxo .skp .3dm ",
                "in its program, export glTF (.glb), or else OBJ"},
    OtherFormat{" .step .stp .iges .igs .brep .fcstd .ifc .sldprt .scad .3mf .amf .off ",
                "in a CAD program such as FreeCAD, export the mesh as glTF (.glb), OBJ or STL"},
    OtherFormat{" .las .laz .e57 .xyz .pcd .pts ",
                "points are not rendered; make a surface of them, in CloudCompare or MeshLab for "
                "example, and save it as PLY"},
    OtherFormat{" .vrm .b3dm ",
                "such a file contains a glTF scene: import it into Blender and use "
                "File > Export > glTF 2.0 (.glb)"},
    OtherFormat{" .gz .zip .7z .xz .bz2 .zst .tar ", "extract the scene file first"},
};

}  // namespace

std::string advice_on_format(std::string_view extension) {
    const std::string word = fmt::format(" {} ", extension);
    for (const OtherFormat& format : other_formats) {
        if (!extension.empty() && format.extensions.find(word) != std::string_view::npos) {
            return std::string(format.advice);
        }
    }
    return fmt::format("use a file of one of the formats {}", fmt::join(file_extensions(), ", "));
}

}  // namespace balcony::scene

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Any bytes → a scene or errors; its images, or the bytes as an image → pixels or errors. A scene
// that load() returns must keep its promises.
//
// What the bytes are is told by how they begin: a GLB, the JSON of a glTF file, a PLY file, "stl:"
// before an STL file, the signature of an image, or else an OBJ file. A line "#mtl" of an OBJ file
// begins what stands in m.mtl.

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <span>
#include <string_view>
#include <vector>

#include "../files/temporary_folder.hpp"
#include "../laws/scene_laws.hpp"
#include "balcony/images.hpp"
#include "balcony/scene.hpp"
#include "demand.hpp"

namespace {

using namespace balcony;
namespace fs = std::filesystem;
using Bytes = std::span<const std::uint8_t>;

// The first rows; the others go the same way.
void read_image(const char* name, Bytes bytes) {
    const auto opened = images::ImageFile::open(name, bytes);
    demand(opened || has_errors(opened.diagnostics), "neither an image nor an error");
    constexpr std::size_t max_values = 1'000'000;
    if (!opened) {
        return;
    }
    images::ImageFile& image = **opened;
    if (image.width() * image.channels() > max_values) {
        return;
    }
    const std::size_t row = image.width() * image.channels();
    const std::size_t rows = std::min(image.height(), max_values / row);
    std::vector<float> values(rows * row);
    if (!image.read_rows(0, rows, values)) {
        // Back to the top.
        values.resize(row);
        (void)image.read_rows(0, 1, values);
    }
}

void load(const fs::path& name, Bytes bytes) {
    const Result<scene::Scene> loaded = scene::load(name, bytes);
    demand_no(laws::broken_law(loaded));
    (void)to_text(loaded.diagnostics);
    if (!loaded) {
        return;
    }
    (void)loaded->bounds();
    for (const scene::Texture& texture : loaded->textures) {
        if (!texture.bytes->empty()) {
            read_image("embedded", *texture.bytes);
        }
    }
}

void load_obj(std::string_view text) {
    static const files::TemporaryFolder folder;
    [[maybe_unused]] static const fs::path texture = folder.write("t.png", "");
    const std::size_t end = std::min(text.find("\n#mtl\n"), text.size());
    folder.write("m.mtl", text.substr(end));
    load(folder / "fuzz.obj", {reinterpret_cast<const std::uint8_t*>(text.data()), end});
}

constexpr std::string_view image_starts[] = {"\x89PNG", "\xff\xd8",     "RIFF", "II",
                                             "MM",      "\x76\x2f\x31", "#?",   "BM"};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t count) {
    const Bytes bytes(data, count);
    const std::string_view text(reinterpret_cast<const char*>(data), count);
    const auto begins_with = [text](std::string_view start) { return text.starts_with(start); };
    if (begins_with("glTF")) {
        load("fuzz.glb", bytes);
    } else if (begins_with("{")) {
        load("/nonexistent/fuzz.gltf", bytes);
    } else if (begins_with("ply")) {
        load("fuzz.ply", bytes);
    } else if (begins_with("stl:")) {
        load("fuzz.stl", bytes.subspan(4));
    } else if (begins_with("tga:")) {
        read_image("fuzz.tga", bytes.subspan(4));
    } else if (std::any_of(std::begin(image_starts), std::end(image_starts), begins_with)) {
        read_image("", bytes);
    } else {
        load_obj(text);
    }
    return 0;
}

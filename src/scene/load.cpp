// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cctype>
#include <exception>
#include <new>

#include <fmt/format.h>

#include "scene/import.hpp"

namespace balcony::scene {

namespace fs = std::filesystem;

namespace {

// The readers by extension, in lower case.
struct Format {
    const char* extension;
    void (*read)(Import&);
};

constexpr Format scene_formats[] = {{".glb", read_gltf}, {".gltf", read_gltf}, {".obj", read_obj}};

const Format* format_of(const fs::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char byte) { return static_cast<char>(std::tolower(byte)); });
    for (const Format& format : scene_formats) {
        if (extension == format.extension) {
            return &format;
        }
    }
    return nullptr;
}

void refuse_missing_or_directory(const fs::path& file) {
    std::error_code code;
    const fs::file_status status = fs::status(file, code);
    if (!fs::exists(status)) {
        throw ReadError{error(fmt::format("there is no file {}", in_quotes(file.string())), {},
                              similar_file(file))};
    }
    if (fs::is_directory(status)) {
        throw ReadError{
            error(fmt::format("{} is a directory, not a scene file", in_quotes(file.string())), {},
                  "name a file in it: .glb, .gltf or .obj")};
    }
}

bool lights_itself(const Scene& scene) {
    return !scene.lights.empty() ||
           std::any_of(scene.materials.begin(), scene.materials.end(),
                       [](const Material& material) {
                           return material.emission != Color3f(0.0F, 0.0F, 0.0F);
                       });
}

void read(Import& import) {
    const fs::path& file = import.file;
    if (!import.given) {
        refuse_missing_or_directory(file);
    }
    const Format* format = format_of(file);
    if (format == nullptr) {
        throw ReadError{
            error(fmt::format("the format of {} is not supported", in_quotes(file.string())), {},
                  "use a .glb, .gltf or .obj file")};
    }
    format->read(import);
    if (import.further_warnings > 0) {
        import.diagnostics.push_back(warning(
            fmt::format("{} more like these", counted(import.further_warnings, "warning"))));
    }
    if (import.scene.instances.empty()) {
        throw ReadError{error(
            fmt::format("nothing to render in {}: it has no triangles", in_quotes(file.string())),
            {}, "check that it is the right file; points and lines are not rendered")};
    }
    import.scene.default_light = !lights_itself(import.scene);
}

Result<Scene> load(Import import) {
    const fs::path& file = import.file;
    import.scene.name = file.string();
    const auto failed = [&](Diagnostic reason) -> Result<Scene> {
        import.diagnostics.push_back(std::move(reason));
        return std::move(import.diagnostics);
    };
    // The boundary to libraries that throw: any exception becomes a diagnostic.
    try {
        read(import);
        return {std::move(import.scene), std::move(import.diagnostics)};
    } catch (const ReadError& reason) {
        return failed(reason.diagnostic);
    } catch (const std::bad_alloc&) {
        return failed(
            error(fmt::format("{} needs more memory than available", in_quotes(file.string()))));
    } catch (const std::exception& reason) {
        return failed(
            error(fmt::format("{} cannot be read: {}", in_quotes(file.string()), reason.what())));
    }
}

}  // namespace

Result<Scene> load(const fs::path& file) {
    Import import;
    import.file = file;
    return load(std::move(import));
}

Result<Scene> load(const fs::path& name, std::span<const std::uint8_t> bytes) {
    Import import;
    import.file = name;
    import.given = bytes;
    return load(std::move(import));
}

}  // namespace balcony::scene

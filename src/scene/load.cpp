// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <exception>
#include <new>

#include <fmt/format.h>

#include "balcony/input_file.hpp"
#include "scene/coincident.hpp"
#include "scene/default_light.hpp"
#include "scene/import.hpp"

namespace balcony::scene {

namespace fs = std::filesystem;

namespace {

// The readers by extension, in lower case.
struct Format {
    std::string_view extension;
    void (*read)(Import&);
};

// As Blender's exporter counts: the luminous efficacy of green light.
constexpr float lumens_per_watt = 683.0F;

constexpr std::array scene_formats{Format{".glb", read_gltf}, Format{".gltf", read_gltf},
                                   Format{".obj", read_obj}, Format{".ply", read_ply},
                                   Format{".stl", read_stl}};

const Format& format_of(const fs::path& file) {
    const std::string extension = extension_of(file);
    for (const Format& format : scene_formats) {
        if (extension == format.extension) {
            return format;
        }
    }
    throw ReadError{
        error(fmt::format("the format of {} is not supported", in_quotes(file.string())), {},
              advice_on_format(extension))};
}

// Before the format is looked at, which a missing file or a folder has not.
void refuse_what_is_no_file(const Import& import) {
    const fs::path& file = import.file;
    if (std::optional<Diagnostic> fault = not_a_file(file, in_quotes(file.string()))) {
        fault->remedy = import.near_name(file).value_or(fault->remedy);
        throw ReadError{*fault};
    }
}

// Brings emission to the units of the lights.
void scale_emission(Import& import) {
    Scene& scene = import.scene;
    const float of_lights = import.is_of_blender && !scene.lights.empty() && has_emission(scene)
                                ? lumens_per_watt
                                : 1.0F;
    scene.emission_scale = import.options.emission_scale.value_or(of_lights);
    for (Material& material : scene.materials) {
        for (float* const part :
             {&material.emission.x, &material.emission.y, &material.emission.z}) {
            *part = std::min(*part * scene.emission_scale, static_cast<float>(max_quantity));
        }
    }
}

void read(Import& import) {
    const fs::path& file = import.file;
    if (!import.given) {
        refuse_what_is_no_file(import);
    }
    import.scene.files.push_back(file);
    format_of(file).read(import);
    std::vector<fs::path>& files = import.scene.files;
    std::sort(files.begin(), files.end());
    files.erase(std::unique(files.begin(), files.end()), files.end());
    warn_of_meshes(import);
    if (import.further_warnings > 0) {
        import.diagnostics.push_back(warning(
            fmt::format("{} more like these", counted(import.further_warnings, "warning"))));
    }
    const bool adds_something = !import.scene.lights.empty() || !import.scene.cameras.empty();
    if (import.scene.instances.empty() && !(import.options.is_addition && adds_something)) {
        throw ReadError{error(
            fmt::format("nothing to render in {}: it has no triangles", in_quotes(file.string())),
            {}, "check that it is the right file; points and lines are not rendered")};
    }
    treat_glass(import);
    scale_emission(import);
    find_default_light(import.scene);
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
        import.begin_phase(1.0, 1.0);
        return {std::move(import.scene), std::move(import.diagnostics)};
    } catch (const ReadError& reason) {
        return failed(reason.diagnostic);
    } catch (const Stopped&) {
        return failed(stopped());
    } catch (const std::bad_alloc&) {
        return failed(
            error(fmt::format("{} needs more memory than available", in_quotes(file.string()))));
    } catch (const std::exception& reason) {
        return failed(
            error(fmt::format("{} cannot be read: {}", in_quotes(file.string()), reason.what())));
    }
}

}  // namespace

void warn_of_meshes(Import& import) {
    for (const MeshFault& fault : import.mesh_faults) {
        const std::string others =
            fault.meshes > 1 ? " and " + counted(fault.meshes - 1, "other") : "";
        import.warn(fmt::format("mesh {}{}: {} {}", in_quotes(fault.first_mesh), others,
                                counted(fault.count, fault.noun), fault.what));
    }
    const std::string file = in_quotes(import.file.filename().string());
    if (import.triangles_without_area > 0) {
        import.warn(fmt::format("{}: {} without area skipped", file,
                                counted(import.triangles_without_area, "triangle")));
    }
    const auto coincident = [&](std::size_t count, std::string_view noun) {
        if (count > 0) {
            import.warn(fmt::format("{}: {} skipped, each in the same place as {} others", file,
                                    counted(count, noun), max_coincident),
                        "remove the copies from the scene");
        }
    };
    coincident(import.coincident_triangles, "triangle");
    coincident(drop_coincident_instances(import.scene), "instance");
}

std::span<const std::string_view> file_extensions() {
    static constexpr auto extensions = [] {
        std::array<std::string_view, scene_formats.size()> all;
        for (std::size_t i = 0; i < all.size(); ++i) {
            all[i] = scene_formats[i].extension;
        }
        return all;
    }();
    return extensions;
}

Result<Scene> load(const fs::path& file, const PartDone& progress, const std::stop_token& stop,
                   const LoadOptions& options) {
    Import import;
    import.file = file;
    import.options = options;
    import.stop = stop;
    import.progress = progress;
    return load(std::move(import));
}

Result<Scene> load(const fs::path& name, std::span<const std::uint8_t> bytes,
                   const PartDone& progress, const std::stop_token& stop) {
    Import import;
    import.file = name;
    import.given = bytes;
    import.stop = stop;
    import.progress = progress;
    return load(std::move(import));
}

}  // namespace balcony::scene

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "balcony/images.hpp"
#include "base/stopwatch.hpp"
#include "render/job/renderer_state.hpp"

namespace balcony::render {

namespace {

Diagnostics check(const scene::TimeInterval& interval) {
    if (interval.begin <= interval.end && std::isfinite(interval.duration())) {
        return {};
    }
    return {error(Kind::usage, "an interval of time does not end after it begins",
                  "give two finite times in their order")};
}

}  // namespace

namespace {

// The images that materials read, and how.
auto read_textures(const scene::Scene& scene) {
    std::set<std::pair<scene::TextureIndex, scene::TextureEncoding>> read;
    for (const scene::Material& material : scene.materials) {
        for (const auto use : scene::texture_uses) {
            if ((material.*use).valid()) {
                read.emplace((material.*use).index, (material.*use).encoding);
            }
        }
    }
    return read;
}

// Whether a scene reads no other images than one before an edit.
bool has_textures_of(const scene::Scene& edited, const scene::Scene& scene) {
    const auto is_same = [](const scene::Texture& one, const scene::Texture& other) {
        return one.file == other.file && &*one.bytes == &*other.bytes &&
               one.wrap_u == other.wrap_u && one.wrap_v == other.wrap_v &&
               one.interpolated == other.interpolated;
    };
    const auto read = read_textures(edited);
    const auto known = read_textures(scene);
    return std::equal(edited.textures.begin(), edited.textures.end(), scene.textures.begin(),
                      scene.textures.end(), is_same) &&
           std::includes(known.begin(), known.end(), read.begin(), read.end());
}

}  // namespace

bool has_parts_of(const scene::Scene& moved, const scene::Scene& scene) {
    return moved.motion == scene.motion && moved.axes == scene.axes &&
           moved.meshes.size() == scene.meshes.size() &&
           moved.instances.size() == scene.instances.size() &&
           moved.objects.size() == scene.objects.size() &&
           moved.materials.size() == scene.materials.size() &&
           moved.textures.size() == scene.textures.size() &&
           moved.lights.size() == scene.lights.size();
}

Result<Renderer> Renderer::make(std::shared_ptr<const scene::Scene> scene,
                                const RendererSettings& settings, const PartDone& progress,
                                const std::stop_token& stop) {
    if (!scene) {
        return error(Kind::internal, "a renderer needs a scene");
    }
    if (Diagnostics found = scene::check(*scene); !found.empty()) {
        return found;
    }
    if (settings.texture_memory < min_texture_memory) {
        return error(fmt::format("{:.3g} MiB are too little memory for textures",
                                 static_cast<double>(settings.texture_memory) / 0x1p20),
                     {}, fmt::format("give at least {} MiB", min_texture_memory >> 20U));
    }
    const scene::TimeInterval times =
        settings.interval.value_or(scene::TimeInterval{scene->time, scene->time});
    if (Diagnostics found = check(times); !found.empty()) {
        return found;
    }
    // What is missing to read it is no fault of a texture, so that no picture is made without it.
    for (const scene::Texture& texture : scene->textures) {
        if (Diagnostics found = texture.file.empty() ? images::require_reader(*texture.bytes)
                                                     : images::require_reader(texture.file);
            has_errors(found)) {
            return found;
        }
    }
    const Stopwatch watch;
    const scene::Movement movement = scene::movement(*scene, times);
    const bool reads_textures = !settings.textures_on_demand && !scene->textures.empty();
    Result<embree::Accelerator> accelerator = embree::Accelerator::build(
        *scene, movement, stop, part_of(progress, 0.0, reads_textures ? 0.5 : 1.0));
    if (!accelerator) {
        return std::move(accelerator.diagnostics);
    }
    Diagnostics warnings = std::move(accelerator.diagnostics);
    const double build_seconds = watch.seconds();
    auto textures =
        std::make_shared<const TextureLibrary>(*scene, settings.texture_memory, warnings, stop);
    if (reads_textures) {
        textures->read_all(stop, part_of(progress, 0.5, 1.0));
    }
    SurfaceFinder surfaces(*scene, movement);
    LightSet lights(*scene, textures.get(), movement, stop);
    if (stop.stop_requested()) {
        return stopped();
    }
    const Preparation preparation{build_seconds, watch.seconds() - build_seconds,
                                  textures->held_bytes()};
    MaterialSet materials(*scene, *textures);
    TracedScene traced{std::move(scene),
                       std::move(*accelerator),
                       std::move(surfaces),
                       lights,
                       std::move(textures),
                       std::move(materials),
                       times};
    return {Renderer(std::make_shared<const State>(
                State{std::move(traced), preparation, settings.textures_on_demand})),
            std::move(warnings)};
}

Result<Renderer> Renderer::moved(std::shared_ptr<const scene::Scene> scene,
                                 const scene::TimeInterval& interval, const PartDone& progress,
                                 const std::stop_token& stop) const {
    if (!scene || !has_textures_of(*scene, *state_->traced.scene)) {
        return error(Kind::usage, "a renderer moves to a scene with its own textures only",
                     "give what scene::moved_to() or an edit makes of its scene");
    }
    if (Diagnostics found = scene::check(*scene); !found.empty()) {
        return found;
    }
    if (Diagnostics found = check(interval); !found.empty()) {
        return found;
    }
    TracedScene traced = state_->traced;
    traced.interval = interval;
    const Stopwatch watch;
    Diagnostics warnings;
    if (scene->motion || scene != traced.scene) {
        const scene::Movement movement = scene::movement(*scene, interval);
        Result<embree::Accelerator> accelerator =
            traced.accelerator.moved(*scene, movement, stop, progress);
        if (!accelerator) {
            return std::move(accelerator.diagnostics);
        }
        warnings = std::move(accelerator.diagnostics);
        traced.accelerator = std::move(*accelerator);
        traced.surfaces = SurfaceFinder(*scene, movement);
        traced.lights = LightSet(*scene, traced.textures.get(), movement, stop);
        if (stop.stop_requested()) {
            return stopped();
        }
        traced.materials = MaterialSet(*scene, *traced.textures);
        traced.scene = std::move(scene);
    }
    Preparation preparation = state_->preparation;
    preparation.build_seconds = watch.seconds();
    return {Renderer(std::make_shared<const State>(
                State{std::move(traced), preparation, state_->textures_on_demand})),
            std::move(warnings)};
}

const Renderer::Preparation& Renderer::preparation() const { return state_->preparation; }

}  // namespace balcony::render

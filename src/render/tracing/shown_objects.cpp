// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/tracing/shown_objects.hpp"

#include <cstdint>
#include <set>
#include <string>

#include <fmt/format.h>

#include "balcony/object_names.hpp"
#include "balcony/probe.hpp"

namespace balcony::render {

namespace {

std::vector<bool> objects_of(const camera::ObjectChoice& choice, const scene::Scene& scene) {
    std::vector<bool> named(scene.objects.size());
    for (const camera::ObjectPattern& pattern : choice.patterns) {
        for (const std::uint32_t object : scene::objects_named(scene, pattern.text)) {
            named[object] = true;
        }
    }
    return named;
}

}  // namespace

Result<ShownObjects> shown_by(const camera::ObjectFilter& filter, const TracedScene& traced) {
    ShownObjects made;
    if (filter.empty()) {
        return made;
    }
    const scene::Scene& scene = *traced.scene;
    made.instances.assign(scene.instances.size(), 1);
    for (const camera::ObjectChoice& choice : filter) {
        made.environment = made.environment && !choice.shows;
        const std::vector<bool> named = objects_of(choice, scene);
        for (std::size_t i = 0; i < made.instances.size(); ++i) {
            if (named[scene.instances[i].object] != choice.shows) {
                made.instances[i] = 0;
            }
        }
    }
    Result<embree::Accelerator> some = traced.accelerator.only(made.instances);
    if (!some) {
        return std::move(some.diagnostics);
    }
    made.some = std::move(*some);
    return made;
}

Diagnostics check_objects(const camera::Picture& picture, const scene::Scene& scene) {
    Diagnostics found;
    std::set<std::string> unknown;
    for (const camera::ShownCamera& shown : camera::shown_cameras(picture)) {
        for (const camera::ShownCamera::LayerUse& use : shown.uses) {
            for (const camera::ObjectChoice& choice : use.objects) {
                for (const camera::ObjectPattern& pattern : choice.patterns) {
                    if (scene::objects_named(scene, pattern.text).empty() &&
                        unknown.insert(pattern.text).second) {
                        found.push_back(scene::no_object(
                            scene,
                            fmt::format("layer {} {} '{}', but the scene has no such object",
                                        use.layer, choice.shows ? "shows" : "hides",
                                        printable(pattern.text)),
                            pattern.text, pattern.written));
                    }
                }
            }
        }
    }
    return found;
}

Result<std::vector<ShownObjects>> shown_objects(const rays::CompiledPicture& picture,
                                                const TracedScene& traced) {
    std::vector<ShownObjects> made;
    for (const rays::CompiledPicture::CameraLayer& layer : picture.layers()) {
        Result<ShownObjects> shown = shown_by(layer.objects, traced);
        if (!shown) {
            return std::move(shown.diagnostics);
        }
        made.push_back(std::move(*shown));
    }
    return made;
}

}  // namespace balcony::render

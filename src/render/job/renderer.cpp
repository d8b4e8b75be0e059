// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cassert>
#include <iterator>

#include "render/job/renderer_state.hpp"
#include "render/job/stopwatch.hpp"

namespace balcony::render {

Result<Renderer> Renderer::make(std::shared_ptr<const scene::Scene> scene) {
    assert(scene);
    const Stopwatch watch;
    Result<embree::Accelerator> accelerator = embree::Accelerator::build(*scene);
    if (!accelerator) {
        return std::move(accelerator.diagnostics);
    }
    Diagnostics warnings = std::move(accelerator.diagnostics);
    const double build_seconds = watch.seconds();
    auto textures = std::make_unique<const TextureLibrary>(*scene, warnings);
    SurfaceFinder surfaces(*scene);
    LightSet lights(*scene);
    const Preparation preparation{build_seconds, watch.seconds() - build_seconds};
    MaterialSet materials(*scene, *textures);
    TracedScene traced{std::move(scene), std::move(*accelerator), std::move(surfaces),
                       lights,           std::move(textures),     std::move(materials)};
    return {Renderer(std::make_shared<const State>(State{std::move(traced), preparation})),
            std::move(warnings)};
}

const Renderer::Preparation& Renderer::preparation() const { return state_->preparation; }

}  // namespace balcony::render

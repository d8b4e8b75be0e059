// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Renders small pictures of the plates' scenes for measuring, and keeps the scenes.

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "balcony/lang.hpp"
#include "balcony/render.hpp"
#include "balcony/scene.hpp"
#include "common/scene_options.hpp"

namespace balcony::plates {

/// Values for parameters of a camera.
using Overrides = std::vector<lang::Override>;

/// What to look at, and through what.
struct Look {
    std::string scene;   ///< Of the catalogue.
    std::string camera;  ///< File in plates/, and perhaps a name in it: "01-gallery/camera.cam".
    std::string name{};  ///< Of a camera or a picture in the file; empty is the last.
    std::size_t width = 320;
    std::size_t height = 200;
    bool pictures_and_walls = true;
};

/// Throws std::runtime_error if a scene or a camera cannot be made.
class Studio {
public:
    /// One ray through the centre of each pixel, with the data layers. Textures are shrunk to
    /// a few texels.
    [[nodiscard]] render::Film look(const Look& look, const Overrides& overrides = {});

    [[nodiscard]] const scene::Scene& scene(const std::string& name,
                                            bool pictures_and_walls = true);

private:
    struct Set {
        std::shared_ptr<const scene::Scene> scene;
        std::shared_ptr<const render::Renderer> renderer;
    };
    static render::Renderer renderer_for(const Set& set, const camera::Picture& picture);
    const Set& set(const std::string& name, bool pictures_and_walls);

    std::map<std::pair<std::string, bool>, Set> sets_;
};

}  // namespace balcony::plates

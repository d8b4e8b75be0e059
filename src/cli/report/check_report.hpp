// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "balcony/diagnose.hpp"
#include "balcony/probe.hpp"
#include "balcony/scene.hpp"

namespace balcony::cli {

/// What `balcony check` has found out about a camera.
struct CameraCheck {
    analyse::Report report;

    struct Layer {
        std::string picture;
        std::string number;  ///< "2", or "3.1" in the picture that layer 3 shows.
    };
    bool by_itself = true;      ///< Not only in layers.
    std::vector<Layer> layers;  ///< That show the camera with these parameters.

    struct Start {
        std::string object;
        double share = 0.0;  ///< Of the rays.
        analyse::V2d point;  ///< Of the picture, an example.
        bool room = false;   ///< All rays start in it, so it may well be the room they are in.
    };
    struct InScene {
        std::string scene;
        std::vector<std::string> never_seen;
        std::vector<Start> starts_inside;
    };
    std::optional<InScene> in_scene;

    /// What --strict does not allow. Few pictures show every object, so that is not asked for.
    [[nodiscard]] std::size_t defect_count() const;
    /// The camera and where it is shown: visitor, layer 2 of poster.
    [[nodiscard]] std::string title() const;
};

[[nodiscard]] CameraCheck::InScene in_scene(const scene::Scene& scene, const render::Probe& probe);

/// For people, some lines.
[[nodiscard]] std::string check_text(const CameraCheck& check);
[[nodiscard]] nlohmann::json check_json(const CameraCheck& check);

}  // namespace balcony::cli

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "balcony/diagnose.hpp"
#include "balcony/inputs.hpp"
#include "balcony/probe.hpp"
#include "balcony/scene.hpp"

namespace balcony::cli {

/// The results of `balcony check` for a camera.
struct CameraCheck {
    analyse::Report report;

    struct Layer {
        std::string picture;
        std::string number;  ///< "2", or "3.1" in the picture of layer 3.
    };
    bool has_lens = false;      ///< The report is about the rays through its centre.
    bool by_itself = true;      ///< Whether it was also requested on its own.
    std::vector<Layer> layers;  ///< The layers that show the camera with these parameters.

    struct Start {
        std::string object;
        double share = 0.0;  ///< The fraction of the rays.
        analyse::V2d point;  ///< An example of a position in the picture.
        bool room = false;   ///< All rays start in it, so it is probably a room.
    };
    struct InScene {
        std::string scene;
        std::vector<std::string> never_seen;
        std::vector<Start> starts_inside;
        std::optional<app::MissText> miss;  ///< If no ray meets anything.
    };
    std::optional<InScene> in_scene;

    /// The number of defects for --strict. Objects that are never visible do not count, unless all
    /// are.
    [[nodiscard]] std::size_t defect_count() const;
    /// The camera and the layers that show it: "visitor, layer 2 of poster".
    [[nodiscard]] std::string title() const;
};

[[nodiscard]] CameraCheck::InScene in_scene(const scene::Scene& scene, const render::Probe& probe);

/// The results as text.
[[nodiscard]] std::string check_text(const CameraCheck& check);
[[nodiscard]] nlohmann::json check_json(const CameraCheck& check);

}  // namespace balcony::cli

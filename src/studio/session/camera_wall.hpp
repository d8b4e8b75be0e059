// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Thumbnails of all built-in cameras in the scene of a view. Those that were made are kept.
//
// Belongs to the thread of the server.

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "balcony/live.hpp"
#include "balcony/thumbnails.hpp"
#include "studio/web/server.hpp"

namespace balcony::studio {

class CameraWall {
public:
    /// What is told comes on the thread of the server.
    struct Told {
        std::function<void(const Bytes&)> picture;
        std::function<void(const nlohmann::json&)> failure;
    };

    CameraWall(Server& server, const app::Request& request, Told told);

    /// What cameras there are.
    [[nodiscard]] const nlohmann::json& list();
    /// Tells the pictures of some, in this order, if the view has a scene. The newest call counts.
    /// Throws a Refusal.
    void show(const live::View& view, const nlohmann::json& asked);

private:
    void take(const live::Thumbnail& made, const Bytes& bytes);

    Server& server_;
    app::Request request_;
    Told told_;
    std::unique_ptr<nlohmann::json> list_;  ///< Null before it is asked for.
    std::array<std::size_t, 2> size_{};
    std::map<std::string, Bytes> made_;  ///< In this size.
    std::unique_ptr<live::Thumbnails>
        thumbnails_;  ///< The last member: its threads use the others.
};

/// The text of a built-in camera. Throws a Refusal.
[[nodiscard]] std::string camera_text(const std::string& built_in_camera);

}  // namespace balcony::studio

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Pictures and films in full quality, rendered one after the other into files beside the camera
// file.
//
// Belongs to the thread of the server.

#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <stop_token>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "balcony/live.hpp"
#include "studio/serve.hpp"
#include "studio/session/inspection.hpp"
#include "studio/session/render_order.hpp"
#include "studio/web/server.hpp"

namespace balcony::studio {

class Renderings {
public:
    /// `tell` is called on the thread of the server.
    Renderings(Server& server, const live::View& view, const Options& options,
               std::function<void(const nlohmann::json&)> tell);
    /// Stops all.
    ~Renderings();
    Renderings(const Renderings&) = delete;
    Renderings& operator=(const Renderings&) = delete;

    /// Renders what the view shows now, after what was asked for before. The result has its number
    /// and its file. Throws a Refusal.
    [[nodiscard]] nlohmann::json start(const nlohmann::json& asked);
    /// Ends one: what there is of its picture, or of its frames, is written.
    void stop(const nlohmann::json& asked);

private:
    [[nodiscard]] std::filesystem::path unused_file(const RenderOrder& order) const;
    void end(int number, const Rendered& made);

    Server& server_;
    const live::View& view_;
    Options options_;
    std::function<void(const nlohmann::json&)> tell_;
    int last_number_ = 0;
    struct Rendering {
        std::filesystem::path file;
        std::stop_source stop;
    };
    std::map<int, Rendering> renderings_;  ///< Those that have not ended.
    Inspection inspection_;                ///< The last member, since its thread uses the others.
};

}  // namespace balcony::studio

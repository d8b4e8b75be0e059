// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The picture of a text that changes: it is made when it must be, and moved where it can be.

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "balcony/lang.hpp"
#include "balcony/live.hpp"
#include "balcony/prepared_scene.hpp"
#include "live/live_picture.hpp"

namespace balcony::live {

class FollowedPicture {
public:
    explicit FollowedPicture(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Makes the picture of what is wanted, but does not move it. False if there is none, as the
    /// diagnostics say: the last good one stays.
    [[nodiscard]] bool follow(app::PreparedScene& scene, const Shown& wanted,
                              const std::stop_token& stop, Diagnostics& found);

    [[nodiscard]] LivePicture& picture() { return *picture_; }

private:
    [[nodiscard]] bool move(app::PreparedScene& scene, double time, const std::stop_token& stop,
                            Diagnostics& found);
    /// Values of parameters that are not open shape the camera.
    [[nodiscard]] bool make(app::PreparedScene& scene, const Shown& wanted,
                            const std::vector<lang::Override>& closed, const std::stop_token& stop,
                            Diagnostics& found);

    std::filesystem::path folder_;
    std::optional<LivePicture> picture_;  ///< The last good one,
    std::string text_;                    ///< and what it was made of.
    std::string camera_;
    std::vector<lang::Override> closed_;
    std::optional<double> time_;  ///< To which the scene was moved.
};

/// What a text and its folder are to a workspace.
[[nodiscard]] lang::CameraSource source_of(const Shown& shown, const std::filesystem::path& folder);

}  // namespace balcony::live

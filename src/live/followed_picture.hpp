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

    /// Makes the picture of what is wanted, but does not move it. With `holds`, parameters that
    /// change with time are held at the value that they have, and can be moved then. False if there
    /// is none, as the diagnostics say: the last good one stays.
    [[nodiscard]] bool follow(app::PreparedScene& scene, const Shown& wanted, bool holds,
                              const std::stop_token& stop, Diagnostics& found);

    [[nodiscard]] LivePicture& picture() { return *picture_; }

private:
    [[nodiscard]] bool move(app::PreparedScene& scene, double time, const std::stop_token& stop,
                            Diagnostics& found);
    [[nodiscard]] std::vector<Value> with_held(const Shown& wanted) const;
    [[nodiscard]] bool can_show(const std::vector<lang::Override>& values) const;
    [[nodiscard]] std::vector<lang::Override> closed_among(
        std::vector<lang::Override> values) const;
    /// Values of parameters that are not open shape the camera.
    [[nodiscard]] bool make(app::PreparedScene& scene, const Shown& wanted,
                            const std::vector<lang::Override>& closed, const std::stop_token& stop,
                            Diagnostics& found);

    std::filesystem::path folder_;
    std::optional<LivePicture> picture_;  ///< The last good one,
    std::string text_;                    ///< and what it was made of.
    std::string camera_;
    std::vector<lang::Override> closed_;
    std::vector<lang::MovingParameter> moving_;  ///< Of the text.
    std::optional<camera::StereoFormat> stereo_;
    std::optional<double> time_;  ///< To which the scene was moved.
};

/// Makes a picture what both eyes see of it, if a format is wanted. False if that cannot be, as the
/// diagnostics say.
[[nodiscard]] bool apply_stereo(const app::PreparedScene& scene,
                                const std::optional<camera::StereoFormat>& stereo,
                                camera::Picture& picture, Diagnostics& found);

/// A request with the stereo format that is shown.
[[nodiscard]] app::Request with_stereo_of(app::Request request, const Shown& shown);

/// What a text and its folder are to a workspace.
[[nodiscard]] lang::CameraSource source_of(const Shown& shown, const std::filesystem::path& folder);

}  // namespace balcony::live

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stop_token>

#include "balcony/prepared_scene.hpp"
#include "dataset/frames/flow.hpp"
#include "dataset/frames/frame_data.hpp"

namespace balcony::dataset {

/// Renders the frames of a scene, which stays loaded, with the light and the exposure of the first
/// one.
class FrameMaker {
public:
    /// The plan must outlive it.
    FrameMaker(const Plan& plan, std::size_t scene, app::PreparedScene prepared)
        : plan_(plan), scene_(scene), prepared_(std::move(prepared)) {}

    [[nodiscard]] std::size_t scene() const { return scene_; }
    /// Warnings come with the value. A stop is an error of Kind::interrupted.
    [[nodiscard]] Result<FrameData> make(const Frame& frame, const app::Observer& observer,
                                         const std::stop_token& stop);

private:
    [[nodiscard]] Diagnostics hold_look(const std::stop_token& stop);
    [[nodiscard]] camera::Picture picture_of(const Frame& frame) const;

    const Plan& plan_;
    std::size_t scene_;
    app::PreparedScene prepared_;
    FlowFinder flows_;
    std::optional<app::Request> held_{};  // With the exposure and the light of the first frame.
};

}  // namespace balcony::dataset

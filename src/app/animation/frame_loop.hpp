// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Renders the frames of an animation, one after the other.

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

#include "app/animation/frame_record.hpp"
#include "app/inputs/frame_pictures.hpp"
#include "app/inputs/loaded.hpp"
#include "app/picture/finished_picture.hpp"
#include "balcony/animation.hpp"

namespace balcony::app {

/// A frame, or a part of it.
struct FrameUnit {
    std::size_t frame = 0;
    render::Shard part{};
};

/// The units of a shard: frame by frame, and within a frame part by part, they are dealt out in
/// turn.
[[nodiscard]] std::vector<FrameUnit> units_of(const FrameNumbers& frames, std::size_t parts,
                                              const render::Shard& shard);

class FrameLoop {
public:
    /// The scene is loaded for the time of frame 1, and the picture is the one to render then. All
    /// references must outlive the loop.
    FrameLoop(const AnimationRequest& animation, Loaded& loaded, camera::Picture picture,
              const render::FilmLayout& layout, const Observer& observer, AnimationReport& report);

    /// Renders what is not finished yet and adds the facts. The scene is moved along.
    void run(const FrameNumbers& frames, const std::stop_token& stop);

private:
    [[nodiscard]] bool fails(const Diagnostics& found);
    [[nodiscard]] bool begin_frames(const FrameNumbers& frames);
    [[nodiscard]] std::filesystem::path file_of(const FrameUnit& unit) const;
    [[nodiscard]] bool is_finished(const FrameUnit& unit);
    [[nodiscard]] bool is_displayed() const;
    [[nodiscard]] bool go_to(std::size_t frame, const std::stop_token& stop);
    [[nodiscard]] bool render(const FrameUnit& unit, const std::stop_token& stop);
    [[nodiscard]] Result<render::Summary> trace_unit(const FrameUnit& unit,
                                                     const std::shared_ptr<render::Film>& shared,
                                                     class CheckpointFile& checkpoint,
                                                     const std::stop_token& stop);
    [[nodiscard]] Diagnostics write_unit(const FrameUnit& unit, render::Film& film);
    void describe_first(const FrameUnit& unit, const render::Film& film,
                        const render::Summary& summary);
    void add_once(const Diagnostics& diagnostics);

    const AnimationRequest& animation_;
    Request request_;
    Loaded& loaded_;
    camera::Picture wanted_;   // At the time of frame 1.
    camera::Picture picture_;  // At the time of the frame.
    const render::FilmLayout& layout_;
    const Observer& observer_;
    AnimationReport& report_;
    FrameInverses inverses_;
    std::uint32_t seed_;
    FrameRecord record_;
    std::optional<render::Job> job_;
    std::set<std::string> told_;
    bool described_ = false;
    bool warned_of_motion_ = false;
};

}  // namespace balcony::app

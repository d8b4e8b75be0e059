// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the frames of a sequence depend on, in a file beside them: PATTERN.animation. A frame is
// finished if it is there and not older than the record.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "balcony/animation.hpp"
#include "balcony/checkpoint.hpp"

namespace balcony::app {

struct FrameRecord {
    render::RenderFacts facts;  ///< All that the pixels depend on, but for the number of a frame.
    FrameNumbers frames;        ///< That were asked for last.
    FrameRate rate{};
    std::optional<double> crf;              ///< Of the film; empty for the usual one.
    std::filesystem::file_time_type since;  ///< Older frames are of other settings.

    /// In words; empty if nothing differs.
    [[nodiscard]] std::string difference_from(const render::RenderFacts& now) const;
    [[nodiscard]] bool is_finished(const std::filesystem::path& frame) const;
};

[[nodiscard]] std::filesystem::path record_file(const FramePattern& pattern);

/// Nothing if there is none; a file that is damaged is an error.
[[nodiscard]] Result<std::optional<FrameRecord>> read_record(const FramePattern& pattern);

/// Begins a new record. Frames that are there already are not finished by it.
[[nodiscard]] Diagnostics begin_record(const FramePattern& pattern, FrameRecord& record);

/// Replaces a record by one of the same facts.
[[nodiscard]] Diagnostics change_record(const FramePattern& pattern, const FrameRecord& record);

}  // namespace balcony::app

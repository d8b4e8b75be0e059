// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/animation.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "app/words.hpp"

namespace balcony::app {

namespace {

std::optional<std::size_t> number_up_to_max(std::string_view text) {
    const auto number = text.starts_with('+') ? std::nullopt : whole_number_of(text);
    return number && *number <= max_frame ? number : std::nullopt;
}

// "1-240x10"
bool add_range(std::string_view text, FrameNumbers& frames) {
    const std::size_t cross = text.find('x');
    const std::string_view range = text.substr(0, cross);
    const std::size_t dash = range.find('-');
    const auto first = number_up_to_max(range.substr(0, dash));
    const auto last =
        dash == std::string_view::npos ? first : number_up_to_max(range.substr(dash + 1));
    const auto step = cross == std::string_view::npos ? std::optional<std::size_t>(1)
                                                      : number_up_to_max(text.substr(cross + 1));
    if (!first || !last || !step || *last < *first || *step == 0) {
        return false;
    }
    for (std::size_t frame = *first; frame <= *last; frame += *step) {
        frames.push_back(frame);
    }
    return true;
}

}  // namespace

std::optional<FrameNumbers> frame_numbers_of(std::string_view text) {
    FrameNumbers frames;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        if (!add_range(text.substr(begin, end - begin), frames)) {
            return std::nullopt;
        }
        begin = end + 1;
    }
    std::sort(frames.begin(), frames.end());
    frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
    return frames;
}

// A film of one frame is not meant.
std::optional<FrameNumbers> frames_of_film(std::string_view text) {
    auto frames = frame_numbers_of(text);
    if (frames && whole_number_of(text)) {
        const std::size_t last = frames->front();
        frames->resize(std::max<std::size_t>(last, 1));
        std::iota(frames->begin(), frames->end(), last > 0 ? 1 : 0);
    }
    return frames;
}

std::string text_of(std::span<const std::size_t> frames) {
    std::string text;
    for (std::size_t i = 0; i < frames.size();) {
        std::size_t last = i;
        while (last + 1 < frames.size() && frames[last + 1] == frames[last] + 1) {
            ++last;
        }
        text += fmt::format("{}{}", text.empty() ? "" : ",", frames[i]);
        text += last > i ? fmt::format("-{}", frames[last]) : "";
        i = last + 1;
    }
    return text;
}

}  // namespace balcony::app

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/animation.hpp"

#include <algorithm>
#include <system_error>

#include <fmt/format.h>

#include "app/words.hpp"
#include "balcony/input_file.hpp"

namespace balcony::app {

namespace {

namespace fs = std::filesystem;

struct Place {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::size_t digits = 1;
};

// "%d" or "%04d"
std::optional<Place> printf_place(std::string_view name) {
    const std::size_t begin = name.find('%');
    if (begin == std::string_view::npos) {
        return std::nullopt;
    }
    const std::size_t end = std::min(name.find_first_not_of("0123456789", begin + 1), name.size());
    const std::string_view digits = name.substr(begin + 1, end - begin - 1);
    const auto count = digits.empty() ? std::optional<std::size_t>(1) : whole_number_of(digits);
    constexpr std::size_t most = 20;
    const bool sound = end < name.size() && name[end] == 'd' && count && *count <= most;
    return sound ? std::optional(Place{begin, end + 1, std::max<std::size_t>(*count, 1)})
                 : std::nullopt;
}

// The last run of #.
std::optional<Place> hash_place(std::string_view name) {
    const std::size_t last = name.rfind('#');
    if (last == std::string_view::npos) {
        return std::nullopt;
    }
    const std::size_t before = name.find_last_not_of('#', last);
    const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
    return Place{begin, last + 1, last + 1 - begin};
}

}  // namespace

std::optional<FramePattern> FramePattern::read(const std::string& text) {
    const fs::path path(text);
    const std::string name = path.filename().string();
    const auto in_hashes = hash_place(name);
    const auto place = in_hashes ? in_hashes : printf_place(name);
    if (!place) {
        return std::nullopt;
    }
    FramePattern pattern;
    pattern.folder_ = path.parent_path();
    pattern.before_ = name.substr(0, place->begin);
    pattern.after_ = name.substr(place->end);
    pattern.digits_ = place->digits;
    return pattern;
}

fs::path FramePattern::file(std::size_t frame) const {
    return folder_ / fmt::format("{}{:0{}}{}", before_, frame, digits_, after_);
}

std::optional<std::size_t> FramePattern::number_of_file(std::string_view name) const {
    if (name.size() < before_.size() + after_.size() + digits_ || !name.starts_with(before_) ||
        !name.ends_with(after_)) {
        return std::nullopt;
    }
    name.remove_prefix(before_.size());
    name.remove_suffix(after_.size());
    const auto number = whole_number_of(name);
    return number && name == fmt::format("{:0{}}", *number, digits_) ? number : std::nullopt;
}

FrameNumbers FramePattern::existing() const {
    FrameNumbers frames;
    for (const std::string& name : names_in(folder_)) {
        if (const auto number = number_of_file(name)) {
            frames.push_back(*number);
        }
    }
    std::sort(frames.begin(), frames.end());
    return frames;
}

std::string FramePattern::text() const {
    return (folder_ / (before_ + std::string(digits_, '#') + after_)).string();
}

}  // namespace balcony::app

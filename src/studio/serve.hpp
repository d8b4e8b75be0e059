// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The studio: a page in which a camera is edited while its picture follows.

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/request.hpp"

namespace balcony::studio {

struct Options {
    /// The scene and all of a picture but its camera, as live::View::load() takes it.
    app::Request request{};
    std::filesystem::path file{};               ///< Of the camera.
    std::string new_text{};                     ///< Of the file if it is not there yet.
    std::string camera{};                       ///< In it; its last one if empty.
    std::array<std::size_t, 2> size{960, 540};  ///< Until a page asks for another one.
    bool is_read_only = false;                  ///< No file is written.
    /// Words of `balcony render` that say what the request does of a picture.
    std::vector<std::string> words{};

    std::uint16_t port = 0;              ///< A free one if it is 0.
    std::filesystem::path token_file{};  ///< Has the token of the address, or gets it.
    /// Called once pages can connect, with the address of the page.
    std::function<void(const std::string&)> on_ready{};
};

/// Serves until a stop.
[[nodiscard]] Diagnostics serve(const Options& options, const std::stop_token& stop);

}  // namespace balcony::studio

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Thumbnails: small pictures of many cameras in one scene, such as all that are built in.
//
//     Thumbnails(scene, request, made) ─▶ show(names, size) ─▶ made(Thumbnail), one after the other

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/prepared_scene.hpp"
#include "balcony/request.hpp"

namespace balcony::live {

/// What a camera sees of a scene.
struct Thumbnail {
    std::string camera;
    std::array<std::size_t, 2> room{};  ///< The size that was asked for.
    std::size_t width = 0;              ///< In pixels; 0 if there is no picture.
    std::size_t height = 0;
    std::vector<std::uint8_t> pixels{};  ///< As render::display_pixels().
    Diagnostics diagnostics{};           ///< Why there is none.
};

/// Makes thumbnails on threads of its own, as many at a time as the machine has cores.
class Thumbnails {
public:
    /// Told by these threads, one call at a time. Must not throw or wait for the thumbnails' end.
    using Made = std::function<void(const Thumbnail&)>;

    /// The request says how light becomes colours; the rest of it is the scene's.
    Thumbnails(const app::PreparedScene& scene, const app::Request& request, Made made);
    /// Ends what is in progress.
    ~Thumbnails();
    Thumbnails(const Thumbnails&) = delete;
    Thumbnails& operator=(const Thumbnails&) = delete;

    /// Makes these next, in this order, and nothing else that was asked for before. Cameras are
    /// files or names of built-in ones. A picture is as large as a size in pixels has room for.
    void show(const std::vector<std::string>& cameras, const std::array<std::size_t, 2>& size);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace balcony::live

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Page: a file of HTML in which a browser looks at a scene through an extended camera, on its own
// graphics processor and without a server.
//
//     PageRequest ─▶ shader of the picture, triangles, textures ─▶ make_page() ─▶ HTML
//
// docs/page.md says what it shows.

#include <array>
#include <cstddef>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "balcony/app.hpp"
#include "balcony/base.hpp"
#include "balcony/request.hpp"

namespace balcony::page {

/// A scene with more triangles, counted with each instance, is an error.
inline constexpr std::size_t max_triangles = 4'000'000;
/// A larger page comes with a warning, since phones may not open it.
inline constexpr std::size_t heavy_page_bytes = 64'000'000;

struct PageRequest {
    /// The scene, its camera and its placement, the size, the exposure and the background. The rest
    /// is not read.
    app::Request picture{};
    /// The parameters of the camera that have sliders; all that can have one if it is empty.
    std::optional<std::vector<std::string>> open{};
    std::string title{};  ///< By default the names of the scene and the camera.
    /// Images with longer sides, in pixels, are reduced; from 1 to 4096.
    std::size_t texture_side = 2048;
};

struct Page {
    std::string html;
    std::array<std::size_t, 2> size{};  ///< Of the picture in pixels, if the window has room.
    std::size_t triangles = 0;          ///< Of all instances.
    std::size_t textures = 0;
    std::vector<std::string> open{};    ///< The parameters with sliders.
    std::vector<std::string> closed{};  ///< Those that cannot have one.
};

/// The same request makes the same bytes. It is an error if the picture cannot become a shader, as
/// export_picture_shader() says, if the scene is too large, and of Kind::environment if this build
/// has no viewer. A stop is an error of Kind::interrupted.
[[nodiscard]] Result<Page> make_page(const PageRequest& request, const app::Observer& observer = {},
                                     const std::stop_token& stop = {});

}  // namespace balcony::page

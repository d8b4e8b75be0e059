// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>

#include <fmt/format.h>

#include "app/words.hpp"
#include "balcony/display_file.hpp"
#include "balcony/lang.hpp"
#include "balcony/output_file.hpp"
#include "balcony/studies.hpp"

namespace balcony::app {

namespace {

namespace fs = std::filesystem;

enum class Format : std::uint8_t { svg, picture, glb };

std::optional<Format> format_of(const fs::path& file) {
    const std::string ending = ending_of(file);
    return ending == ".svg"                          ? std::optional(Format::svg)
           : ending == ".glb"                        ? std::optional(Format::glb)
           : render::display_format(file) != nullptr ? std::optional(Format::picture)
                                                     : std::nullopt;
}

Diagnostics check_drawing(const DrawRequest& request) {
    constexpr std::size_t minimum = 16;
    constexpr std::size_t maximum = 16384;
    const auto [width, height] = std::pair(request.view.width, request.view.height);
    if (std::min(width, height) < minimum || std::max(width, height) > maximum) {
        return {error(Kind::usage,
                      fmt::format("a drawing cannot have {} x {} pixels", width, height),
                      fmt::format("give a size such as 960x720; a side has {} to {} pixels",
                                  minimum, maximum))};
    }
    if (!format_of(request.output)) {
        return {error(Kind::usage,
                      fmt::format("the file extension of '{}' is not a drawing format",
                                  request.output.string()),
                      "use a file name that ends in .svg, .png, .jpg, .webp, .tif or .glb")};
    }
    return OutputFile::check(request.output);
}

Diagnostics write_model(const camera::Picture& picture, const DrawRequest& request,
                        const std::stop_token& stop) {
    const auto scene = analyse::model(picture, request.depiction, {}, stop);
    Diagnostics found = scene.diagnostics;
    if (scene) {
        add(found, write_whole(request.output, scene::to_glb(*scene)));
    }
    return found;
}

Diagnostics write_drawing(const camera::Picture& picture, const DrawRequest& request,
                          const std::stop_token& stop) {
    const auto drawing = analyse::draw(picture, request.depiction, request.view, {}, stop);
    if (!drawing) {
        return drawing.diagnostics;
    }
    Diagnostics found = drawing.diagnostics;
    if (format_of(request.output) == Format::svg) {
        add(found, write_whole(request.output, analyse::to_svg(*drawing)));
    } else if (const auto image = analyse::rasterise(*drawing, {}, stop)) {
        add(found, render::write_samples(image->samples, {image->width, image->height, 3},
                                         request.output));
    } else {
        add(found, image.diagnostics);
    }
    return found;
}

}  // namespace

Diagnostics draw(const DrawRequest& request, const std::stop_token& stop) {
    Diagnostics found = check_drawing(request);
    if (has_errors(found)) {
        return found;
    }
    lang::Workspace workspace;
    workspace.stop_with(stop);
    const auto picture = load_picture(request.camera, request.set, workspace);
    add(found, picture.diagnostics);
    add(found, check_overwrites(request.output, workspace.files()));
    if (!has_errors(found)) {
        add(found, format_of(request.output) == Format::glb
                       ? write_model(*picture, request, stop)
                       : write_drawing(*picture, request, stop));
    }
    return found;
}

}  // namespace balcony::app

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "app/animation/animation_film.hpp"
#include "app/animation/film_file.hpp"
#include "app/animation/frame_record.hpp"
#include "app/words.hpp"
#include "balcony/display_file.hpp"
#include "balcony/lang.hpp"
#include "balcony/output_file.hpp"
#include "balcony/studies.hpp"
#include "base/precondition.hpp"

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
    return {};
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

Diagnostics write(const camera::Picture& picture, const DrawRequest& request,
                  const std::stop_token& stop) {
    return format_of(request.output) == Format::glb ? write_model(picture, request, stop)
                                                    : write_drawing(picture, request, stop);
}

// The folder of a film's frames is made.
Diagnostics prepare_film(const FilmRequest& film, const FramePattern& pattern) {
    Diagnostics found = check_film(film);
    if (has_errors(found)) {
        return found;
    }
    std::error_code failed;
    if (fs::exists(record_file(pattern), failed)) {
        return {error(Kind::input,
                      fmt::format("the frames of an animation that is not finished are in '{}'",
                                  pattern.folder().string()),
                      "finish or remove it, or name another output")};
    }
    return make_film_folder(film);
}

// The warnings of one frame stand for those of all.
Diagnostics write_frames(const camera::Picture& picture, const DrawFilmRequest& request,
                         const Observer& observer, const std::stop_token& stop) {
    const auto time_of_frame = [&](std::size_t frame) {
        return time_of(frame, request.drawing.depiction.time, request.rate);
    };
    DrawRequest drawing = request.drawing;
    if (!drawing.depiction.film) {
        drawing.depiction.film = {time_of_frame(request.frames.front()),
                                  time_of_frame(request.frames.back())};
    }
    Diagnostics found;
    std::set<std::string> told;
    for (std::size_t i = 0; i < request.frames.size() && !has_errors(found); ++i) {
        if (observer.frame) {
            observer.frame(request.frames[i], i, request.frames.size());
        }
        drawing.depiction.time = time_of_frame(request.frames[i]);
        drawing.output = request.output.pattern.file(request.frames[i]);
        for (const Diagnostic& one : write(picture, drawing, stop)) {
            if (told.insert(one.message).second) {
                found.push_back(one);
            }
        }
    }
    return found;
}

}  // namespace

Diagnostics draw(const DrawRequest& request, const std::stop_token& stop) {
    Diagnostics found = check_drawing(request);
    if (has_errors(found) || add(found, OutputFile::check(request.output))) {
        return found;
    }
    lang::Workspace workspace;
    workspace.stop_with(stop);
    const auto picture = load_picture(request.camera, request.set, workspace);
    add(found, picture.diagnostics);
    add(found, check_overwrites(request.output, workspace.files()));
    if (!has_errors(found)) {
        add(found, write(*picture, request, stop));
    }
    return found;
}

Diagnostics draw_film(const DrawFilmRequest& request, const Observer& observer,
                      const std::stop_token& stop) {
    precondition(!request.frames.empty(), "a film has frames");
    DrawRequest first = request.drawing;
    first.output = request.output.pattern.file(request.frames.front());
    std::optional<FilmRequest> film = request.output.film;
    Diagnostics found = check_drawing(first);
    if (has_errors(found) || (!film && add(found, OutputFile::check(first.output)))) {
        return found;
    }
    lang::Workspace workspace;
    workspace.stop_with(stop);
    const auto picture = load_picture(first.camera, first.set, workspace);
    add(found, picture.diagnostics);
    add(found, check_inputs(request.output.pattern, workspace.files()));
    if (has_errors(found)) {
        return found;
    }
    if (film) {
        film->rate = request.rate;
        if (add(found, prepare_film(*film, request.output.pattern))) {
            return found;
        }
    }
    bool is_whole = !add(found, write_frames(*picture, request, observer, stop));
    if (film && is_whole) {
        is_whole = !add(found, make_film_of_frames(*film, request.output.pattern, request.frames,
                                                   true, observer, stop));
    }
    if (film && !is_whole && kind_of_errors(found) != Kind::environment) {
        remove_frame_files(request.output.pattern);
    }
    return found;
}

}  // namespace balcony::app

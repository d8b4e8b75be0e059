// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/animation/animate.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "app/animation/animation_film.hpp"
#include "app/animation/film_file.hpp"
#include "app/animation/frame_loop.hpp"
#include "app/animation/turntable.hpp"
#include "app/picture/finished_picture.hpp"
#include "app/picture/paused_run.hpp"
#include "app/request_check.hpp"
#include "app/words.hpp"
#include "balcony/animation.hpp"
#include "balcony/inputs.hpp"
#include "balcony/motion.hpp"
#include "balcony/names.hpp"

namespace balcony::app {

namespace {

namespace fs = std::filesystem;

// As long as the longest of the scene's animations, or five seconds of a turntable.
Result<FrameNumbers> default_frames(const scene::Scene& scene, const AnimationRequest& request) {
    constexpr double turntable_seconds = 5.0;
    constexpr double rounding = 1e-6;
    const double frame_time = request.picture.shutter.rate.frame_time();
    double frames =
        request.duration ? std::max(std::round(*request.duration / frame_time), 1.0) : 0.0;
    if (scene.motion && frames == 0.0) {
        for (const scene::Animation& animation : scene.motion->animations) {
            frames = std::max(frames, std::floor(animation.duration / frame_time + rounding) + 1.0);
        }
    }
    if (frames == 0.0 && request.turntable) {
        frames = std::max(std::round(turntable_seconds / frame_time), 1.0);
    }
    if (frames == 0.0) {
        return error(Kind::usage,
                     "nothing tells how many frames there are, since the scene has no animation",
                     "add --frames 1-240");
    }
    FrameNumbers numbers(
        static_cast<std::size_t>(std::min(frames, static_cast<double>(max_frame))));
    std::iota(numbers.begin(), numbers.end(), 1);
    return numbers;
}

Diagnostics check_shards(const AnimationRequest& request, const FrameNumbers& frames) {
    if (!request.shard || request.shard->count <= frames.size() * request.parts_per_frame) {
        return {};
    }
    const std::size_t shards = request.shard->count;
    const std::string units =
        request.parts_per_frame == 1
            ? counted(frames.size(), "frame")
            : counted(frames.size() * request.parts_per_frame, "part") + " of frames";
    return {error(Kind::usage, fmt::format("there are {} shards, but only {}", shards, units),
                  fmt::format("use at most as many shards as frames, or divide each frame: "
                              "--parts-per-frame {}",
                              (shards + frames.size() - 1) / frames.size()))};
}

// The film's pixels are in pairs, so a chosen size becomes even.
render::FilmLayout layout_of(const AnimationRequest& animation, const camera::Picture& picture,
                             Diagnostics& found) {
    const bool displayed = render::display_format(animation.pattern.file(1)) != nullptr;
    const Request& request = animation.picture;
    render::FilmLayout layout = film_layout(request, picture, displayed);
    if (!animation.film || !has_even_sides(animation.film->file)) {
        return layout;
    }
    if (!request.size.width && !request.size.height && !layout.window) {
        const auto even = [](std::size_t side) { return std::max<std::size_t>(side / 2 * 2, 2); };
        layout.width = even(layout.width);
        layout.height = even(layout.height);
    }
    const render::Region shown =
        layout.window.value_or(render::Region{0, 0, layout.width, layout.height});
    if (shown.width % 2 != 0 || shown.height % 2 != 0) {
        found.push_back(warning(fmt::format("the film has sides of an even number of pixels: {} x "
                                            "{}",
                                            shown.width / 2 * 2, shown.height / 2 * 2),
                                {}, "choose even sides with --size"));
    }
    return layout;
}

// Numbers that are longer than their place no longer sort by name.
void warn_of_long_numbers(const FramePattern& pattern, const FrameNumbers& frames,
                          Diagnostics& found) {
    const std::size_t digits = fmt::format("{}", frames.back()).size();
    if (pattern.digits() > 1 && digits > pattern.digits()) {
        found.push_back(warning(fmt::format("frame {} has more digits than '{}', so the names of "
                                            "the files do not sort by frame",
                                            frames.back(), pattern.text()),
                                {}, fmt::format("write {}", std::string(digits, '#'))));
    }
}

// The picture of a turntable. Without a camera, it shows the whole scene, or object, from all
// sides.
std::optional<camera::Picture> turned_round(const AnimationRequest& animation,
                                            const FrameNumbers& frames, const Loaded& loaded,
                                            camera::Picture picture, const std::stop_token& stop,
                                            Diagnostics& found) {
    const Request& request = animation.picture;
    const Result<render::SceneExtent> extent =
        render::measure_scene(*loaded.renderer, animation.around, stop);
    if (add(found, extent.diagnostics)) {
        return std::nullopt;
    }
    if (request.camera.empty()) {
        const auto [width, height] = request.size.resolve(camera::default_aspect);
        const Result<camera::Picture> whole = turntable_picture(
            *loaded.scene, *extent, static_cast<double>(width) / static_cast<double>(height));
        if (add(found, whole.diagnostics)) {
            return std::nullopt;
        }
        picture = whole->with_fit(request.size.fit);
    }
    return picture.with_turn(turn_of(*extent, animation, frames));
}

Diagnostics check_stereo(const Request& request, const scene::Scene& scene) {
    return request.stereo.is_wanted() && has_moving_camera(request, scene)
               ? Diagnostics{error(Kind::usage,
                                   "--stereo cannot follow a camera of the scene that moves",
                                   "name a camera of a file with --camera")}
               : Diagnostics{};
}

// Everything before the first frame.
struct Prepared {
    camera::Picture picture;
    FrameNumbers frames;
    render::FilmLayout layout;
};

std::optional<Prepared> prepare(const AnimationRequest& animation, Loaded& loaded,
                                std::optional<camera::Picture> picture, const std::stop_token& stop,
                                Diagnostics& found) {
    const Request& request = animation.picture;
    add(found, check_inputs(animation.pattern, loaded.files()));
    Result<FrameNumbers> frames = animation.frames ? Result<FrameNumbers>(*animation.frames)
                                                   : default_frames(*loaded.scene, animation);
    add(found, frames.diagnostics);
    if (has_errors(found) || add(found, check_shards(animation, *frames))) {
        return std::nullopt;
    }
    warn_of_long_numbers(animation.pattern, *frames, found);
    if (animation.turntable) {
        picture = turned_round(animation, *frames, loaded, *picture, stop, found);
    }
    if (!picture || add(found, check_stereo(request, *loaded.scene))) {
        return std::nullopt;
    }
    Result<camera::Picture> view = stereo_view(request, *picture);
    if (add(found, view.diagnostics)) {
        return std::nullopt;
    }
    Prepared made{std::move(*view), std::move(*frames), {}};
    made.layout = layout_of(animation, made.picture, found);
    if (is_large(made.layout, request)) {
        found.push_back(too_large("a frame"));
    }
    return has_errors(found) ? std::nullopt : std::optional(std::move(made));
}

void load_and_render(const AnimationRequest& request, const Observer& observer,
                     const std::stop_token& stop, AnimationReport& report) {
    AnimationRequest animation = request;
    animation.picture.settings.time = animation.time_of(1);
    Loaded loaded;
    loaded.since = FileWatch::Time::clock::now();
    Diagnostics& found = report.diagnostics;
    if (!add(found, check_frames(animation)) && !add(found, check_request(animation.picture)) &&
        load_settings(animation.picture, loaded, stop, found)) {
        if (auto picture = load_all(animation.picture, loaded, observer, stop, found)) {
            render_frames(animation, loaded, std::move(*picture), observer, stop, report);
        }
    }
    report.interrupted |= kind_of_errors(found) == Kind::interrupted;
}

void make_film(const AnimationRequest& animation, const FrameNumbers& frames,
               const Observer& observer, const std::stop_token& stop, AnimationReport& report) {
    const Diagnostics found = make_film_of_frames(*animation.film, animation.pattern, frames,
                                                  !animation.keep_frames, observer, stop);
    report.is_film_missing = kind_of_errors(found) == Kind::interrupted;
    report.interrupted |= report.is_film_missing;
    if (!report.is_film_missing && !add(report.diagnostics, found)) {
        report.film = animation.film->file;
    }
}

}  // namespace

Diagnostics check_output(const AnimationRequest& request) {
    return request.film ? check_film(*request.film) : check_output(request.pattern.file(1));
}

Diagnostics prepare_output(const AnimationRequest& request) {
    Diagnostics found = check_output(request);
    return has_errors(found) || !request.film ? found : make_film_folder(*request.film);
}

AnimationReport animate(const AnimationRequest& request, const Observer& observer,
                        const std::stop_token& stop) {
    AnimationReport report;
    within_memory(report.diagnostics, [&] { load_and_render(request, observer, stop, report); });
    return report;
}

void render_frames(const AnimationRequest& animation, Loaded& loaded, camera::Picture picture,
                   const Observer& observer, const std::stop_token& stop, AnimationReport& report) {
    const std::optional<Prepared> made =
        prepare(animation, loaded, std::move(picture), stop, report.diagnostics);
    if (!made) {
        return;
    }
    FrameLoop(animation, loaded, made->picture, made->layout, observer, report)
        .run(made->frames, stop);
    const bool is_whole = !animation.shard && animation.parts_per_frame == 1;
    if (animation.film && is_whole && !has_errors(report.diagnostics) && !report.interrupted) {
        make_film(animation, made->frames, observer, stop, report);
    }
}

void end_film(const AnimationRequest& animation, const Observer& observer,
              AnimationReport& report) {
    FrameNumbers frames;
    for (const FrameReport& one : report.rendered) {
        frames.push_back(one.frame);
    }
    if (!frames.empty()) {
        make_film(animation, frames, observer, {}, report);
    } else {
        remove_frame_files(animation.pattern);
    }
}

}  // namespace balcony::app

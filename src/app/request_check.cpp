// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/request_check.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "app/inputs/placement.hpp"
#include "app/words.hpp"
#include "balcony/app.hpp"
#include "balcony/inputs.hpp"
#include "balcony/picture_options.hpp"

namespace balcony::app {

namespace {

bool is_positive(double value) { return value > 0.0; }
bool is_finite(double value) { return std::isfinite(value); }
bool is_factor(float value) {
    return 0.0F <= value && value <= static_cast<float>(scene::max_quantity);
}
bool is_length(double value) { return is_positive(value) && is_finite(value); }
bool is_frame(std::size_t number) { return number <= max_frame; }
bool is_side(std::size_t pixels) { return 1 <= pixels && pixels <= max_side; }
bool is_shard(const render::Shard& shard) {
    return shard.index < shard.count && shard.count <= render::max_shards;
}
bool is_rate(const FrameRate& rate) {
    return is_positive(rate.frames) && is_positive(rate.seconds) && is_finite(rate.frame_time());
}
bool is_scale(double scale) { return is_positive(scale) && scale <= double{max_side}; }
bool are_corners(const std::array<double, 4>& corners) {
    return std::all_of(corners.begin(), corners.end(),
                       [](double corner) { return 0.0 <= corner && corner <= double{max_side}; });
}

template <class T, class Holds>
bool holds_if_any(const std::optional<T>& value, const Holds& holds) {
    return !value || holds(*value);
}

// Members, and whether their values are in range.
using Ranges = std::initializer_list<std::pair<std::string_view, bool>>;

Diagnostics broken(const Ranges& ranges) {
    Diagnostics found;
    for (const auto& [member, holds] : ranges) {
        if (!holds) {
            found.push_back(error(Kind::internal, fmt::format("{} is out of range", member)));
        }
    }
    return found;
}

Diagnostics out_of_range(const Request& request) {
    const JobRequest& job = request.job;
    const LightRequest& light = request.light;
    Diagnostics found = check_size(request.size);
    add(found, check_unit(request.meters_per_unit));
    const Diagnostics more =
        broken({{"Request::crop.scale", is_scale(request.crop.scale)},
                {"Request::crop.corners", holds_if_any(request.crop.corners, are_corners)},
                {"Request::mm_per_pixel", holds_if_any(request.mm_per_pixel, is_length)},
                {"Request::samples", request.samples != 0U},
                {"Request::settings.time", is_finite(request.settings.time)},
                {"Request::light.rotation", is_finite(light.rotation)},
                {"Request::light.strength", is_finite(light.strength) && light.strength >= 0.0F},
                {"Request::light.emission_scale", holds_if_any(light.emission_scale, is_factor)},
                {"Request::shutter.duration",
                 is_finite(request.shutter.duration) && request.shutter.duration >= 0.0},
                {"Request::shutter.rate", is_rate(request.shutter.rate)},
                {"Request::stereo.formats", request.stereo.formats.size() <= 2},
                {"Request::dpi", holds_if_any(request.dpi, is_positive)},
                {"Request::exposure", holds_if_any(request.exposure, is_finite)},
                {"Request::job.time_limit", holds_if_any(job.time_limit, is_positive)},
                {"Request::job.save_every", holds_if_any(job.save_every, is_positive)},
                {"Request::job.checkpoint_every", holds_if_any(job.checkpoint_every, is_positive)},
                {"Request::job.film_memory", holds_if_any(job.film_memory, is_positive)},
                {"Request::job.shard", holds_if_any(job.shard, is_shard)}});
    found.insert(found.end(), more.begin(), more.end());
    return found;
}

}  // namespace

Diagnostics check_size(const SizeRequest& size) {
    return broken({{"SizeRequest::width", holds_if_any(size.width, is_side)},
                   {"SizeRequest::height", holds_if_any(size.height, is_side)}});
}

Diagnostics check_unit(const std::optional<double>& meters_per_unit) {
    return broken({{"the length of a unit", holds_if_any(meters_per_unit, is_length)}});
}

Diagnostics check_request(const Request& request) {
    Diagnostics found = out_of_range(request);
    if (!found.empty()) {
        return found;
    }
    if (request.camera.empty() && !request.set.empty()) {
        found.push_back(error(Kind::usage, "--set needs a camera whose parameter it sets",
                              "add --camera FILE"));
    }
    if (!request.solve.empty() && (request.camera.empty() || is_of_scene(request.camera))) {
        found.push_back(error(Kind::usage,
                              "--solve needs a camera of a file, whose parameters it finds",
                              "add --camera FILE or the name of a built-in camera"));
    } else if (!request.solve.empty() && request.placement.is_demanded()) {
        found.push_back(error(Kind::usage,
                              "--solve and a camera that the scene places exclude "
                              "each other",
                              "leave out --fit, --fit-to and --from, or --solve"));
    }
    if (request.placement.is_demanded() &&
        (request.camera.empty() || is_of_scene(request.camera))) {
        found.push_back(error(Kind::usage,
                              fmt::format("{} needs a camera of a file, which it places",
                                          request.placement.from              ? "--from"
                                          : !request.placement.fit_to.empty() ? "--fit-to"
                                                                              : "--fit"),
                              "add --camera FILE or the name of a built-in camera"));
    }
    if (request.mm_per_pixel && (request.size.width || request.size.height)) {
        found.push_back(error(Kind::usage, "--mm-per-pixel and a size in pixels exclude each other",
                              "leave out one of them"));
    }
    add(found, check_placement(request.placement, true));
    add(found, check_dpi(request.dpi, request.output));
    return found;
}

Diagnostics check_frames(const AnimationRequest& request) {
    const auto are_frames = [](const FrameNumbers& frames) {
        return !frames.empty() && std::all_of(frames.begin(), frames.end(), is_frame) &&
               std::adjacent_find(frames.begin(), frames.end(), std::greater_equal<>()) ==
                   frames.end();
    };
    const std::size_t parts = request.parts_per_frame;
    return broken({{"AnimationRequest::frames", holds_if_any(request.frames, are_frames)},
                   {"AnimationRequest::start_time", is_finite(request.start_time)},
                   {"AnimationRequest::shard", holds_if_any(request.shard, is_shard)},
                   {"AnimationRequest::parts_per_frame", 1 <= parts && parts <= render::max_shards},
                   {"AnimationRequest::film.rate", !request.film || is_rate(request.film->rate)}});
}

}  // namespace balcony::app

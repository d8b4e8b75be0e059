// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/picture/findings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/words.hpp"
#include "balcony/inputs.hpp"
#include "balcony/names.hpp"

namespace balcony::app {

namespace {

/// "camera 'pinhole'", or "layer 'inset'" of several.
std::string name_of(const render::Summary::Layer& layer, const render::Summary& summary) {
    return fmt::format("{} '{}'", summary.layers.size() == 1 ? "camera" : "layer",
                       printable(layer.name));
}

/// Whether a camera lacks rays only where its arrangers show nothing of it, as around the circle of
/// a dome master. It is looked at in some places.
bool is_cut_out(const camera::Camera& camera, double time) {
    if (camera.parts().arrangers.empty()) {
        return false;
    }
    constexpr std::size_t side = 96;
    expr::Graph graph;
    const camera::PicturePoint point{
        {side * camera.parts().aspect * graph.picture_x(), double{side} * graph.picture_y()},
        {graph.constant(side * camera.parts().aspect), graph.constant(side)}};
    const std::array roots{camera.emit_arranged(point), camera.emit(point).valid};
    const std::vector<double> values = expr::BatchEvaluator(roots)(
        side * side, [&](const expr::Node& leaf, std::span<double> of_leaf) {
            const std::string& name = graph.input_names()[leaf.detail];
            const auto& known = camera.parts().inputs;
            const auto input =
                std::find_if(known.begin(), known.end(),
                             [&name](const camera::KnownInput& one) { return one.name == name; });
            for (std::size_t i = 0; i < of_leaf.size(); ++i) {
                of_leaf[i] = name == "x"            ? (static_cast<double>(i % side) + 0.5) / side
                             : name == "y"          ? (static_cast<double>(i / side) + 0.5) / side
                             : input == known.end() ? time
                                                    : input->value;
            }
        });
    for (std::size_t i = 0; i < side * side; ++i) {
        if (values[i] == 1.0 && values[side * side + i] != 1.0) {
            return false;
        }
    }
    return true;
}

/// Reports where a layer has no ray.
void describe_gaps(Report& report, const Shown& film, const camera::Picture& picture, double time,
                   const render::Summary& summary) {
    std::vector<bool> cut_out(summary.layers.size(), false);
    for (const camera::ShownCamera& shown : shown_cameras(picture)) {
        for (const camera::ShownCamera::LayerUse& use : shown.uses) {
            cut_out[use.index] =
                summary.layers[use.index].invalid_rays > 0 && is_cut_out(shown.camera, time);
        }
    }
    const bool single = summary.layers.size() == 1;
    const std::string_view shown = film.has_background ? "show the background" : "are transparent";
    for (std::size_t i = 0; i < summary.layers.size(); ++i) {
        const render::Summary::Layer& layer = summary.layers[i];
        const std::string what = name_of(layer, summary);
        if (layer.invalid_rays == 0) {
            continue;
        }
        if (cut_out[i] && layer.invalid_rays < layer.camera_rays) {
            continue;
        }
        if (layer.invalid_rays == layer.camera_rays) {
            report.diagnostics.push_back(
                warning(fmt::format("{} has no ray anywhere; {}", what,
                                    single ? "the picture is empty" : "it is invisible")));
            continue;
        }
        const std::string pixels = single ? fmt::format(" ({} of {} pixel centres)",
                                                        summary.invalid_pixels, film.window.size())
                                          : "";
        report.diagnostics.push_back(
            warning(fmt::format("{} has no ray at {} of {} picture points{}; they {}", what,
                                layer.invalid_rays, layer.camera_rays, pixels, shown)));
    }
}

// Pixels whose motion is not certain.
void describe_motion(Report& report, const render::Summary& summary) {
    if (summary.unknown_motion > 0) {
        report.diagnostics.push_back(warning(fmt::format(
            "the motion of {} is 0 because neither the previous nor the next frame shows the "
            "surface there",
            counted(summary.unknown_motion, "pixel"))));
    }
    if (summary.ambiguous_motion > 0) {
        report.diagnostics.push_back(warning(fmt::format(
            "the previous or next frame shows the surface of {} at several places; the layer "
            "motion is that to the nearest",
            counted(summary.ambiguous_motion, "pixel"))));
    }
}

// Why no ray of a layer meets anything, or hardly any where others would or none starts in the
// scene.
void describe_miss(Report& report, const Loaded& loaded, const camera::ShownCamera& shown,
                   std::size_t index, std::pair<std::size_t, std::size_t> size) {
    constexpr double many = 10.0;  // So many times as many rays are worth a word.
    const render::Summary& summary = report.summary;
    const render::Summary::Layer& layer = summary.layers[index];
    const double share = static_cast<double>(layer.hits) / static_cast<double>(layer.traced_rays());
    Result<render::Miss> miss = render::explain_miss(
        *loaded.renderer, shown.camera,
        {.width = size.first, .height = size.second, .time = loaded.settings.time});
    if (miss) {
        std::erase_if(miss->attempts,
                      [&](const auto& attempt) { return attempt.share < many * share; });
    }
    if (layer.hits > 0 && (!miss || (miss->attempts.empty() && !starts_outside(*miss)))) {
        return;
    }
    const MissText text = miss ? miss_text(*miss, shown.camera) : MissText{};
    report.diagnostics.push_back(warning(
        fmt::format(
            "{} of {} meet{} anything{}{}",
            layer.hits == 0 ? "no ray" : fmt::format("only {:.2g} % of the rays", 100.0 * share),
            name_of(layer, summary), layer.hits == 0 ? "s" : "", text.reason.empty() ? "" : ": ",
            text.reason),
        {}, text.remedy));
}

render::ProbeSettings coarse_probe(std::pair<std::size_t, std::size_t> size, double rays,
                                   double time) {
    const double step = std::sqrt(static_cast<double>(size.first * size.second) / rays);
    return {.width = size.first,
            .height = size.second,
            .step = static_cast<std::size_t>(std::max(1.0, step)),
            .searches = false,
            .time = time};
}

// Warns of objects that the rays of a camera start in, found by a coarse look.
Diagnostics warn_of_starts(const std::string& camera, const render::Probe& probe,
                           const scene::Scene& scene, bool passes) {
    std::vector<std::string> texts;
    for (const StartInside& start : starts_inside(probe, scene)) {
        if (!start.is_room) {
            texts.push_back(
                fmt::format("{:.3g} % in '{}'", 100.0 * start.share, printable(start.object)));
        }
    }
    if (texts.empty()) {
        return {};
    }
    return {warning(
        fmt::format("rays of {} start in closed objects and {}: {}", camera,
                    passes ? "pass through them" : "show them from inside", fmt::join(texts, ", ")),
        {},
        passes ? ""
               : "let rays pass with --inside pass, move the camera with --set, or "
                 "make its eye object smaller")};
}

}  // namespace

void describe(Report& report, const Loaded& loaded, const camera::Picture& picture,
              const Shown& shown, const render::Summary& summary) {
    describe_gaps(report, shown, picture, loaded.settings.time, summary);
    if (summary.repaired > 0) {
        report.diagnostics.push_back(warning(fmt::format(
            "{} samples had no finite colour and were replaced by black", summary.repaired)));
    }
    describe_motion(report, summary);
    report.is_traced = true;
    report.camera = picture.name();
    report.width = shown.window.width;
    report.height = shown.window.height;
    report.summary = summary;
    report.interrupted = summary.interrupted;
    report.load_seconds = loaded.load_seconds;
    report.emission_scale = loaded.scene->emission_scale;
    report.preparation = loaded.renderer->preparation();
    report.fitted = loaded.cameras.fitted();
}

// A layer of some objects may show little.
void describe_objects(Report& report, const render::Summary::Layer& layer) {
    if (layer.hits == 0) {
        report.diagnostics.push_back(
            warning(fmt::format("no ray of {} meets the objects that it shows",
                                name_of(layer, report.summary)),
                    {}, "'balcony locate' finds where a camera shows a point of the scene"));
    }
}

void describe_sight(Report& report, const Loaded& loaded, const camera::Picture& picture,
                    std::pair<std::size_t, std::size_t> size, const std::stop_token& stop) {
    constexpr double few = 0.02;  // The share of rays that meet something, if hardly any does.
    render::ProbeSettings settings = coarse_probe(size, 64.0 * 64.0, loaded.settings.time);
    for (const camera::ShownCamera& shown : shown_cameras(picture)) {
        for (const camera::ShownCamera::LayerUse& use : shown.uses) {
            settings.objects = use.objects;
            const Result<render::Probe> probe =
                render::probe(*loaded.renderer, shown.camera, settings, {}, stop);
            const render::Summary::Layer& layer = report.summary.layers[use.index];
            if (layer.traced_rays() == 0) {
                continue;
            }
            if (!use.objects.empty()) {
                describe_objects(report, layer);
            } else if (static_cast<double>(layer.hits) <
                       few * static_cast<double>(layer.traced_rays())) {
                describe_miss(report, loaded, shown, use.index, size);
            }
            if (probe) {
                add(report.diagnostics,
                    warn_of_starts(name_of(layer, report.summary), *probe, *loaded.scene,
                                   !loaded.settings.passed_objects.empty()));
            }
        }
    }
}

Diagnostics pass_starts(InsideRule rule, const camera::Picture& picture,
                        std::pair<std::size_t, std::size_t> size, Loaded& loaded,
                        const std::stop_token& stop) {
    std::vector<std::uint32_t>& passed = loaded.settings.passed_objects;
    passed.clear();
    if (rule != InsideRule::pass) {
        return {};
    }
    render::ProbeSettings settings = coarse_probe(size, 256.0 * 256.0, loaded.settings.time);
    for (const camera::ShownCamera& shown : shown_cameras(picture)) {
        for (const camera::ShownCamera::LayerUse& use : shown.uses) {
            settings.objects = use.objects;
            const Result<render::Probe> probe =
                render::probe(*loaded.renderer, shown.camera, settings, {}, stop);
            if (!probe) {
                return probe.diagnostics;
            }
            for (const StartInside& start : starts_inside(*probe, *loaded.scene)) {
                if (!start.is_room) {
                    passed.push_back(start.index);
                }
            }
        }
    }
    return {};
}

std::optional<SampleRange> sample_range(const render::Film& film) {
    if (film.pixel_passes.empty()) {
        return std::nullopt;
    }
    SampleRange range{.fewest = std::numeric_limits<std::uint32_t>::max()};
    double total = 0.0;
    for (const std::uint32_t count : film.pixel_passes) {
        range.fewest = std::min(range.fewest, count);
        range.most = std::max(range.most, count);
        total += count;
    }
    range.mean = total / static_cast<double>(film.window.size());
    return range;
}

Diagnostics warn_of_lost_alpha(const render::Film& film, const Finish& finish) {
    const render::DisplayFormat* const format = finish.display_format();
    if (format == nullptr || format->has_alpha || film.background) {
        return {};
    }
    const render::Region& window = film.window;
    for (std::size_t y = window.y; y < window.y + window.height; ++y) {
        for (std::size_t x = window.x; x < window.x + window.width; ++x) {
            // Rounding to a byte hides less than this.
            if (film.pixel(x, y).a < 1.0F - 0.5F / 255.0F) {
                return {warning(
                    fmt::format("a {} file has no transparency; transparent places are black",
                                format->extension),
                    {}, "choose a colour with --background, or write a .png file")};
            }
        }
    }
    return {};
}

}  // namespace balcony::app

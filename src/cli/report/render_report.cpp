// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/report/render_report.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "balcony/probe.hpp"
#include "cli/report/json.hpp"
#include "cli/report/miss_text.hpp"
#include "cli/report/peak_memory.hpp"
#include "cli/report/report.hpp"

namespace balcony::cli {

namespace {

/// Reports where a layer has no ray.
void describe_gaps(RenderReport& report, const render::Film& film, const render::Summary& summary) {
    const bool single = summary.layers.size() == 1;
    const std::string_view shown = film.background ? "show the background" : "are transparent";
    for (const render::Summary::Layer& layer : summary.layers) {
        const std::string what =
            fmt::format("{} '{}'", single ? "camera" : "layer", printable(layer.name));
        if (layer.invalid_rays == 0) {
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
void describe_motion(RenderReport& report, const render::Summary& summary) {
    if (summary.unknown_motion > 0) {
        report.diagnostics.push_back(warning(fmt::format(
            "the motion of {} is 0 because neither the previous nor the next frame shows the "
            "surface there",
            counted(summary.unknown_motion, "pixel", "pixels"))));
    }
    if (summary.ambiguous_motion > 0) {
        report.diagnostics.push_back(warning(fmt::format(
            "the previous or next frame shows the surface of {} at several places; the layer "
            "motion is that to the nearest",
            counted(summary.ambiguous_motion, "pixel", "pixels"))));
    }
}

nlohmann::json layers_json(const render::Summary& summary) {
    nlohmann::json layers = nlohmann::json::array();
    for (const render::Summary::Layer& layer : summary.layers) {
        layers.push_back({{"name", layer.name},
                          {"rays", layer.camera_rays},
                          {"invalid_rays", layer.invalid_rays},
                          {"hits", layer.hits}});
    }
    return layers;
}

// The numbers of samples of adaptive sampling: the fewest, the most, and the mean.
struct SampleRange {
    std::uint32_t fewest = std::numeric_limits<std::uint32_t>::max();
    std::uint32_t most = 0;
    double mean = 0.0;
};

SampleRange sample_range(const render::Film& film) {
    SampleRange range;
    double total = 0.0;
    for (const std::uint32_t count : film.pixel_passes) {
        range.fewest = std::min(range.fewest, count);
        range.most = std::max(range.most, count);
        total += count;
    }
    range.mean = total / static_cast<double>(film.window.size());
    return range;
}

// One line per layer of a picture with several layers.
std::string layers_text(const render::Summary& summary) {
    std::string text;
    for (const render::Summary::Layer& layer : summary.layers) {
        text += fmt::format("  layer {:<20} {} rays\n", printable(layer.name),
                            count_text(static_cast<double>(layer.camera_rays)));
    }
    return summary.layers.size() > 1 ? text : "";
}

}  // namespace

void add(RenderReport& report, const Diagnostics& diagnostics) {
    report.diagnostics.insert(report.diagnostics.end(), diagnostics.begin(), diagnostics.end());
}

RenderReport failed(RenderReport report, ExitCode code, const Diagnostics& diagnostics) {
    add(report, diagnostics);
    report.code = code;
    return report;
}

void describe(RenderReport& report, const PictureOutput& output, const camera::Picture& picture,
              const render::Film& film, const render::Summary& summary) {
    describe_gaps(report, film, summary);
    if (summary.repaired > 0) {
        report.diagnostics.push_back(warning(fmt::format(
            "{} samples had no finite colour and were replaced by black", summary.repaired)));
    }
    describe_motion(report, summary);
    report.facts = {{"output", nullptr},
                    {"camera", picture.name()},
                    {"layers", layers_json(summary)},
                    {"width", film.window.width},
                    {"height", film.window.height},
                    {"passes", summary.passes},
                    {"rays", summary.camera_rays},
                    {"invalid_rays", summary.invalid_rays},
                    {"invalid_pixels", summary.invalid_pixels},
                    {"repaired", summary.repaired},
                    {"seconds", summary.seconds},
                    {"compile_seconds", summary.compile_seconds},
                    {"camera_share", summary.camera_share},
                    {"ambient", summary.ambient.x},
                    {"light", summary.light},
                    {"peak_memory", peak_memory()},
                    {"interrupted", summary.interrupted}};
    report.sentence =
        fmt::format("{}{}: {} x {} pixels through '{}', {}, {} rays in {}, {:.0f} MiB\n",
                    summary.interrupted ? "interrupted; the partial picture is " : "",
                    printable(output.name()), film.window.width, film.window.height, picture.name(),
                    counted(summary.passes, "pass", "passes"),
                    count_text(static_cast<double>(summary.camera_rays)),
                    duration_text(summary.seconds), static_cast<double>(peak_memory()) / 0x1p20);
    if (!summary.light.empty()) {
        report.sentence += fmt::format("  lit by {}\n", printable(summary.light));
    }
    if (!film.pixel_passes.empty()) {
        const SampleRange range = sample_range(film);
        report.facts["mean_samples"] = range.mean;
        report.sentence += fmt::format("  {} to {} samples per pixel, on average {:.1f}\n",
                                       range.fewest, range.most, range.mean);
    }
    report.sentence += layers_text(summary);
}

void describe_misses(RenderReport& report, const scene::Scene& scene,
                     const camera::Picture& picture, const render::Settings& settings,
                     const render::Film& film, const render::Summary& summary) {
    for (const camera::ShownCamera& shown : shown_cameras(picture)) {
        for (const camera::ShownCamera::LayerUse& use : shown.uses) {
            const render::Summary::Layer& layer = summary.layers[use.index];
            if (layer.hits > 0 || layer.camera_rays == layer.invalid_rays) {
                continue;
            }
            const Result<render::Miss> miss = render::explain_miss(
                scene, shown.camera,
                {.width = film.width, .height = film.height, .time = settings.time});
            const MissText text = miss ? miss_text(*miss, shown.camera) : MissText{};
            report.diagnostics.push_back(warning(
                fmt::format("no ray of {} '{}' meets anything{}{}",
                            summary.layers.size() == 1 ? "camera" : "layer", printable(layer.name),
                            text.reason.empty() ? "" : ": ", text.reason),
                {}, text.remedy));
        }
    }
}

void warn_of_lost_alpha(RenderReport& report, const render::Film& film,
                        const PictureOutput& output) {
    const render::DisplayFormat* const format = output.display_format();
    if (format == nullptr || format->has_alpha || film.background) {
        return;
    }
    const render::Region& window = film.window;
    for (std::size_t y = window.y; y < window.y + window.height; ++y) {
        for (std::size_t x = window.x; x < window.x + window.width; ++x) {
            // Rounding to a byte hides less than this.
            if (film.pixel(x, y).a < 1.0F - 0.5F / 255.0F) {
                report.diagnostics.push_back(warning(
                    fmt::format("a {} file has no transparency; transparent places are black",
                                format->extension),
                    {}, "choose a colour with --background, or write a .png file"));
                return;
            }
        }
    }
}

nlohmann::json json_of(const RenderReport& report) {
    nlohmann::json facts = report.facts;
    facts["diagnostics"] = to_json(report.diagnostics);
    return facts;
}

}  // namespace balcony::cli

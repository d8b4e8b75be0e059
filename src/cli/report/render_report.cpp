// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/report/render_report.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "balcony/names.hpp"
#include "base/memory.hpp"

namespace balcony::cli {

namespace {

// A part as JSON has it.
double rounded(double part) { return std::round(1e4 * part) / 1e4; }

nlohmann::json layers_json(const render::Summary& summary) {
    nlohmann::json layers = nlohmann::json::array();
    for (const render::Summary::Layer& layer : summary.layers) {
        layers.push_back({{"name", layer.name},
                          {"rays", layer.camera_rays},
                          {"invalid_rays", layer.invalid_rays},
                          {"blocked_rays", layer.blocked_rays},
                          {"hits", layer.hits},
                          {"softened_light", rounded(layer.softened_share())},
                          {"left_out", rounded(layer.share_left_out())},
                          {"cut_off", rounded(layer.share_cut_off())}});
    }
    return layers;
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

// What is blurred or left out, where it is noticeable.
std::string lost_light_text(const render::Summary& summary, const render::BounceLimits& limits) {
    constexpr double noticeable = 0.005;
    constexpr double noticeable_estimate = 0.01;
    constexpr std::size_t most = render::BounceLimits::most;
    render::RayCounts all;
    for (const render::Summary::Layer& layer : summary.layers) {
        all.add(layer);
    }
    std::string text;
    if (all.softened_share() >= noticeable) {
        text += fmt::format(
            "  {:.1f} % of the light is from mirrors and glass that are softened against specks; "
            "--exact keeps them sharp\n",
            100.0 * all.softened_share());
    }
    if (all.share_left_out() >= noticeable) {
        text += fmt::format(
            "  {:.1f} % of the light is left out against specks; --exact without --clamp keeps "
            "it\n",
            100.0 * all.share_left_out());
    }
    if (all.share_cut_off() > noticeable_estimate) {
        text += fmt::format(
            "  about {:.1f} % of the light is cut off by limits of bounces; {}\n",
            100.0 * all.share_cut_off(),
            std::min({limits.all, limits.diffuse, limits.glossy, limits.transmission}) < most
                ? fmt::format("--bounces {} keeps more", most)
                : "they are the highest");
    }
    return text;
}

double shown_value(const lang::FittedParameter& parameter) {
    return parameter.is_angle ? *parameter.value * 180.0 / std::numbers::pi : *parameter.value;
}

// Where the scene has placed the camera, with angles in degrees.
std::string fitted_text(const std::vector<lang::FittedParameter>& fitted) {
    std::vector<std::string> texts;
    for (const lang::FittedParameter& parameter : fitted) {
        if (parameter.value) {
            texts.push_back(fmt::format("{}={:.4g}{}", parameter.name, shown_value(parameter),
                                        parameter.is_angle ? "deg" : ""));
        }
    }
    return texts.empty() ? std::string() : fmt::format("  fitted: {}\n", fmt::join(texts, " "));
}

nlohmann::json fitted_json(const std::vector<lang::FittedParameter>& fitted) {
    nlohmann::json all = nlohmann::json::array();
    for (const lang::FittedParameter& parameter : fitted) {
        if (parameter.value) {
            all.push_back({{"camera", parameter.camera},
                           {"name", parameter.name},
                           {"value", shown_value(parameter)},
                           {"unit", parameter.is_angle ? "deg" : ""}});
        }
    }
    return all;
}

// Most scenes are ready at once.
std::string preparation_text(const app::Report& report) {
    constexpr double noticeable = 0.5;
    const double preparing = report.preparation.build_seconds + report.preparation.texture_seconds;
    return report.load_seconds + preparing < noticeable
               ? std::string()
               : fmt::format("  scene read in {}, prepared in {}\n",
                             duration_text(report.load_seconds), duration_text(preparing));
}

std::string exposure_text(const app::Report& report) {
    if (!report.is_exposure_chosen || report.exposure == 0.0) {
        return {};
    }
    return report.summary.light.empty()
               ? fmt::format(
                     "  exposure {:+} stops, ambient light {:.3g}; --exposure and "
                     "--ambient set them\n",
                     report.exposure, report.summary.ambient.x)
               : fmt::format("  exposure {:+} stops; --exposure sets it\n", report.exposure);
}

// Of a picture without a partial one.
std::string interrupted_text(const app::Report& report, const std::string& when) {
    return report.checkpoint.empty() ? fmt::format("interrupted{}; there is no checkpoint\n", when)
                                     : fmt::format("interrupted{}; --resume continues from {}\n",
                                                   when, report.checkpoint.string());
}

std::string text_of_shard(const app::Report& report, const render::Shard& shard) {
    if (!report.interrupted) {
        return fmt::format("{}: shard {} of {} in {}\n", report.output.string(), shard.index + 1,
                           shard.count, duration_text(report.summary.seconds));
    }
    return interrupted_text(report, "");
}

std::string name_of_output(const std::filesystem::path& output) {
    return output == "-" ? "standard output" : output.string();
}

nlohmann::json facts_of(const app::Report& report) {
    nlohmann::json facts = nlohmann::json::object();
    const render::Summary& summary = report.summary;
    if (report.shard) {
        if (!report.output.empty()) {
            facts["output"] = report.output.string();
            facts["seconds"] = summary.seconds;
            facts["rays"] = summary.camera_rays;
        }
        return facts;
    }
    if (!report.is_traced) {
        return facts;
    }
    facts.update({{"output", nullptr},
                  {"camera", report.camera},
                  {"layers", layers_json(summary)},
                  {"fitted", fitted_json(report.fitted)},
                  {"width", report.width},
                  {"height", report.height},
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
                  {"interrupted", summary.interrupted},
                  {"emission_scale", report.emission_scale},
                  {"load_seconds", report.load_seconds},
                  {"build_seconds", report.preparation.build_seconds},
                  {"texture_seconds", report.preparation.texture_seconds}});
    if (report.samples) {
        facts["mean_samples"] = report.samples->mean;
    }
    if (report.denoised) {
        facts["denoiser"] = report.denoised->used;
        facts["left_out"] = report.denoised->left_out;
    }
    if (report.has_samples) {
        facts["exposure"] = report.exposure;
    }
    if (!report.output.empty()) {
        facts["output"] = report.output.string();
    }
    return facts;
}

std::string text_of(const app::Report& report, const app::Request& request) {
    const render::Summary& summary = report.summary;
    if (report.shard) {
        return text_of_shard(report, *report.shard);
    }
    if (report.in_bands && report.interrupted) {
        return interrupted_text(report, fmt::format(" after {:.0f} %", 100.0 * report.done));
    }
    if (!report.has_samples) {
        return "interrupted before there was anything to save\n";
    }
    std::string text = fmt::format(
        "{}{}: {} x {} pixels through '{}', {}, {} rays in {}, {:.0f} MiB\n",
        report.interrupted ? "interrupted; the partial picture is " : "",
        printable(name_of_output(request.output)), report.width, report.height, report.camera,
        counted(summary.passes, "pass"), count_text(static_cast<double>(summary.camera_rays)),
        duration_text(summary.seconds), static_cast<double>(peak_memory()) / 0x1p20);
    if (!summary.light.empty()) {
        text += fmt::format("  lit by {}\n", printable(summary.light));
    }
    if (report.emission_scale != 1.0F && !request.light.emission_scale) {
        text += fmt::format(
            "  emission x {:g}, to the units of Blender's lamps; --emission-scale "
            "sets it\n",
            report.emission_scale);
    }
    if (report.samples) {
        text += fmt::format("  {} to {} samples per pixel, on average {:.1f}\n",
                            report.samples->fewest, report.samples->most, report.samples->mean);
    }
    if (const auto pixel = request.pixel_millimeters()) {
        text += fmt::format("  {:.4g} mm per pixel: {:.5g} x {:.5g} mm\n", *pixel,
                            *pixel * static_cast<double>(report.width),
                            *pixel * static_cast<double>(report.height));
    }
    text += layers_text(summary) + lost_light_text(summary, request.settings.path.bounces) +
            fitted_text(report.fitted) + preparation_text(report);
    if (report.denoised) {
        text += fmt::format("  denoised by {} in {:.1f} s\n", report.denoised->used,
                            report.denoised->seconds);
        if (report.denoised->left_out > 0.001) {
            text +=
                fmt::format("  without {:.1f} % of the light, which was in single bright specks\n",
                            100.0 * report.denoised->left_out);
        }
    }
    text += exposure_text(report);
    if (!report.checkpoint.empty()) {
        text += fmt::format("  --resume continues from {}\n", report.checkpoint.string());
    }
    return text;
}

}  // namespace

Answer answer_of(const app::Report& report, const app::Request& request) {
    Answer answer{report.diagnostics, report.interrupted, facts_of(report)};
    answer.text = has_errors(report.diagnostics) ? "" : text_of(report, request);
    if (const auto pixel = request.pixel_millimeters(); pixel && report.is_traced) {
        answer.facts["mm_per_pixel"] = *pixel;
    }
    answer.print = request.output == "-" ? print_aside : print_result;
    return answer;
}

Answer answer_of(const app::MergedPicture& merged) {
    Answer answer{merged.diagnostics};
    if (merged.denoised) {
        answer.facts["denoiser"] = merged.denoised->used;
    }
    if (!merged.output.empty()) {
        const std::string name = name_of_output(merged.output);
        answer.facts.update({{"output", name},
                             {"exposure", merged.exposure},
                             {"shards", merged.shards},
                             {"width", merged.width},
                             {"height", merged.height}});
        answer.text = fmt::format("{}: {} x {} pixels, merged from {} shards\n", name, merged.width,
                                  merged.height, merged.shards);
    }
    return answer;
}

}  // namespace balcony::cli

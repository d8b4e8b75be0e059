// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/request.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/memory.hpp"
#include "base/precondition.hpp"

namespace balcony::app {

namespace fs = std::filesystem;

std::pair<std::size_t, std::size_t> SizeRequest::resolve(
    double aspect, std::optional<std::array<std::size_t, 2>> own) const {
    if (!width && !height && own) {
        return {(*own)[0], (*own)[1]};
    }
    precondition(aspect > 0.0 && std::isfinite(aspect), "an aspect is positive and finite");
    constexpr double default_pixels = 1280.0 * 720.0;
    // An aspect that was computed may miss a half by rounding.
    constexpr double slack = 1e-9;
    const auto side = [](double pixels) {
        return static_cast<std::size_t>(
            std::clamp(std::round(pixels + slack), 1.0, static_cast<double>(max_side)));
    };
    const std::size_t wide = width.value_or(
        side(height ? static_cast<double>(*height) * aspect : std::sqrt(default_pixels * aspect)));
    return {wide, height.value_or(side(static_cast<double>(wide) / aspect))};
}

std::pair<std::size_t, std::size_t> Crop::scaled(std::size_t width, std::size_t height) const {
    precondition(scale > 0.0 && std::isfinite(scale), "a scale is positive and finite");
    const auto side = [this](std::size_t pixels) {
        return static_cast<std::size_t>(
            std::max(1.0, std::round(static_cast<double>(pixels) * scale)));
    };
    return {side(width), side(height)};
}

std::optional<render::Region> Crop::region(std::size_t width, std::size_t height) const {
    if (!corners) {
        return std::nullopt;
    }
    const auto [wide, high] = scaled(width, height);
    // A part of a pixel is the whole pixel.
    const auto range = [this](double from, double to, std::size_t side) {
        constexpr double rounding = 1e-9;
        const double factor = in_pixels ? scale : static_cast<double>(side);
        const auto first = static_cast<std::size_t>(std::floor(from * factor + rounding));
        const auto last = static_cast<std::size_t>(std::ceil(to * factor - rounding));
        // What is beyond the picture stays there, to be refused.
        return std::pair(first, std::max<std::size_t>(last, first + 1) - first);
    };
    const auto [x, region_width] = range((*corners)[0], (*corners)[2], wide);
    const auto [y, region_height] = range((*corners)[1], (*corners)[3], high);
    return render::Region{x, y, region_width, region_height};
}

std::string FrameRate::text() const {
    return seconds == 1.0 ? fmt::format("{}", frames) : fmt::format("{}/{}", frames, seconds);
}

render::Shutter ShutterRequest::shutter() const {
    return {in_degrees ? duration / 360.0 * rate.frame_time() : duration, shape};
}

bool StereoRequest::is_anaglyph() const {
    using camera::StereoFormat;
    return std::any_of(formats.begin(), formats.end(), [](StereoFormat format) {
        return format == StereoFormat::anaglyph || format == StereoFormat::anaglyph_color ||
               format == StereoFormat::anaglyph_grey;
    });
}

fs::path file_of_eye(const fs::path& file, camera::StereoFormat eye) {
    fs::path made = file;
    made.replace_filename(fmt::format("{}.{}{}", file.stem().string(),
                                      camera::stereo_formats()[eye].name,
                                      file.extension().string()));
    return made;
}

Names<InsideRule> inside_rules() {
    static constexpr std::array names{
        Named{InsideRule::report, "report", "they show them from inside, and are named"},
        Named{InsideRule::pass, "pass", "they pass through them"}};
    return Names<InsideRule>(names);
}

// The scene and other programs need some memory, too.
std::string DisplayAddress::text() const {
    const bool is_ip6 = host.find(':') != std::string::npos;
    return fmt::format(fmt::runtime(is_ip6 ? "[{}]:{}" : "{}:{}"), host, port);
}

double JobRequest::film_bytes() const { return film_memory.value_or(0.5 * physical_memory()); }

render::ViewTransform Request::view_transform() const {
    return view.value_or(stereo.is_anaglyph() ? render::ViewTransform::standard
                                              : render::ViewTransform::neutral);
}

std::optional<double> Request::pixel_millimeters() const {
    return mm_per_pixel ? std::optional(*mm_per_pixel / crop.scale) : std::nullopt;
}

render::DisplayOptions Request::display() const {
    constexpr double millimeters_per_inch = 25.4;
    const std::optional<double> pixel = pixel_millimeters();
    return {.exposure = exposure.value_or(0.0),
            .view = view_transform(),
            .dither = dither,
            .dpi = dpi.value_or(pixel ? millimeters_per_inch / *pixel : 0.0)};
}

Result<render::Settings> settings_of(const Request& request) {
    Result<render::Settings> made{request.settings};
    render::Settings& settings = *made;
    settings.samples = request.samples.value_or(settings.sampling.noise > 0.0 ? default_max_samples
                                                                              : default_samples);
    settings.shutter = request.shutter.shutter();
    settings.frames.duration = request.shutter.rate.frame_time();
    if (request.exposure) {
        settings.sampling.white = std::exp2(-*request.exposure);
    }
    const LightRequest& light = request.light;
    settings.light.sky_beside_suns = true;
    if (light.lamp_at_eye) {
        settings.light.substitute = render::SubstituteLight::eye;
    }
    if (light.sun_angle) {
        settings.light.sun_angle = light.sun_angle;
    }
    const auto place = [&](const render::Environment& environment) {
        settings.light.environment = environment.rotated(light.rotation).scaled(light.strength);
    };
    if (const auto* const radiance = std::get_if<Imath::Color3f>(&light.environment)) {
        place(render::Environment::constant(*radiance));
    } else if (const auto* const sky = std::get_if<render::Sky>(&light.environment)) {
        const auto environment = render::Environment::sky(*sky);
        if (!environment) {
            return environment.diagnostics;
        }
        place(*environment);
    }
    return made;
}

}  // namespace balcony::app

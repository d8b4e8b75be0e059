// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "analyse/draw/bitmap.hpp"
#include "analyse/draw/color_scale.hpp"
#include "analyse/draw/legend.hpp"
#include "balcony/diagnose.hpp"

namespace balcony::analyse {

namespace {

constexpr Color no_ray_color{128, 128, 128};
constexpr Color singular_color{200, 30, 110};
constexpr Color no_surface_color{205, 205, 205};

/// The design of a map: the contents of the legend, and the colour of each sample.
struct Design {
    std::string title;
    std::function<Color(const Sample&)> color;
    std::optional<ColorScale> scale;
    std::vector<Swatch> swatches;

    [[nodiscard]] Legend legend() const { return {title, scale, swatches}; }
};

// The sorted values of the samples that have a ray and are not singular.
std::vector<double> sorted_values(const CameraReport& report, double Sample::*value) {
    std::vector<double> values;
    for (const Sample& sample : report.samples) {
        if (sample.valid && !sample.singular) {
            values.push_back(sample.*value);
        }
    }
    std::sort(values.begin(), values.end());
    return values;
}

// Excludes outliers at both ends, which would occupy most of the colour scale.
Design scaled(const CameraReport& report, std::string title, double Sample::*value,
              ColorScale::Spacing spacing) {
    constexpr std::size_t hundredth = 100;
    const std::vector<double> values = sorted_values(report, value);
    double minimum = values.empty() ? 1.0 : values[values.size() / hundredth];
    double maximum = values.empty() ? 1.0 : values[values.size() - 1 - values.size() / hundredth];
    if (maximum - minimum <= 1e-6 * std::abs(maximum)) {
        const double margin = maximum != 0.0 ? 0.05 * std::abs(maximum) : 1.0;
        minimum -= margin;
        maximum += margin;
    }
    const ColorScale scale(minimum, maximum, spacing);
    return {std::move(title),
            [scale, value](const Sample& sample) {
                return !sample.valid     ? no_ray_color
                       : sample.singular ? singular_color
                                         : scale.color(sample.*value);
            },
            scale,
            {{no_ray_color, "no ray"}, {singular_color, "singular"}}};
}

Design magnification(const CameraReport& report) {
    return scaled(report,
                  report.distance ? fmt::format("magnification: pixels per unit at distance {:.4g}",
                                                *report.distance)
                                  : "magnification: pixels per degree",
                  &Sample::magnification, ColorScale::Spacing::logarithmic);
}

Design anisotropy(const CameraReport& report) {
    return scaled(report, "anisotropy: ratio of largest to smallest magnification",
                  &Sample::anisotropy, ColorScale::Spacing::logarithmic);
}

Design origins(const CameraReport& report) {
    return scaled(report, "distance of the ray origins from their centre", &Sample::origin_distance,
                  ColorScale::Spacing::linear);
}

// Zero is in the middle of the scale: what is shorter is darker, and what is longer brighter.
Design scale(const CameraReport& report) {
    constexpr double percent = 100.0;
    constexpr double least = 0.1;  // So that rounding errors do not fill the scale.
    constexpr std::size_t fiftieth = 50;
    std::vector<double> sizes;
    for (const Sample& sample : report.samples) {
        if (sample.scale_error) {
            sizes.push_back(percent * std::abs(*sample.scale_error));
        }
    }
    std::sort(sizes.begin(), sizes.end());
    const double most =
        sizes.empty() ? least : std::max(least, sizes[sizes.size() - 1 - sizes.size() / fiftieth]);
    const ColorScale colors(-most, most, ColorScale::Spacing::linear);
    return {"error of the scale: percent by which a pixel is longer on the surface",
            [colors](const Sample& sample) {
                return !sample.valid         ? no_ray_color
                       : !sample.scale_error ? no_surface_color
                                             : colors.color(percent * *sample.scale_error);
            },
            colors,
            {{no_ray_color, "no ray"}, {no_surface_color, "no surface"}}};
}

Design orientation(const CameraReport&) {
    static constexpr Color right{49, 104, 142};
    static constexpr Color mirrored{240, 150, 40};
    return {"orientation",
            [](const Sample& sample) {
                return !sample.valid            ? no_ray_color
                       : sample.singular        ? singular_color
                       : sample.orientation > 0 ? right
                                                : mirrored;
            },
            std::nullopt,
            {{right, "not mirrored"},
             {mirrored, "mirrored"},
             {singular_color, "singular"},
             {no_ray_color, "no ray"}}};
}

Design validity(const CameraReport&) {
    static constexpr Color valid{53, 183, 121};
    return {"validity",
            [](const Sample& sample) { return sample.valid ? valid : no_ray_color; },
            std::nullopt,
            {{valid, "ray"}, {no_ray_color, "no ray"}}};
}

Design seams(const CameraReport&) {
    static constexpr Color smooth{205, 215, 225};
    static constexpr Color seam{190, 20, 20};
    return {"seams",
            [](const Sample& sample) {
                return !sample.valid ? no_ray_color : sample.seam ? seam : smooth;
            },
            std::nullopt,
            {{smooth, "smooth"}, {seam, "rays jump"}, {no_ray_color, "no ray"}}};
}

Design repeated(const CameraReport& report) {
    int maximum = 1;
    for (const Sample& sample : report.samples) {
        maximum = std::max(maximum, int{sample.views});
    }
    Design design{"how often the picture shows this view", {}, std::nullopt, {}};
    const ColorScale scale(1.0, std::max(maximum, 2), ColorScale::Spacing::linear);
    constexpr int max_swatches = 5;
    for (int views = 1; views <= std::min(maximum, max_swatches); ++views) {
        design.swatches.push_back({scale.color(views), fmt::format("{}", views)});
    }
    if (maximum > max_swatches) {
        design.swatches.push_back({scale.color(maximum), fmt::format("{}", maximum)});
    }
    design.swatches.push_back({singular_color, "singular"});
    design.swatches.push_back({no_ray_color, "no ray"});
    design.color = [scale](const Sample& sample) {
        return !sample.valid       ? no_ray_color
               : sample.views == 0 ? singular_color
                                   : scale.color(sample.views);
    };
    return design;
}

Design design_of(const CameraReport& report, MapKind kind) {
    switch (kind) {
        case MapKind::magnification: return magnification(report);
        case MapKind::anisotropy: return anisotropy(report);
        case MapKind::orientation: return orientation(report);
        case MapKind::validity: return validity(report);
        case MapKind::seams: return seams(report);
        case MapKind::repeated: return repeated(report);
        case MapKind::origins: return origins(report);
        case MapKind::scale: return scale(report);
    }
    return {};
}

// The legend omits colours that the map does not use.
void leave_out_unused(const CameraReport& report, Design& design) {
    std::erase_if(design.swatches, [&](const Swatch& swatch) {
        return std::none_of(
            report.samples.begin(), report.samples.end(),
            [&](const Sample& sample) { return design.color(sample) == swatch.color; });
    });
}

}  // namespace

Names<MapKind> map_kinds() {
    static constexpr std::array rows{
        Named{MapKind::magnification, "magnification", "how large things appear"},
        Named{MapKind::anisotropy, "anisotropy", "how much things are stretched"},
        Named{MapKind::orientation, "orientation",
              "where the picture is mirrored, which reveals folds"},
        Named{MapKind::validity, "validity", "where there are rays"},
        Named{MapKind::seams, "seams", "where rays jump"},
        Named{MapKind::repeated, "repeated", "how often the picture shows the same view"},
        Named{MapKind::origins, "origins", "distance of the ray origins from their centre"},
        Named{MapKind::scale, "scale", "how true the scale is on the surfaces of --scene"},
    };
    return Names<MapKind>(rows);
}

Image false_color(const CameraReport& report, MapKind kind) {
    constexpr std::size_t min_width = 800;
    constexpr std::size_t max_side = 8192;
    Design design = design_of(report, kind);
    leave_out_unused(report, design);
    const SampleGrid& grid = report.grid;
    const std::size_t wished =
        std::max(static_cast<std::size_t>(std::lround(grid.step)),
                 (min_width + grid.columns - 1) / std::max<std::size_t>(grid.columns, 1));
    const std::size_t longest = std::max({grid.columns, grid.rows, std::size_t{1}});
    const std::size_t side = std::min(wished, std::max<std::size_t>(max_side / longest, 1));
    const std::size_t map_height = side * grid.rows;
    const Legend legend = design.legend();
    Bitmap bitmap(std::max(side * grid.columns, min_width), map_height + height_of(legend), white);
    for (std::size_t i = 0; i < report.samples.size(); ++i) {
        bitmap.fill(side * (i % grid.columns), side * (i / grid.columns), side, side,
                    design.color(report.samples[i]));
    }
    write_legend(legend, map_height, bitmap);
    return bitmap.take();
}

}  // namespace balcony::analyse

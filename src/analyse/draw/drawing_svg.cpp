// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "balcony/drawing.hpp"
#include "base/markup.hpp"

namespace balcony::analyse {

namespace {

// Paths have a resolution of a tenth of a pixel.
struct Tenths {
    long x, y;
};

Tenths tenths(const V2d& point) {
    // Clamps coordinates far outside the page.
    constexpr double maximum = 1e7;
    return {std::lround(std::clamp(10.0 * point.x, -maximum, maximum)),
            std::lround(std::clamp(10.0 * point.y, -maximum, maximum))};
}

void append_number(std::string& text, long value, bool separated) {
    if (separated && value >= 0) {
        text += ' ';
    }
    if (value % 10 == 0) {
        fmt::format_to(std::back_inserter(text), "{}", value / 10);
    } else {
        fmt::format_to(std::back_inserter(text), "{}{}.{}", value < 0 ? "-" : "",
                       std::labs(value) / 10, std::labs(value) % 10);
    }
}

// The first point, then relative steps, which are shorter.
std::string path_of(const DrawingShape& shape) {
    std::string text = "M";
    Tenths last{0, 0};
    for (std::size_t i = 0; i < shape.points.size(); ++i) {
        const Tenths point = tenths(shape.points[i]);
        if (i == 1) {
            text += 'l';
        }
        append_number(text, point.x - last.x, i > 1);
        append_number(text, point.y - last.y, true);
        last = point;
    }
    // A line of one point is a dot.
    text += shape.line_width == 0.0 ? "z" : shape.points.size() == 1 ? "h0" : "";
    return text;
}

std::string element(const DrawingShape& shape) {
    const std::string color =
        fmt::format("#{:02x}{:02x}{:02x}", shape.color[0], shape.color[1], shape.color[2]);
    const std::string paint =
        shape.line_width > 0.0
            ? fmt::format("stroke=\"{}\" stroke-width=\"{:.3g}\"", color, shape.line_width)
        : shape.opacity < 1.0
            ? fmt::format("fill=\"{}\" fill-opacity=\"{:.3g}\"", color, shape.opacity)
            : fmt::format("fill=\"{}\"", color);
    const std::string camera = shape.camera > 0 ? fmt::format(" camera-{}", shape.camera) : "";
    return fmt::format("<path class=\"{}{}\" {} d=\"{}\"/>\n", name_of(shape.part), camera, paint,
                       path_of(shape));
}

std::string element(const DrawingLabel& label) {
    // In most typefaces, capitals have a height of 0.7 of the font size, and the letters of
    // monospaced ones a width of 0.6 of it.
    return fmt::format(
        "<text x=\"{:.1f}\" y=\"{:.1f}\" font-family=\"{}\" font-size=\"{:.1f}\" "
        "fill=\"#{:02x}{:02x}{:02x}\"{}>{}</text>\n",
        label.position.x, label.position.y, label.monospaced ? "monospace" : "sans-serif",
        label.size / 0.7, label.color[0], label.color[1], label.color[2],
        label.monospaced ? " xml:space=\"preserve\"" : "", markup_of(label.text));
}

}  // namespace

std::string to_svg(const Drawing& drawing) {
    std::string text = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
        "viewBox=\"0 0 {0} {1}\">\n"
        "<title>{2}</title>\n"
        "<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n"
        "<g fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n",
        drawing.width, drawing.height, markup_of(drawing.name));
    for (const DrawingShape& shape : drawing.shapes) {
        text += element(shape);
    }
    for (const DrawingLabel& label : drawing.labels) {
        text += element(label);
    }
    return text + "</g>\n</svg>\n";
}

}  // namespace balcony::analyse

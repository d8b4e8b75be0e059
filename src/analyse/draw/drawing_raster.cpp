// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "analyse/draw/bitmap_font.hpp"
#include "analyse/measure/work.hpp"
#include "balcony/drawing.hpp"

namespace balcony::analyse {

namespace {

// Samples along each side of a pixel.
constexpr std::size_t fineness = 4;
// Rows of pixels painted at a time, so that large pictures need little memory.
constexpr std::size_t band_height = 32;

struct Paint {
    std::array<float, 3> color;
    float opacity;
};

/// A band of the picture at the resolution of the samples.
class Band {
public:
    Band(std::size_t width, std::size_t top)
        : columns_(width * fineness),
          top_(static_cast<double>(top)),
          samples_(columns_ * band_height * fineness, {1.0F, 1.0F, 1.0F}) {}

    /// Begins with the rows of an image, which is as wide.
    void show(const Image& image) {
        const auto top = static_cast<std::size_t>(top_);
        for (std::size_t i = 0; i < samples_.size(); ++i) {
            const std::size_t x = i % columns_ / fineness;
            const std::size_t y = top + i / columns_ / fineness;
            for (std::size_t c = 0; c < 3 && y < image.height; ++c) {
                samples_[i][c] =
                    static_cast<float>(image.samples[3 * (y * image.width + x) + c]) / 255.0F;
            }
        }
    }

    /// Fills an outline by the non-zero winding rule.
    void fill(const std::vector<V2d>& outline, const Paint& paint) {
        double highest = outline.front().y;
        double lowest = highest;
        for (const V2d& point : outline) {
            highest = std::min(highest, point.y);
            lowest = std::max(lowest, point.y);
        }
        const std::size_t begin = sample_at(highest - top_, band_height * fineness);
        const std::size_t end = sample_at(lowest - top_, band_height * fineness);
        for (std::size_t row = begin; row < end; ++row) {
            fill_row(row, outline, paint);
        }
    }

    /// The mean of a pixel's samples, from 0 to 1.
    std::array<float, 3> pixel(std::size_t x, std::size_t y) const {
        std::array<float, 3> sum{};
        for (std::size_t i = 0; i < fineness * fineness; ++i) {
            const auto& sample =
                samples_[(y * fineness + i / fineness) * columns_ + x * fineness + i % fineness];
            for (std::size_t c = 0; c < sum.size(); ++c) {
                sum[c] += sample[c] / static_cast<float>(fineness * fineness);
            }
        }
        return sum;
    }

private:
    struct Crossing {
        double x;
        int winding;
    };

    // The first sample whose centre is at or behind a place, at most `most`.
    static std::size_t sample_at(double place, std::size_t maximum) {
        const double sample = std::ceil(place * static_cast<double>(fineness) - 0.5);
        return static_cast<std::size_t>(std::clamp(sample, 0.0, static_cast<double>(maximum)));
    }

    void fill_row(std::size_t row, const std::vector<V2d>& outline, const Paint& paint) {
        const double y = top_ + (static_cast<double>(row) + 0.5) / static_cast<double>(fineness);
        crossings_.clear();
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const V2d& a = outline[i];
            const V2d& b = outline[(i + 1) % outline.size()];
            if ((a.y <= y) != (b.y <= y)) {
                crossings_.push_back(
                    {a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x), a.y < b.y ? 1 : -1});
            }
        }
        std::sort(crossings_.begin(), crossings_.end(),
                  [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
        int winding = 0;
        for (std::size_t i = 0; i + 1 < crossings_.size(); ++i) {
            winding += crossings_[i].winding;
            if (winding != 0) {
                blend(row, sample_at(crossings_[i].x, columns_),
                      sample_at(crossings_[i + 1].x, columns_), paint);
            }
        }
    }

    void blend(std::size_t row, std::size_t begin, std::size_t end, const Paint& paint) {
        for (std::size_t column = begin; column < end; ++column) {
            auto& sample = samples_[row * columns_ + column];
            for (std::size_t c = 0; c < sample.size(); ++c) {
                sample[c] += paint.opacity * (paint.color[c] - sample[c]);
            }
        }
    }

    std::size_t columns_;
    double top_;
    std::vector<std::array<float, 3>> samples_;
    std::vector<Crossing> crossings_;
};

std::vector<V2d> disc(const V2d& center, double radius) {
    constexpr int minimum = 8;
    const int corners = minimum + static_cast<int>(std::min(radius * 4.0, 56.0));
    std::vector<V2d> outline;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / corners;
        outline.push_back(center + radius * V2d(std::cos(angle), std::sin(angle)));
    }
    return outline;
}

// A line as areas: a rectangle per segment, and a disc at each end of a segment.
std::vector<std::vector<V2d>> outlines_of(const DrawingShape& shape) {
    if (shape.line_width == 0.0) {
        return {shape.points};
    }
    const double radius = 0.5 * shape.line_width;
    std::vector<std::vector<V2d>> outlines;
    for (std::size_t i = 0; i < shape.points.size(); ++i) {
        const V2d& a = shape.points[i];
        outlines.push_back(disc(a, radius));
        if (i + 1 < shape.points.size() && shape.points[i + 1] != a) {
            const V2d& b = shape.points[i + 1];
            const V2d along = (b - a).normalized();
            const V2d aside = radius * V2d(-along.y, along.x);
            outlines.push_back({a + aside, b + aside, b - aside, a - aside});
        }
    }
    return outlines;
}

// The dots of a text.
std::vector<std::vector<V2d>> outlines_of(const DrawingLabel& label) {
    const double dot = label.size / static_cast<double>(glyph_height);
    std::vector<std::vector<V2d>> outlines;
    double left = label.position.x;
    for (const char character : label.text) {
        const Glyph& rows = glyph(character);
        for (std::size_t row = 0; row < glyph_height; ++row) {
            for (std::size_t column = 0; column < glyph_width; ++column) {
                if ((rows[row] >> (glyph_width - 1 - column) & 1) != 0) {
                    const V2d corner(
                        left + dot * static_cast<double>(column),
                        label.position.y - dot * static_cast<double>(glyph_height - row));
                    outlines.push_back({corner, corner + V2d(dot, 0.0), corner + V2d(dot, dot),
                                        corner + V2d(0.0, dot)});
                }
            }
        }
        left += dot * static_cast<double>(glyph_width + 1);
    }
    return outlines;
}

Paint paint_of(const DrawingColor& color, double opacity) {
    Paint paint{{}, static_cast<float>(opacity)};
    for (std::size_t c = 0; c < paint.color.size(); ++c) {
        paint.color[c] = static_cast<float>(color[c]) / 255.0F;
    }
    return paint;
}

Image raster_of(const Drawing& drawing, const Work& work) {
    Image image{drawing.width, drawing.height, {}};
    image.samples.reserve(drawing.width * drawing.height * 3);
    for (std::size_t top = 0; top < drawing.height; top += band_height) {
        work.done(static_cast<double>(top) / static_cast<double>(drawing.height));
        Band band(drawing.width, top);
        if (drawing.background) {
            band.show(*drawing.background);
        }
        for (const DrawingShape& shape : drawing.shapes) {
            work.go_on();
            for (const std::vector<V2d>& outline : outlines_of(shape)) {
                band.fill(outline, paint_of(shape.color, shape.opacity));
            }
        }
        for (const DrawingLabel& label : drawing.labels) {
            for (const std::vector<V2d>& dot : outlines_of(label)) {
                band.fill(dot, paint_of(label.color, 1.0));
            }
        }
        for (std::size_t y = 0; y < std::min(band_height, drawing.height - top); ++y) {
            for (std::size_t x = 0; x < drawing.width; ++x) {
                for (const float value : band.pixel(x, y)) {
                    image.samples.push_back(static_cast<std::uint8_t>(std::lround(value * 255.0F)));
                }
            }
        }
    }
    work.done(1.0);
    return image;
}

}  // namespace

Image rasterise(const Drawing& drawing) { return raster_of(drawing, Work()); }

Result<Image> rasterise(const Drawing& drawing, const PartDone& progress, std::stop_token stop) {
    return unless_stopped(
        [&]() -> Result<Image> { return raster_of(drawing, Work(progress, std::move(stop))); });
}

}  // namespace balcony::analyse

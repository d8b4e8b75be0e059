// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "common/painting.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <tbb/parallel_for.h>

namespace balcony::plates {

namespace {

double linear_from_srgb(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

double srgb_from_linear(double x) {
    return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
}

std::uint8_t byte_of(double linear, scene::TextureEncoding encoding) {
    const double x = std::clamp(linear, 0.0, 1.0);
    const double encoded = encoding == scene::TextureEncoding::srgb ? srgb_from_linear(x) : x;
    return static_cast<std::uint8_t>(std::lround(encoded * 255.0));
}

V3d oklab_from_linear(const Color& c) {
    const double l = std::cbrt(0.4122214708 * c.x + 0.5363325363 * c.y + 0.0514459929 * c.z);
    const double m = std::cbrt(0.2119034982 * c.x + 0.6806995451 * c.y + 0.1073969566 * c.z);
    const double s = std::cbrt(0.0883024619 * c.x + 0.2817188376 * c.y + 0.6299787005 * c.z);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

Color linear_from_oklab(const V3d& lab) {
    const auto cube = [](double x) { return x * x * x; };
    const double l = cube(lab.x + 0.3963377774 * lab.y + 0.2158037573 * lab.z);
    const double m = cube(lab.x - 0.1055613458 * lab.y - 0.0638541728 * lab.z);
    const double s = cube(lab.x - 0.0894841775 * lab.y - 1.2914855480 * lab.z);
    return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
            -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
            -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

// Faster than std::floor where that is a call; for numbers that fit into an int.
int floor_of(double x) {
    const int truncated = static_cast<int>(x);
    return x < truncated ? truncated - 1 : truncated;
}

}  // namespace

Painting paint(int width, int height, const Painter& painter, scene::TextureEncoding encoding,
               Sampling sampling) {
    const int a_side = sampling == Sampling::centre ? 1 : samples_per_axis;
    const int count = a_side * a_side;
    assert(width > 0 && height > 0);
    Painting painting{width, height, {}, encoding};
    painting.pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
    tbb::parallel_for(0, height, [&](int row) {
        for (int column = 0; column < width; ++column) {
            Color sum(0.0);
            for (int k = 0; k < count; ++k) {
                const double dx = (k % a_side + 0.5) / a_side;
                const double dy = (k / a_side + 0.5) / a_side;
                const V2d point((2.0 * (column + dx) - width) / height,
                                1.0 - 2.0 * (row + dy) / height);
                const Color color = painter({point, k});
                for (int channel = 0; channel < 3; ++channel) {
                    sum[channel] += std::clamp(color[channel], 0.0, 1.0);
                }
            }
            auto at = (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                       static_cast<std::size_t>(column)) *
                      3;
            for (int channel = 0; channel < 3; ++channel) {
                painting.pixels[at++] = byte_of(sum[channel] / count, encoding);
            }
        }
    });
    return painting;
}

std::vector<std::uint8_t> to_png(const Painting& painting) {
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = OIIO::ImageOutput::create("png", &memory);
    if (!output) {
        return {};
    }
    OIIO::ImageSpec spec(painting.width, painting.height, 3, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace",
                   painting.encoding == scene::TextureEncoding::srgb ? "sRGB" : "Linear");
    spec.attribute("png:compressionLevel", 6);
    if (!output->open("painting.png", spec) ||
        !output->write_image(OIIO::TypeDesc::UINT8, painting.pixels.data()) || !output->close()) {
        return {};
    }
    return bytes;
}

Color from_srgb(std::uint32_t rrggbb) {
    const auto channel = [rrggbb](int shift) {
        return linear_from_srgb((rrggbb >> shift & 0xffU) / 255.0);
    };
    return {channel(16), channel(8), channel(0)};
}

double smooth_step(double from, double to, double x) {
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

Gradient::Gradient(std::initializer_list<std::uint32_t> colors, bool cyclic) : cyclic_(cyclic) {
    assert(colors.size() >= 2);
    for (const std::uint32_t color : colors) {
        stops_.push_back(oklab_from_linear(from_srgb(color)));
    }
    if (cyclic) {
        stops_.push_back(stops_.front());
    }
}

Color Gradient::operator()(double t) const {
    const double inside = cyclic_ ? t - std::floor(t) : std::clamp(t, 0.0, 1.0);
    const double scaled = inside * static_cast<double>(stops_.size() - 1);
    const auto index = std::min(static_cast<std::size_t>(scaled), stops_.size() - 2);
    return linear_from_oklab(
        mix(stops_[index], stops_[index + 1], scaled - static_cast<double>(index)));
}

double lattice_noise(int x, int y, std::uint32_t seed) {
    std::uint32_t h = static_cast<std::uint32_t>(x) * 0x9e3779b1U ^
                      static_cast<std::uint32_t>(y) * 0x85ebca77U ^ seed * 0xc2b2ae3dU;
    h = (h ^ h >> 15U) * 0x2c1b3c6dU;
    h = (h ^ h >> 12U) * 0x297a2d39U;
    h ^= h >> 15U;
    return h / 4294967296.0;
}

double noise(const V2d& point, std::uint32_t seed) {
    const int x = floor_of(point.x);
    const int y = floor_of(point.y);
    const double u = smooth_step(0.0, 1.0, point.x - x);
    const double v = smooth_step(0.0, 1.0, point.y - y);
    const double low = std::lerp(lattice_noise(x, y, seed), lattice_noise(x + 1, y, seed), u);
    const double high =
        std::lerp(lattice_noise(x, y + 1, seed), lattice_noise(x + 1, y + 1, seed), u);
    return 2.0 * std::lerp(low, high, v) - 1.0;
}

double fractal_noise(V2d point, int octaves, std::uint32_t seed) {
    double sum = 0.0;
    double height = 0.5;
    for (int octave = 0; octave < octaves; ++octave) {
        sum += height * noise(point, seed + static_cast<std::uint32_t>(octave));
        point *= 2.0;
        height /= 2.0;
    }
    return sum;
}

}  // namespace balcony::plates

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "shading/textures/mip_pyramid.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

namespace balcony::render {

namespace {

using Imath::Color4f;
using Imath::V2f;

// Four channels in one register, by an extension of GCC and Clang.
using Float4 = float __attribute__((vector_size(16)));

// ------------------------------------------------------------------------------------- texels

struct ByteCodec {
    using Texel = ByteTexel;
    const ByteScale& color;
    const ByteScale& alpha;

    [[nodiscard]] Float4 decode(const Texel& t) const {
        return Float4{color.decode(t[0]), color.decode(t[1]), color.decode(t[2]),
                      alpha.decode(t[3])};
    }
    [[nodiscard]] Texel encode(const Float4& value) const {
        return {color.encode(value[0]), color.encode(value[1]), color.encode(value[2]),
                alpha.encode(value[3])};
    }
};

struct HalfCodec {
    using Texel = HalfTexel;

    [[nodiscard]] static Float4 decode(const Texel& t) { return Float4{t[0], t[1], t[2], t[3]}; }
    [[nodiscard]] static Texel encode(const Float4& value) {
        return {value[0], value[1], value[2], value[3]};
    }
};

// ------------------------------------------------------------------------------------ halving

constexpr int halved(int side) { return std::max(side / 2, 1); }

// The shares of neighbouring texels of a row or column in a texel of its halving. If the number of
// texels is odd, it covers a little more than two.
struct Shares {
    std::size_t first = 0;
    std::array<float, 3> parts{};
};

std::vector<Shares> shares_of(int count) {
    const int half_count = halved(count);
    const double width = static_cast<double>(count) / half_count;
    std::vector<Shares> all(static_cast<std::size_t>(half_count));
    for (std::size_t i = 0; i < all.size(); ++i) {
        const double begin = static_cast<double>(i) * width;
        all[i].first = std::min(static_cast<std::size_t>(begin),
                                static_cast<std::size_t>(std::max(count - 3, 0)));
        for (std::size_t k = 0; k < all[i].parts.size(); ++k) {
            const auto left = static_cast<double>(all[i].first + k);
            const double overlap = std::min(begin + width, left + 1.0) - std::max(begin, left);
            all[i].parts[k] = static_cast<float>(std::max(overlap, 0.0) / width);
        }
    }
    return all;
}

// The halving of an image, whose row y is row(y).
template <class Row>
std::vector<Float4> halving(int width, int height, const Row& row) {
    const std::vector<Shares> columns = shares_of(width);
    const auto last = static_cast<std::size_t>(width - 1);
    std::vector<Float4> made;
    made.reserve(columns.size() * static_cast<std::size_t>(halved(height)));
    std::vector<Float4> line(static_cast<std::size_t>(width));
    for (const Shares& rows : shares_of(height)) {
        std::fill(line.begin(), line.end(), Float4{});
        for (std::size_t k = 0; k < rows.parts.size(); ++k) {
            if (rows.parts[k] > 0.0F) {
                const std::span<const Float4> source = row(rows.first + k);
                for (std::size_t x = 0; x < line.size(); ++x) {
                    line[x] += rows.parts[k] * source[x];
                }
            }
        }
        for (const Shares& column : columns) {
            Float4 sum{};
            for (std::size_t k = 0; k < column.parts.size(); ++k) {
                sum += column.parts[k] * line[std::min(column.first + k, last)];
            }
            made.push_back(sum);
        }
    }
    return made;
}

// ----------------------------------------------------------------------------------- look-ups

// The ellipse of a footprint, in texels: the images of a circle of diameter 1, a pixel, under the
// linear map with these columns.
struct Ellipse {
    Ellipse(const V2f& x, const V2f& y) {
        const float difference = 0.5F * (x.x * x.x + y.x * y.x - x.y * x.y - y.y * y.y);
        const float mixed = x.x * x.y + y.x * y.y;
        const float root = std::sqrt(difference * difference + mixed * mixed);
        const float square = 0.5F * (x.length2() + y.length2()) + root;
        length = std::sqrt(square);
        width = length > 0.0F ? std::abs(x.x * y.y - x.y * y.x) / length : 0.0F;
        // Of the two forms of the eigenvector, the one without cancellation.
        const V2f direction =
            difference >= 0.0F ? V2f(root + difference, mixed) : V2f(mixed, root - difference);
        // A circle has no longer axis; next to one, the eigenvector may underflow.
        const float scale = length / std::sqrt(direction.length2());
        axis = std::isfinite(scale) ? direction * scale : V2f(length, 0.0F);
    }

    float length = 0.0F;  // The longer diameter.
    float width = 0.0F;
    V2f axis;  // The longer diameter as a vector.
};

// Beyond this, a float cannot distinguish the texels of an image.
bool in_range(const V2f& v) {
    constexpr float farthest = MipPyramid::max_coordinate;
    return std::abs(v.x) < farthest && std::abs(v.y) < farthest;
}

int floor_of(float value) {
    const int truncated = static_cast<int>(value);
    return truncated - (value < static_cast<float>(truncated) ? 1 : 0);
}

// Two neighbouring texels of a row or column, and the weight of the second.
struct Neighbours {
    Neighbours(float position, int count, scene::Wrap wrap, bool interpolated) {
        const bool repeats = wrap == scene::Wrap::repeat;
        const float x = wrapped(position, wrap) * static_cast<float>(count) - 0.5F;
        const int below = floor_of(x);
        weight = x - static_cast<float>(below);
        first = below >= 0 ? below : repeats ? count - 1 : 0;
        second = below + 1 < count ? below + 1 : repeats ? 0 : count - 1;
        if (!interpolated) {
            first = second = weight < 0.5F ? first : second;
        }
    }

    // From 0 to 1.
    static float wrapped(float position, scene::Wrap wrap) {
        if (wrap == scene::Wrap::clamp) {
            return std::clamp(position, 0.0F, 1.0F);
        }
        if (wrap == scene::Wrap::repeat) {
            return position - static_cast<float>(floor_of(position));
        }
        const float in_period = position - 2.0F * static_cast<float>(floor_of(0.5F * position));
        return in_period > 1.0F ? 2.0F - in_period : in_period;
    }

    int first;
    int second;
    float weight;
};

}  // namespace

MipPyramid::MipPyramid(const TextureReader& image, const scene::Texture& texture, TexelBlock texels)
    : levels_(levels_of(image)),
      wrap_u_(texture.wrap_u),
      wrap_v_(texture.wrap_v),
      interpolated_(texture.interpolated),
      color_(&ByteScale::of(image.encoding())),
      alpha_(&ByteScale::of(TextureEncoding::linear)),
      has_bytes_(image.has_bytes()),
      texels_(std::move(texels)) {
    set_byte_levels();
}

void MipPyramid::set_byte_levels() {
    constexpr auto largest = static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max());
    if (!has_bytes_ || levels_.back().first >= largest) {
        return;
    }
    texture_lanes::ByteLevels& made = byte_levels_.emplace();
    made.width = levels_.front().width;
    made.height = levels_.front().height;
    made.last = static_cast<std::int32_t>(levels_.size() - 1);
    std::transform(levels_.begin(), levels_.end(), made.first.begin(),
                   [](const Level& level) { return static_cast<std::int32_t>(level.first); });
    made.wrap_u = wrap_u_;
    made.wrap_v = wrap_v_;
    made.interpolated = interpolated_;
}

std::vector<MipPyramid::Level> MipPyramid::levels_of(const TextureReader& image) {
    std::vector<Level> levels{
        {static_cast<int>(image.width()), static_cast<int>(image.height()), 0}};
    while (levels.back().width > 1 || levels.back().height > 1) {
        const Level& above = levels.back();
        levels.push_back({halved(above.width), halved(above.height),
                          above.first + static_cast<std::size_t>(above.width) *
                                            static_cast<std::size_t>(above.height)});
    }
    return levels;
}

std::size_t MipPyramid::bytes(const TextureReader& image) {
    return (levels_of(image).back().first + 1) *
           (image.has_bytes() ? sizeof(ByteTexel) : sizeof(HalfTexel));
}

Result<MipPyramid> MipPyramid::read(TextureReader& image, const scene::Texture& texture,
                                    SpillFile* file) {
    const std::size_t size = bytes(image);
    MipPyramid made(image, texture, TexelBlock(size));
    const auto failure = image.has_bytes() ? made.fill(image, ByteCodec{*made.color_, *made.alpha_})
                                           : made.fill(image, HalfCodec{});
    if (failure) {
        return *failure;
    }
    if (file != nullptr) {
        Result<TexelBlock> kept = file->keep(made.texels_);
        if (!kept) {
            return std::move(kept.diagnostics);
        }
        made.texels_ = std::move(*kept);
    }
    return made;
}

template <class Codec>
std::optional<Diagnostic> MipPyramid::fill(TextureReader& image, const Codec& codec) {
    using Texel = typename Codec::Texel;
    const std::span texels(reinterpret_cast<Texel*>(texels_.data()), levels_.back().first + 1);
    const std::size_t width = image.width();
    constexpr std::size_t rows_at_once = 64;
    for (std::size_t y = 0; y < image.height(); y += rows_at_once) {
        const std::size_t end = std::min(y + rows_at_once, image.height());
        const std::span rows = texels.subspan(y * width, (end - y) * width);
        if (auto failure = image.read_rows(y, end, rows)) {
            return failure;
        }
    }
    std::vector<Float4> above;
    std::vector<Float4> line(width);
    for (std::size_t level = 1; level < levels_.size(); ++level) {
        const Level& from = levels_[level - 1];
        const auto row_width = static_cast<std::size_t>(from.width);
        // The image itself is decoded row by row.
        const auto row = [&](std::size_t y) -> std::span<const Float4> {
            if (level > 1) {
                return std::span(above).subspan(y * row_width, row_width);
            }
            std::transform(texels.begin() + static_cast<std::ptrdiff_t>(y * width),
                           texels.begin() + static_cast<std::ptrdiff_t>((y + 1) * width),
                           line.begin(), [&](const Texel& texel) { return codec.decode(texel); });
            return line;
        };
        std::vector<Float4> made = halving(from.width, from.height, row);
        std::transform(made.begin(), made.end(),
                       texels.begin() + static_cast<std::ptrdiff_t>(levels_[level].first),
                       [&](const Float4& value) { return codec.encode(value); });
        above = std::move(made);
    }
    return std::nullopt;
}

Color4f MipPyramid::mean(const TextureFootprint& footprint) const {
    if (!in_range(footprint.at)) {
        return {1.0F, 1.0F, 1.0F, 1.0F};
    }
    return mean_within(in_range(footprint.along_x) && in_range(footprint.along_y)
                           ? footprint
                           : TextureFootprint{footprint.at, V2f(0.0F), V2f(0.0F)});
}

void MipPyramid::set_means(const texture_lanes::Footprints& footprints,
                           texture_lanes::Colors& colors) const {
    if (byte_levels_) {
        texture_lanes::set_means(*byte_levels_, texels_, *color_, footprints, colors);
        return;
    }
    for (std::size_t lane = 0; lane < texture_lanes::lane_count; ++lane) {
        const Color4f color = mean({{footprints.at_u[lane], footprints.at_v[lane]},
                                    {footprints.along_x_u[lane], footprints.along_x_v[lane]},
                                    {footprints.along_y_u[lane], footprints.along_y_v[lane]}});
        colors.red[lane] = color.r;
        colors.green[lane] = color.g;
        colors.blue[lane] = color.b;
    }
}

Color4f MipPyramid::mean_within(const TextureFootprint& footprint) const {
    return has_bytes_ ? mean(footprint, ByteCodec{*color_, *alpha_}) : mean(footprint, HalfCodec{});
}

// The probes lie at equal distances on the longer axis of the footprint. Each is as wide as the
// footprint, but at least as their distance, so that there are no gaps.
template <class Codec>
Color4f MipPyramid::mean(const TextureFootprint& footprint, const Codec& codec) const {
    using Texel = typename Codec::Texel;
    const auto bilinear = [&](const Level& level, const V2f& at) {
        const bool interpolated = interpolated_ || &level != &levels_.front();
        const Neighbours x(at.x, level.width, wrap_u_, interpolated);
        const Neighbours y(at.y, level.height, wrap_v_, interpolated);
        const auto mixed = [&](int row) {
            const std::size_t begin =
                level.first + static_cast<std::size_t>(row) * static_cast<std::size_t>(level.width);
            const auto decoded = [&](int column) {
                return codec.decode(texels_.at<Texel>(begin + static_cast<std::size_t>(column)));
            };
            const Float4 left = decoded(x.first);
            return left + x.weight * (decoded(x.second) - left);
        };
        const Float4 top = mixed(y.first);
        return top + y.weight * (mixed(y.second) - top);
    };

    const Level& image = levels_.front();
    const V2f size(static_cast<float>(image.width), static_cast<float>(image.height));
    const Ellipse ellipse(footprint.along_x * size, footprint.along_y * size);
    const float aspect =
        std::min(ellipse.length / std::max(ellipse.width, 1.0F), static_cast<float>(max_probes));
    const int probes = std::max(static_cast<int>(aspect + 0.7F), 1);
    const float spacing = 1.0F / static_cast<float>(probes);
    const float width = std::max({ellipse.width, ellipse.length * spacing, 1.0F});

    // Level n has texels with a side of 2^n. The width is 2^n times 1 + the share of the next
    // level, which are the exponent and the fraction of the number.
    const auto bits = std::bit_cast<std::uint32_t>(width);
    std::size_t level = (bits >> 23U) - 127U;
    float next = std::bit_cast<float>((bits & 0x007fffffU) | 0x3f800000U) - 1.0F;
    if (level + 1 >= levels_.size()) {
        level = levels_.size() - 1;
        next = 0.0F;
    }
    const V2f step = spacing * ellipse.axis / size;
    V2f at = footprint.at - 0.5F * static_cast<float>(probes - 1) * step;
    Float4 sum{};
    for (int probe = 0; probe < probes; ++probe, at += step) {
        const Float4 sharper = bilinear(levels_[level], at);
        sum +=
            next > 0.0F ? sharper + next * (bilinear(levels_[level + 1], at) - sharper) : sharper;
    }
    sum *= spacing;
    return {sum[0], sum[1], sum[2], sum[3]};
}

}  // namespace balcony::render

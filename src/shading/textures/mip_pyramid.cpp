// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "shading/textures/mip_pyramid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

#include "balcony/progress.hpp"
#include "shading/textures/texture_look_up.hpp"

namespace balcony::render {

namespace {

using Imath::Color4f;

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

constexpr std::size_t halved(std::size_t side) { return std::max<std::size_t>(side / 2, 1); }

// The shares of neighbouring texels of a row or column in a texel of its halving. If the number of
// texels is odd, it covers a little more than two.
struct Shares {
    std::size_t first = 0;
    std::array<float, 3> parts{};
};

std::vector<Shares> shares_of(std::size_t count) {
    std::vector<Shares> all(halved(count));
    const double width = static_cast<double>(count) / static_cast<double>(all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        const double begin = static_cast<double>(i) * width;
        all[i].first =
            std::min(static_cast<std::size_t>(begin), std::max<std::size_t>(count, 3) - 3);
        for (std::size_t k = 0; k < all[i].parts.size(); ++k) {
            const auto left = static_cast<double>(all[i].first + k);
            const double overlap = std::min(begin + width, left + 1.0) - std::max(begin, left);
            all[i].parts[k] = static_cast<float>(std::max(overlap, 0.0) / width);
        }
    }
    return all;
}

// Halves an image whose rows come one after the other.
class Halving {
public:
    Halving(std::size_t width, std::size_t height)
        : columns_(shares_of(width)),
          rows_(shares_of(height)),
          sum_(width),
          made_(columns_.size()),
          is_even_(width % 2 == 0) {}

    // Takes the next row, and calls done(row) for each row of the halved image that it completes.
    template <class Done>
    void take(std::span<const Float4> row, const Done& done) {
        const std::size_t y = next_++;
        // A row may be part of two, the last of one and the first of the next.
        while (made_rows_ < rows_.size()) {
            const Shares& rows = rows_[made_rows_];
            if (y < rows.first) {
                return;
            }
            const float part = rows.parts[y - rows.first];
            for (std::size_t x = 0; part > 0.0F && x < sum_.size(); ++x) {
                sum_[x] += part * row[x];
            }
            const bool goes_on = std::any_of(rows.parts.begin() + (y - rows.first) + 1,
                                             rows.parts.end(), [](float p) { return p > 0.0F; });
            if (goes_on) {
                return;
            }
            halve_sum();
            ++made_rows_;
            done(std::span<const Float4>(made_));
        }
    }

private:
    void halve_sum() {
        if (is_even_) {
            for (std::size_t x = 0; x < made_.size(); ++x) {
                made_[x] = 0.5F * sum_[2 * x] + 0.5F * sum_[2 * x + 1];
            }
        } else {
            for (std::size_t x = 0; x < made_.size(); ++x) {
                made_[x] = Float4{};
                for (std::size_t k = 0; k < columns_[x].parts.size(); ++k) {
                    const std::size_t column = std::min(columns_[x].first + k, sum_.size() - 1);
                    made_[x] += columns_[x].parts[k] * sum_[column];
                }
            }
        }
        std::fill(sum_.begin(), sum_.end(), Float4{});
    }

    std::vector<Shares> columns_;
    std::vector<Shares> rows_;
    std::vector<Float4> sum_;   // Of the rows that the next halved row covers.
    std::vector<Float4> made_;  // A halved row.
    std::size_t next_ = 0;
    std::size_t made_rows_ = 0;
    bool is_even_;
};

// ----------------------------------------------------------------------------------- look-ups

// The texels of a pyramid.
template <class Codec>
class PyramidTexels {
public:
    PyramidTexels(std::span<const std::size_t> first, const TexelBlock& texels, const Codec& codec)
        : first_(first), texels_(texels), codec_(codec) {}

    static Float4 black() { return Float4{}; }
    static Float4 white() { return Float4{1.0F, 1.0F, 1.0F, 1.0F}; }

    [[nodiscard]] auto rows(int level, int width, const TexelPair& columns) const {
        return [this, first = first_[static_cast<std::size_t>(level)],
                width = static_cast<std::size_t>(width), columns](int number) {
            const std::size_t begin = first + static_cast<std::size_t>(number) * width;
            return std::pair(decoded(begin, columns.first), decoded(begin, columns.second));
        };
    }

private:
    [[nodiscard]] Float4 decoded(std::size_t begin, int column) const {
        return codec_.decode(
            texels_.at<typename Codec::Texel>(begin + static_cast<std::size_t>(column)));
    }

    std::span<const std::size_t> first_;  // The indices of the first texels of levels.
    const TexelBlock& texels_;
    const Codec& codec_;
};

}  // namespace

MipPyramid::MipPyramid(const TextureReader& image, const scene::Texture& texture, TexelBlock texels)
    : first_(first_texels(image)),
      color_(&ByteScale::of(image.encoding())),
      alpha_(&ByteScale::of(TextureEncoding::linear)),
      has_bytes_(image.has_bytes()),
      texels_(std::move(texels)) {
    constexpr auto largest = static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max());
    image_.width = static_cast<std::int32_t>(image.width());
    image_.height = static_cast<std::int32_t>(image.height());
    image_.last = static_cast<std::int32_t>(first_.size() - 1);
    image_.wrap_u = texture.wrap_u;
    image_.wrap_v = texture.wrap_v;
    image_.interpolated = texture.interpolated;
    fits_lanes_ = has_bytes_ && first_.back() < largest;
    if (fits_lanes_) {
        std::transform(first_.begin(), first_.end(), image_.first.begin(),
                       [](std::size_t first) { return static_cast<std::int32_t>(first); });
    }
}

std::vector<std::size_t> MipPyramid::first_texels(const TextureReader& image) {
    std::vector<std::size_t> first{0};
    std::size_t width = image.width();
    std::size_t height = image.height();
    while (width > 1 || height > 1) {
        first.push_back(first.back() + width * height);
        width = halved(width);
        height = halved(height);
    }
    return first;
}

std::size_t MipPyramid::bytes(const TextureReader& image) {
    return (first_texels(image).back() + 1) *
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
    const std::span texels(reinterpret_cast<Texel*>(texels_.data()), first_.back() + 1);
    const std::size_t width = image.width();
    const std::size_t height = image.height();
    std::vector<Halving> halvings;
    std::vector<Texel*> ends;  // Of what each level has.
    for (std::size_t level = 1; level < first_.size(); ++level) {
        halvings.emplace_back(std::max<std::size_t>(width >> (level - 1), 1),
                              std::max<std::size_t>(height >> (level - 1), 1));
        ends.push_back(&texels[first_[level]]);
    }
    const auto halve = [&](const auto& self, std::size_t level,
                           std::span<const Float4> row) -> void {
        if (level == halvings.size()) {
            return;
        }
        halvings[level].take(row, [&](std::span<const Float4> made) {
            ends[level] = std::transform(made.begin(), made.end(), ends[level],
                                         [&](const Float4& value) { return codec.encode(value); });
            self(self, level + 1, made);
        });
    };
    constexpr std::size_t rows_at_once = 64;
    std::vector<Float4> decoded(width);
    for (std::size_t y = 0; y < height; y += rows_at_once) {
        const std::size_t end = std::min(y + rows_at_once, height);
        const std::span rows = texels.subspan(y * width, (end - y) * width);
        if (auto failure = image.read_rows(y, end, rows)) {
            return failure;
        }
        for (std::size_t row = 0; row < rows.size(); row += width) {
            std::transform(&rows[row], &rows[row] + width, decoded.begin(),
                           [&](const Texel& texel) { return codec.decode(texel); });
            halve(halve, 0, decoded);
        }
    }
    return std::nullopt;
}

Color4f MipPyramid::mean(const TextureFootprint& footprint) const {
    const auto mean = [&](const auto& codec) {
        const Float4 found = mean_over(image_, PyramidTexels(first_, texels_, codec), footprint);
        return Color4f(found[0], found[1], found[2], found[3]);
    };
    return has_bytes_ ? mean(ByteCodec{*color_, *alpha_}) : mean(HalfCodec{});
}

void MipPyramid::set_means(const texture_lanes::Footprints& footprints, LaneVectors& colors) const {
    if (fits_lanes_) {
        texture_lanes::set_means(image_, texels_, *color_, footprints, colors);
        return;
    }
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
        const Color4f color = mean(
            {footprints.at.of(lane), footprints.along_x.of(lane), footprints.along_y.of(lane)});
        colors.set(lane, {color.r, color.g, color.b});
    }
}

}  // namespace balcony::render

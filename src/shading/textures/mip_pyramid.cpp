// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "shading/textures/mip_pyramid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <new>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

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

// A row of an image, by column.
struct RowOfValues {
    std::span<const Float4> values;
    const Float4& operator()(std::size_t x) const { return values[x]; }
};

// Halves an image whose rows come one after the other.
class Halving {
public:
    Halving(std::size_t width, std::size_t height)
        : columns_(shares_of(width)),
          rows_(shares_of(height)),
          sum_(width),
          made_(columns_.size()),
          is_even_(width % 2 == 0) {}

    // Takes the next row, whose texels are row(x), and calls done(row) for each row of the halved
    // image that it completes.
    template <class Row, class Done>
    void take(const Row& row, const Done& done) {
        const std::size_t y = next_++;
        // A row may be part of two, the last of one and the first of the next.
        while (made_rows_ < rows_.size()) {
            const Shares& rows = rows_[made_rows_];
            if (y < rows.first) {
                return;
            }
            const float part = rows.parts[y - rows.first];
            for (std::size_t x = 0; part > 0.0F && x < sum_.size(); ++x) {
                sum_[x] += part * row(x);
            }
            const bool goes_on = std::any_of(rows.parts.begin() + (y - rows.first) + 1,
                                             rows.parts.end(), [](float p) { return p > 0.0F; });
            if (goes_on) {
                return;
            }
            halve_sum();
            ++made_rows_;
            done(RowOfValues{made_});
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

// Reads an image, some rows at a time, to rows_at(y, count), and calls visit(y, rows). Ends with
// the first failure of either.
template <class RowsAt, class Visit>
std::optional<Diagnostic> for_each_rows(TextureReader& image, RowsAt rows_at, const Visit& visit) {
    constexpr std::size_t at_once = 64;
    std::optional<Diagnostic> failure;
    for (std::size_t y = 0; !failure && y < image.height(); y += at_once) {
        const std::size_t end = std::min(y + at_once, image.height());
        const auto rows = rows_at(y, end - y);
        failure = image.read_rows(y, end, rows);
        if (!failure) {
            failure = visit(y, rows);
        }
    }
    return failure;
}

// Memory for a few rows at a time, for for_each_rows().
template <class Texel>
class RowBuffer {
public:
    explicit RowBuffer(std::size_t width) : width_(width) {}
    std::span<Texel> operator()(std::size_t, std::size_t count) {
        texels_.resize(count * width_);
        return texels_;
    }

private:
    std::size_t width_;
    std::vector<Texel> texels_;
};

std::vector<std::size_t> first_texels(const TextureReader& image) {
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

// Reads the image as for_each_rows(), and sets the other levels, which are one after the other.
template <class Codec, class RowsAt>
std::optional<Diagnostic> read_levels(TextureReader& image, const Codec& codec,
                                      std::span<const std::size_t> first,
                                      typename Codec::Texel* others, RowsAt rows_at) {
    using Texel = typename Codec::Texel;
    const std::size_t width = image.width();
    const std::size_t height = image.height();
    std::vector<Halving> halvings;
    std::vector<Texel*> ends;  // Of what each level has.
    for (std::size_t level = 1; level < first.size(); ++level) {
        halvings.emplace_back(std::max<std::size_t>(width >> (level - 1), 1),
                              std::max<std::size_t>(height >> (level - 1), 1));
        ends.push_back(others + (first[level] - first[1]));
    }
    const auto halve = [&](const auto& self, std::size_t level, const auto& row) -> void {
        if (level == halvings.size()) {
            return;
        }
        halvings[level].take(row, [&](const RowOfValues& made) {
            ends[level] = std::transform(made.values.begin(), made.values.end(), ends[level],
                                         [&](const Float4& value) { return codec.encode(value); });
            self(self, level + 1, made);
        });
    };
    return for_each_rows(
        image, std::move(rows_at),
        [&](std::size_t, std::span<const Texel> rows) -> std::optional<Diagnostic> {
            for (std::size_t begin = 0; begin < rows.size(); begin += width) {
                halve(halve, 0,
                      [&codec, row = &rows[begin]](std::size_t x) { return codec.decode(row[x]); });
            }
            return std::nullopt;
        });
}

// Writes the image itself, which is read again, to the first bytes of a block of a file.
template <class Texel>
class ImageFill {
public:
    ImageFill(const TextureReader& image, const scene::Texture& texture, const SpillFile& file)
        : texture_(texture),
          encoding_(image.encoding()),
          width_(image.width()),
          height_(image.height()),
          file_(&file) {}

    std::optional<Diagnostic> operator()(const TexelBlock& block) const {
        std::optional<Diagnostic> failure;
        try {
            failure = write(block);
        } catch (const std::bad_alloc&) {
            failure = error("it needs more memory than available");
        }
        if (failure) {
            failure->message = fmt::format("texture '{}' cannot be read again: {}", texture_.name,
                                           failure->message);
        }
        return failure;
    }

private:
    [[nodiscard]] std::optional<Diagnostic> write(const TexelBlock& block) const {
        Result<TextureReader> image = TextureReader::open(texture_, encoding_);
        if (!image) {
            return image.diagnostics.front();
        }
        if (image->width() != width_ || image->height() != height_ ||
            image->has_bytes() != std::is_same_v<Texel, ByteTexel>) {
            return error("it has changed");
        }
        return for_each_rows(
            *image, RowBuffer<Texel>(width_), [&](std::size_t y, std::span<const Texel> rows) {
                return file_->write(block, y * width_ * sizeof(Texel), std::as_bytes(rows));
            });
    }

    scene::Texture texture_;
    TextureEncoding encoding_;
    std::size_t width_, height_;
    const SpillFile* file_;
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

MipPyramid::MipPyramid(const TextureReader& image, const scene::Texture& texture,
                       std::vector<std::size_t> first, TexelBlock texels)
    : first_(std::move(first)),
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
                       [](std::size_t one) { return static_cast<std::int32_t>(one); });
    }
}

std::size_t MipPyramid::bytes(const TextureReader& image) {
    return (first_texels(image).back() + 1) *
           (image.has_bytes() ? sizeof(ByteTexel) : sizeof(HalfTexel));
}

Result<MipPyramid> MipPyramid::read(TextureReader& image, const scene::Texture& texture,
                                    SpillFile* file) {
    const auto read = [&](const auto& codec) {
        return file == nullptr ? read_to_memory(image, texture, codec)
                               : read_to_file(image, texture, codec, *file);
    };
    return image.has_bytes() ? read(ByteCodec{ByteScale::of(image.encoding()),
                                              ByteScale::of(TextureEncoding::linear)})
                             : read(HalfCodec{});
}

template <class Codec>
Result<MipPyramid> MipPyramid::read_to_memory(TextureReader& image, const scene::Texture& texture,
                                              const Codec& codec) {
    MipPyramid made(image, texture, first_texels(image), TexelBlock(bytes(image)));
    auto* const texels = reinterpret_cast<typename Codec::Texel*>(made.texels_.data());
    const auto rows_at = [&](std::size_t y, std::size_t count) {
        return std::span(texels + y * image.width(), count * image.width());
    };
    auto failure =
        read_levels(image, codec, made.first_, texels + image.width() * image.height(), rows_at);
    return failure ? Result<MipPyramid>(*failure) : Result<MipPyramid>(std::move(made));
}

// The image and the other levels have no chunk in common.
template <class Codec>
Result<MipPyramid> MipPyramid::read_to_file(TextureReader& image, const scene::Texture& texture,
                                            const Codec& codec, SpillFile& file) {
    using Texel = typename Codec::Texel;
    constexpr std::size_t in_chunk = TexelBlock::chunk_bytes / sizeof(Texel);
    const std::size_t in_image = image.width() * image.height();
    const std::size_t moved = (in_chunk - in_image % in_chunk) % in_chunk;
    std::vector<std::size_t> first = first_texels(image);
    std::vector<Texel> others(first.back() + 1 - (first.size() > 1 ? in_image : 1));
    std::transform(first.begin() + 1, first.end(), first.begin() + 1,
                   [moved](std::size_t one) { return one + moved; });
    Result<TexelBlock> block =
        file.reserve((first.back() + 1) * sizeof(Texel), in_image * sizeof(Texel),
                     ImageFill<Texel>(image, texture, file));
    if (!block) {
        return std::move(block.diagnostics);
    }
    auto failure = read_levels(image, codec, first, others.data(), RowBuffer<Texel>(image.width()));
    if (!failure) {
        failure = file.write(*block, (in_image + moved) * sizeof(Texel),
                             std::as_bytes(std::span(others)));
    }
    return failure ? Result<MipPyramid>(*failure)
                   : Result<MipPyramid>(
                         MipPyramid(image, texture, std::move(first), std::move(*block)));
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

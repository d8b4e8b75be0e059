// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "film/denoise/feature_filter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <tbb/enumerable_thread_specific.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "base/fork_and_join.hpp"
#include "film/sums/tile_image.hpp"

namespace balcony::render {

namespace {

// The weights of non-local means with known variance: how similar the patches around two pixels
// are, beyond the difference that noise explains (Rousselle, Knaus and Zwicker, "Adaptive
// Rendering with Non-Local Means Filtering", 2012, equations 4 to 6). Belongs to one thread.
class PatchWeights {
public:
    static constexpr std::size_t patch_radius = 3;

    // A larger tolerance takes more differences for noise.
    PatchWeights(const NoisyImage& image, float tolerance) : image_(image), tolerance_(tolerance) {}

    // The weights, from 0 to 1, of the pixels at an offset from those of a tile, row by row. The
    // offset is at most NoisyImage::margin - patch_radius.
    void find(const Region& tile, std::ptrdiff_t right, std::ptrdiff_t down,
              std::vector<float>& weights);

private:
    const NoisyImage& image_;
    float tolerance_;
    std::vector<float> distances_;  // Of pixels; kept for its memory.
    std::vector<float> sums_;       // Over the rows of patches.
};

void PatchWeights::find(const Region& tile, std::ptrdiff_t right, std::ptrdiff_t down,
                        std::vector<float>& weights) {
    constexpr std::size_t side = 2 * patch_radius + 1;
    const std::size_t width = tile.width + 2 * patch_radius;
    const std::size_t height = tile.height + 2 * patch_radius;
    const auto stride = static_cast<std::ptrdiff_t>(image_.stride());
    const std::ptrdiff_t offset = down * stride + right;
    distances_.assign(width * height, 0.0F);
    const float spread = tolerance_ * tolerance_;
    for (std::size_t channel = 0; channel < image_.channels(); ++channel) {
        for (std::size_t y = 0; y < height; ++y) {
            const std::size_t first =
                image_.index(tile.x, tile.y + y) - patch_radius * image_.stride() - patch_radius;
            const float* value = image_.values(channel).data() + first;
            const float* variance = image_.variances(channel).data() + first;
            float* distance = distances_.data() + y * width;
            for (std::size_t x = 0; x < width; ++x) {
                const float here = variance[x];
                const float there = *(variance + x + offset);
                const float difference = value[x] - *(value + x + offset);
                distance[x] += (difference * difference - (here + std::min(here, there))) /
                               (1e-10F + spread * (here + there));
            }
        }
    }
    sums_.resize(tile.width * height);
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < tile.width; ++x) {
            float sum = 0.0F;
            for (std::size_t i = 0; i < side; ++i) {
                sum += distances_[y * width + x + i];
            }
            sums_[y * tile.width + x] = sum;
        }
    }
    const float mean = 1.0F / static_cast<float>(side * side * image_.channels());
    weights.resize(tile.size());
    for (std::size_t y = 0; y < tile.height; ++y) {
        for (std::size_t x = 0; x < tile.width; ++x) {
            float sum = 0.0F;
            for (std::size_t i = 0; i < side; ++i) {
                sum += sums_[(y + i) * tile.width + x];
            }
            weights[y * tile.width + x] = std::exp(-std::max(mean * sum, 0.0F));
        }
    }
}

constexpr std::size_t tile_side = 32;

// Calls visit(tile) for the tiles of an image, in parallel. Tiles that are visited at the same time
// are at least one tile apart, so a visit may also change pixels nearby; the order of the changes
// of a pixel is always the same.
template <class Visit>
void for_each_tile(const NoisyImage& image, std::size_t threads, const Visit& visit) {
    const std::size_t columns = (image.width() + tile_side - 1) / tile_side;
    const std::size_t rows = (image.height() + tile_side - 1) / tile_side;
    const auto all = static_cast<std::size_t>(tbb::info::default_concurrency());
    tbb::task_arena arena(static_cast<int>(threads == 0 ? all : std::min(threads, all)));
    for (std::size_t group = 0; group < 4; ++group) {
        std::vector<Region> tiles;
        for (std::size_t row = group / 2; row < rows; row += 2) {
            for (std::size_t column = group % 2; column < columns; column += 2) {
                const std::size_t x = column * tile_side;
                const std::size_t y = row * tile_side;
                tiles.push_back({x, y, std::min(tile_side, image.width() - x),
                                 std::min(tile_side, image.height() - y)});
            }
        }
        fork_and_join::before_all();
        arena.execute([&] {
            tbb::parallel_for(std::size_t{0}, tiles.size(), [&](std::size_t i) {
                fork_and_join::before_each();
                visit(tiles[i]);
                fork_and_join::after_each();
            });
        });
        fork_and_join::after_all();
    }
}

// An offset to a neighbour, in pixels.
struct Offset {
    std::ptrdiff_t right = 0;
    std::ptrdiff_t down = 0;
};

std::vector<Offset> offsets_within(std::ptrdiff_t radius) {
    std::vector<Offset> offsets;
    for (std::ptrdiff_t down = -radius; down <= radius; ++down) {
        for (std::ptrdiff_t right = -radius; right <= radius; ++right) {
            offsets.push_back({right, down});
        }
    }
    return offsets;
}

bool inside(const NoisyImage& image, std::size_t x, std::size_t y, const Offset& offset) {
    const auto within = [](std::size_t at, std::ptrdiff_t step, std::size_t side) {
        const std::ptrdiff_t moved = static_cast<std::ptrdiff_t>(at) + step;
        return moved >= 0 && moved < static_cast<std::ptrdiff_t>(side);
    };
    return within(x, offset.right, image.width()) && within(y, offset.down, image.height());
}

// ---------------------------------------------------------------------------------- regression

// A weighted linear fit of three values by features, which are given relative to the pixel at its
// centre: normal equations, with a ridge that keeps slopes small where the data do not tell.
template <std::size_t Count>
class Fit {
public:
    static constexpr std::size_t terms = Count + 1;  // A constant and the features.
    using Terms = std::array<float, terms>;

    void add(float weight, const Terms& at, const std::array<float, 3>& value) {
        for (std::size_t i = 0; i < terms; ++i) {
            const float weighted = weight * at[i];
            for (std::size_t k = 0; k <= i; ++k) {
                matrix_[i][k] += weighted * at[k];
            }
            for (std::size_t c = 0; c < 3; ++c) {
                right_[c][i] += weighted * value[c];
            }
        }
    }

    // Cholesky's decomposition; afterwards, value() gives the fit.
    void solve() {
        constexpr float ridge = 0.01F;
        constexpr float samples = 0.05F;  // Of which the ridge stands for, at least.
        const float total = matrix_[0][0];
        for (std::size_t i = 1; i < terms; ++i) {
            matrix_[i][i] += ridge * total + samples;
        }
        for (std::size_t i = 0; i < terms; ++i) {
            for (std::size_t k = 0; k <= i; ++k) {
                float rest = matrix_[i][k];
                for (std::size_t j = 0; j < k; ++j) {
                    rest -= matrix_[i][j] * matrix_[k][j];
                }
                matrix_[i][k] = i == k ? std::sqrt(std::max(rest, 1e-6F)) : rest / matrix_[k][k];
            }
        }
        for (Terms& right : right_) {
            for (std::size_t i = 0; i < terms; ++i) {
                for (std::size_t k = 0; k < i; ++k) {
                    right[i] -= matrix_[i][k] * right[k];
                }
                right[i] /= matrix_[i][i];
            }
            for (std::size_t i = terms; i-- > 0;) {
                for (std::size_t k = i + 1; k < terms; ++k) {
                    right[i] -= matrix_[k][i] * right[k];
                }
                right[i] /= matrix_[i][i];
            }
        }
    }

    [[nodiscard]] float value(const Terms& at, std::size_t channel) const {
        float sum = 0.0F;
        for (std::size_t i = 0; i < terms; ++i) {
            sum += right_[channel][i] * at[i];
        }
        return sum;
    }

private:
    std::array<Terms, terms> matrix_{};
    std::array<Terms, 3> right_{};  // By channel; after solve(), the coefficients.
};

constexpr std::ptrdiff_t radius = 9;
constexpr std::size_t feature_count = 9;
using FeatureFit = Fit<feature_count>;

// Filters the tiles of an image; belongs to one thread.
class Regression {
public:
    Regression(const NoisyImage& color, const NoisyImage& features)
        : color_(color), features_(features), similarity_(color, tolerance) {}

    // Adds the fits around the pixels of a tile to the sums, which have a weight as fourth channel.
    void add(const Region& tile, NoisyImage& sums) {
        weights_.resize(offsets_.size());
        for (std::size_t o = 0; o < offsets_.size(); ++o) {
            similarity_.find(tile, offsets_[o].right, offsets_[o].down, weights_[o]);
        }
        // Each fit serves all pixels nearby, so every second one is enough.
        constexpr std::size_t step = 2;
        for (std::size_t y = 0; y < tile.height; y += step) {
            for (std::size_t x = 0; x < tile.width; x += step) {
                gather(tile, x, y);
                if (!neighbours_.empty()) {
                    fit(sums);
                }
            }
        }
    }

private:
    static constexpr float tolerance = 0.5F;

    struct Neighbour {
        std::size_t index = 0;
        float weight = 0.0F;
        FeatureFit::Terms terms{};
    };

    // The similar pixels, with their features relative to those of the pixel, from -1 to 1.
    void gather(const Region& tile, std::size_t x, std::size_t y) {
        constexpr float least = 1e-3F;
        const std::size_t here = color_.index(tile.x + x, tile.y + y);
        neighbours_.clear();
        for (std::size_t o = 0; o < offsets_.size(); ++o) {
            const float weight = weights_[o][y * tile.width + x];
            if (weight > least && inside(color_, tile.x + x, tile.y + y, offsets_[o])) {
                const std::ptrdiff_t offset =
                    offsets_[o].down * static_cast<std::ptrdiff_t>(color_.stride()) +
                    offsets_[o].right;
                neighbours_.push_back({here + static_cast<std::size_t>(offset), weight, {1.0F}});
            }
        }
        for (std::size_t f = 0; f < feature_count; ++f) {
            const std::vector<float>& feature = features_.values(f);
            float largest = 0.0F;
            for (Neighbour& one : neighbours_) {
                one.terms[f + 1] = feature[one.index] - feature[here];
                largest = std::max(largest, std::abs(one.terms[f + 1]));
            }
            // Differences that are only rounding are none.
            const bool differs = largest > 1e-4F * std::abs(feature[here]) + 1e-6F;
            const float scale = differs ? 1.0F / largest : 0.0F;
            for (Neighbour& one : neighbours_) {
                one.terms[f + 1] *= scale;
            }
        }
    }

    void fit(NoisyImage& sums) const {
        FeatureFit fit;
        for (const Neighbour& one : neighbours_) {
            fit.add(one.weight, one.terms,
                    {color_.values(0)[one.index], color_.values(1)[one.index],
                     color_.values(2)[one.index]});
        }
        fit.solve();
        // A linear function overshoots where the light has an edge that the features do not show,
        // such as that of a lamp: below 0, even. The light is within that of the similar pixels.
        std::array<float, 3> least, most;
        for (std::size_t c = 0; c < 3; ++c) {
            const auto [low, high] = std::minmax_element(
                neighbours_.begin(), neighbours_.end(),
                [&](const Neighbour& a, const Neighbour& b) {
                    return color_.values(c)[a.index] < color_.values(c)[b.index];
                });
            least[c] = color_.values(c)[low->index];
            most[c] = color_.values(c)[high->index];
        }
        for (const Neighbour& one : neighbours_) {
            for (std::size_t c = 0; c < 3; ++c) {
                sums.values(c)[one.index] +=
                    one.weight * std::clamp(fit.value(one.terms, c), least[c], most[c]);
            }
            sums.values(3)[one.index] += one.weight;
        }
    }

    const NoisyImage& color_;
    const NoisyImage& features_;
    PatchWeights similarity_;
    std::vector<Offset> offsets_ = offsets_within(radius);
    std::vector<std::vector<float>> weights_;  // By offset, then pixel of the tile.
    std::vector<Neighbour> neighbours_;        // Of the pixel at work.
};

}  // namespace

void smooth(NoisyImage& image, float tolerance, std::size_t threads) {
    constexpr std::ptrdiff_t reach = 5;
    const std::vector<Offset> offsets = offsets_within(reach);
    NoisyImage sums(image.width(), image.height(), image.channels() + 1);
    for_each_tile(image, threads, [&](const Region& tile) {
        PatchWeights similarity(image, tolerance);
        std::vector<float> weights;
        for (const Offset& offset : offsets) {
            similarity.find(tile, offset.right, offset.down, weights);
            const std::ptrdiff_t step =
                offset.down * static_cast<std::ptrdiff_t>(image.stride()) + offset.right;
            for_each_pixel(tile, [&](std::size_t i, std::size_t x, std::size_t y) {
                const std::size_t at = image.index(x, y);
                const std::size_t there = at + static_cast<std::size_t>(step);
                for (std::size_t c = 0; c < image.channels(); ++c) {
                    sums.values(c)[at] += weights[i] * image.values(c)[there];
                }
                sums.values(image.channels())[at] += weights[i];
            });
        }
    });
    for_each_pixel(
        {0, 0, image.width(), image.height()}, [&](std::size_t, std::size_t x, std::size_t y) {
            const std::size_t at = image.index(x, y);
            for (std::size_t c = 0; c < image.channels(); ++c) {
                image.values(c)[at] = sums.values(c)[at] / sums.values(image.channels())[at];
            }
        });
    image.continue_beyond_border();
}

NoisyImage regressed(const NoisyImage& color, const NoisyImage& features, std::size_t threads) {
    NoisyImage sums(color.width(), color.height(), 4);
    tbb::enumerable_thread_specific<Regression> workers(
        [&] { return Regression(color, features); });
    for_each_tile(color, threads, [&](const Region& tile) { workers.local().add(tile, sums); });
    NoisyImage result(color.width(), color.height(), 3);
    for_each_pixel(
        {0, 0, color.width(), color.height()}, [&](std::size_t, std::size_t x, std::size_t y) {
            const std::size_t at = color.index(x, y);
            const float weight = sums.values(3)[at];
            for (std::size_t c = 0; c < 3; ++c) {
                // A fit may undershoot, but light is not negative.
                result.values(c)[at] = weight > 0.0F ? std::max(sums.values(c)[at] / weight, 0.0F)
                                                     : color.values(c)[at];
            }
        });
    return result;
}

}  // namespace balcony::render

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/denoise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>

#include <fmt/format.h>

#include "base/stopwatch.hpp"
#include "film/denoise/feature_filter.hpp"
#include "film/denoise/image_denoise_library.hpp"
#include "film/sums/layer_rows.hpp"
#include "film/sums/tile_image.hpp"

namespace balcony::render {

namespace {

constexpr std::array denoiser_rows{
    Named{Denoiser::automatic, "auto", "library where there is one"},
    Named{Denoiser::library, "library", "Open Image Denoise"},
    Named{Denoiser::features, "features", "Balcony's filter, the same on every machine"},
};

Diagnostics check(const Film& film) {
    if (!film.noisy.empty()) {
        return {error(Kind::internal, "the film is denoised already")};
    }
    for (const LayerRow& row : layer_rows()) {
        if (denoise_layers().contains(row.info.id) && !row.complete(film)) {
            return {error(Kind::internal,
                          fmt::format("denoising needs the layer {}, which the film does not have",
                                      row.info.name),
                          "create the film with denoise_layers()")};
        }
    }
    if (film.passes.empty() || *std::min_element(film.passes.begin(), film.passes.end()) < 2) {
        return {error(Kind::usage, "denoising needs at least two samples in each pixel",
                      "render with --samples 2 or more")};
    }
    return {};
}

// Calls visit(x, y, at) for the pixels of a film; `at` is the index in an image of its window.
template <class Visit>
void for_each_pixel_of(const Film& film, const NoisyImage& image, const Visit& visit) {
    for_each_pixel(film.window, [&](std::size_t, std::size_t x, std::size_t y) {
        visit(x, y, image.index(x - film.window.x, y - film.window.y));
    });
}

// A variance that is itself estimated from few samples is smoothed: a pixel that no light path
// found by chance would otherwise count as exact.
void smooth_variances(NoisyImage& image) {
    const auto stride = static_cast<std::ptrdiff_t>(image.stride());
    for (std::size_t c = 0; c < image.channels(); ++c) {
        const std::vector<float> before = image.variances(c);
        for (std::size_t y = 0; y < image.height(); ++y) {
            for (std::size_t x = 0; x < image.width(); ++x) {
                const auto at = static_cast<std::ptrdiff_t>(image.index(x, y));
                float sum = 0.0F;
                for (std::ptrdiff_t down = -1; down <= 1; ++down) {
                    for (std::ptrdiff_t right = -1; right <= 1; ++right) {
                        sum += before[static_cast<std::size_t>(at + down * stride + right)];
                    }
                }
                image.variances(c)[static_cast<std::size_t>(at)] = sum / 9.0F;
            }
        }
    }
    image.continue_beyond_border();
}

NoisyImage color_of(const Film& film) {
    NoisyImage color(film.window.width, film.window.height, 3);
    for_each_pixel_of(film, color, [&](std::size_t x, std::size_t y, std::size_t at) {
        const Color4f light = film.surface_light(x, y);
        const Color4d variance = film.variance(x, y);
        const float lights[] = {light.r, light.g, light.b};
        const double variances[] = {variance.r, variance.g, variance.b};
        for (std::size_t c = 0; c < 3; ++c) {
            color.values(c)[at] = lights[c];
            color.variances(c)[at] = static_cast<float>(variances[c] / film.samples(x, y));
        }
    });
    color.continue_beyond_border();
    smooth_variances(color);
    return color;
}

NoisyImage moments_of(const Film& film, const std::vector<Moments>& moments) {
    NoisyImage feature(film.window.width, film.window.height, 3);
    for_each_pixel_of(film, feature, [&](std::size_t x, std::size_t y, std::size_t at) {
        const Moments& of_pixel = moments[film.index(x, y)];
        const auto samples = static_cast<float>(film.samples(x, y));
        for (int c = 0; c < 3; ++c) {
            const auto channel = static_cast<std::size_t>(c);
            feature.values(channel)[at] = of_pixel.mean[c];
            feature.variances(channel)[at] = of_pixel.squares[c] / (samples * (samples - 1.0F));
        }
    });
    feature.continue_beyond_border();
    return feature;
}

// Albedo, normal and position, each without its own noise.
NoisyImage features_of(const Film& film, std::size_t threads) {
    NoisyImage all(film.window.width, film.window.height, 9);
    std::size_t channel = 0;
    for (const std::vector<Moments>* moments :
         {&film.means.albedo, &film.means.normal, &film.means.position}) {
        NoisyImage feature = moments_of(film, *moments);
        smooth(feature, 1.0F, threads);
        for (std::size_t c = 0; c < 3; ++c) {
            all.values(channel++) = std::move(feature.values(c));
        }
    }
    return all;
}

std::vector<float> interleaved(const NoisyImage& image) {
    std::vector<float> made;
    made.reserve(3 * image.width() * image.height());
    for_each_pixel({0, 0, image.width(), image.height()},
                   [&](std::size_t, std::size_t x, std::size_t y) {
                       for (std::size_t c = 0; c < 3; ++c) {
                           made.push_back(image.values(c)[image.index(x, y)]);
                       }
                   });
    return made;
}

Diagnostics filter_by_library(const Film& film, const ImageDenoiseLibrary& library,
                              NoisyImage& color) {
    std::vector<float> light = interleaved(color);
    std::vector<float> albedo = interleaved(moments_of(film, film.means.albedo));
    std::vector<float> normal = interleaved(moments_of(film, film.means.normal));
    if (Diagnostics found = library.filter(color.width(), color.height(), light, albedo, normal);
        !found.empty()) {
        return found;
    }
    for_each_pixel({0, 0, color.width(), color.height()},
                   [&](std::size_t i, std::size_t x, std::size_t y) {
                       for (std::size_t c = 0; c < 3; ++c) {
                           color.values(c)[color.index(x, y)] = light[3 * i + c];
                       }
                   });
    return {};
}

void store(const NoisyImage& color, Film& film) {
    film.noisy = film.sum;
    if (!film.layer_set.empty()) {
        film.layer_set.insert(LayerId::noisy);
    }
    for_each_pixel_of(film, color, [&](std::size_t x, std::size_t y, std::size_t at) {
        Color4d& sum = film.sum[film.index(x, y)];
        const double samples = film.samples(x, y);
        sum.r = samples * static_cast<double>(color.values(0)[at]);
        sum.g = samples * static_cast<double>(color.values(1)[at]);
        sum.b = samples * static_cast<double>(color.values(2)[at]);
    });
}

}  // namespace

Names<Denoiser> denoisers() { return Names<Denoiser>(denoiser_rows); }

LayerSet denoise_layers() {
    return {LayerId::mean_albedo, LayerId::mean_normal, LayerId::mean_position, LayerId::variance};
}

Result<DenoiseSummary> denoise(Film& film, const DenoiseOptions& options) {
    if (Diagnostics found = check(film); !found.empty()) {
        return found;
    }
    const Stopwatch watch;
    try {
        Diagnostics warnings;
        NoisyImage color = color_of(film);
        const auto library = options.denoiser == Denoiser::features
                                 ? std::nullopt
                                 : ImageDenoiseLibrary::load(options.library);
        if (options.denoiser == Denoiser::library && !library) {
            return error(Kind::environment, "the library Open Image Denoise is not found",
                         "install it (openimagedenoise.org), or use the denoiser features");
        }
        bool done = false;
        if (library) {
            const Diagnostics found = filter_by_library(film, *library, color);
            done = found.empty();
            if (!done && options.denoiser == Denoiser::library) {
                return found;
            }
            for (const Diagnostic& failed : found) {
                warnings.push_back(
                    warning(failed.message + "; Balcony's own filter is used instead"));
            }
        }
        if (!done) {
            color = regressed(color, features_of(film, options.threads), options.threads);
        }
        store(color, film);
        return {DenoiseSummary{done ? library->name() : "Balcony's filter", watch.seconds()},
                std::move(warnings)};
    } catch (const std::bad_alloc&) {
        return error(Kind::environment, "out of memory while denoising",
                     "make the picture smaller");
    }
}

}  // namespace balcony::render

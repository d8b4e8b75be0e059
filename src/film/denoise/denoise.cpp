// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/denoise.hpp"

#include <algorithm>
#include <array>
#include <new>

#include <fmt/format.h>

#include "base/stopwatch.hpp"
#include "film/denoise/image_denoise_library.hpp"
#include "film/denoise/light_filter.hpp"
#include "film/denoise/surface_filter.hpp"
#include "film/sums/layer_rows.hpp"
#include "film/sums/sample_halves.hpp"
#include "film/sums/tile_image.hpp"
#include "images/luminance.hpp"

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

Canvas canvas_of(const Film& film, std::size_t threads) {
    return {film.window.width, film.window.height, threads};
}

// Calls visit(x, y, i) for the pixels of a film; i is the index in a plane.
template <class Visit>
void for_each_pixel_of(const Film& film, const Visit& visit) {
    for_each_pixel(film.window,
                   [&](std::size_t i, std::size_t x, std::size_t y) { visit(x, y, i); });
}

std::array<Plane, 3> planes_of(const Film& film) {
    std::array<Plane, 3> planes;
    planes.fill(Plane(film.window.size()));
    return planes;
}

std::array<Plane, 3> light_of(const Film& film) {
    std::array<Plane, 3> light = planes_of(film);
    for_each_pixel_of(film, [&](std::size_t x, std::size_t y, std::size_t i) {
        const Color4f color = film.surface_light(x, y);
        light[0][i] = color.r;
        light[1][i] = color.g;
        light[2][i] = color.b;
    });
    return light;
}

std::array<Plane, 3> emission_of(const Film& film) {
    std::array<Plane, 3> light = planes_of(film);
    for_each_pixel_of(film, [&](std::size_t x, std::size_t y, std::size_t i) {
        const V3f mean(film.means.emission[i] / film.samples(x, y));
        for (int c = 0; c < 3; ++c) {
            light[static_cast<std::size_t>(c)][i] = mean[c];
        }
    });
    return light;
}

std::array<Plane, 3> means_of(const Film& film, const std::vector<Moments>& moments) {
    std::array<Plane, 3> means = planes_of(film);
    for (std::size_t i = 0; i < moments.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            means[static_cast<std::size_t>(c)][i] = moments[i].mean[c];
        }
    }
    return means;
}

// The means of both halves of the samples, from the sums of the first one and of all.
template <class SumOf>
Halves halves_of(const Film& film, const std::vector<HalfSum>& half_sums, const SumOf& sum_of) {
    Halves halves;
    halves.fill(Plane(film.window.size()));
    for_each_pixel_of(film, [&](std::size_t x, std::size_t y, std::size_t i) {
        const std::uint32_t samples = film.samples(x, y);
        const std::uint32_t first = first_half_of(samples);
        const V3d sum_of_first(half_sums[i].first);
        const V3f mean_of_first(sum_of_first / first);
        const V3f mean_of_rest((sum_of(i) - sum_of_first) / (samples - first));
        for (int c = 0; c < 3; ++c) {
            halves[static_cast<std::size_t>(c)][i] = mean_of_first[c];
            halves[static_cast<std::size_t>(c) + 3][i] = mean_of_rest[c];
        }
    });
    return halves;
}

Plane part_of_first_half(const Film& film) {
    Plane part(film.window.size());
    for_each_pixel_of(film, [&](std::size_t x, std::size_t y, std::size_t i) {
        const std::uint32_t samples = film.samples(x, y);
        part[i] = static_cast<float>(first_half_of(samples)) / static_cast<float>(samples);
    });
    return part;
}

double luminance_of(const std::array<Plane, 3>& light) {
    double sum = 0.0;
    for (std::size_t i = 0; i < light[0].size(); ++i) {
        sum += double{luminance(Color3f(light[0][i], light[1][i], light[2][i]))};
    }
    return sum;
}

// Returns the part of the light that is left out.
double filter_by_features(const Film& film, std::size_t threads, std::array<Plane, 3>& light) {
    const Canvas canvas = canvas_of(film, threads);
    const MeanLayers& means = film.means;
    const SurfaceFilter surfaces({means_of(film, means.normal), means_of(film, means.position),
                                  means_of(film, means.albedo)},
                                 canvas);
    const double before = luminance_of(light);
    const Plane part = part_of_first_half(film);
    // Direct light has sharp shadows, indirect light more noise.
    const FilteredLight direct =
        filtered(halves_of(film, means.direct_half, [&](std::size_t i) { return means.direct[i]; }),
                 part, surfaces, 1);
    const FilteredLight indirect = filtered(
        halves_of(film, means.indirect_half, [&](std::size_t i) { return indirect_sum(film, i); }),
        part, surfaces, 3);
    light = emission_of(film);
    for (std::size_t c = 0; c < light.size(); ++c) {
        for_each_pixel(canvas, [&](std::size_t i) {
            light[c][i] += direct.light[c][i] + indirect.light[c][i];
        });
    }
    return before > 0.0 ? (direct.left_out + indirect.left_out) / before : 0.0;
}

std::vector<float> interleaved(const std::array<Plane, 3>& planes) {
    std::vector<float> made;
    made.reserve(3 * planes[0].size());
    for (std::size_t i = 0; i < planes[0].size(); ++i) {
        made.insert(made.end(), {planes[0][i], planes[1][i], planes[2][i]});
    }
    return made;
}

Diagnostics filter_by_library(const Film& film, const ImageDenoiseLibrary& library,
                              std::array<Plane, 3>& light) {
    std::vector<float> color = interleaved(light);
    std::vector<float> albedo = interleaved(means_of(film, film.means.albedo));
    std::vector<float> normal = interleaved(means_of(film, film.means.normal));
    if (Diagnostics found =
            library.filter(film.window.width, film.window.height, color, albedo, normal);
        !found.empty()) {
        return found;
    }
    for (std::size_t k = 0; k < color.size(); ++k) {
        light[k % 3][k / 3] = color[k];
    }
    return {};
}

void store(const std::array<Plane, 3>& light, Film& film) {
    film.noisy = film.sum;
    if (!film.layer_set.empty()) {
        film.layer_set.insert(LayerId::noisy);
    }
    for_each_pixel_of(film, [&](std::size_t x, std::size_t y, std::size_t i) {
        const double samples = film.samples(x, y);
        film.sum[i].r = samples * double{light[0][i]};
        film.sum[i].g = samples * double{light[1][i]};
        film.sum[i].b = samples * double{light[2][i]};
    });
}

}  // namespace

Names<Denoiser> denoisers() { return Names<Denoiser>(denoiser_rows); }

LayerSet denoise_layers() {
    return {LayerId::emission,      LayerId::direct,      LayerId::direct_half,
            LayerId::indirect_half, LayerId::mean_albedo, LayerId::mean_normal,
            LayerId::mean_position};
}

Result<DenoiseSummary> denoise(Film& film, const DenoiseOptions& options) {
    if (Diagnostics found = check(film); !found.empty()) {
        return found;
    }
    const Stopwatch watch;
    try {
        Diagnostics warnings;
        std::array<Plane, 3> light = light_of(film);
        const auto library = options.denoiser == Denoiser::features
                                 ? std::nullopt
                                 : ImageDenoiseLibrary::load(options.library);
        if (options.denoiser == Denoiser::library && !library) {
            return error(Kind::environment, "the library Open Image Denoise is not found",
                         "install it (openimagedenoise.org), or use the denoiser features");
        }
        bool done = false;
        if (library) {
            const Diagnostics found = filter_by_library(film, *library, light);
            done = found.empty();
            if (!done && options.denoiser == Denoiser::library) {
                return found;
            }
            for (const Diagnostic& failed : found) {
                warnings.push_back(
                    warning(failed.message + "; Balcony's own filter is used instead"));
            }
        }
        const double left_out = done ? 0.0 : filter_by_features(film, options.threads, light);
        store(light, film);
        return {
            DenoiseSummary{done ? library->name() : "Balcony's filter", watch.seconds(), left_out},
            std::move(warnings)};
    } catch (const std::bad_alloc&) {
        return error(Kind::environment, "out of memory while denoising",
                     "make the picture smaller");
    }
}

}  // namespace balcony::render

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "film/sums/tile_image.hpp"

#include <algorithm>
#include <bit>

#include "film/sums/sample_halves.hpp"
#include "film/sums/sample_sums.hpp"

namespace balcony::render {

namespace {

void write_data(DataLayers& layers, std::size_t at, const PointData& data) {
    const auto set = [at](auto& values, const auto& value) {
        if (!values.empty()) {
            values[at] = value;
        }
    };
    set(layers.valid, std::uint8_t{1});
    set(layers.layer, data.layer);
    set(layers.origin, V3f(data.origin));
    set(layers.direction, V3f(data.direction));
    set(layers.parameters, data.parameters);
    set(layers.motion, data.motion);
    const VisibleSurface& visible = data.visible;
    if (visible.any) {
        set(layers.ray_length, static_cast<float>(std::max(data.length, 0.0)));
        set(layers.position, visible.position);
        set(layers.normal, visible.normal);
        set(layers.albedo, visible.albedo);
        set(layers.object, visible.object);
        set(layers.magnification, data.magnification);
    }
}

void keep_halves(Film& film, std::size_t at, std::uint32_t index) {
    MeanLayers& means = film.means;
    if (!means.direct_half.empty()) {
        keep_half(means.direct_half[at], index, means.direct[at]);
    }
    if (!means.indirect_half.empty()) {
        keep_half(means.indirect_half[at], index, indirect_sum(film, at));
    }
}

// The sample with number `count`, from 1.
void add_means(MeanLayers& means, std::size_t at, std::uint32_t count,
               std::span<const Contribution> contributions) {
    Color3f emission(0.0F);
    Color3f direct(0.0F);
    V3f albedo(0.0F);
    V3f normal(0.0F);
    V3f position(0.0F);
    for (const Contribution& one : contributions) {
        const auto cover = [&](std::vector<Matte>& mattes, const Matte& seen) {
            for (const Matte::Entry& entry : seen.entries) {
                if (!mattes.empty() && entry.id != 0) {
                    mattes[at].add(entry.id, one.weight * entry.coverage);
                }
            }
        };
        cover(means.objects, one.coverage.objects);
        cover(means.materials, one.coverage.materials);
        emission += one.weight * one.parts.emission;
        direct += one.weight * one.parts.direct;
        const VisibleSurface& shown = one.shown;
        if (!shown.any) {
            continue;
        }
        albedo += one.weight * shown.albedo;
        normal += one.weight * shown.normal;
        position += one.weight * shown.position;
    }
    const auto sum = [at](std::vector<V3d>& sums, const V3f& value) {
        if (!sums.empty()) {
            sums[at] += V3d(value);
        }
    };
    sum(means.emission, emission);
    sum(means.direct, direct);
    const auto average = [&](std::vector<Moments>& moments, const V3f& value) {
        if (!moments.empty()) {
            moments[at].add(value, count);
        }
    };
    average(means.albedo, albedo);
    average(means.normal, normal);
    average(means.position, position);
}

// Adds all samples of a region that are in the film's window. The first pass is not added to
// anything.
void add_rows(const Film& film, bool is_first, const Region& region,
              const std::vector<Color4f>& samples, std::vector<Color4d>& sums) {
    for_each_row_within(region, film.window,
                        [&](std::size_t i, std::size_t x, std::size_t y, std::size_t width) {
                            (is_first ? set_first_samples : add_samples)(&samples[i], width,
                                                                         &sums[film.index(x, y)]);
                        });
    if (is_first) {
        finish_first_samples();
    }
}

}  // namespace

void add_pass(Film& film, std::size_t tile, const TileImage& image) {
    // Each layer by itself: loops over contiguous values.
    const auto for_each_sample = [&](const auto& visit) {
        for_each_pixel_within(image.region, film.window,
                              [&](std::size_t i, std::size_t x, std::size_t y) {
                                  if (image.active.empty() || image.active[i] != 0) {
                                      visit(i, film.index(x, y));
                                  }
                              });
    };
    if (!film.pixel_passes.empty()) {
        for_each_sample([&](std::size_t, std::size_t at) {
            if (std::has_single_bit(film.pixel_passes[at])) {
                film.first_half[at] = film.sum[at];
            }
            ++film.pixel_passes[at];
        });
    }
    if (!image.contributions.empty()) {
        const std::uint32_t count = film.passes[tile] + 1;
        for_each_sample([&](std::size_t i, std::size_t at) {
            keep_halves(film, at, count - 1);
            add_means(film.means, at, count, image.contributions[i]);
        });
    }
    const auto add = [&](std::vector<Color4d>& sums, const std::vector<Color4f>& samples) {
        if (samples.empty()) {
            return;
        }
        if (image.active.empty()) {
            add_rows(film, film.passes[tile] == 0, image.region, samples, sums);
            return;
        }
        for_each_sample([&](std::size_t i, std::size_t at) { sums[at] += Color4d(samples[i]); });
    };
    add(film.sum, image.light);
    add(film.display, image.display);
    add(film.mirrored, image.mirrored);
    if (!film.sum_of_squares.empty()) {
        for_each_sample([&](std::size_t i, std::size_t at) {
            const Color4d sample(image.light[i]);
            film.sum_of_squares[at] += sample * sample;
        });
    }
    if (film.layers && !image.data.empty()) {
        for_each_sample([&](std::size_t i, std::size_t at) {
            if (image.data[i].valid) {
                write_data(*film.layers, at, image.data[i]);
            }
        });
    }
    ++film.passes[tile];
}

}  // namespace balcony::render

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "film/denoise/light_filter.hpp"

#include <numeric>
#include <utility>

#include "images/luminance.hpp"

namespace balcony::render {

namespace {

constexpr std::size_t colors = 3;
constexpr std::size_t first = 0;  // The first plane of a half.
constexpr std::size_t second = 3;
constexpr float least_albedo = 0.1F;

float luminance_of(const Halves& halves, std::size_t half, std::size_t i) {
    return luminance(Imath::Color3f(halves[half][i], halves[half + 1][i], halves[half + 2][i]));
}

Plane luminance_of(const Halves& halves, std::size_t half, const Canvas& canvas) {
    Plane made(canvas.size());
    for_each_pixel(canvas, [&](std::size_t i) { made[i] = luminance_of(halves, half, i); });
    return made;
}

// The mean of all samples, of which `part` are in the first half.
float mean(float of_first, float of_second, float part) {
    return part * of_first + (1.0F - part) * of_second;
}

Plane mean_luminance(const Halves& halves, const Plane& part, const Canvas& canvas) {
    Plane made(canvas.size());
    for_each_pixel(canvas, [&](std::size_t i) {
        made[i] = mean(luminance_of(halves, first, i), luminance_of(halves, second, i), part[i]);
    });
    return made;
}

// The variance of the mean of both halves, whether neighbours share paths or not.
Plane noise(const Halves& halves, const Plane& part, const Canvas& canvas) {
    constexpr std::size_t radius = 5;
    Plane squares(canvas.size());
    for_each_pixel(canvas, [&](std::size_t i) {
        const float difference = luminance_of(halves, first, i) - luminance_of(halves, second, i);
        squares[i] = part[i] * (1.0F - part[i]) * difference * difference;
    });
    return box_mean(squares, radius, canvas);
}

// What one half of the samples has found, the other one should find nearby, or at least in part at
// the same pixel. Light far beyond that is an outlier and limited to it. Returns the luminance that
// is left out, summed over the pixels.
double limit_outliers(Halves& halves, const Plane& part, const Canvas& canvas) {
    constexpr float beyond_neighbours = 6.0F;
    constexpr float beyond_pixel = 4.0F;
    constexpr std::size_t radius = 3;
    const std::array of{luminance_of(halves, first, canvas), luminance_of(halves, second, canvas)};
    Plane left_out(canvas.size(), 0.0F);
    for (const std::size_t half : {first, second}) {
        const Plane& own = of[half == first ? 0 : 1];
        const Plane& other = of[half == first ? 1 : 0];
        const Plane nearby = box_maximum(box_mean(other, 1, canvas), radius, canvas);
        for_each_pixel(canvas, [&](std::size_t i) {
            const float limit = std::max(beyond_neighbours * nearby[i], beyond_pixel * other[i]);
            if (own[i] > limit) {
                const float kept = limit / own[i];
                left_out[i] += (half == first ? part[i] : 1.0F - part[i]) * (own[i] - limit);
                for (std::size_t c = half; c < half + colors; ++c) {
                    halves[c][i] *= kept;
                }
            }
        });
    }
    return std::accumulate(left_out.begin(), left_out.end(), 0.0);
}

// The squared error of the mean of both halves of a candidate, up to a term that all candidates
// have in common: each half is compared with the samples of the other one, whose noise is
// independent. The mean has less noise than a half, by what their difference tells.
Plane squared_error(const Halves& candidate, const Halves& samples, const Plane& part,
                    const Plane& weight, const Canvas& canvas) {
    const auto square = [](float v) { return v * v; };
    Plane made(canvas.size());
    for_each_pixel(canvas, [&](std::size_t i) {
        float sum = 0.0F;
        for (std::size_t c = 0; c < colors; ++c) {
            const float a = candidate[first + c][i];
            const float b = candidate[second + c][i];
            sum += mean(square(a - samples[second + c][i]), square(b - samples[first + c][i]),
                        part[i]) -
                   part[i] * (1.0F - part[i]) * square(a - b);
        }
        made[i] = weight[i] * sum;
    });
    return box_mean(made, 1, canvas);
}

// By which squared errors become relative to the light nearby.
Plane relative_to(const Halves& light, const Plane& part, const Canvas& canvas) {
    constexpr double darkest = 0.01;  // Of the mean of the picture.
    Plane made = box_mean(mean_luminance(light, part, canvas), 2, canvas);
    double sum = 0.0;
    for (const float value : made) {
        sum += double{value};
    }
    const auto least = static_cast<float>(darkest * sum / static_cast<double>(canvas.size()));
    for_each_pixel(canvas, [&](std::size_t i) {
        made[i] = 1.0F / (made[i] * made[i] + least * least + 1e-30F);
    });
    return made;
}

using Candidates = std::array<Halves, std::tuple_size_v<Stack>>;

// In each pixel, that of the candidates, from noisy to smooth, whose error is the least in pixels
// nearby that show the same surface. The smoother one is taken if the difference may be chance.
Halves best_of(const Candidates& candidates, const Plane& part, const Plane& weight,
               const SurfaceFilter& filter) {
    const Canvas& canvas = filter.canvas();
    Stack errors;
    for (std::size_t k = 0; k < errors.size(); ++k) {
        errors[k] = squared_error(candidates[k], candidates.front(), part, weight, canvas);
    }
    for (std::size_t spacing = 1; spacing <= 16; spacing *= 2) {
        errors = filter.filtered(errors, spacing, nullptr);
    }
    Halves made;
    made.fill(Plane(canvas.size()));
    for_each_pixel(canvas, [&](std::size_t i) {
        std::size_t best = errors.size() - 1;
        const float chance = 0.01F * errors[0][i];
        for (std::size_t k = best; k-- > 0;) {
            best = errors[k][i] < errors[best][i] - chance ? k : best;
        }
        for (std::size_t plane = 0; plane < made.size(); ++plane) {
            made[plane][i] = candidates[best][plane][i];
        }
    });
    return made;
}

void multiply_by(const Surfaces& surfaces, float (*factor)(float albedo), Halves& halves,
                 const Canvas& canvas) {
    for (std::size_t plane = 0; plane < halves.size(); ++plane) {
        const Plane& albedo = surfaces.albedo[plane % colors];
        for_each_pixel(canvas, [&](std::size_t i) {
            halves[plane][i] *= factor(std::max(albedo[i], least_albedo));
        });
    }
}

// The mean of both halves of the filtered light, and what it lacks, or has too much, over areas of
// some eight pixels, as far as both halves of the samples agree on it.
std::array<Plane, 3> with_means_of(const Halves& samples, const Halves& light, const Plane& part,
                                   const Plane& weight, const Canvas& canvas) {
    constexpr std::size_t radius = 3;
    constexpr float largest_part = 0.1F;  // A bright spot has no halo.
    Stack lacking;
    for (std::size_t plane = 0; plane < lacking.size(); ++plane) {
        lacking[plane].resize(canvas.size());
        for_each_pixel(canvas, [&](std::size_t i) {
            lacking[plane][i] = samples[plane][i] - light[plane][i];
        });
        lacking[plane] = box_mean(box_mean(lacking[plane], radius, canvas), radius, canvas);
    }
    double agreed = 0.0;
    double all = 0.0;
    for (std::size_t c = 0; c < colors; ++c) {
        for (std::size_t i = 0; i < canvas.size(); ++i) {
            const float a = lacking[first + c][i];
            const float b = lacking[second + c][i];
            const float both = mean(a, b, part[i]);
            agreed += double{weight[i]} * a * b;
            all += double{weight[i]} * both * both;
        }
    }
    const auto sure = static_cast<float>(all > 0.0 ? std::clamp(agreed / all, 0.0, 1.0) : 0.0);
    std::array<Plane, 3> made;
    for (std::size_t c = 0; c < colors; ++c) {
        made[c].resize(canvas.size());
        for_each_pixel(canvas, [&](std::size_t i) {
            const float found = mean(light[first + c][i], light[second + c][i], part[i]);
            const float change =
                sure * mean(lacking[first + c][i], lacking[second + c][i], part[i]);
            made[c][i] = found + std::clamp(change, -largest_part * found, largest_part * found);
        });
    }
    return made;
}

// Beside all surfaces there is nothing to reflect light: what is bright has no glow there.
void clear_background(const Halves& samples, const Surfaces& surfaces, const Canvas& canvas,
                      std::array<Plane, 3>& light) {
    for_each_pixel(canvas, [&](std::size_t i) {
        const auto is_zero = [i](const Plane& plane) { return plane[i] == 0.0F; };
        if (std::all_of(samples.begin(), samples.end(), is_zero) &&
            std::all_of(surfaces.normal.begin(), surfaces.normal.end(), is_zero)) {
            for (Plane& plane : light) {
                plane[i] = 0.0F;
            }
        }
    });
}

}  // namespace

FilteredLight filtered(Halves halves, const Plane& part, const SurfaceFilter& filter,
                       std::size_t blur_radius) {
    constexpr float tolerance = 1.5F;
    const Canvas& canvas = filter.canvas();
    FilteredLight made;
    made.left_out = limit_outliers(halves, part, canvas);
    // Without textures, the light is smoother.
    Candidates candidates;
    candidates[0] = halves;
    multiply_by(
        filter.surfaces(), [](float albedo) { return 1.0F / albedo; }, candidates[0], canvas);
    for (std::size_t k = 1; k < candidates.size(); ++k) {
        const Halves& before = candidates[k - 1];
        const Guide guide{box_mean(mean_luminance(before, part, canvas), blur_radius, canvas),
                          noise(before, part, canvas), tolerance};
        candidates[k] = filter.filtered(before, std::size_t{1} << (k - 1), &guide);
    }
    const Plane weight = relative_to(candidates.back(), part, canvas);
    Halves best = best_of(candidates, part, weight, filter);
    multiply_by(
        filter.surfaces(), [](float albedo) { return albedo; }, best, canvas);
    made.light = with_means_of(halves, best, part, weight, canvas);
    clear_background(halves, filter.surfaces(), canvas, made.light);
    return made;
}

}  // namespace balcony::render

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "film/denoise/light_filter.hpp"

#include <cmath>
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

// What a candidate has more than the next smoother one is a detail. The part of it which makes the
// squared error the least is a quotient of means over pixels nearby that show the same surface.
// Each half is compared with the samples of the other one, whose noise is independent.
struct Detail {
    Plane agreement;  // Of the detail with what the smoother candidate lacks.
    Plane square;
};

Detail detail_of(const Halves& candidate, const Halves& smoother, const Halves& samples,
                 const Plane& part, const Plane& weight, const Canvas& canvas) {
    Detail made{Plane(canvas.size()), Plane(canvas.size())};
    for_each_pixel(canvas, [&](std::size_t i) {
        for (std::size_t c = 0; c < colors; ++c) {
            const float a = smoother[first + c][i];
            const float b = smoother[second + c][i];
            const float more_a = candidate[first + c][i] - a;
            const float more_b = candidate[second + c][i] - b;
            const float more = mean(more_a, more_b, part[i]);
            // The mean of both halves has less noise than a half, by what their difference tells.
            made.agreement[i] +=
                weight[i] * (mean(more_a * (samples[second + c][i] - a),
                                  more_b * (samples[first + c][i] - b), part[i]) +
                             part[i] * (1.0F - part[i]) * (a - b) * (more_a - more_b));
            made.square[i] += weight[i] * more * more;
        }
    });
    return {box_mean(made.agreement, 1, canvas), box_mean(made.square, 1, canvas)};
}

// The smoothest of the candidates, which are from noisy to smooth, and parts of the details of the
// others, within the range of all. What the part leaves out is noise; a detail whose square is far
// beyond that of the noise nearby is kept. A small part may be there by chance and is left out.
Halves blended(const Candidates& candidates, const Plane& part, const Plane& weight,
               const SurfaceFilter& filter) {
    constexpr std::size_t farthest = 8;
    constexpr std::size_t smoothest = std::tuple_size_v<Candidates> - 1;
    const Canvas& canvas = filter.canvas();
    constexpr float far_beyond = 8.0F;
    constexpr float by_chance = 0.4F;  // Noise that both halves have in common.
    Stack agreements;
    Stack squares;
    agreements[smoothest].resize(canvas.size());
    squares[smoothest].resize(canvas.size());
    for (std::size_t k = 0; k < smoothest; ++k) {
        Detail detail =
            detail_of(candidates[k], candidates[k + 1], candidates.front(), part, weight, canvas);
        agreements[k] = std::move(detail.agreement);
        squares[k] = std::move(detail.square);
    }
    const Stack own_squares = squares;
    for (std::size_t spacing = 1; spacing <= farthest; spacing *= 2) {
        agreements = filter.filtered(agreements, spacing, nullptr);
        squares = filter.filtered(squares, spacing, nullptr);
    }
    Halves made = candidates[smoothest];
    for_each_pixel(canvas, [&](std::size_t i) {
        std::array<float, smoothest> factors;
        for (std::size_t k = 0; k < smoothest; ++k) {
            const float usual = agreements[k][i] / (squares[k][i] + 1e-20F);
            const float noise_square = (1.0F - usual) * squares[k][i];
            const float distinct = 1.0F - far_beyond * noise_square / (own_squares[k][i] + 1e-20F);
            const float sure = (std::max(usual, distinct) - by_chance) / (1.0F - by_chance);
            factors[k] = std::clamp(sure, 0.0F, 1.0F);
        }
        for (std::size_t plane = 0; plane < made.size(); ++plane) {
            float low = made[plane][i];
            float high = low;
            float sum = low;
            for (std::size_t k = smoothest; k-- > 0;) {
                const float value = candidates[k][plane][i];
                sum += factors[k] * (value - candidates[k + 1][plane][i]);
                low = std::min(low, value);
                high = std::max(high, value);
            }
            made[plane][i] = std::clamp(sum, low, high);
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

// Adds to the light what it lacks, or has too much, over areas of about this radius, as far as both
// halves of the samples agree on it nearby.
void restore_means(const Halves& samples, std::size_t radius, const Plane& part,
                   const Plane& weight, const Canvas& canvas, Halves& light) {
    constexpr std::size_t nearby = 16;
    Stack lacking;
    for (std::size_t plane = 0; plane < lacking.size(); ++plane) {
        lacking[plane].resize(canvas.size());
        for_each_pixel(canvas, [&](std::size_t i) {
            lacking[plane][i] = samples[plane][i] - light[plane][i];
        });
        lacking[plane] = box_mean(box_mean(lacking[plane], radius, canvas), radius, canvas);
    }
    Plane agreed(canvas.size());
    Plane all(canvas.size());
    for_each_pixel(canvas, [&](std::size_t i) {
        for (std::size_t c = 0; c < colors; ++c) {
            const float a = lacking[first + c][i];
            const float b = lacking[second + c][i];
            const float both = mean(a, b, part[i]);
            agreed[i] += weight[i] * a * b;
            all[i] += weight[i] * both * both;
        }
    });
    agreed = box_mean(box_mean(agreed, nearby, canvas), nearby, canvas);
    all = box_mean(box_mean(all, nearby, canvas), nearby, canvas);
    for_each_pixel(canvas, [&](std::size_t i) {
        const float sure = std::clamp(agreed[i] / (all[i] + 1e-20F), 0.0F, 1.0F);
        for (std::size_t plane = 0; plane < light.size(); ++plane) {
            light[plane][i] += sure * lacking[plane][i];
        }
    });
}

// The mean of both halves of the filtered light, with the means of the samples over large areas,
// then smaller ones, down to pixels. No pixel is darker than all samples nearby.
std::array<Plane, 3> with_means_of(const Halves& samples, const Halves& light, const Plane& part,
                                   const Plane& weight, const Canvas& canvas) {
    constexpr std::array<std::size_t, 4> radii{7, 3, 1, 0};
    constexpr float largest_part = 0.1F;  // A bright spot has no halo.
    Halves restored = light;
    for (const std::size_t radius : radii) {
        restore_means(samples, radius, part, weight, canvas, restored);
    }
    std::array<Plane, 3> made;
    for (std::size_t c = 0; c < colors; ++c) {
        made[c].resize(canvas.size());
        Plane negative(canvas.size());
        for_each_pixel(canvas, [&](std::size_t i) {
            negative[i] = -mean(samples[first + c][i], samples[second + c][i], part[i]);
        });
        const Plane darkest = box_maximum(negative, 1, canvas);
        for_each_pixel(canvas, [&](std::size_t i) {
            const float found = mean(light[first + c][i], light[second + c][i], part[i]);
            const float wanted = mean(restored[first + c][i], restored[second + c][i], part[i]);
            const float limit = largest_part * std::abs(found);
            made[c][i] = std::max(found + std::clamp(wanted - found, -limit, limit), -darkest[i]);
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
    Halves best = blended(candidates, part, weight, filter);
    multiply_by(
        filter.surfaces(), [](float albedo) { return albedo; }, best, canvas);
    made.light = with_means_of(halves, best, part, weight, canvas);
    clear_background(halves, filter.surfaces(), canvas, made.light);
    return made;
}

}  // namespace balcony::render

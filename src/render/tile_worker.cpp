// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/tile_worker.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace balcony::render {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_between(Clock::time_point begin, Clock::time_point end) {
    return std::chrono::duration<double>(end - begin).count();
}

// The inverse of the distribution function of a tent on [-1, 1].
double tent(double uniform) {
    return uniform < 0.5 ? std::sqrt(2.0 * uniform) - 1.0 : 1.0 - std::sqrt(2.0 - 2.0 * uniform);
}

bool is_finite(const Color4f& c) {
    return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b) && std::isfinite(c.a);
}

}  // namespace

Imath::V2d pass_offset(std::size_t pass) {
    // Roberts' R2 sequence: steps by the powers of the plastic number's inverse.
    constexpr double plastic = 1.32471795724474602596;
    const auto at = [pass](double step) {
        const double value = 0.5 + static_cast<double>(pass) * step;
        return tent(value - std::floor(value));
    };
    return {at(1.0 / plastic), at(1.0 / (plastic * plastic))};
}

void WorkCounts::add(const WorkCounts& other) {
    camera_rays += other.camera_rays;
    invalid_rays += other.invalid_rays;
    invalid_pixels += other.invalid_pixels;
    repaired += other.repaired;
    camera_seconds += other.camera_seconds;
    seconds += other.seconds;
}

TileWorker::TileWorker(const TracedScene& traced, const program::Program& camera,
                       const Settings& settings, Film& film)
    : traced_(&traced),
      camera_(&camera),
      settings_(&settings),
      film_(&film),
      tracer_(traced, settings),
      // Many samples share the work of filtering; pbrt bounds the sharing alike.
      footprint_scale_(std::max(0.125, 1.0 / std::sqrt(static_cast<double>(settings.samples)))) {
    const std::size_t points = (tile_width + 1) * (tile_height + 1);
    grid_.resize(points);
    traceable_.resize(points);
    rays_.resize(tile_width * tile_height);
    has_ray_.resize(tile_width * tile_height);
    hits_.resize(tile_width * tile_height);
}

void TileWorker::render(const PixelTile& tile, std::size_t pass) {
    const Clock::time_point begin = Clock::now();
    make_rays(tile, pass);
    counts_.camera_seconds += seconds_between(begin, Clock::now());
    const std::size_t pixels = tile.width * tile.height;
    traced_->accelerator.intersect_grid(tile.width, std::span(rays_).first(pixels),
                                        std::span(has_ray_).first(pixels), hits_);
    for (std::size_t y = 0; y < tile.height; ++y) {
        for (std::size_t x = 0; x < tile.width; ++x) {
            render_pixel(tile, x, y, pass == 0);
        }
    }
    counts_.seconds += seconds_between(begin, Clock::now());
}

void TileWorker::make_rays(const PixelTile& tile, std::size_t pass) {
    const Imath::V2d offset = pass_offset(pass);
    grid_width_ = tile.width + 1;
    program::run(
        *camera_,
        {static_cast<double>(tile.x) + 0.5 + offset.x, static_cast<double>(tile.y) + 0.5 + offset.y,
         1.0, grid_width_, tile.height + 1, settings_->time},
        scratch_, grid_.roots());
    const std::size_t points = grid_width_ * (tile.height + 1);
    for (std::size_t i = 0; i < points; ++i) {
        traceable_[i] = grid_.traceable(i) ? 1 : 0;
    }
    for (std::size_t i = 0; i < tile.width * tile.height; ++i) {
        const std::size_t point = i / tile.width * grid_width_ + i % tile.width;
        has_ray_[i] = traceable_[point];
        if (has_ray_[i] != 0) {
            rays_[i] = {V3f(grid_.origin(point)), V3f(grid_.direction(point))};
        }
    }
}

RayDifferentials TileWorker::differentials(std::size_t point, std::size_t x, std::size_t y) const {
    RayDifferentials slopes;
    // Forward where the neighbour has a ray, else backward within the tile, else none: sharp.
    const auto difference = [&](std::size_t step, bool has_before, V3f& origin, V3f& direction) {
        const bool forward = traceable_[point + step] != 0;
        if (!forward && !(has_before && traceable_[point - step] != 0)) {
            return;
        }
        const std::size_t first = forward ? point : point - step;
        const std::size_t second = first + step;
        origin = V3f(footprint_scale_ * (grid_.origin(second) - grid_.origin(first)));
        direction = V3f(footprint_scale_ * (grid_.direction(second) - grid_.direction(first)));
    };
    difference(1, x > 0, slopes.origin_x, slopes.direction_x);
    difference(grid_width_, y > 0, slopes.origin_y, slopes.direction_y);
    return slopes;
}

void TileWorker::render_pixel(const PixelTile& tile, std::size_t x, std::size_t y,
                              bool first_pass) {
    const std::size_t point = y * grid_width_ + x;
    const std::size_t in_tile = y * tile.width + x;
    const std::size_t pixel = (tile.y + y) * film_->width + tile.x + x;
    ++counts_.camera_rays;
    ++film_->samples[pixel];
    if (has_ray_[in_tile] == 0) {
        ++counts_.invalid_rays;
        counts_.invalid_pixels += first_pass ? 1 : 0;
        return;
    }
    Ray ray{rays_[in_tile].origin, rays_[in_tile].direction};
    if (traced_->textured) {
        ray.differentials = differentials(point, x, y);
    }
    Tracer::Result seen = tracer_.trace(ray, hits_[in_tile]);
    if (settings_->background) {
        seen.radiance.a = 1.0F;
    }
    if (is_finite(seen.radiance)) {
        film_->sum[pixel] += seen.radiance;
    } else {
        ++counts_.repaired;
    }
    if (first_pass && film_->layers) {
        write_layers(pixel, point, seen.visible);
    }
}

void TileWorker::write_layers(std::size_t pixel, std::size_t point, const VisibleSurface& visible) {
    DataLayers& layers = *film_->layers;
    const Imath::V3d origin = grid_.origin(point);
    const Imath::V3d direction = grid_.direction(point);
    layers.valid[pixel] = 1;
    layers.origin[pixel] = V3f(origin);
    layers.direction[pixel] = V3f(direction);
    layers.parameters[pixel] = grid_.parameters(point);
    if (visible.any) {
        const double length = (Imath::V3d(visible.position) - origin).dot(direction);
        layers.ray_length[pixel] = static_cast<float>(std::max(length, 0.0));
        layers.position[pixel] = visible.position;
        layers.normal[pixel] = visible.normal;
        layers.albedo[pixel] = visible.albedo;
        layers.object[pixel] = visible.object;
    }
}

}  // namespace balcony::render

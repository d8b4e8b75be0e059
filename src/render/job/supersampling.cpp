// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/job/supersampling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "balcony/median.hpp"
#include "images/luminance.hpp"
#include "render/job/coarse_rays.hpp"
#include "render/job/pass_grid.hpp"

namespace balcony::render {

namespace {

// A border is where the light of pixels beside each other differs by so many times the common one.
constexpr float high_contrast = 4.0F;

bool has_borders(const TracedScene& traced, const Settings& settings) {
    return shows_environment(traced, settings) || traced.lights.emissive_triangles() > 0;
}

bool has_glass(const scene::Scene& scene) {
    return std::any_of(scene.materials.begin(), scene.materials.end(), bends_light);
}

// Of the region, with one more pixel on each side where the picture has one.
Region with_neighbours(const Region& region, const std::array<std::size_t, 2>& picture_size) {
    const std::size_t left = region.x - std::min<std::size_t>(region.x, 1);
    const std::size_t top = region.y - std::min<std::size_t>(region.y, 1);
    return {left, top, std::min(region.x + region.width + 1, picture_size[0]) - left,
            std::min(region.y + region.height + 1, picture_size[1]) - top};
}

template <class Value>
Value mean_of(std::span<TileImage> samples, std::vector<Value> TileImage::*values, std::size_t i) {
    Value sum(0.0F);
    for (TileImage& sample : samples) {
        sum += (sample.*values)[i];
    }
    return sum / static_cast<float>(samples.size());
}

}  // namespace

std::optional<float> common_light(const TracedScene& traced, const Settings& settings,
                                  const IntegratorRow& integrator, PictureRays& rays,
                                  const Film& film) {
    constexpr double points = 512.0;
    constexpr std::size_t look_passes = 4;
    if (!has_borders(traced, settings) && !has_glass(*traced.scene)) {
        return std::nullopt;
    }
    Settings look = settings;
    look.samples = look_passes;
    look.path.reuse = false;
    const std::unique_ptr<Integrator> tracer = integrator.make(traced, look);
    const rays::Tile grid = coarse_grid(film.width, film.height, points, settings.time);
    std::vector<double> found;
    TileRays all;
    std::vector<CameraRay> batch;
    for (std::size_t layer = 0; layer < rays.layer_count(); ++layer) {
        rays.find_rays(layer, grid, all);
        std::vector<double> light(all.all.size());
        for (std::size_t number = 0; number < look_passes; ++number) {
            const PassNumbers pass(number, 0);
            batch.clear();
            for (std::size_t i = 0; i < all.all.size(); ++i) {
                const DifferentialRay ray = coarse_ray(traced, grid, all, i);
                const embree::Hit hit = SceneTracer(traced).nearest(ray, all.shown->only());
                if (traceable(all.all, i) && hit.any()) {
                    batch.push_back({ray, hit, Sampler(i % grid.width, i / grid.width, pass)});
                }
            }
            std::vector<Seen> seen(batch.size());
            tracer->trace(batch, *all.shown, seen);
            light.resize(batch.size());
            for (std::size_t k = 0; k < seen.size(); ++k) {
                const float lit = luminance(seen[k].radiance) - luminance(seen[k].parts.emission);
                light[k] += std::isfinite(lit) ? double{lit} : 0.0;
            }
        }
        found.insert(found.end(), light.begin(), light.end());
    }
    return static_cast<float>(median(std::move(found)).value_or(0.0) / look_passes);
}

Supersampling::Supersampling(const TracedScene& traced, const Settings& settings,
                             std::array<std::size_t, 2> picture_size,
                             std::optional<float> common_light)
    : traced_(&traced),
      picture_size_(picture_size),
      time_(settings.time),
      shows_environment_(shows_environment(traced, settings)),
      common_light_(common_light) {}

std::shared_ptr<const Mask> Supersampling::of(const Region& tile, PictureRays& rays) {
    if (!common_light_) {
        return nullptr;
    }
    const std::array<std::size_t, 2> place{tile.x, tile.y};
    {
        const std::lock_guard lock(mutex_);
        if (const auto at = known_.find(place); at != known_.end()) {
            return at->second;
        }
    }
    Mask found = find(tile, rays);
    const bool any = std::find(found.begin(), found.end(), 1) != found.end();
    auto shared = any ? std::make_shared<const Mask>(std::move(found)) : nullptr;
    const std::lock_guard lock(mutex_);
    return known_.emplace(place, std::move(shared)).first->second;
}

// What a ray meets first, or by way of panes and perfect mirrors.
Supersampling::Probe Supersampling::probe(DifferentialRay ray, const ShownObjects& shown) const {
    constexpr std::size_t most_passed = 8;
    const SceneTracer tracer(*traced_);
    float part = 1.0F;
    for (std::size_t passed = 0; passed < most_passed; ++passed) {
        const embree::Hit hit = tracer.nearest(ray, passed == 0 ? shown.only() : nullptr);
        if (!hit.any()) {
            return {shows_environment_ && (passed > 0 || shown.environment)
                        ? part * luminance(traced_->lights.radiance_from(ray.direction))
                        : 0.0F};
        }
        const Interaction at = tracer.interaction(ray, hit);
        const Appearance& appearance = at.appearance();
        const float lamp =
            part * luminance(appearance.unlit ? appearance.base_color : at.emission(ray.direction));
        if (lamp > 0.0F || appearance.unlit) {
            return {lamp};
        }
        if (const Color3f straight = at.straight(ray.direction); !is_black(straight)) {
            part *= luminance(straight);
            ray.origin = at.surface.start(ray.direction);
            continue;
        }
        const Bsdf bsdf = at.bsdf();
        if (bsdf.material().is_clear()) {
            return {0.0F, !appearance.thin_walled};
        }
        const auto mirrored =
            is_black(bsdf.material().diffuse) ? bsdf.sample_mirror(-ray.direction) : std::nullopt;
        if (!mirrored) {
            return {};
        }
        part *= luminance(mirrored->weight);
        ray.origin = at.surface.start(mirrored->to_light);
        ray.direction = mirrored->to_light;
    }
    return {};
}

std::vector<Supersampling::Probe> Supersampling::probe(const Region& region, std::size_t layer,
                                                       PictureRays& rays) const {
    const rays::Tile grid =
        pass_grid(region, {0.0, 0.0}, picture_size_[0], picture_size_[1], time_);
    TileRays all;
    rays.find_rays(layer, grid, all);
    std::vector<Probe> probes(region.size());
    for (std::size_t i = 0; i < probes.size(); ++i) {
        if (traceable(all.all, i)) {
            probes[i] = probe(coarse_ray(*traced_, grid, all, i), *all.shown);
        }
    }
    return probes;
}

Mask Supersampling::find(const Region& tile, PictureRays& rays) const {
    const Region around = with_neighbours(tile, picture_size_);
    Mask found(tile.size(), 0);
    for (std::size_t layer = 0; layer < rays.layer_count(); ++layer) {
        const std::vector<Probe> probes = probe(around, layer, rays);
        const auto at = [&](std::size_t x, std::size_t y) -> const Probe& {
            return probes[(y - around.y) * around.width + x - around.x];
        };
        for_each_pixel(tile, [&](std::size_t i, std::size_t x, std::size_t y) {
            float least = std::numeric_limits<float>::infinity();
            float most = 0.0F;
            for_each_pixel(with_neighbours({x, y, 1, 1}, picture_size_),
                           [&](std::size_t, std::size_t u, std::size_t v) {
                               least = std::min(least, at(u, v).lamp);
                               most = std::max(most, at(u, v).lamp);
                           });
            if (at(x, y).glass || most - least > high_contrast * *common_light_) {
                found[i] = 1;
            }
        });
    }
    return found;
}

void set_means(TileImage& image, const Mask& marked, std::span<TileImage> samples) {
    const Region& all = image.region;
    const Region& region = samples.front().region;
    const float part = 1.0F / static_cast<float>(samples.size());
    for_each_pixel_within(all, region, [&](std::size_t i, std::size_t x, std::size_t y) {
        if (marked[i] == 0) {
            return;
        }
        const std::size_t k = (y - region.y) * region.width + x - region.x;
        for (const auto values : {&TileImage::light, &TileImage::display, &TileImage::mirrored}) {
            if (!(image.*values).empty()) {
                (image.*values)[i] = mean_of(samples, values, k);
            }
        }
        if (!image.data.empty()) {
            image.data[i] = samples.front().data[k];
        }
    });
    if (image.contributions.empty()) {
        return;
    }
    Contributions mixed;
    for_each_pixel(all, [&](std::size_t i, std::size_t x, std::size_t y) {
        if (marked[i] == 0) {
            for (const Contribution& one : image.contributions[i]) {
                mixed.add(one);
            }
        } else {
            for (const TileImage& sample : samples) {
                for (Contribution one :
                     sample.contributions[(y - region.y) * region.width + x - region.x]) {
                    one.weight *= part;
                    mixed.add(one);
                }
            }
        }
        mixed.end_pixel();
    });
    image.contributions = std::move(mixed);
}

}  // namespace balcony::render

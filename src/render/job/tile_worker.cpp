// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/job/tile_worker.hpp"

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

void mark(std::uint8_t& flag, bool set) {
    if (set) {
        flag = 1;
    }
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
    layers.resize(std::max(layers.size(), other.layers.size()));
    for (std::size_t i = 0; i < other.layers.size(); ++i) {
        layers[i].camera_rays += other.layers[i].camera_rays;
        layers[i].invalid_rays += other.layers[i].invalid_rays;
    }
    invalid_pixels += other.invalid_pixels;
    repaired += other.repaired;
    camera_seconds += other.camera_seconds;
    seconds += other.seconds;
}

TileWorker::TileWorker(const TracedScene& traced, const rays::CompiledPicture& picture,
                       const Settings& settings, Film& film)
    : traced_(&traced),
      picture_(&picture),
      settings_(&settings),
      film_(&film),
      tracer_(traced, settings),
      // Many samples share the work of filtering; pbrt bounds the sharing alike.
      footprint_scale_(std::max(0.125, 1.0 / std::sqrt(static_cast<double>(settings.samples)))) {
    constexpr std::size_t maximum = tile_width * tile_height;
    has_ray_.resize(maximum);
    rays_.resize(maximum);
    hits_.resize(maximum);
    counts_.layers.resize(picture.layers().size());
    if (picture.is_one_camera()) {
        return;
    }
    wanted_.resize(maximum);
    has_data_.resize(maximum);
    drawn_.resize(picture.layers().size());
    coverages_.resize(picture.coverage_count());
    for (std::vector<double>& values : coverages_) {
        values.resize(maximum);
        coverage_roots_.push_back(values.data());
    }
}

void TileWorker::render(const PixelTile& tile, std::size_t pass) {
    const Clock::time_point begin = Clock::now();
    tile_ = tile;
    pass_ = pass;
    pixels_ = tile.width * tile.height;
    if (picture_->is_one_camera()) {
        render_single();
    } else {
        render_layers();
    }
    counts_.seconds += seconds_between(begin, Clock::now());
}

// What the filter reaches beyond the picture counts as at its border, since there the camera may go
// on with something else or nothing; just inside, for what ends there.
rays::Tile TileWorker::points() const {
    constexpr double just_inside = 1e-6;
    const auto limits = [](std::size_t extent) {
        return rays::Tile::Limits{just_inside, static_cast<double>(extent) - just_inside};
    };
    const Imath::V2d offset = pass_offset(pass_);
    return {static_cast<double>(tile_.x) + 0.5 + offset.x,
            static_cast<double>(tile_.y) + 0.5 + offset.y,
            1.0,
            tile_.width,
            tile_.height,
            settings_->time,
            limits(film_->width),
            limits(film_->height)};
}

// Fills grid_, has_ray_ and rays_.
void TileWorker::make_rays(std::size_t layer) {
    const Clock::time_point begin = Clock::now();
    picture_->layers()[layer].rays.run(points(), scratch_, grid_);
    for (std::size_t i = 0; i < pixels_; ++i) {
        has_ray_[i] = traceable(grid_, i) ? 1 : 0;
        if (has_ray_[i] != 0) {
            rays_[i] = {V3f(grid_.origin(i)), V3f(grid_.direction(i))};
        }
    }
    counts_.camera_seconds += seconds_between(begin, Clock::now());
}

// What the ray of a pixel sees, given where it hits first.
Tracer::Result TileWorker::trace(std::size_t i) {
    Ray ray{rays_[i].origin, rays_[i].direction};
    if (grid_.has_footprints()) {
        ray.differentials = differentials(grid_, i, footprint_scale_);
    }
    Tracer::Result seen = tracer_.trace(ray, hits_[i]);
    if (settings_->background) {
        seen.radiance.a = 1.0F;
    }
    if (!is_finite(seen.radiance)) {
        ++counts_.repaired;
        seen.radiance = Color4f(0.0F);
    }
    return seen;
}

void TileWorker::render_single() {
    make_rays(0);
    traced_->accelerator.intersect_grid(tile_.width, std::span(rays_).first(pixels_),
                                        std::span(has_ray_).first(pixels_), hits_);
    RayCounts& counts = counts_.layers[0];
    for (std::size_t i = 0; i < pixels_; ++i) {
        ++counts.camera_rays;
        ++film_->samples[pixel(i)];
        if (has_ray_[i] == 0) {
            ++counts.invalid_rays;
            counts_.invalid_pixels += pass_ == 0 ? 1 : 0;
            continue;
        }
        const Tracer::Result seen = trace(i);
        film_->sum[pixel(i)] += seen.radiance;
        if (pass_ == 0 && film_->layers) {
            write_data(i, 0, seen.visible);
        }
    }
}

// Rays first, from the front to the back, since what is hidden needs none; then the colours, from
// the back to the front.
void TileWorker::render_layers() {
    if (picture_->coverage_count() > 0) {
        const Clock::time_point begin = Clock::now();
        picture_->run_coverages(points(), scratch_, coverage_roots_);
        counts_.camera_seconds += seconds_between(begin, Clock::now());
    }
    for (std::vector<Drawn>& layer : drawn_) {
        layer.clear();
    }
    std::fill(has_data_.begin(), has_data_.end(), std::uint8_t{0});
    Mask hidden(pixels_, 0);
    find_rays(picture_->elements(), hidden, std::vector<float>(pixels_, 1.0F));
    for (std::size_t i = 0; i < pixels_; ++i) {
        const Drawn all = drawn(picture_->elements(), i);
        film_->sum[pixel(i)] += all.color;
        ++film_->samples[pixel(i)];
        counts_.invalid_pixels += pass_ == 0 && all.presence <= 0.0F ? 1 : 0;
    }
}

// What is no number is not above 0 and counts as 0.
float TileWorker::coverage(const Element& element, std::size_t i) const {
    if (!element.coverage) {
        return 1.0F;
    }
    const double value = coverages_[*element.coverage][i];
    return value > 0.0 ? static_cast<float>(std::min(value, 1.0)) : 0.0F;
}

// Traces what shows of some elements of one group, the front first, and marks in `hidden` what
// they hide. `share` is how much the groups round them cover.
void TileWorker::find_rays(const std::vector<Element>& elements, Mask& hidden,
                           const std::vector<float>& share) {
    for (auto element = elements.rbegin(); element != elements.rend(); ++element) {
        const bool hides = element->blend == camera::BlendMode::normal;
        if (!element->group.empty()) {
            find_rays_of_group(*element, hidden, share);
        } else if (element->layer) {
            trace_layer(*element, hidden, share);
            const std::vector<Drawn>& layer = drawn_[*element->layer];
            for (std::size_t i = 0; hides && i < layer.size(); ++i) {
                mark(hidden[i], layer[i].presence > 0.0F && coverage(*element, i) >= 1.0F);
            }
        } else {
            for (std::size_t i = 0; hides && i < pixels_; ++i) {
                mark(hidden[i], coverage(*element, i) >= 1.0F);
            }
        }
    }
}

void TileWorker::find_rays_of_group(const Element& element, Mask& hidden,
                                    const std::vector<float>& share) {
    Mask hidden_inside = hidden;
    std::vector<float> share_inside = share;
    bool shows = false;
    for (std::size_t i = 0; i < pixels_; ++i) {
        const float part = coverage(element, i);
        mark(hidden_inside[i], part <= 0.0F);
        share_inside[i] *= part;
        shows = shows || hidden_inside[i] == 0;
    }
    if (!shows) {
        return;
    }
    find_rays(element.group, hidden_inside, share_inside);
    if (element.blend == camera::BlendMode::normal) {
        for (std::size_t i = 0; i < pixels_; ++i) {
            mark(hidden[i], hidden_inside[i] != 0 && coverage(element, i) >= 1.0F);
        }
    }
}

void TileWorker::trace_layer(const Element& element, const Mask& hidden,
                             const std::vector<float>& share) {
    const std::size_t layer = *element.layer;
    bool any = false;
    for (std::size_t i = 0; i < pixels_; ++i) {
        wanted_[i] = hidden[i] == 0 && coverage(element, i) > 0.0F ? 1 : 0;
        any = any || wanted_[i] != 0;
    }
    if (!any) {
        return;
    }
    make_rays(layer);
    RayCounts& counts = counts_.layers[layer];
    for (std::size_t i = 0; i < pixels_; ++i) {
        counts.camera_rays += wanted_[i];
        counts.invalid_rays += wanted_[i] != 0 && has_ray_[i] == 0 ? 1 : 0;
        has_ray_[i] = has_ray_[i] != 0 && wanted_[i] != 0 ? 1 : 0;
    }
    traced_->accelerator.intersect_grid(tile_.width, std::span(rays_).first(pixels_),
                                        std::span(has_ray_).first(pixels_), hits_);
    drawn_[layer].assign(pixels_, {});
    for (std::size_t i = 0; i < pixels_; ++i) {
        if (has_ray_[i] == 0) {
            continue;
        }
        const Tracer::Result seen = trace(i);
        drawn_[layer][i] = {seen.radiance, 1.0F};
        const bool in_front = has_data_[i] == 0 && share[i] * coverage(element, i) >= 0.5F;
        if (pass_ == 0 && film_->layers && in_front) {
            has_data_[i] = 1;
            write_data(i, layer, seen.visible);
        }
    }
}

Drawn TileWorker::drawn(const std::vector<Element>& elements, std::size_t i) const {
    Drawn all;
    for (const Element& element : elements) {
        const float part = coverage(element, i);
        if (part <= 0.0F) {
            continue;
        }
        Drawn source;
        if (!element.group.empty()) {
            source = drawn(element.group, i);
        } else if (element.paint) {
            const auto channel = [&](std::size_t c) {
                return static_cast<float>(coverages_[*element.paint + c][i]);
            };
            source = {Color4f(channel(0), channel(1), channel(2), 1.0F), 1.0F};
        } else if (!drawn_[*element.layer].empty()) {
            source = drawn_[*element.layer][i];
        }
        all = composed(all, source, part, element.blend);
    }
    return all;
}

void TileWorker::write_data(std::size_t i, std::size_t layer, const VisibleSurface& visible) {
    DataLayers& layers = *film_->layers;
    const std::size_t at = pixel(i);
    const Imath::V3d origin = grid_.origin(i);
    const Imath::V3d direction = grid_.direction(i);
    layers.valid[at] = 1;
    layers.layer[at] = static_cast<std::uint16_t>(layer + 1);
    layers.origin[at] = V3f(origin);
    layers.direction[at] = V3f(direction);
    layers.parameters[at] = parameters(grid_, i);
    if (visible.any) {
        const double length = (Imath::V3d(visible.position) - origin).dot(direction);
        layers.ray_length[at] = static_cast<float>(std::max(length, 0.0));
        layers.position[at] = visible.position;
        layers.normal[at] = visible.normal;
        layers.albedo[at] = visible.albedo;
        layers.object[at] = visible.object;
    }
}

}  // namespace balcony::render

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/job/compositor.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "images/luminance.hpp"
#include "render/job/bent_rays.hpp"
#include "render/job/layer_weights.hpp"
#include "render/job/point_blender.hpp"

namespace balcony::render {

namespace {

void mark(std::uint8_t& flag, bool set) {
    if (set) {
        flag = 1;
    }
}

// What a sample shows that the lens of its camera blocks.
const Color4f no_light(0.0F, 0.0F, 0.0F, 1.0F);

// The points of a region whose rays a lens blocks, and whether they are counted.
template <class Do>
void for_each_blocked(const TileRays& rays, const Region& region, const Region& counted,
                      const Do& act) {
    if (rays.through_lens) {
        for_each_pixel(region, [&](std::size_t i, std::size_t x, std::size_t y) {
            if (rays.all.blocked(i)) {
                act(i, counted.contains(x, y));
            }
        });
    }
}

// A distance from a point at which only the direction matters.
double far_along(const V3d& from) {
    return 1e9 * std::max({std::abs(from.x), std::abs(from.y), std::abs(from.z), 1.0});
}

}  // namespace

/// A tile in progress: the requested parts and the results so far.
struct Compositor::Work {
    /// Whether a point is in the region that is counted.
    [[nodiscard]] bool counts(std::size_t i) const {
        return counted.contains(points.region.x + i % points.region.width,
                                points.region.y + i / points.region.width);
    }

    // Marks the points that a layer covers completely.
    void mark_covered(const Element& element, Mask& covered) const {
        const std::vector<Drawn>& drawn = layers[*element.layer];
        for (std::size_t i = 0; i < drawn.size(); ++i) {
            mark(covered[i], drawn[i].presence >= 1.0F && coverages.coverage(element, i) >= 1.0F);
        }
    }

    const TilePoints& points;
    Region counted;
    TileCoverages coverages;
    std::vector<std::vector<Drawn>> layers;   // By camera layer; empty if it is invisible.
    std::vector<std::vector<double>> depths;  // The same, of those that are composited by depth.
    Mask bare;  // Where the rays of a layer meet none of the objects that it shows.
    std::vector<PointData> data;  // Empty if not requested.
    // What the rays see, by camera layer; empty if not requested.
    std::vector<std::vector<Contribution>> seen;
};

/// What covers the elements that are still to be traced, by point.
struct Compositor::Veil {
    Mask hidden;               // Whether something in front covers the point completely.
    std::vector<float> share;  // The coverage of the enclosing groups.
};

/// The rays of a master, and the nearest data of its layers.
struct Compositor::Master {
    rays::RayBatch rays;
    rays::RayBatch central;  // Without a lens, if there are data.
    std::vector<PointData> data;
    std::vector<double> depths;  // Of the data.
};

Compositor::Compositor(const rays::CompiledPicture& picture, PictureRays rays, TileTracer tracer)
    : picture_(&picture),
      rays_(std::move(rays)),
      tracer_(std::move(tracer)),
      counts_(picture.layers().size()) {}

TileImage& Compositor::sample(const TilePoints& points, const Region& counted,
                              const Wanted& wanted) {
    image_.region = points.region;
    image_.light.clear();
    image_.data.clear();
    image_.display.clear();
    image_.mirrored.clear();
    image_.contributions = {};
    image_.active.clear();
    // One camera has no display colours, and what a light tracer shows, no mirrors.
    if (picture_->is_one_camera() && tracer_.has_light_tracer() && !wanted.data &&
        !wanted.contributions) {
        sample_light(points, counted);
    } else {
        sample_all(points, counted, wanted);
    }
    return image_;
}

void Compositor::sample_light(const TilePoints& points, const Region& counted) {
    rays_.find_rays_of_pass(0, points.grid, points.region, points.numbers, tile_rays_);
    image_.light.resize(points.size());
    RayCounts found = tracer_.trace_light(points.region, counted, tile_rays_, image_.light);
    for_each_blocked(tile_rays_, points.region, counted, [&](std::size_t i, bool counts) {
        image_.light[i] = no_light;
        found.invalid_rays -= counts ? 1 : 0;
        found.blocked_rays += counts ? 1 : 0;
    });
    counts_[0].add(found);
    invalid_pixels_ += points.pass == 0 ? found.invalid_rays : 0;
}

// Traces rays from front to back, because hidden layers need none; then composites the colours from
// back to front.
void Compositor::sample_all(const TilePoints& points, const Region& counted, const Wanted& wanted) {
    const std::size_t size = points.size();
    Work work{points,
              counted,
              rays_.coverages(points.grid),
              std::vector<std::vector<Drawn>>(picture_->layers().size()),
              std::vector<std::vector<double>>(picture_->layers().size()),
              Mask(size, 0),
              std::vector<PointData>(wanted.data ? size : 0),
              std::vector<std::vector<Contribution>>(
                  wanted.contributions ? picture_->layers().size() : 0)};
    Veil veil{Mask(size, 0), std::vector<float>(size, 1.0F)};
    trace(picture_->elements(), veil, work);
    PointBlender blend(work.coverages, work.layers, work.depths);
    image_.light.reserve(size);
    image_.display.reserve(wanted.display ? size : 0);
    image_.mirrored.reserve(wanted.mirrored ? size : 0);
    for_each_pixel(points.region, [&](std::size_t i, std::size_t x, std::size_t y) {
        const Drawn all = blend(picture_->elements(), i);
        image_.light.push_back(all.light);
        if (wanted.display) {
            image_.display.push_back(all.display);
        }
        if (wanted.mirrored) {
            image_.mirrored.push_back(all.mirrored);
        }
        invalid_pixels_ += points.pass == 0 && points.is_active(i) && all.presence <= 0.0F &&
                                   work.bare[i] == 0 && counted.contains(x, y)
                               ? 1
                               : 0;
    });
    if (wanted.contributions) {
        image_.contributions = contributions(work);
    }
    image_.data = std::move(work.data);
}

Contributions Compositor::contributions(const Work& work) const {
    LayerWeights weights(work.coverages, work.layers, work.depths);
    Contributions found;
    for (std::size_t i = 0; i < work.points.size(); ++i) {
        weights.at(picture_->elements(), i, [&](std::size_t layer, float weight) {
            Contribution one = work.seen[layer][i];
            one.weight = weight;
            found.add(one);
        });
        found.end_pixel();
    }
    return found;
}

// From front to back; marks in the veil what each element hides.
void Compositor::trace(const std::vector<Element>& elements, Veil& veil, Work& work) {
    for (auto element = elements.rbegin(); element != elements.rend(); ++element) {
        const bool hides = element->blend == camera::BlendMode::normal;
        if (!element->group.empty()) {
            trace_group(*element, veil, work);
        } else if (element->layer) {
            trace_layer(*element, veil, work, nullptr);
            if (hides) {
                work.mark_covered(*element, veil.hidden);
            }
        } else {
            for (std::size_t i = 0; hides && i < work.points.size(); ++i) {
                mark(veil.hidden[i], work.coverages.coverage(*element, i) >= 1.0F);
            }
        }
    }
}

void Compositor::trace_group(const Element& element, Veil& veil, Work& work) {
    Veil inside = veil;
    bool shows = false;
    for (std::size_t i = 0; i < work.points.size(); ++i) {
        const float part = work.coverages.coverage(element, i);
        mark(inside.hidden[i], part <= 0.0F);
        inside.share[i] *= part;
        shows = shows || inside.hidden[i] == 0;
    }
    if (!shows) {
        return;
    }
    if (element.compositing == camera::Compositing::depth) {
        trace_by_depth(element.group, inside, work);
    } else {
        trace(element.group, inside, work);
    }
    if (element.blend == camera::BlendMode::normal) {
        for (std::size_t i = 0; i < work.points.size(); ++i) {
            mark(veil.hidden[i],
                 inside.hidden[i] != 0 && work.coverages.coverage(element, i) >= 1.0F);
        }
    }
}

// None of the layers hides another before their depths are known.
void Compositor::trace_by_depth(const std::vector<Element>& layers, Veil& veil, Work& work) {
    const TilePoints& points = work.points;
    const std::size_t first = *layers.front().layer;
    Master master;
    master.data.resize(work.data.size());
    master.depths.resize(work.data.size());
    rays_.find_rays_of_pass(first, points.grid, points.region, points.numbers, tile_rays_);
    std::swap(master.rays, tile_rays_.all);
    if (!work.data.empty()) {
        rays_.find_rays(first, points.grid, tile_rays_);
        std::swap(master.central, tile_rays_.all);
    }
    for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer) {
        trace_layer(*layer, veil, work, &master);
    }
    for (const Element& layer : layers) {
        work.mark_covered(layer, veil.hidden);
    }
    for (std::size_t i = 0; i < work.data.size(); ++i) {
        if (!work.data[i].valid) {
            work.data[i] = master.data[i];
        }
    }
}

// With a master, layers are composited by depth along its rays.
void Compositor::trace_layer(const Element& element, const Veil& veil, Work& work, Master* master) {
    const TilePoints& points = work.points;
    const std::size_t layer = *element.layer;
    Mask wanted(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        mark(wanted[i], points.is_active(i) && veil.hidden[i] == 0 &&
                            work.coverages.coverage(element, i) > 0.0F);
    }
    if (std::find(wanted.begin(), wanted.end(), 1) == wanted.end()) {
        return;
    }
    TileRays& rays = tile_rays_;
    // Data are sharp: they are those of the central rays.
    const bool data_apart = !work.data.empty() && rays_.has_lens(layer);
    if (data_apart) {
        rays_.find_rays(layer, points.grid, rays);
        tracer_.trace(points, rays, wanted, [&](std::size_t i, const Seen& seen, std::size_t part) {
            add_data(element, veil, i, seen, part, work, master);
        });
    }
    rays_.find_rays_of_pass(layer, points.grid, points.region, points.numbers, rays);
    for_each_pixel(points.region, [&](std::size_t i, std::size_t x, std::size_t y) {
        const bool counts = wanted[i] != 0 && work.counted.contains(x, y);
        counts_[layer].camera_rays += counts ? 1 : 0;
        counts_[layer].invalid_rays += counts && !traceable(rays.all, i) ? 1 : 0;
    });
    RayCounts& count = counts_[layer];
    std::vector<Drawn>& drawn = work.layers[layer];
    drawn.resize(points.size());
    if (master != nullptr) {
        work.depths[layer].resize(points.size());
    }
    // The mount of the lens is in front of everything.
    for_each_blocked(rays, points.region, work.counted, [&](std::size_t i, bool counts) {
        if (wanted[i] != 0) {
            drawn[i] = {no_light, Color4f(0.0F), {}, 1.0F};
            count.invalid_rays -= counts ? 1 : 0;
            count.blocked_rays += counts ? 1 : 0;
        }
    });
    if (!work.seen.empty()) {
        work.seen[layer].resize(points.size());
    }
    tracer_.trace(points, rays, wanted, [&](std::size_t i, const Seen& seen, std::size_t part) {
        const float presence = rays.shown->environment ? 1.0F : seen.radiance.a;
        mark(work.bare[i], presence <= 0.0F);
        const double depth = master != nullptr ? depth_along(master->rays, i, seen.end) : 0.0;
        if (depth >= 0.0) {
            drawn[i] = {seen.radiance, Color4f(0.0F), seen.mirrored, presence};
        }
        if (master != nullptr) {
            work.depths[layer][i] = depth;
        }
        if (work.counts(i)) {
            count.hits += seen.visible.any ? 1 : 0;
            count.light +=
                static_cast<double>(luminance({seen.radiance.r, seen.radiance.g, seen.radiance.b}));
            count.softened_light += static_cast<double>(seen.softened);
            count.light_left_out += static_cast<double>(seen.left_out);
            count.emitted_light += static_cast<double>(luminance(seen.parts.emission));
            count.bounces_cut += static_cast<double>(seen.cut);
        }
        if (!work.seen.empty()) {
            work.seen[layer][i] = {1.0F, seen.parts, seen.shown, seen.coverage};
        }
        if (!data_apart) {
            add_data(element, veil, i, seen, part, work, master);
        }
    });
}

// The data of a point are those of the front layer that covers at least half of it, and shows
// something there.
void Compositor::add_data(const Element& element, const Veil& veil, std::size_t i, const Seen& seen,
                          std::size_t part, Work& work, Master* master) const {
    if (work.data.empty() || veil.share[i] * work.coverages.coverage(element, i) < 0.5F ||
        !(tile_rays_.shown->environment || seen.visible.any)) {
        return;
    }
    PointData& data = master != nullptr ? master->data[i] : work.data[i];
    if (master != nullptr) {
        const double depth =
            depth_along(master->central, i,
                        seen.visible.any ? std::optional(seen.visible.position) : std::nullopt);
        if (depth < 0.0 || (data.valid && depth >= master->depths[i])) {
            return;
        }
        master->depths[i] = depth;
    } else if (data.valid) {
        return;
    }
    const rays::RayBatch& rays = tile_rays_.all;
    const V3d position(seen.visible.position);
    const rays::RayBatch::Part at = rays.part(i, part);
    const double along =
        seen.visible.any ? (position - at.origin).dot(at.direction) : far_along(at.origin);
    data = {true,
            static_cast<std::uint16_t>(*element.layer + 1),
            rays.origin(i),
            rays.direction(i),
            length_before(rays, i, part) + along,
            at.origin + along * at.direction,
            parameters(rays, i),
            magnification(rays, i, part, position),
            rays.has_times() ? rays.time(i) : work.points.grid.time,
            seen.visible};
}

}  // namespace balcony::render

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Pixels that take several samples in a pass: at borders of what is much brighter than the light
// around, and at solid glass, there is more noise than elsewhere.

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "balcony/film.hpp"
#include "balcony/render.hpp"
#include "film/sums/tile_image.hpp"
#include "render/integrators/integrator.hpp"
#include "render/job/picture_rays.hpp"
#include "render/tracing/scene_tracer.hpp"

namespace balcony::render {

/// How many samples such a pixel takes in pass n: those of the passes 4 n to 4 n + 3.
inline constexpr std::size_t samples_of_pass = 4;

/// The median light of what a picture shows, besides that of lamps and of the environment: by a
/// first look at coarse rays of the whole of it. Nothing if no pixel is to take several samples.
[[nodiscard]] std::optional<float> common_light(const TracedScene& traced, const Settings& settings,
                                                const IntegratorRow& integrator, PictureRays& rays,
                                                const Film& film);

/// Which pixels these are, tile by tile: by a ray through the centre of each pixel, so whatever the
/// samples and the film's window. For any number of threads.
class Supersampling {
public:
    /// The scene must outlive it.
    Supersampling(const TracedScene& traced, const Settings& settings,
                  std::array<std::size_t, 2> picture_size, std::optional<float> common_light);

    /// Of a tile; null if there are none. The rays are those of the picture, at the same inputs in
    /// each call.
    [[nodiscard]] std::shared_ptr<const Mask> of(const Region& tile, PictureRays& rays);

private:
    struct Probe {
        float lamp = 0.0F;  // The light of a lamp or of the environment.
        bool glass = false;
    };
    [[nodiscard]] Probe probe(DifferentialRay ray, const ShownObjects& shown) const;
    [[nodiscard]] std::vector<Probe> probe(const Region& region, std::size_t layer,
                                           PictureRays& rays) const;
    [[nodiscard]] Mask find(const Region& tile, PictureRays& rays) const;

    const TracedScene* traced_;
    std::array<std::size_t, 2> picture_size_;
    double time_;
    bool shows_environment_;
    std::optional<float> common_light_;
    std::mutex mutex_;
    std::map<std::array<std::size_t, 2>, std::shared_ptr<const Mask>> known_;  // By place.
};

/// Replaces the marked pixels of an image by the means of samples. They are of a region of it; the
/// mask is that of the image.
void set_means(TileImage& image, const Mask& marked, std::span<TileImage> samples);

}  // namespace balcony::render

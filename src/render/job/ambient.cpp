// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/job/ambient.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "balcony/median.hpp"
#include "render/film/luminance.hpp"
#include "render/job/picture_rays.hpp"

namespace balcony::render {

namespace {

constexpr double rays_per_layer = 2048.0;

// The radiance of a white surface at this place, turned to the lights, and of the place itself.
double brightness(const SceneTracer& tracer, const V3f& to_viewer, const Interaction& at) {
    constexpr float white_radiance = 1.0F / std::numbers::pi_v<float>;
    Color3f total = at.appearance.emission;
    for (std::size_t light = 0; light < tracer.lights().size(); ++light) {
        const Illumination arriving =
            tracer.lights().arriving(light, {at.surface.position, to_viewer});
        if (arriving.to_light.dot(at.surface.normal) > 0.0F) {
            total += white_radiance *
                     tracer.transmittance(at.surface, arriving.to_light, arriving.distance, 0.0F) *
                     arriving.irradiance;
        }
    }
    return static_cast<double>(luminance(total));
}

// The brightness of lit places.
class BrightnessGrid {
public:
    BrightnessGrid(const TracedScene& traced, const rays::CompiledPicture& picture)
        : tracer_(traced),
          rays_(picture, traced.interval),
          textured_(traced.materials.has_textures()) {}

    void add(std::size_t layer, const rays::Tile& points) {
        rays_.find_rays(layer, points, found_);
        for (std::size_t i = 0; i < found_.rays.size(); ++i) {
            if (found_.valid[i] == 0) {
                continue;
            }
            Ray ray{found_.rays[i].origin, found_.rays[i].direction, {}, found_.rays[i].time};
            if (textured_) {
                ray.differentials = differentials(found_.all, i, points.step);
            }
            if (const embree::Hit hit = tracer_.nearest(ray); hit.any()) {
                const double found =
                    brightness(tracer_, -ray.direction, tracer_.interaction(ray, hit));
                if (found > 0.0 && std::isfinite(found)) {
                    lit_.push_back(found);
                }
            }
        }
    }

    [[nodiscard]] std::optional<double> median_of_lit() && { return median(std::move(lit_)); }

private:
    SceneTracer tracer_;
    PictureRays rays_;
    bool textured_;
    TileRays found_;
    std::vector<double> lit_;
};

}  // namespace

Color3f ambient_of(const TracedScene& traced, const rays::CompiledPicture& picture,
                   const Film& film, double time) {
    constexpr double share = 0.1;
    constexpr double in_the_dark = 0.3;
    const auto width = static_cast<double>(film.width);
    const auto height = static_cast<double>(film.height);
    const double step = std::max(1.0, std::sqrt(width * height / rays_per_layer));
    const auto count = [step](double extent) {
        return static_cast<std::size_t>(std::max(1.0, std::round(extent / step)));
    };

    BrightnessGrid grid(traced, picture);
    for (std::size_t layer = 0; layer < picture.layers().size(); ++layer) {
        grid.add(layer, {0.5 * step,
                         0.5 * step,
                         step,
                         count(width),
                         count(height),
                         time,
                         {0.5, width - 0.5},
                         {0.5, height - 0.5}});
    }
    const std::optional<double> lit = std::move(grid).median_of_lit();
    return Color3f(static_cast<float>(lit ? share * *lit : in_the_dark));
}

}  // namespace balcony::render

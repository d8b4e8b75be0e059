// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/job/coarse_rays.hpp"

#include <algorithm>
#include <cmath>

#include "render/job/picture_rays.hpp"

namespace balcony::render {

void for_each_coarse_ray(const TracedScene& traced, const rays::CompiledPicture& picture,
                         const Film& film, double time,
                         const std::function<void(const Ray&)>& visit) {
    constexpr double rays_per_layer = 2048.0;
    const auto width = static_cast<double>(film.width);
    const auto height = static_cast<double>(film.height);
    const double step = std::max(1.0, std::sqrt(width * height / rays_per_layer));
    const auto count = [step](double extent) {
        return static_cast<std::size_t>(std::max(1.0, std::round(extent / step)));
    };
    PictureRays rays(picture, traced.interval);
    TileRays found;
    for (std::size_t layer = 0; layer < picture.layers().size(); ++layer) {
        rays.find_rays(layer,
                       {0.5 * step,
                        0.5 * step,
                        step,
                        count(width),
                        count(height),
                        time,
                        {0.5, width - 0.5},
                        {0.5, height - 0.5}},
                       found);
        for (std::size_t i = 0; i < found.rays.size(); ++i) {
            if (found.valid[i] == 0) {
                continue;
            }
            Ray ray{found.rays[i].origin, found.rays[i].direction, {}, found.rays[i].time};
            if (traced.materials.has_textures()) {
                ray.differentials = differentials(found.all, i, step);
            }
            visit(ray);
        }
    }
}

}  // namespace balcony::render

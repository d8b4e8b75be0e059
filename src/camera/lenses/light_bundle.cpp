// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/lenses/light_bundle.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace balcony::camera {

namespace {

LensOptics turned(LensOptics lens) {
    std::reverse(lens.surfaces.begin(), lens.surfaces.end());
    for (RefractingSurface& surface : lens.surfaces) {
        LensSurface& s = surface.shape;
        s.curvature = -s.curvature;
        if (s.curvature_x) {
            s.curvature_x = -*s.curvature_x;
        }
        for (double& term : s.aspheric) {
            term = -term;
        }
        std::swap(surface.index, surface.index_after);
    }
    lens.stop = lens.surfaces.size() - 1 - lens.stop;
    return lens;
}

}  // namespace

LightBundle::LightBundle(const LensOptics& lens, const std::array<double, 2>& field)
    : turned_(turned(lens)), at_(focused(lens, std::nullopt, 0.0)), sensor_(-at_.sensor) {
    at_.sensor = -at_.vertices.front();
    std::reverse(at_.vertices.begin(), at_.vertices.end());
    for (double& vertex : at_.vertices) {
        vertex = -vertex;
    }
    const double length = std::hypot(field[0], field[1], 1.0);
    direction_ = {field[0] / length, -field[1] / length, 1.0 / length};
}

std::optional<std::array<double, 2>> LightBundle::arrival(const std::array<double, 2>& from) const {
    const LensPath<double> path = traced(turned_, at_, {-from[0], from[1]}, direction_);
    if (!path.passed) {
        return std::nullopt;
    }
    const double t = (sensor_ - path.point[2]) / path.direction[2];
    return std::array{-(path.point[0] + t * path.direction[0]),
                      path.point[1] + t * path.direction[1]};
}

std::optional<Obstacle> LightBundle::obstacle(const std::array<double, 2>& from) const {
    LensPath<double> ray{{-from[0], from[1], at_.sensor}, direction_, true, true, {}};
    const std::size_t count = turned_.surfaces.size();
    for (std::size_t i = 0; i < count; ++i) {
        const RefractingSurface& surface = turned_.surfaces[count - 1 - i];
        const double vertex = at_.vertices[count - 1 - i];
        LensPath<double> straight = ray;
        refract(surface, vertex, ray);
        if (!ray.refracted) {
            RefractingSurface clear = surface;
            clear.index_after = clear.index;
            refract(clear, vertex, straight);
            return Obstacle{i,
                            straight.refracted ? Obstacle::Kind::reflection : Obstacle::Kind::miss};
        }
        if (!ray.passed) {
            return Obstacle{i, Obstacle::Kind::hole};
        }
    }
    return std::nullopt;
}

}  // namespace balcony::camera

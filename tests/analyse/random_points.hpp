// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "analyse/inverse/point_rays.hpp"

namespace balcony::analyse::test {

/// Points on the rays of random places of a picture, at distances of a thousandth to a thousand
/// times the size of the eye object.
struct RandomPoints {
    std::vector<V2d> places;
    std::vector<V3d> points;

    RandomPoints(const camera::Camera& camera, double width, double height, std::size_t count) {
        const PointRays rays(
            *rays::compile(camera, width, height, {.footprints = true, .points = true}), 0.0);
        PointRays::Batch batch(rays);
        std::mt19937_64 random(1996);
        std::uniform_real_distribution<double> unit(0.0, 1.0);
        double size = 0.0;
        for (std::size_t tries = 0; points.size() < count && tries < 100 * count;
             tries += program::max_points) {
            for (std::size_t i = 0; i < program::max_points; ++i) {
                batch.place(i, {width * unit(random), height * unit(random)});
            }
            batch.run(program::max_points);
            for (std::size_t i = 0; tries == 0 && i < program::max_points; ++i) {
                size = std::max(size, batch.ray(i).valid ? batch.ray(i).origin.length() : 0.0);
            }
            for (std::size_t i = 0; i < program::max_points && points.size() < count; ++i) {
                const Ray ray = batch.ray(i);
                const double distance =
                    (size > 0.0 ? size : 1.0) * std::pow(10.0, 6.0 * unit(random) - 3.0);
                if (ray.valid) {
                    places.push_back(batch.at(i));
                    points.push_back(ray.origin + distance * ray.direction);
                }
            }
        }
    }
};

}  // namespace balcony::analyse::test

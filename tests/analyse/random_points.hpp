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
/// times the size of the eye object; of bent rays, on random straight parts.
struct RandomPoints {
    std::vector<V2d> places;
    std::vector<V3d> points;

    RandomPoints(const camera::Camera& camera, double width, double height, std::size_t count) {
        const rays::RayProgram program = *rays::compile(
            camera, width, height, {.footprints = true, .points = true, .bends = true});
        std::vector<PointRays> parts;
        for (std::size_t part = 0; part < program.part_count(); ++part) {
            parts.emplace_back(program, 0.0, part);
        }
        std::mt19937_64 random(1996);
        std::uniform_real_distribution<double> unit(0.0, 1.0);
        double size = 0.0;
        for (std::size_t tries = 0; points.size() < count && tries < 100 * count;
             tries += program::max_points) {
            PointRays::Batch batch(parts[tries / program::max_points % parts.size()]);
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
                    std::min((size > 0.0 ? size : 1.0) * std::pow(10.0, 6.0 * unit(random) - 3.0),
                             batch.path(i).length);
                if (ray.valid) {
                    places.push_back(batch.at(i));
                    points.push_back(ray.origin + distance * ray.direction);
                }
            }
        }
    }
};

}  // namespace balcony::analyse::test

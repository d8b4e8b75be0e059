// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "analyse/inverse/linear_rays.hpp"

#include <algorithm>
#include <cmath>

namespace balcony::analyse {

namespace {

// The minimum cosine between a ray and the normal: a field of view of 178 degrees.
constexpr double min_cosine = 0.017;

}  // namespace

// The derivatives are those of a quotient: slope = d / (d.n), foot = o - ((o.n) - height) slope.
LinearRays::LinearRays(const Ray& ray, const V2d& at, const V3d& normal)
    : center_(at), normal_(normal), height_(ray.origin.dot(normal)) {
    const double cosine = ray.direction.dot(normal);
    const auto slope_by = [&](const V3d& direction_by) {
        return (direction_by - direction_by.dot(normal) / cosine * ray.direction) / cosine;
    };
    slope_ = ray.direction / cosine;
    slope_by_x_ = slope_by(ray.direction_by_x);
    slope_by_y_ = slope_by(ray.direction_by_y);
    foot_ = ray.origin;
    foot_by_x_ = ray.origin_by_x - ray.origin_by_x.dot(normal) * slope_;
    foot_by_y_ = ray.origin_by_y - ray.origin_by_y.dot(normal) * slope_;
}

std::optional<LinearRays> LinearRays::fit(const Survey& survey) {
    V3d sum(0.0);
    std::optional<std::size_t> middle;
    const V2d picture_middle = 0.5 * (survey.place(0) + survey.place(survey.rays.size() - 1));
    const auto from_middle = [&](std::size_t i) {
        return (survey.place(i) - picture_middle).length2();
    };
    for (std::size_t i = 0; i < survey.rays.size(); ++i) {
        if (!survey.rays[i].valid) {
            continue;
        }
        sum += survey.rays[i].direction;
        if (!middle || from_middle(i) < from_middle(*middle)) {
            middle = i;
        }
    }
    if (!middle || sum.length() == 0.0) {
        return std::nullopt;
    }
    const V3d normal = sum.normalized();
    if (survey.rays[*middle].direction.dot(normal) < min_cosine) {
        return std::nullopt;
    }
    const LinearRays made(survey.rays[*middle], survey.place(*middle), normal);
    for (std::size_t i = 0; i < survey.rays.size(); ++i) {
        if (survey.rays[i].valid && !made.fits(survey.rays[i], survey.place(i), survey.extent)) {
            return std::nullopt;
        }
    }
    return made;
}

bool LinearRays::fits(const Ray& ray, const V2d& at, double extent) const {
    const double cosine = ray.direction.dot(normal_);
    if (cosine < min_cosine) {
        return false;
    }
    const V2d by = at - center_;
    const V3d slope = ray.direction / cosine;
    const V3d foot = ray.origin - (ray.origin.dot(normal_) - height_) * slope;
    const V3d slope_error = slope - (slope_ + by.x * slope_by_x_ + by.y * slope_by_y_);
    const V3d foot_error = foot - (foot_ + by.x * foot_by_x_ + by.y * foot_by_y_);
    constexpr double rounding = 1e-12;
    return slope_error.length() <= rounding * slope.length() &&
           foot_error.length() <= rounding * (extent + ray.origin.length() + std::abs(height_));
}

std::optional<V2d> LinearRays::place_of(const V3d& point) const {
    const double over = point.dot(normal_) - height_;
    const V3d by_x = foot_by_x_ + over * slope_by_x_;
    const V3d by_y = foot_by_y_ + over * slope_by_y_;
    const V3d left = point - (foot_ + over * slope_);
    const double determinant = normal_.dot(by_x.cross(by_y));
    // The rounding error of a determinant that is 0.
    if (std::abs(determinant) <= 1e-14 * by_x.length() * by_y.length()) {
        return std::nullopt;
    }
    return center_ +
           V2d(normal_.dot(left.cross(by_y)), normal_.dot(by_x.cross(left))) / determinant;
}

}  // namespace balcony::analyse

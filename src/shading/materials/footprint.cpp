// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "shading/materials/footprint.hpp"

#include <algorithm>
#include <cmath>

namespace balcony::render {

namespace {

// The derivatives of reflection and refraction have the same form: the new direction is
// scale * d - shift * n, where shift is a function of d·n.
RayDifferentials bent(const DifferentialRay& ray, const PositionDifferentials& moved,
                      const V3f& normal, const NormalDifferentials& turned, float scale,
                      float shift, float shift_by_cosine) {
    const RayDifferentials& d = ray.differentials;
    const auto direction_by = [&](const V3f& direction, const V3f& normal_by) {
        const float cosine_by = direction.dot(normal) + ray.direction.dot(normal_by);
        return scale * direction - shift * normal_by - shift_by_cosine * cosine_by * normal;
    };
    return {moved.along_x, moved.along_y, direction_by(d.direction_x, turned.along_x),
            direction_by(d.direction_y, turned.along_y)};
}

// A unit vector perpendicular to a unit vector.
V3f perpendicular(const V3f& v) {
    return (std::abs(v.x) > std::abs(v.z) ? V3f(-v.y, v.x, 0.0F) : V3f(0.0F, -v.z, v.y))
        .normalized();
}

}  // namespace

RayDifferentials after_mirror(const DifferentialRay& ray, const PositionDifferentials& moved,
                              const V3f& normal, const NormalDifferentials& turned) {
    return bent(ray, moved, normal, turned, 1.0F, 2.0F * ray.direction.dot(normal), 2.0F);
}

RayDifferentials after_refraction(const DifferentialRay& ray, const PositionDifferentials& moved,
                                  const V3f& normal, float eta, const NormalDifferentials& turned) {
    const float cosine = ray.direction.dot(normal);
    const float square = 1.0F - eta * eta * (1.0F - cosine * cosine);
    if (!(square > 0.0F)) {
        return after_mirror(ray, moved, normal, turned);
    }
    const float refracted_cosine = std::copysign(std::sqrt(square), cosine);
    return bent(ray, moved, normal, turned, eta, eta * cosine - refracted_cosine,
                eta - eta * eta * cosine / refracted_cosine);
}

RayDifferentials after_rough(const DifferentialRay& ray, const PositionDifferentials& moved,
                             const V3f& direction, float pdf, float scale) {
    constexpr float widest = 1.0F;
    const RayDifferentials& d = ray.differentials;
    const float arriving = d.direction_x.cross(d.direction_y).length();
    const float lobe = pdf > 0.0F ? scale * scale / pdf : widest;
    const float width = std::min(std::sqrt(arriving + lobe), widest);
    const V3f across = perpendicular(direction);
    return {moved.along_x, moved.along_y, width * across, width * direction.cross(across)};
}

RayDifferentials after_sample(const DifferentialRay& ray, const PositionDifferentials& moved,
                              const BsdfSample& sample, float scale) {
    if (!sample.delta) {
        return after_rough(ray, moved, sample.to_light, sample.pdf, scale);
    }
    return sample.transmitted ? after_refraction(ray, moved, sample.facet_normal, sample.eta)
                              : after_mirror(ray, moved, sample.facet_normal);
}

}  // namespace balcony::render

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The footprint of a ray after a bounce: what a pixel's texture look-ups filter over.

#include "shading/materials/bsdf.hpp"
#include "shading/surfaces/surface.hpp"

namespace balcony::render {

/// The change of a unit normal from a pixel to the next; 0 on a flat facet.
struct NormalDifferentials {
    V3f along_x{0.0F}, along_y{0.0F};
};

/// The differentials of the ray that a mirror with this unit normal reflects: Igehy, "Tracing Ray
/// Differentials" (1999), section 3.1.3. `ray` arrives, and `moved` is its footprint on the
/// surface.
[[nodiscard]] RayDifferentials after_mirror(const DifferentialRay& ray,
                                            const PositionDifferentials& moved, const V3f& normal,
                                            const NormalDifferentials& turned = {});

/// The same for the refracted ray: Igehy, section 3.1.4. `eta` is the refractive index of the side
/// that the ray comes from, divided by that of the other side; the normal may be on either side.
/// Where there is no refracted ray, those of the reflected ray.
[[nodiscard]] RayDifferentials after_refraction(const DifferentialRay& ray,
                                                const PositionDifferentials& moved,
                                                const V3f& normal, float eta,
                                                const NormalDifferentials& turned = {});

/// The differentials of a ray that is sampled from a rough lobe, with this unit direction. The
/// sample represents a solid angle of 1 / pdf, of which the share `scale`² belongs to it alone if
/// 1 / scale² samples divide the lobe. The cross-section of the beam is a square, whose solid angle
/// is that share plus that of the arriving beam; at most a radian wide.
[[nodiscard]] RayDifferentials after_rough(const DifferentialRay& ray,
                                           const PositionDifferentials& moved, const V3f& direction,
                                           float pdf, float scale = 1.0F);

/// After a sample of a surface without normal differentials; `scale` as above.
[[nodiscard]] RayDifferentials after_sample(const DifferentialRay& ray,
                                            const PositionDifferentials& moved,
                                            const BsdfSample& sample, float scale);

}  // namespace balcony::render

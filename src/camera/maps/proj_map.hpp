// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// PROJ's map projections: which there are, and the forward function of each.

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/base.hpp"
#include "camera/maps/definition.hpp"

struct PJconsts;
struct pj_ctx;

namespace balcony::camera::maps {

/// A point of a map, x to the east and y to the north, in radii of the sphere.
struct MapPoint {
    double x = 0.0, y = 0.0;
};

/// A point of the sphere, in radians.
struct SpherePoint {
    double longitude = 0.0, latitude = 0.0;
};

/// A point of the unit sphere: x at longitude and latitude 0, z at the north pole.
struct Direction {
    double x = 0.0, y = 0.0, z = 0.0;
};

[[nodiscard]] Direction direction_of(const SpherePoint& point);
[[nodiscard]] SpherePoint sphere_point_of(const Direction& direction);

/// PROJ's forward function of one projection. For one thread at a time, and only for tables and
/// checks while a stage is made: rays do not use it.
class ProjMap {
public:
    /// Errors: a name that PROJ does not know, no map, no inverse, parameters that PROJ rejects.
    [[nodiscard]] static Result<std::shared_ptr<const ProjMap>> make(const Definition& definition);

    /// Nothing where the projection has no point.
    [[nodiscard]] std::optional<MapPoint> operator()(const SpherePoint& point) const;

private:
    struct Destroy {
        void operator()(pj_ctx* context) const;
        void operator()(PJconsts* projection) const;
    };
    std::unique_ptr<pj_ctx, Destroy> context_;
    std::unique_ptr<PJconsts, Destroy> projection_;
    double radius_ = 1.0;
};

}  // namespace balcony::camera::maps

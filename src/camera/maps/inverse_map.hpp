// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The inverse of a map projection, as formulas: from a point of the map to a point of the unit
// sphere.

#include <functional>
#include <memory>
#include <numbers>
#include <optional>

#include "balcony/emitter.hpp"
#include "camera/maps/definition.hpp"
#include "camera/maps/proj_map.hpp"

namespace balcony::camera::maps {

inline constexpr double pi = std::numbers::pi;
inline constexpr double degree = pi / 180.0;

/// A rectangle of a map with edges along x and y.
struct MapExtent {
    double min_x = 0.0, max_x = 0.0, min_y = 0.0, max_y = 0.0;
};

/// From a point of the map, x to the east and y to the north, to the unit sphere.
class InverseMap {
public:
    InverseMap() = default;
    InverseMap(const InverseMap&) = delete;
    InverseMap& operator=(const InverseMap&) = delete;
    virtual ~InverseMap() = default;

    /// Requires that the point is on the map.
    [[nodiscard]] virtual ObjectPoint direction(const ParameterPoint& p, Emitter& emit) const = 0;
    /// The rectangle around the map, if points of PROJ's forward function do not show it.
    [[nodiscard]] virtual std::optional<MapExtent> extent() const { return std::nullopt; }
};

using InverseMapPointer = std::shared_ptr<const InverseMap>;

/// An inverse in closed form.
using InverseFormula = std::function<ObjectPoint(const ParameterPoint& p, Emitter& emit)>;
[[nodiscard]] InverseMapPointer by_formula(InverseFormula formula,
                                           std::optional<MapExtent> extent = std::nullopt);

/// A map as numbers: PROJ's forward function, possibly in other coordinates of the sphere.
using ForwardMap = std::function<std::optional<MapPoint>(const SpherePoint&)>;

/// The point of the unit sphere at a longitude and latitude.
[[nodiscard]] inline ObjectPoint at_longitude_and_latitude_of_map(Expr longitude, Expr latitude) {
    return {cos(longitude) * cos(latitude), sin(longitude) * cos(latitude), sin(latitude)};
}

/// Other axes of the unit sphere, right-handed: its longitudes begin at x, its north pole is z.
struct SphereAxes {
    Direction x{1.0, 0.0, 0.0}, y{0.0, 1.0, 0.0}, z{0.0, 0.0, 1.0};

    /// From these axes to those of the earth.
    [[nodiscard]] SpherePoint on_earth(const SpherePoint& point) const;
    [[nodiscard]] ObjectPoint on_earth(const ObjectPoint& point) const;
    /// The same with longitudes from another one.
    [[nodiscard]] SphereAxes with_first_meridian(double longitude) const;
    [[nodiscard]] ForwardMap seen_from(const ForwardMap& map) const;
};

/// The axes with the equator through a point in a direction, clockwise from north.
[[nodiscard]] SphereAxes along_great_circle(const SpherePoint& through, double azimuth);
/// The axes with a point as the north pole, from which longitude 0 leads south.
[[nodiscard]] SphereAxes with_pole(const SpherePoint& pole);

/// The axes with the equator through two points, from the first one on.
[[nodiscard]] SphereAxes through_points(const SpherePoint& first, const SpherePoint& second);

/// A map in other axes of the sphere.
[[nodiscard]] InverseMapPointer in_axes(const SphereAxes& axes, InverseMapPointer map);

}  // namespace balcony::camera::maps

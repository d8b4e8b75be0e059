// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/maps/inverse_map.hpp"

#include <cmath>
#include <numbers>

namespace balcony::camera::maps {

namespace {

Direction combined(const Direction& a, double by_a, const Direction& b, double by_b) {
    return {by_a * a.x + by_b * b.x, by_a * a.y + by_b * b.y, by_a * a.z + by_b * b.z};
}

class MapInAxes final : public InverseMap {
public:
    MapInAxes(const SphereAxes& axes, InverseMapPointer map) : axes_(axes), map_(std::move(map)) {}
    ObjectPoint direction(const ParameterPoint& p, Emitter& emit) const override {
        return axes_.on_earth(map_->direction(p, emit));
    }
    std::optional<MapExtent> extent() const override { return map_->extent(); }

private:
    SphereAxes axes_;
    InverseMapPointer map_;
};

class FormulaMap final : public InverseMap {
public:
    FormulaMap(InverseFormula formula, std::optional<MapExtent> extent)
        : formula_(std::move(formula)), extent_(extent) {}
    ObjectPoint direction(const ParameterPoint& p, Emitter& emit) const override {
        return formula_(p, emit);
    }
    std::optional<MapExtent> extent() const override { return extent_; }

private:
    InverseFormula formula_;
    std::optional<MapExtent> extent_;
};

/// The directions to the east and to the north at a point.
struct Compass {
    explicit Compass(const SpherePoint& at)
        : east(direction_of({at.longitude + 0.5 * pi, 0.0})),
          north(direction_of({at.longitude, at.latitude + 0.5 * pi})) {}
    Direction east, north;
};

}  // namespace

SpherePoint SphereAxes::on_earth(const SpherePoint& point) const {
    const Direction d = direction_of(point);
    const Direction in_equator = combined(x, d.x, y, d.y);
    return sphere_point_of(combined(in_equator, 1.0, z, d.z));
}

ObjectPoint SphereAxes::on_earth(const ObjectPoint& p) const {
    return {x.x * p.x + y.x * p.y + z.x * p.z, x.y * p.x + y.y * p.y + z.y * p.z,
            x.z * p.x + y.z * p.y + z.z * p.z};
}

SphereAxes SphereAxes::with_first_meridian(double longitude) const {
    const double c = std::cos(longitude);
    const double s = std::sin(longitude);
    return {combined(x, c, y, s), combined(y, c, x, -s), z};
}

ForwardMap SphereAxes::seen_from(const ForwardMap& map) const {
    return [axes = *this, map](const SpherePoint& point) { return map(axes.on_earth(point)); };
}

SphereAxes along_great_circle(const SpherePoint& through, double azimuth) {
    const Compass compass(through);
    const double s = std::sin(azimuth);
    const double c = std::cos(azimuth);
    return {direction_of(through), combined(compass.east, s, compass.north, c),
            combined(compass.north, s, compass.east, -c)};
}

SphereAxes with_pole(const SpherePoint& pole) {
    const Compass compass(pole);
    return {combined(compass.north, -1.0, compass.east, 0.0), compass.east, direction_of(pole)};
}

SphereAxes through_points(const SpherePoint& first, const SpherePoint& second) {
    const Compass compass(first);
    const Direction to = direction_of(second);
    const auto along = [&to](const Direction& d) { return d.x * to.x + d.y * to.y + d.z * to.z; };
    return along_great_circle(first, std::atan2(along(compass.east), along(compass.north)));
}

InverseMapPointer by_formula(InverseFormula formula, std::optional<MapExtent> extent) {
    return std::make_shared<const FormulaMap>(std::move(formula), extent);
}

InverseMapPointer in_axes(const SphereAxes& axes, InverseMapPointer map) {
    return std::make_shared<const MapInAxes>(axes, std::move(map));
}

}  // namespace balcony::camera::maps

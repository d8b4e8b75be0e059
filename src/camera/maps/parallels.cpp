// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/maps/parallels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "camera/maps/profile.hpp"

namespace balcony::camera::maps {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
// Rounding of PROJ's coordinates, relative to them.
constexpr double relative_rounding = 1e-12;

double x_of(const std::optional<MapPoint>& p) { return p ? p->x : none; }
double y_of(const std::optional<MapPoint>& p) { return p ? p->y : none; }

bool nearly(double a, double b) {
    return std::fabs(a - b) <= relative_rounding * (1.0 + std::fabs(a) + std::fabs(b));
}

constexpr std::array trial_latitudes{-1.1, -0.6, -0.15, 0.2, 0.75, 1.2};
constexpr std::array trial_longitudes{-2.7, -1.3, 0.4, 1.7, 2.9};

/// lambda = (x - x_0)/X(phi), phi by y.
class StraightParallels final : public InverseMap {
public:
    StraightParallels(Profile profile, double origin, double limit)
        : profile_(std::move(profile)), origin_(origin), limit_(limit) {}
    ObjectPoint direction(const ParameterPoint& p, Emitter& emit) const override {
        const auto [latitude, width] = profile_(p.v, emit);
        const Expr x = p.u - origin_;
        emit.require(0.0 < width && abs(x) <= limit_ * width);
        return at_longitude_and_latitude_of_map(x / width, latitude);
    }

private:
    Profile profile_;
    double origin_;
    double limit_;  ///< Of longitude.
};

/// The same about the meridian of each lobe.
class LobedParallels final : public InverseMap {
public:
    LobedParallels(Profile profile, std::span<const Lobe> lobes, double origin, double scale)
        : profile_(std::move(profile)),
          lobes_(lobes.begin(), lobes.end()),
          origin_(origin),
          scale_(scale) {}
    ObjectPoint direction(const ParameterPoint& p, Emitter& emit) const override {
        const auto [latitude, width] = profile_(p.v, emit);
        const Expr x = p.u - origin_;
        const Expr north = 0.0 <= p.v;
        Expr west = emit(0.0), east = emit(0.0), meridian = emit(0.0);
        for (const Lobe& lobe : lobes_) {
            const Expr here = (lobe.north ? north : !north) && lobe.west * scale_ <= x;
            west = select(here, emit(lobe.west), west);
            east = select(here, emit(lobe.east), east);
            meridian = select(here, emit(lobe.meridian), meridian);
        }
        emit.require(0.0 < width);
        const Expr longitude = meridian + (x - scale_ * meridian) / width;
        emit.require(west <= longitude && longitude <= east);
        return at_longitude_and_latitude_of_map(longitude, latitude);
    }

private:
    Profile profile_;
    std::vector<Lobe> lobes_;
    double origin_, scale_;  ///< x on the equator at longitude 0, and of a radian there.
};

/// About a centre on the middle meridian: phi by the distance, lambda = angle/E(phi).
class ConcentricParallels final : public InverseMap {
public:
    ConcentricParallels(Profile profile, const MapPoint& center, double side)
        : profile_(std::move(profile)), center_(center), side_(side) {}
    ObjectPoint direction(const ParameterPoint& p, Emitter& emit) const override {
        const Expr x = p.u - center_.x;
        const Expr y = side_ * (center_.y - p.v);
        const auto [latitude, factor] = profile_(sqrt(x * x + y * y), emit);
        const Expr angle = atan2(x, y);
        emit.require(0.0 < factor && abs(angle) <= pi * factor);
        return at_longitude_and_latitude_of_map(angle / factor, latitude);
    }

private:
    Profile profile_;
    MapPoint center_;
    double side_;  ///< 1 if the centre is north of the map, -1 if it is south.
};

/// In axes with the centre at x, east at y and north at z.
class Azimuthal final : public InverseMap {
public:
    Azimuthal(Profile profile, double radius) : profile_(std::move(profile)), radius_(radius) {}
    std::optional<MapExtent> extent() const override {
        return MapExtent{-radius_, radius_, -radius_, radius_};
    }
    ObjectPoint direction(const ParameterPoint& p, Emitter& emit) const override {
        constexpr double tiny = 1e-20;  // makes sin(angle)/distance finite in the centre
        const Expr distance = sqrt(max(p.u * p.u + p.v * p.v, emit(tiny)));
        const Expr angle = profile_(distance, emit).angle;
        const Expr ratio = sin(angle) / distance;
        return {cos(angle), ratio * p.u, ratio * p.v};
    }

private:
    Profile profile_;
    double radius_;  ///< Of the map, or pi if it is infinite.
};

/// Turned in the plane, in radians: a map whose own x axis has this angle.
class TurnedMap final : public InverseMap {
public:
    TurnedMap(double angle, InverseMapPointer map) : angle_(angle), map_(std::move(map)) {}
    ObjectPoint direction(const ParameterPoint& p, Emitter& emit) const override {
        const double c = std::cos(angle_);
        const double s = std::sin(angle_);
        return map_->direction({c * p.u + s * p.v, c * p.v - s * p.u}, emit);
    }

private:
    double angle_;
    InverseMapPointer map_;
};

// The largest latitude from a middle for which the map still has points.
double reach(const ForwardMap& map, double longitude, double inside, double outside) {
    if (map({longitude, outside})) {
        return outside;
    }
    constexpr int halvings = 60;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (inside + outside);
        (map({longitude, middle}) ? inside : outside) = middle;
    }
    return inside;
}

}  // namespace

InverseMapPointer straight_parallels(const ForwardMap& map, double limit) {
    const double origin = x_of(map({0.0, trial_latitudes[0]}));
    for (const double latitude : trial_latitudes) {
        const auto unit = map({1.0, latitude});
        for (const double trial : trial_longitudes) {
            const double longitude = trial * limit / pi;
            const auto p = map({longitude, latitude});
            if (!p || !unit || !nearly(p->y, unit->y) ||
                !nearly(p->x - origin, longitude * (unit->x - origin))) {
                return nullptr;
            }
        }
    }
    const std::optional<Profile> profile =
        Profile::make({.coordinate =
                           [&](double latitude) {
                               return y_of(map({0.0, latitude}));
                           },
                       .second =
                           [&](double latitude) {
                               return x_of(map({1.0, latitude})) - origin;
                           },
                       .parameters = {-0.5 * pi, 0.5 * pi}});
    return profile ? std::make_shared<const StraightParallels>(*profile, origin, limit) : nullptr;
}

InverseMapPointer straight_parallels(const AngleFunctions& functions) {
    const std::optional<Profile> profile = Profile::make(functions);
    return profile ? std::make_shared<const StraightParallels>(*profile, 0.0, pi) : nullptr;
}

InverseMapPointer lobed_parallels(const AngleFunctions& functions, std::span<const Lobe> lobes,
                                  const ForwardMap& map) {
    const std::optional<Profile> profile = Profile::make(functions);
    const double origin = x_of(map({0.0, 0.0}));
    const double scale = x_of(map({1.0, 0.0})) - origin;
    return profile ? std::make_shared<const LobedParallels>(*profile, lobes, origin, scale)
                   : nullptr;
}

namespace {

InverseMapPointer concentric_between(const ForwardMap& map, double middle_latitude,
                                     const Interval& latitudes) {
    std::vector<double> trials;
    for (const double latitude : trial_latitudes) {
        if (latitudes.first < latitude && latitude < latitudes.last) {
            trials.push_back(latitude);
        }
    }
    // The centre of the circle through a parallel at longitudes -1, 0 and 1.
    const auto center_y = [&](double latitude) {
        const auto top = map({0.0, latitude});
        const auto side = map({1.0, latitude});
        if (!top || !side) {
            return none;
        }
        const double dy = side->y - top->y;
        return 0.5 * ((side->x - top->x) * (side->x - top->x) / dy + side->y + top->y);
    };
    const MapPoint center{x_of(map({0.0, trials[1]})), center_y(trials[1])};
    const double side = center.y > y_of(map({0.0, trials[1]})) ? 1.0 : -1.0;
    const auto distance = [&](double latitude) {
        return side * (center.y - y_of(map({0.0, latitude})));
    };
    const auto angle = [&](double longitude, double latitude) {
        const auto p = map({longitude, latitude});
        return p ? std::atan2(p->x - center.x, side * (center.y - p->y)) : none;
    };
    constexpr double center_rounding = 1e-10;  // a difference of nearly equal y, divided by another
    for (const double latitude : trials) {
        if (!(std::fabs(center_y(latitude) - center.y) <=
              center_rounding * (1.0 + std::fabs(center.y)))) {
            return nullptr;
        }
        for (const double longitude : trial_longitudes) {
            if (!(std::fabs(angle(longitude, latitude) - longitude * angle(1.0, latitude)) <=
                  center_rounding)) {
                return nullptr;
            }
        }
    }
    const std::optional<Profile> profile =
        Profile::make({.coordinate = distance,
                       .second = [&](double latitude) { return angle(1.0, latitude); },
                       .parameters = latitudes,
                       .shift = middle_latitude});
    return profile ? std::make_shared<const ConcentricParallels>(*profile, center, side) : nullptr;
}

}  // namespace

InverseMapPointer concentric_parallels(const ForwardMap& map, double middle_latitude) {
    constexpr double pole = 0.5 * pi;
    if (InverseMapPointer whole = concentric_between(map, middle_latitude, {-pole, pole})) {
        return whole;
    }
    // Of a cone on which the sphere is seen from its centre, a hemisphere.
    return concentric_between(
        map, middle_latitude,
        {std::max(-pole, middle_latitude - pole), std::min(pole, middle_latitude + pole)});
}

InverseMapPointer azimuthal(const ForwardMap& map, const SpherePoint& center) {
    // From the centre as the pole of longitude 0 to the south.
    const ForwardMap from_center = with_pole(center).seen_from(map);
    const auto at = [&](double azimuth, double angle) {
        return from_center({pi - azimuth, 0.5 * pi - angle});
    };
    const double last = 0.5 * pi - reach(from_center, pi - 1.0, 0.5 * pi, -0.5 * pi);
    for (const double fraction : {0.05, 0.13, 0.24}) {
        const double angle = fraction * last;
        const double distance = y_of(at(0.0, angle));
        for (const double azimuth : trial_longitudes) {
            const auto p = at(azimuth, angle);
            if (!p || !nearly(p->x, distance * std::sin(azimuth)) ||
                !nearly(p->y, distance * std::cos(azimuth))) {
                return nullptr;
            }
        }
    }
    constexpr double azimuth = 1.0;
    const auto distance = [&](double angle) {
        const auto p = at(azimuth, angle);
        return p ? std::hypot(p->x, p->y) : none;
    };
    const std::optional<Profile> profile = Profile::make(
        {.coordinate = distance, .second = [](double) { return 0.0; }, .parameters = {0.0, last}});
    // Extrapolated to the end, where forward functions lose their digits.
    constexpr double step = 1e-4;
    const double radius = 2.0 * distance(last - step) - distance(last - 2.0 * step);
    constexpr double infinite = 8.0;
    return profile ? in_axes(along_great_circle(center, 0.5 * pi),
                             std::make_shared<const Azimuthal>(*profile,
                                                               radius < infinite ? radius : pi))
                   : nullptr;
}

namespace {

InverseMapPointer cylinder_from(const ForwardMap& map, const SphereAxes& axes) {
    const ForwardMap along = axes.seen_from(map);
    // The map's own x axis leads from one point of a parallel to another.
    const auto from = along({0.0, 0.3});
    const auto to = along({0.5, 0.3});
    if (!from || !to) {
        return nullptr;
    }
    const double angle = std::atan2(to->y - from->y, to->x - from->x);
    const auto turned = [&along, angle](const SpherePoint& point) -> std::optional<MapPoint> {
        const auto p = along(point);
        if (!p) {
            return std::nullopt;
        }
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        return MapPoint{c * p->x + s * p->y, c * p->y - s * p->x};
    };
    // Some are defined for half of the great circle only.
    InverseMapPointer straight = straight_parallels(turned, pi);
    straight = straight ? straight : straight_parallels(turned, 0.5 * pi);
    return straight ? in_axes(axes, std::make_shared<const TurnedMap>(angle, std::move(straight)))
                    : nullptr;
}

}  // namespace

InverseMapPointer oblique_cylinder(const ForwardMap& map, const SphereAxes& axes) {
    // The map is cut on one side; where, only its points show. The middle is opposite.
    const ForwardMap along = axes.seen_from(map);
    constexpr double latitude = 0.3;
    constexpr int steps = 36;
    const auto distance = [&](double a, double b) {
        const auto p = along({a, latitude});
        const auto q = along({b, latitude});
        return p && q ? std::hypot(p->x - q->x, p->y - q->y) : 0.0;
    };
    double before = 0.0;
    double after = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double a = 2.0 * pi * i / steps;
        const double b = 2.0 * pi * (i + 1) / steps;
        if (distance(a, b) > distance(before, after)) {
            before = a;
            after = b;
        }
    }
    constexpr int halvings = 50;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (before + after);
        (distance(before, middle) > distance(middle, after) ? after : before) = middle;
    }
    const SphereAxes from_middle = axes.with_first_meridian(0.5 * (before + after) - pi);
    if (InverseMapPointer made = cylinder_from(map, from_middle)) {
        return made;
    }
    return cylinder_from(map, axes);
}

}  // namespace balcony::camera::maps

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/maps/map_inverse.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "camera/maps/formula_maps.hpp"
#include "camera/maps/parallels.hpp"
#include "camera/maps/pseudocylindrical.hpp"

namespace balcony::camera::maps {

namespace {

ForwardMap forward_of(std::shared_ptr<const ProjMap> map) {
    return [map = std::move(map)](const SpherePoint& point) { return (*map)(point); };
}

// The axes of a sphere that is turned about its own.
SphereAxes turned(double longitude) { return along_great_circle({longitude, 0.0}, 0.5 * pi); }

// By name first, then by what the forward function shows.
InverseMapPointer inverse_of(const Definition& definition, const ForwardMap& map) {
    for (const auto& family :
         {stretched_maps(), perspective_maps(), polyhedral_maps(), two_point_maps(),
          conformal_maps(), oblique_cylinders(), elliptic_maps(), searched_maps()}) {
        for (const FormulaMapRow& row : family) {
            if (row.name == definition.projection) {
                return row.make(definition, map);
            }
        }
    }
    if (InverseMapPointer special = special_pseudocylindrical(definition, map)) {
        return special;
    }
    const double first = definition.angle("lat_1", 0.0);
    const double middle = 0.5 * (first + definition.angle("lat_2", first));
    if (InverseMapPointer found = azimuthal(map, {0.0, definition.angle("lat_0", 0.0)})) {
        return found;
    }
    if (InverseMapPointer found = straight_parallels(map, pi)) {
        return found;
    }
    InverseMapPointer conic = concentric_parallels(map, middle);
    return conic ? conic : concentric_parallels(map, first);
}

/// The largest value of a function of the points of the sphere on the map: the largest one on a
/// grid, from which ever smaller steps climb to the limb.
double largest(const ForwardMap& map, const std::function<double(const MapPoint&)>& value) {
    struct Best {
        SpherePoint at;
        double value = -std::numeric_limits<double>::infinity();
    };
    Best best;
    const auto climbs = [&](const SpherePoint& to) {
        const SpherePoint at{std::clamp(to.longitude, -pi, pi),
                             std::clamp(to.latitude, -0.5 * pi, 0.5 * pi)};
        const auto p = map(at);
        if (!p || !(value(*p) > best.value)) {
            return false;
        }
        best = {at, value(*p)};
        return true;
    };
    constexpr int steps = 90;
    for (int i = 0; i <= steps; ++i) {
        for (int j = 0; j <= steps; ++j) {
            climbs({pi * (2.0 * i / steps - 1.0), pi * (static_cast<double>(j) / steps - 0.5)});
        }
    }
    for (double step = 0.02; step > 1e-9; step *= 0.5) {
        bool climbed = true;
        for (int i = 0; i < 20 && climbed; ++i) {
            climbed = false;
            for (const auto& [east, north] :
                 {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
                climbed =
                    climbs({best.at.longitude + east * step, best.at.latitude + north * step}) ||
                    climbed;
            }
        }
    }
    constexpr double infinite = 8.0;
    return best.value < infinite ? best.value : pi;
}

MapExtent extent_of(const ForwardMap& map) {
    return {-largest(map, [](const MapPoint& p) { return -p.x; }),
            largest(map, [](const MapPoint& p) { return p.x; }),
            -largest(map, [](const MapPoint& p) { return -p.y; }),
            largest(map, [](const MapPoint& p) { return p.y; })};
}

// The largest error at points on the map in its rectangle; nothing if there are none.
std::optional<double> largest_error(const Map& made, const ForwardMap& map) {
    Graph graph;
    Emitter emit(graph);
    const Expr u = graph.variable(0);
    const Expr v = graph.variable(1);
    const ObjectPoint e = made.inverse->direction({u, v}, emit);
    std::vector<MapPoint> points;
    constexpr int columns = 24;
    constexpr int rows = 17;
    for (int i = 0; i < columns; ++i) {
        for (int j = 0; j < rows; ++j) {
            // Off the equator, the middle meridian and the poles, where the forward functions of
            // some maps are rounded to half of their digits.
            const auto p =
                map({pi * (2.0 * (i + 0.37) / columns - 1.0), pi * ((j + 0.53) / rows - 0.5)});
            if (p && made.extent.min_x <= p->x && p->x <= made.extent.max_x &&
                made.extent.min_y <= p->y && p->y <= made.extent.max_y) {
                points.push_back(*p);
            }
        }
    }
    const expr::BatchEvaluator evaluate(std::array{e.x, e.y, e.z, emit.valid()});
    const std::vector<double> values =
        evaluate(points.size(), [&](const expr::Node& leaf, std::span<double> at) {
            for (std::size_t i = 0; i < at.size(); ++i) {
                at[i] = leaf.detail == u.node().detail ? points[i].x : points[i].y;
            }
        });
    std::optional<double> worst;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto value = [&](std::size_t which) { return values[which * points.size() + i]; };
        if (value(3) != 0.0) {
            const auto p = map(sphere_point_of({value(0), value(1), value(2)}));
            const double error = p ? std::hypot(p->x - points[i].x, p->y - points[i].y)
                                   : std::numeric_limits<double>::infinity();
            worst = std::max(worst.value_or(0.0), error);
        }
    }
    return worst;
}

// PROJ's ob_tran: a map of the sphere with its north pole elsewhere, given by o_lat_p and o_lon_p.
InverseMapPointer oblique_transformation(const Definition& definition) {
    const Definition::Entry* projection = definition.find("o_proj");
    if (projection == nullptr || !definition.has("o_lat_p")) {
        return nullptr;
    }
    Definition inner{.projection = projection->value};
    for (const Definition::Entry& entry : definition.entries) {
        if (!entry.key.starts_with("o_") && entry.key != "lon_0") {
            inner.entries.push_back(entry);
        }
    }
    const Result<std::shared_ptr<const ProjMap>> map = ProjMap::make(inner);
    InverseMapPointer inverse = map ? inverse_of(inner, forward_of(*map)) : nullptr;
    if (!inverse) {
        return nullptr;
    }
    // The new pole is north of the old one on the far meridian; o_lon_p is the longitude of the
    // near meridian in the new axes.
    const SphereAxes axes =
        with_pole({pi, definition.angle("o_lat_p", 0.0)}).with_first_meridian(pi);
    return in_axes(axes, in_axes(turned(-definition.angle("o_lon_p", 0.0)), std::move(inverse)));
}

Diagnostic no_inverse(const Definition& definition) {
    return error(fmt::format("there is no inverse of this variant of the map projection '{}'",
                             definition.projection),
                 {},
                 "docs/maps.md lists the projections with an inverse, and why others have none");
}

}  // namespace

Result<Map> make_map(Definition definition) {
    Result<std::shared_ptr<const ProjMap>> whole = ProjMap::make(definition);
    if (!whole) {
        return std::move(whole.diagnostics);
    }
    // Projections that have a middle of their own ignore lon_0.
    const double longitude = definition.angle("lon_0", 0.0);
    Definition without_longitude = definition;
    without_longitude.remove("lon_0");
    Result<std::shared_ptr<const ProjMap>> unturned = ProjMap::make(without_longitude);
    const ForwardMap map = forward_of(*whole);
    const SpherePoint trial{0.3, 0.2};
    const auto at = map({trial.longitude + longitude, trial.latitude});
    const auto expected = unturned ? forward_of(*unturned)(trial) : std::nullopt;
    const bool turns =
        at && expected && std::hypot(at->x - expected->x, at->y - expected->y) < largest_map_error;

    Map made;
    if (definition.projection == "ob_tran") {
        made.inverse = oblique_transformation(definition);
    } else {
        made.inverse = turns ? inverse_of(without_longitude, forward_of(*unturned))
                             : inverse_of(definition, map);
    }
    if (!made.inverse) {
        return no_inverse(definition);
    }
    if (turns && longitude != 0.0) {
        made.inverse = in_axes(turned(longitude), std::move(made.inverse));
    }
    const std::optional<MapExtent> extent = made.inverse->extent();
    made.extent = extent ? *extent : extent_of(map);
    const std::optional<double> measured = largest_error(made, map);
    if (!measured || !(*measured <= largest_map_error)) {
        return no_inverse(definition);
    }
    return made;
}

}  // namespace balcony::camera::maps

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/maps/proj_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "balcony/names.hpp"
#include "camera/maps/proj/functions.hpp"

namespace balcony::camera::maps {

namespace {

// Operations of PROJ that are no maps.
constexpr std::array no_maps{
    "affine",     "axisswap",    "cart",        "defmodel",   "deformation", "geoc",
    "geocent",    "geogoffset",  "helmert",     "hgridshift", "horner",      "molobadekas",
    "molodensky", "noop",        "pipeline",    "pop",        "push",        "set",
    "tinshift",   "topocentric", "unitconvert", "vertoffset", "vgridshift",  "xyzgridshift"};
constexpr std::array coordinates{"longlat", "latlong", "lonlat", "latlon"};

template <std::size_t count>
bool contains(const std::array<const char*, count>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

// Of a PROJ that is there: a map is made by it, and nothing else here is called before.
const ProjFunctions& proj() { return **proj_functions(); }

std::vector<std::string> map_names() {
    std::vector<std::string> names;
    for (const PJ_OPERATIONS* row = proj().list_operations(); row->id != nullptr; ++row) {
        if (!contains(no_maps, row->id) && !contains(coordinates, row->id)) {
            names.emplace_back(row->id);
        }
    }
    return names;
}

// The last line of PROJ's description names the parameters: "Conic, Sph&Ell\n\tlat_1= and lat_2=".
std::string parameters_of(std::string_view projection) {
    for (const PJ_OPERATIONS* row = proj().list_operations(); row->id != nullptr; ++row) {
        const std::string_view description = *row->descr;
        const std::size_t equals = description.find('=');
        if (row->id == projection && equals != std::string_view::npos) {
            const std::size_t line = description.find_last_of("\n\t", equals);
            return std::string(description.substr(line + 1));
        }
    }
    return {};
}

Diagnostic unknown(const std::string& name) {
    return error(fmt::format("PROJ has no map projection named '{}'", name), {},
                 did_you_mean(name, map_names(),
                              "docs/maps.md lists the names; 'robin' is the Robinson projection"));
}

Diagnostic rejected(const Definition& definition, std::string_view reason) {
    const std::string parameters = parameters_of(definition.projection);
    return error(
        fmt::format("PROJ rejects this definition of '{}': {}", definition.projection, reason), {},
        parameters.empty() ? fmt::format("check its parameters: {}", definition.text())
                           : fmt::format("its parameters are, in degrees: {}", parameters));
}

// PROJ replaces the given radius for projections that were made for one sphere.
double fixed_radius(std::string_view projection) {
    constexpr std::array fixed{"alsk", "gs48", "gs50"};
    return contains(fixed, projection) ? 6370997.0 : 1.0;
}

}  // namespace

Direction direction_of(const SpherePoint& point) {
    const double cosine = std::cos(point.latitude);
    return {cosine * std::cos(point.longitude), cosine * std::sin(point.longitude),
            std::sin(point.latitude)};
}

SpherePoint sphere_point_of(const Direction& d) {
    return {std::atan2(d.y, d.x), std::atan2(d.z, std::hypot(d.x, d.y))};
}

void ProjMap::Destroy::operator()(pj_ctx* context) const { proj().context_destroy(context); }
void ProjMap::Destroy::operator()(PJconsts* projection) const { proj().destroy(projection); }

Result<std::shared_ptr<const ProjMap>> ProjMap::make(const Definition& definition) {
    const std::string& name = definition.projection;
    if (contains(coordinates, name)) {
        return error(fmt::format("'{}' gives longitude and latitude, which are not a map", name),
                     {}, R"(write "eqc", the map with longitude and latitude as x and y)");
    }
    if (const auto& functions = proj_functions(); !functions) {
        return functions.diagnostics;
    }
    const std::vector<std::string> names = map_names();
    if (contains(no_maps, name)) {
        return error(fmt::format("'{}' is a transformation, not a map projection", name), {},
                     R"(name a map projection, for example "robin")");
    }
    if (std::find(names.begin(), names.end(), name) == names.end()) {
        return unknown(name);
    }
    const auto made = std::make_shared<ProjMap>();
    made->context_.reset(proj().context_create());
    proj().log_level(made->context_.get(), PJ_LOG_NONE);
    made->projection_.reset(proj().create(made->context_.get(), definition.text().c_str()));
    made->radius_ = fixed_radius(name);
    if (!made->projection_) {
        const int problem = proj().context_errno(made->context_.get());
        return rejected(definition, proj().context_errno_string(made->context_.get(), problem));
    }
    if (proj().pj_info(made->projection_.get()).has_inverse == 0) {
        return error(fmt::format("PROJ has no inverse of the map projection '{}'", name), {},
                     "choose a similar projection that has one: docs/maps.md lists them by class");
    }
    return std::shared_ptr<const ProjMap>(made);
}

std::optional<MapPoint> ProjMap::operator()(const SpherePoint& point) const {
    PJ* projection = projection_.get();
    proj().errno_reset(projection);
    PJ_COORD given{};
    given.lp = {point.longitude, point.latitude};
    const PJ_COORD at = proj().trans(projection, PJ_FWD, given);
    if (proj().errno_of(projection) != 0 || !std::isfinite(at.xy.x) || !std::isfinite(at.xy.y)) {
        return std::nullopt;
    }
    return MapPoint{at.xy.x / radius_, at.xy.y / radius_};
}

}  // namespace balcony::camera::maps

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Object generator, PCS → OCS: the sphere by a map projection of PROJ.

#include <array>
#include <numbers>

#include <fmt/format.h>

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"
#include "camera/maps/map_inverse.hpp"

namespace balcony::camera {

namespace {

/// Its points are the viewpoint, or at a distance from it on the rays; its normals are the rays.
class ProjectedSphere final : public ObjectGenerator {
public:
    ProjectedSphere(maps::Map map, Scalar radius, bool outside)
        : map_(std::move(map)), radius_(std::move(radius)), outside_(outside) {}
    int dimension() const override { return 2; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        const ObjectPoint unit = map_.inverse->direction(p, emit);
        const Expr r = emit(radius_);
        return {r * unit.x, r * unit.y, r * unit.z};
    }
    std::optional<ObjectVector> normal(const ParameterPoint& p, Emitter& emit) const override {
        const ObjectPoint unit = map_.inverse->direction(p, emit);
        return ObjectVector{unit.x, unit.y, unit.z};
    }
    std::optional<ParameterRectangle> own_picture() const override {
        const maps::MapExtent& m = map_.extent;
        // Seen from the centre of the sphere, east is on the left.
        return outside_ ? ParameterRectangle{m.min_x, m.max_x, m.min_y, m.max_y}
                        : ParameterRectangle{m.max_x, m.min_x, m.min_y, m.max_y};
    }

private:
    maps::Map map_;
    Scalar radius_;
    bool outside_;
};

constexpr std::array proj_angles{"lon_0",  "lat_0", "lat_1", "lat_2",
                                 "lat_ts", "alpha", "tilt",  "azi"};
constexpr std::array proj_numbers{"h", "n", "m"};

StageResult make_map_projection(const Arguments& a) {
    Result<maps::Definition> definition = maps::read_definition(a.choice("definition"));
    if (!definition) {
        return std::move(definition.diagnostics);
    }
    constexpr double degree = std::numbers::pi / 180.0;
    for (const char* name : proj_angles) {
        if (a.has(name)) {
            definition->set(name, fmt::format("{:.17g}", a.constant(name) / degree));
        }
    }
    for (const char* name : proj_numbers) {
        if (a.has(name)) {
            definition->set(name, fmt::format("{:.17g}", a.constant(name)));
        }
    }
    Result<maps::Map> map = maps::make_map(std::move(*definition));
    if (!map) {
        return std::move(map.diagnostics);
    }
    return {std::make_shared<const ProjectedSphere>(std::move(*map), a.number("radius"),
                                                    a.choice("seen_from") == "outside"),
            std::move(definition.diagnostics)};
}

StageParameter parameter_of_proj(std::string_view name, Unit unit, std::string_view meaning) {
    return {.name = name,
            .type = NumberParameter{.unit = unit, .constant = true},
            .optional = true,
            .meaning = meaning};
}

}  // namespace

std::vector<StageEntry> map_projections() {
    return {
        {.name = "projection",
         .meaning = "the sphere of directions, or any sphere, by one of PROJ's map projections; no "
                    "map is needed",
         .formula = R"(
p = radius e   at the longitude λ and latitude φ of the point (u, v) of the map:
e = (cos φ cos λ, cos φ sin λ, sin φ),   (u, v) = forward(λ, φ)
u to the east and v to the north, in radii of the sphere, within 1e-9 of PROJ's
forward function;  no ray beyond the outline of the map
)",
         .parameters =
             {{.name = "definition",
               .type = NameParameter{},
               .meaning =
                   "the projection in the words of PROJ, on a sphere: \"robin\", \"+proj=lcc "
                   "+lat_1=30 +lat_2=60\""},
              number_parameter(
                  "radius", 0.0,
                  "the radius of the sphere of its points: 0 for a panorama, whose rays "
                  "are its normals; 1 for a direction object; that of a sphere around "
                  "an object to map"),
              choice_parameter(
                  "seen_from", {"inside", "outside"},
                  "which way the picture shows the map where there is no map statement: "
                  "inside is a panorama, with east on the left; outside is a map, with "
                  "east on the right, for look normal(inward)"),
              parameter_of_proj("lon_0", Unit::angle, "the longitude in the middle of the map"),
              parameter_of_proj("lat_0", Unit::angle, "the latitude of the map's origin"),
              parameter_of_proj("lat_1", Unit::angle, "the first standard parallel"),
              parameter_of_proj("lat_2", Unit::angle, "the second standard parallel"),
              parameter_of_proj("lat_ts", Unit::angle, "the latitude of true scale"),
              parameter_of_proj("alpha", Unit::angle,
                                "the azimuth of the line of an oblique cylinder"),
              parameter_of_proj("tilt", Unit::angle, "of the plane of a perspective view"),
              parameter_of_proj("azi", Unit::angle, "the azimuth of the tilt"),
              parameter_of_proj("h", Unit::number,
                                "the height of the viewer of a perspective view"),
              parameter_of_proj("n", Unit::number, "of projections with this parameter"),
              parameter_of_proj("m", Unit::number, "of projections with this parameter")},
         .make = make_map_projection,
         .dimension = 2,
         .example = R"(
// Everything around the viewer but zenith and nadir, with true angles: Mercator's projection.
camera mercator {
    eye  projection("merc")
    look normal
}
)"},
    };
}

}  // namespace balcony::camera

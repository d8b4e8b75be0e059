// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "balcony/catalogue.hpp"

namespace balcony::camera {

/// A stage as a maker returns it.
template <class Concrete, class... Values>
StageResult made(Values&&... values) {
    return {std::make_shared<const Concrete>(std::forward<Values>(values)...)};
}

/// A checked argument, as what a constructor takes.
struct Argument {
    const Arguments& all;
    std::string_view name;

    operator Scalar() const { return all.number(name); }
    operator double() const { return all.constant(name); }
    operator std::size_t() const { return all.count(name); }
    operator std::array<Scalar, 2>() const { return all.pair(name); }
    operator std::array<Scalar, 3>() const { return all.triple(name); }
};

/// The maker of a stage whose constructor takes the parameters with these names, in this order.
template <class Concrete, class... Names>
auto maker(Names... names) {
    return [names...](const Arguments& a) { return made<Concrete>(Argument{a, names}...); };
}

/// A stage of a known port as a maker returns it.
template <class Port>
StageResult as_stage(Result<std::shared_ptr<const Port>> made) {
    if (!made) {
        return std::move(made.diagnostics);
    }
    return {std::move(*made), std::move(made.diagnostics)};
}

// Each family of stages has its own file, with its rows of the catalogue.
// A new stage needs a class and a row in its family's file; a new family also needs a line here.
[[nodiscard]] std::vector<StageEntry> picture_affine();
[[nodiscard]] std::vector<StageEntry> picture_warps();
[[nodiscard]] std::vector<StageEntry> clip_shapes();
[[nodiscard]] std::vector<StageEntry> picture_mappers();
[[nodiscard]] std::vector<StageEntry> parameter_affine();
[[nodiscard]] std::vector<StageEntry> local_zoom();
[[nodiscard]] std::vector<StageEntry> complex_maps();
[[nodiscard]] std::vector<StageEntry> coins();
[[nodiscard]] std::vector<StageEntry> deformations();
[[nodiscard]] std::vector<StageEntry> grids();
[[nodiscard]] std::vector<StageEntry> seed_warps();
[[nodiscard]] std::vector<StageEntry> line_pair_warp();
[[nodiscard]] std::vector<StageEntry> repeats();
[[nodiscard]] std::vector<StageEntry> formula_transformers();
[[nodiscard]] std::vector<StageEntry> primitives();
[[nodiscard]] std::vector<StageEntry> curve_primitives();
[[nodiscard]] std::vector<StageEntry> surface_primitives();
[[nodiscard]] std::vector<StageEntry> spheres();
[[nodiscard]] std::vector<StageEntry> map_projections();
[[nodiscard]] std::vector<StageEntry> conics();
[[nodiscard]] std::vector<StageEntry> superconics();
[[nodiscard]] std::vector<StageEntry> spherical_product();
[[nodiscard]] std::vector<StageEntry> quadrics();
[[nodiscard]] std::vector<StageEntry> fractals();
[[nodiscard]] std::vector<StageEntry> spline_curves();
[[nodiscard]] std::vector<StageEntry> spline_surfaces();
[[nodiscard]] std::vector<StageEntry> arc_length_curve();
[[nodiscard]] std::vector<StageEntry> sweeps();
[[nodiscard]] std::vector<StageEntry> formula_objects();
[[nodiscard]] std::vector<StageEntry> mesh_surface();
[[nodiscard]] std::vector<StageEntry> screens();
[[nodiscard]] std::vector<StageEntry> ray_maps();
[[nodiscard]] std::vector<StageEntry> general_linear();
[[nodiscard]] std::vector<StageEntry> st_maps();
[[nodiscard]] std::vector<StageEntry> panini();
[[nodiscard]] std::vector<StageEntry> mirrors();
[[nodiscard]] std::vector<StageEntry> distorted_cameras();
[[nodiscard]] std::vector<StageEntry> splined_cameras();
[[nodiscard]] std::vector<StageEntry> closed_form_cameras();
[[nodiscard]] std::vector<StageEntry> calibration_files();
[[nodiscard]] std::vector<StageEntry> object_affine();
[[nodiscard]] std::vector<StageEntry> camera_placements();
[[nodiscard]] std::vector<StageEntry> parallel_surface();
[[nodiscard]] std::vector<StageEntry> projection();
[[nodiscard]] std::vector<StageEntry> normal_rule();
[[nodiscard]] std::vector<StageEntry> direction_rules();
[[nodiscard]] std::vector<StageEntry> curve_rules();
[[nodiscard]] std::vector<StageEntry> optical_rules();
[[nodiscard]] std::vector<StageEntry> blended_rule();
[[nodiscard]] std::vector<StageEntry> stereo_views();
[[nodiscard]] std::vector<StageEntry> lenses();
[[nodiscard]] std::vector<StageEntry> prescribed_lenses();
[[nodiscard]] std::vector<StageEntry> focus_surfaces();
[[nodiscard]] std::vector<StageEntry> curve_bend();
[[nodiscard]] std::vector<StageEntry> field_bend();
[[nodiscard]] std::vector<StageEntry> pinhole_chain();

/// A family's rows, and what they need not say one by one.
struct Family {
    std::vector<StageEntry> (*rows)();
    std::optional<StageKind> kind{};  ///< Without it, each row has its own.
    std::string_view section{};
};

inline constexpr std::array families = {
    Family{picture_affine, StageKind::picture_arranger},
    Family{picture_warps, StageKind::picture_arranger},
    Family{clip_shapes, StageKind::clip_shape},
    Family{picture_mappers, StageKind::picture_mapper},
    Family{parameter_affine, StageKind::parameter_transformer},
    Family{local_zoom, StageKind::parameter_transformer},
    Family{formula_transformers},
    Family{primitives, StageKind::object_generator},
    Family{curve_primitives, StageKind::object_generator},
    Family{surface_primitives, StageKind::object_generator},
    Family{spheres, StageKind::object_generator},
    Family{map_projections, StageKind::object_generator, "Map projections"},
    Family{conics, StageKind::object_generator, "Conics and superconics"},
    Family{superconics, StageKind::object_generator, "Conics and superconics"},
    Family{spherical_product, StageKind::object_generator, "Quadrics and superquadrics"},
    Family{quadrics, StageKind::object_generator, "Quadrics and superquadrics"},
    Family{fractals, StageKind::object_generator, "Fractal objects"},
    Family{spline_curves, StageKind::object_generator, "General curves"},
    Family{spline_surfaces, StageKind::object_generator, "Free-form surfaces"},
    Family{arc_length_curve, StageKind::object_generator, "General curves"},
    Family{sweeps, StageKind::object_generator, "Sweeps"},
    Family{formula_objects, StageKind::object_generator, "Objects from formulas"},
    Family{mesh_surface, StageKind::object_generator, "Free-form surfaces"},
    Family{screens, StageKind::object_generator},
    Family{ray_maps, StageKind::object_generator, "Free-form surfaces"},
    Family{general_linear, StageKind::object_generator},
    Family{panini, StageKind::object_generator},
    Family{mirrors, StageKind::object_generator, "Mirrors"},
    Family{calibration_files, StageKind::object_generator, "Calibrated cameras"},
    Family{distorted_cameras, StageKind::object_generator, "Calibrated cameras"},
    Family{splined_cameras, StageKind::object_generator, "Calibrated cameras"},
    Family{closed_form_cameras, StageKind::object_generator, "Calibrated cameras"},
    Family{object_affine, StageKind::object_transformer},
    Family{camera_placements, StageKind::object_transformer},
    Family{parallel_surface, StageKind::object_transformer},
    Family{projection, StageKind::object_transformer},
    Family{normal_rule, StageKind::direction_rule},
    Family{direction_rules, StageKind::direction_rule},
    Family{curve_rules, StageKind::direction_rule},
    Family{optical_rules, StageKind::direction_rule},
    Family{blended_rule, StageKind::direction_rule},
    Family{stereo_views, StageKind::stereo_view},
    Family{lenses, StageKind::lens},
    Family{prescribed_lenses, StageKind::lens},
    Family{focus_surfaces, StageKind::focus},
    Family{curve_bend, StageKind::bend},
    Family{field_bend, StageKind::bend},
    Family{pinhole_chain, StageKind::bend},
    Family{complex_maps, StageKind::parameter_transformer},
    Family{coins, StageKind::object_transformer},
    Family{deformations, StageKind::object_transformer},
    Family{repeats},
    Family{grids},
    Family{seed_warps},
    Family{line_pair_warp, StageKind::parameter_transformer},
    Family{st_maps, StageKind::parameter_transformer},
};

}  // namespace balcony::camera

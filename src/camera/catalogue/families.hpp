// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "balcony/catalogue.hpp"

namespace balcony::camera {

/// A stage as a maker returns it.
template <class Concrete, class... Values>
Result<std::shared_ptr<const Stage>> made(Values&&... values) {
    return {std::make_shared<const Concrete>(std::forward<Values>(values)...)};
}

/// A stage of a known port as a maker returns it.
template <class Port>
Result<std::shared_ptr<const Stage>> as_stage(Result<std::shared_ptr<const Port>> made) {
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
[[nodiscard]] std::vector<StageEntry> st_maps();
[[nodiscard]] std::vector<StageEntry> panini();
[[nodiscard]] std::vector<StageEntry> mirrors();
[[nodiscard]] std::vector<StageEntry> distorted_cameras();
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
[[nodiscard]] std::vector<StageEntry> focus_surfaces();

inline constexpr auto families = {
    picture_affine,
    picture_warps,
    clip_shapes,
    picture_mappers,
    parameter_affine,
    local_zoom,
    formula_transformers,
    primitives,
    curve_primitives,
    surface_primitives,
    spheres,
    map_projections,
    conics,
    superconics,
    spherical_product,
    quadrics,
    fractals,
    spline_curves,
    spline_surfaces,
    arc_length_curve,
    sweeps,
    formula_objects,
    mesh_surface,
    screens,
    ray_maps,
    panini,
    mirrors,
    calibration_files,
    distorted_cameras,
    closed_form_cameras,
    object_affine,
    camera_placements,
    parallel_surface,
    projection,
    normal_rule,
    direction_rules,
    curve_rules,
    optical_rules,
    blended_rule,
    stereo_views,
    lenses,
    focus_surfaces,
    complex_maps,
    coins,
    deformations,
    repeats,
    grids,
    seed_warps,
    line_pair_warp,
    st_maps,
};

}  // namespace balcony::camera

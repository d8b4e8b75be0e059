// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The formulas of a camera, ready to be written in another language.

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/export.hpp"
#include "balcony/ray_roots.hpp"

namespace balcony::bridge {

using expr::Expr;
using expr::Op;
using rays::RayRoots;

/// The inputs beside x, y and t: the size of the picture in pixels.
inline constexpr std::string_view width_input = "width";
inline constexpr std::string_view height_input = "height";

/// A stage with what it computes.
struct StageFormulas {
    std::string name;                ///< In words: "warp zoom".
    std::string written;             ///< As the camera's file has it: "warp zoom(at = (1, 0))".
    std::vector<Expr> values;        ///< Two or three, simplified.
    std::vector<std::string> names;  ///< Of the values: "u", "v".
};

struct CameraFormulas {
    std::unique_ptr<expr::Graph> graph;
    std::vector<StageFormulas> stages;
    /// Those of RayRoots, simplified; with footprints if they were requested or are measured by.
    std::vector<Expr> roots;
    /// Which of the roots is listed as a condition; all others are numbers.
    std::optional<std::size_t> condition = RayRoots::valid;
    Axes axes = Axes::z_up;  ///< Of the ray.
    bool lens = false;       ///< The ray depends on the inputs of a lens.
};

struct FormulaRequest {
    std::string_view target;  ///< The export that they are for, as `balcony export --to` has it.
    Axes axes = Axes::z_up;
    bool footprints = false;
    /// Footprints only to measure by: they are computed from the other roots, which stay as they
    /// are without them.
    bool measured = false;
};

/// The formulas of a camera in a picture of any size. An error if they are too large, if they need
/// a scene, if a stage has no formula, or if the rays are bent.
[[nodiscard]] Result<CameraFormulas> formulas_of(const camera::Camera& camera,
                                                 const FormulaRequest& request);

/// The error of formulas that do not fit into a graph.
[[nodiscard]] Diagnostic too_large_error(std::string_view camera);

/// The stage in whose formulas a node first occurs; null for the ray itself.
[[nodiscard]] const StageFormulas* stage_with(const CameraFormulas& formulas, expr::NodeId node);

}  // namespace balcony::bridge

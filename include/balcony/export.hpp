// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Export: a camera as a text in another language, which computes the same rays without Balcony.
//
//     Camera ─▶ simplified formulas, stage by stage ─▶ the words of a language ─▶ text
//
// docs/bridges.md shows how other programs use these texts.

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/camera.hpp"

namespace balcony::bridge {

/// A number that stays open in the text: an input of the camera's formulas.
struct ExportParameter {
    std::string name;     ///< As the camera's file has it.
    std::string input;    ///< Its input in the formulas.
    std::string written;  ///< The text of its value: "45", "30deg".
    double value = 0.0;   ///< In radians if it is an angle.
    bool is_angle = false;
};

struct ExportSource {
    camera::Camera camera;
    std::vector<ExportParameter> parameters{};
    std::string title{};    ///< Where the camera comes from: "walls.cam:superelliptic".
    std::string comment{};  ///< What its author says about it, any number of lines.
};

struct ExportOptions {
    std::optional<Axes> axes{};  ///< Of the rays; by default the target's, or the camera's own.
    bool single = false;         ///< Single precision, where a language has both.
    bool inverse = false;        ///< Also a function from points to positions, where it has one.
    /// The picture, in pixels, in which single precision is judged; not judged if empty.
    std::optional<std::array<std::size_t, 2>> judged_in{};
};

/// What single precision changes in a picture: the rays of the exported formulas, as a processor
/// computes them, beside the exact ones.
struct SinglePrecision {
    std::size_t rays = 0;  ///< Compared, over the whole picture.
    std::size_t lost = 0;  ///< Of these, how many are there in one precision only.
    /// The largest and the 99th percentile of the differences, in pixels, as
    /// rays::pixels_between() measures them at the distance of the camera's own size.
    double largest = 0.0;
    double usual = 0.0;
    double x = 0.0, y = 0.0;  ///< Where the largest one is, in pixels.
};

/// A camera in another language.
struct ExportedCamera {
    std::string text;
    std::optional<SinglePrecision> single{};  ///< If the text is in single precision and judged.
};

struct CameraFormulas;

/// A language that cameras are exported to.
struct ExportTarget {
    std::string_view name;     ///< As `balcony export --to` has it.
    std::string_view meaning;  ///< One line for documentation.
    std::string_view ending;   ///< Of its files, with the dot.
    /// The text of the formulas of an adapted camera.
    Result<std::string> (*write)(const ExportSource& source, const ExportOptions& options,
                                 CameraFormulas formulas);
    bool always_single = false;     ///< It has single precision only.
    bool opens_parameters = false;  ///< Parameters stay open unless others are asked for.
    bool footprints = false;        ///< The text has the derivatives of the ray.
    bool has_inverse = false;       ///< It can find points: ExportOptions::inverse.
    std::optional<Axes> axes{};     ///< Of the rays, if these are not the camera's own.
    bool only_axes = false;         ///< These axes and no others.
    /// The camera as far as the language can have it; null if it can have all.
    Result<camera::Camera> (*adapted)(const camera::Camera& camera) = nullptr;
};

[[nodiscard]] std::span<const ExportTarget> export_targets();
/// Null if there is none of this name.
[[nodiscard]] const ExportTarget* find_export_target(std::string_view name);

/// Writes a camera in a language. A camera without a formula, one that needs a scene, and one that
/// is too large for the language are errors.
[[nodiscard]] Result<ExportedCamera> export_camera(const ExportTarget& target,
                                                   const ExportSource& source,
                                                   const ExportOptions& options = {});

}  // namespace balcony::bridge

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Export: a camera as a text in another language, which computes the same rays without Balcony.
//
//     Camera ─▶ simplified formulas, stage by stage ─▶ the words of a language ─▶ text
//
// docs/bridges.md shows how other programs use these texts.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/camera.hpp"

namespace balcony::bridge {

/// A number that whoever uses the text can change: an input of the camera's formulas.
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
};

/// A language that cameras are exported to.
struct ExportTarget {
    std::string_view name;     ///< As `balcony export --to` has it.
    std::string_view meaning;  ///< One line for documentation.
    std::string_view ending;   ///< Of its files, with the dot.
    bool always_single;        ///< It has single precision only.
    bool opens_parameters;     ///< Parameters stay open unless others are asked for.
    Result<std::string> (*write)(const ExportSource& source, const ExportOptions& options);
};

[[nodiscard]] std::span<const ExportTarget> export_targets();
/// Null if there is none of this name.
[[nodiscard]] const ExportTarget* find_export_target(std::string_view name);

/// What single precision changes in a picture.
struct SinglePrecision {
    std::size_t rays = 0;  ///< Compared, over the whole picture.
    std::size_t lost = 0;  ///< Of these, how many are there in one precision only.
    /// The largest and the 99th percentile of the differences, in pixels, as
    /// rays::pixels_between() measures them at the distance of the camera's own size.
    double largest = 0.0;
    double usual = 0.0;
    double x = 0.0, y = 0.0;  ///< Where the largest one is, in pixels.
};

/// Compares the rays of a camera in single precision, as a processor computes the exported
/// formulas, with the exact ones, in a picture of a size in pixels.
[[nodiscard]] Result<SinglePrecision> measure_single_precision(const ExportSource& source,
                                                               std::size_t width,
                                                               std::size_t height);

}  // namespace balcony::bridge

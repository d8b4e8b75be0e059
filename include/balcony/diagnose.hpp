// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Diagnose: samples a camera and says what its picture will be like: how large and how distorted
// things appear where, and what may be wrong with it. docs/analysis.md has the definitions.
//
//     diagnose(camera, settings) ─▶ report ─▶ false_color(report, map)

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Imath/ImathVec.h>

#include "balcony/base.hpp"
#include "balcony/camera.hpp"
#include "balcony/image.hpp"

namespace balcony::analyse {

using Imath::V2d;
using Imath::V3d;

// ----------------------------------------------------------------------------------- settings

/// Equally spaced points of a picture, one in the middle of each of its cells.
struct SampleGrid {
    double picture_width = 0.0;  ///< In pixels, as are all lengths here.
    double picture_height = 0.0;
    double step = 1.0;  ///< From sample to sample in both directions.
    std::size_t columns = 0;
    std::size_t rows = 0;

    /// As many samples, at least one, as cells of the given size fit into the picture; what is left
    /// over is at its borders.
    [[nodiscard]] static SampleGrid over(double picture_width, double picture_height, double step);

    [[nodiscard]] std::size_t size() const { return columns * rows; }
    [[nodiscard]] V2d first() const;
    /// Where the sample of an index (row by row) lies.
    [[nodiscard]] V2d at(std::size_t index) const;
};

struct DiagnoseSettings {
    double width = 1280.0;  ///< Of the picture, in pixels.
    double height = 720.0;
    std::size_t max_samples = 65536;
    double time = 0.0;  ///< The t of the camera's formulas.
    /// Where the picture is measured: how far from the origins of the rays, along them. Nothing is
    /// directions alone if all rays leave one point, else a quarter of the diagonal of the box that
    /// holds the origins.
    std::optional<double> distance;
};

// ------------------------------------------------------------------------------------- report

/// A point of the picture, in pixels from its top left corner, with its (u, v).
struct Place {
    V2d point;
    V2d parameters;
};

struct Statistics {
    double minimum = 0.0;
    double median = 0.0;
    double maximum = 0.0;
    Place min_at, max_at;
};

enum class FindingKind : std::uint8_t {
    no_ray,    ///< Parts of the picture without a ray.
    fold,      ///< The picture turns over and shows things a second time, mirrored.
    mirrored,  ///< The picture, or a part of it that nothing joins to the rest, is a mirror image.
    seam,      ///< Neighbouring rays jump, however near they are.
    singular,  ///< A pixel's ray does not change in some direction, or changes without bound.
    repeated,  ///< Points of the picture have one and the same ray.
};

[[nodiscard]] std::string_view name_of(FindingKind kind);

struct Finding {
    FindingKind kind = FindingKind::no_ray;
    bool defect = true;          ///< False for what is worth knowing, but may well be wanted.
    std::size_t count = 0;       ///< How many regions or lines of the picture it concerns.
    double share = 0.0;          ///< Of the picture; 0 for lines.
    double length = 0.0;         ///< Of lines, in pixels; 0 for regions.
    Place place;                 ///< An example, in the largest region or on the longest line.
    std::optional<Place> other;  ///< Where the same ray is once more, or across a fold.
    std::string message;         ///< What is there, as a Diagnostic's message.
    std::string remedy;
};

struct Sample {
    bool valid = false;
    bool singular = false;
    bool seam = false;             ///< A seam passes on the way to one of its four neighbours.
    int orientation = 0;           ///< 1 as things are, -1 mirrored, 0 unknown.
    std::uint8_t views = 0;        ///< Points of the picture with this ray.
    double magnification = 0.0;    ///< 0 where there is no ray, or it is singular.
    double anisotropy = 0.0;       ///< The same.
    double origin_distance = 0.0;  ///< Of the origin from the middle of all origins.
};

struct Report {
    std::string camera;
    SampleGrid grid;
    std::vector<Sample> samples;     ///< Row by row.
    bool single_viewpoint = false;   ///< All rays leave one point.
    double origin_extent = 0.0;      ///< The diagonal of the box that holds the origins.
    std::optional<double> distance;  ///< Where it was measured; nothing is directions alone.
    double valid_share = 0.0;
    std::optional<Statistics> magnification;  ///< Pixels a degree, or a unit of length.
    std::optional<Statistics> anisotropy;     ///< From 1; 1 shows shapes as they are.
    std::vector<Finding> findings;            ///< Defects first.

    [[nodiscard]] bool has_defects() const;
};

[[nodiscard]] Result<Report> diagnose(const camera::Camera& camera,
                                      const DiagnoseSettings& settings);

// --------------------------------------------------------------------------------------- maps

/// What a picture in false colours can show.
enum class MapKind : std::uint8_t {
    magnification,
    anisotropy,
    orientation,
    validity,
    seams,
    repeated,
    origins,
};

struct MapDescription {
    MapKind kind;
    std::string_view name;     ///< As users write it.
    std::string_view meaning;  ///< One line for documentation.
};

[[nodiscard]] const std::vector<MapDescription>& map_kinds();
[[nodiscard]] std::optional<MapKind> find_map_kind(std::string_view name);

/// The samples of a report as a picture in false colours, with a legend below it.
[[nodiscard]] Image false_color(const Report& report, MapKind kind);

}  // namespace balcony::analyse

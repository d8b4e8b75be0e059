// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Diagnose: samples a camera and reports the properties of its picture: how large and how distorted
// things appear, and possible defects. docs/analysis.md has the definitions.
//
//     diagnose(camera, settings) ─▶ report ─▶ false_color(report, map)

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include <Imath/ImathBox.h>
#include <Imath/ImathVec.h>

#include "balcony/base.hpp"
#include "balcony/camera.hpp"
#include "balcony/image.hpp"
#include "balcony/names.hpp"
#include "balcony/progress.hpp"

namespace balcony::analyse {

using Imath::V2d;
using Imath::V3d;

// ----------------------------------------------------------------------------------- settings

/// Equally spaced points of a picture, one at the centre of each cell.
struct SampleGrid {
    double picture_width = 0.0;  ///< In pixels, like all lengths here.
    double picture_height = 0.0;
    double step = 1.0;  ///< From sample to sample in both directions.
    std::size_t columns = 0;
    std::size_t rows = 0;

    /// As many samples as cells of the given size fit into the picture, but at least one; the
    /// remainder is at its borders.
    [[nodiscard]] static SampleGrid over(double picture_width, double picture_height, double step);

    [[nodiscard]] std::size_t size() const { return columns * rows; }
    [[nodiscard]] V2d first() const;
    /// The position of the sample with an index (row by row).
    [[nodiscard]] V2d at(std::size_t index) const;
    /// The cells of samples, in rising order, joined to boxes that do not overlap. Cells at the
    /// borders reach to the end of the picture.
    [[nodiscard]] std::vector<Imath::Box2d> cells_of(const std::vector<std::size_t>& samples) const;
};

struct DiagnoseSettings {
    double width = 1280.0;  ///< Width of the picture in pixels.
    double height = 720.0;
    std::size_t max_samples = 65536;
    double time = 0.0;  ///< The value of t in the camera's formulas.
    /// The distance of the measurement from the ray origins, along the rays. Nothing means
    /// directions only if all rays start at one point, otherwise where a lens is focused in the
    /// middle of the picture or, without one, a quarter of the diagonal of the bounding box of the
    /// origins.
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
    bool defect = true;     ///< False for what is worth knowing, but may well be wanted.
    std::size_t count = 0;  ///< How many regions or lines of the picture it concerns.
    double share = 0.0;     ///< Fraction of the picture; 0 for lines.
    double length = 0.0;    ///< Length of lines in pixels; 0 for regions.
    Place place;            ///< An example, in the largest region or on the longest line.
    std::optional<Place>
        other;            ///< Another position with the same ray, or on the other side of a fold.
    std::string message;  ///< A message like that of a Diagnostic.
    std::string remedy;
    /// Those of CameraReport::samples in the regions, or on both sides of the lines; rising.
    std::vector<std::size_t> samples{};
};

struct Sample {
    bool valid = false;
    bool singular = false;
    bool seam = false;             ///< A seam separates it from one of its four neighbours.
    int orientation = 0;           ///< 1 unmirrored, -1 mirrored, 0 unknown.
    std::uint8_t views = 0;        ///< Number of points of the picture with this ray.
    double magnification = 0.0;    ///< 0 where there is no ray, or where it is singular.
    double anisotropy = 0.0;       ///< The same.
    double origin_distance = 0.0;  ///< Distance of the origin from the centre of all origins.
    /// By how much a pixel is longer on the surface than the camera's scale says: 0.1 is a tenth.
    /// diagnose() knows no surfaces; render::scale_errors() does.
    std::optional<double> scale_error{};
};

struct CameraReport {
    std::string camera;
    SampleGrid grid;
    std::vector<Sample> samples;    ///< Row by row.
    bool single_viewpoint = false;  ///< All rays start at one point.
    double origin_extent = 0.0;     ///< The diagonal of the bounding box of the origins.
    std::optional<double>
        distance;  ///< The distance of the measurement; nothing if only directions matter.
    double valid_share = 0.0;
    std::optional<Statistics> magnification;  ///< Pixels per degree, or per unit of length.
    std::optional<Statistics> anisotropy;     ///< At least 1; 1 preserves shapes.
    std::vector<Finding> findings;            ///< Defects first.

    [[nodiscard]] bool has_defects() const;
};

/// An error of Kind::interrupted if it is stopped.
[[nodiscard]] Result<CameraReport> diagnose(const camera::Camera& camera,
                                            const DiagnoseSettings& settings,
                                            const PartDone& progress = {},
                                            std::stop_token stop = {});

// --------------------------------------------------------------------------------------- maps

/// The quantities that a false-colour picture can show.
enum class MapKind : std::uint8_t {
    magnification,
    anisotropy,
    orientation,
    validity,
    seams,
    repeated,
    origins,
    scale,  ///< Sample::scale_error.
};

[[nodiscard]] Names<MapKind> map_kinds();

/// The samples of a report as a false-colour picture, with a legend below it.
[[nodiscard]] Image false_color(const CameraReport& report, MapKind kind);

}  // namespace balcony::analyse

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Ray maps: the rays of a camera as data for programs that know nothing of cameras.
//
//     RayGrid::make(picture, settings) ─▶ write_ray_map(grid, "rays.exr")
//                                      ─▶ stream_rays(grid, NumberFormat::text, sink)
//
// All of these work row by row from the top left, in memory that does not grow with the picture.
// docs/raymaps.md describes the files.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/picture.hpp"
#include "balcony/rays.hpp"

namespace balcony::bridge {

struct RaySettings {
    std::size_t width = 0;  ///< Of the picture, in pixels.
    std::size_t height = 0;
    /// The name of a camera layer, or its number: "2", or "3.1" in the picture of layer 3. A
    /// picture with one camera layer needs none.
    std::string layer{};
    std::optional<Axes> axes{};  ///< By default those of the camera.
    double time = 0.0;           ///< The value of t in the camera's formulas.
    bool footprints = false;     ///< Include the derivatives by picture x and y.

    bool operator==(const RaySettings&) const = default;
};

/// The rays of one camera through the pixel centres of a picture. Of a layer, those where it covers
/// something, whatever is in front of it; of a camera with a lens, those through its middle.
/// Immutable, may be shared by threads.
class RayGrid {
public:
    /// A picture with several camera layers needs a layer; the error lists them.
    [[nodiscard]] static Result<RayGrid> make(const camera::Picture& picture,
                                              const RaySettings& settings);

    [[nodiscard]] std::size_t width() const { return width_; }
    [[nodiscard]] std::size_t height() const { return height_; }
    [[nodiscard]] std::size_t size() const { return width_ * height_; }
    [[nodiscard]] const std::string& name() const { return layer_.name; }
    [[nodiscard]] Axes axes() const { return layer_.axes; }
    [[nodiscard]] bool has_footprints() const { return layer_.rays.has_footprints(); }
    /// Whether each ray has a time of its own.
    [[nodiscard]] bool has_times() const { return layer_.rays.has_times(); }

    /// The rays of a rectangle of pixels, row by row.
    void run(std::size_t x, std::size_t y, std::size_t width, std::size_t height,
             rays::Scratch& scratch, rays::RayBatch& rays) const;
    /// The rays of any points of the picture, in pixels.
    void run_at(std::span<const double> x, std::span<const double> y, rays::Scratch& scratch,
                rays::RayBatch& rays) const;

private:
    RayGrid(rays::VisibleLayer layer, const RaySettings& settings)
        : layer_(std::move(layer)),
          width_(settings.width),
          height_(settings.height),
          time_(settings.time) {}

    rays::VisibleLayer layer_;
    std::size_t width_;
    std::size_t height_;
    double time_;
};

/// A number of a ray as files have it. Where there is no ray, all of them are 0.
struct RayColumn {
    std::string_view name;  ///< Of the channel in an EXR file: origin.X, direction.X, valid.A, ...
    double (*value)(const rays::RayBatch& rays, std::size_t i);
};

/// The columns of a ray map in their order: origin, direction, valid, (u, v), then the footprint if
/// the grid has it, then the time if each ray has its own.
[[nodiscard]] std::vector<RayColumn> ray_columns(const RayGrid& grid);

/// How numbers are written: the shortest decimal text that reads back as the same double, or
/// binary, in the byte order of the machine.
enum class NumberFormat : std::uint8_t { text, single_precision, double_precision };

/// Receives bytes in the order of the output; false ends the writing.
using ByteSink = std::function<bool(std::span<const char>)>;

/// How writing went.
struct RaysWritten {
    std::size_t rays = 0;    ///< Written, valid or not.
    std::size_t valid = 0;   ///< Of these.
    bool complete = false;   ///< Otherwise the sink or a stop ended it.
    Diagnostics problems{};  ///< Of a file that cannot be written.
};

/// Writes six numbers for each ray, origin and direction of unit length, as Radiance's rtrace reads
/// them: text has a line for each ray. Six zeros are no ray.
[[nodiscard]] RaysWritten stream_rays(const RayGrid& grid, NumberFormat format,
                                      const ByteSink& sink, const std::stop_token& stop = {});

/// Writes a ray map by the file's extension: .exr, with 32-bit floats, or .npy, an array of the
/// shape (height, width, columns) in the given precision. The file is complete or unchanged. An
/// extension that is neither, and text, are errors.
[[nodiscard]] RaysWritten write_ray_map(const RayGrid& grid, const std::filesystem::path& file,
                                        NumberFormat format, const std::stop_token& stop = {});

}  // namespace balcony::bridge

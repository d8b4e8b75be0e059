// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// STMaps: from which place of a photo each pixel of a camera's picture comes, and photos that are
// warped by it.
//
//     StMap::make(camera, source) ─▶ write_st_map(map, "st.exr")
//                                 ─▶ warp_photo(map, "photo.jpg", "warped.png")
//
// A photo knows the light of directions from one point. So the camera needs a single viewpoint, as
// the camera of the photo has one; both are taken to be at the same place.

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <stop_token>
#include <vector>

#include <Imath/ImathVec.h>

#include "balcony/base.hpp"
#include "balcony/image_points.hpp"
#include "balcony/ray_maps.hpp"

namespace balcony::bridge {

using rays::V2d;
using rays::V3d;

/// The point nearest to some rays, as lines, by least squares, and how far from it they pass.
struct Viewpoint {
    V3d point{0.0};
    double largest = 0.0;  ///< Distance of a ray from the point, in scene units.
    double median = 0.0;
    double spread = 0.0;  ///< The largest distance of an origin from the point.

    /// Whether all rays meet in the point, but for rounding in single precision.
    [[nodiscard]] bool is_single() const {
        return largest <= 1e-6 * spread + 1e-10 * point.length();
    }
};

/// Of the rays of a grid, at up to some ten thousand places; all zeros without a valid ray.
[[nodiscard]] Viewpoint find_viewpoint(const RayGrid& grid);

/// The camera that a photo was taken with.
struct SourceCamera {
    RayGrid rays;  ///< Of the photo's pixels, with footprints and with z up.
    /// Finds points, with z up, in the picture of this camera in the size of the grid.
    std::shared_ptr<const rays::ImagePointFinder> finder;
};

/// A place in a photo: s from its left to its right side and t from its bottom to its top, from 0
/// to 1, and the change from pixel to pixel, by picture x and y (down).
struct SourcePlace {
    bool valid = false;     ///< Whether the photo shows what the pixel's centre sees.
    double coverage = 0.0;  ///< The part of the pixel that the photo shows.
    V2d st{0.0};            ///< Of the centre or, if only another part is shown, of that.
    V2d st_by_x{0.0}, st_by_y{0.0};
};

enum class Parallax { refuse, ignore };

/// The places in a photo that the pixels of a camera's picture show. Immutable, may be shared by
/// threads, cheap to copy.
class StMap {
public:
    /// The rays have footprints and z up. A camera without a single viewpoint, that of the photo or
    /// the other one, is an error, which says how far it is from one; if parallax is ignored, only
    /// the directions of its rays count, and this is a warning.
    [[nodiscard]] static Result<StMap> make(const RayGrid& rays, const SourceCamera& source,
                                            Parallax parallax = Parallax::refuse);

    [[nodiscard]] std::size_t width() const;
    [[nodiscard]] std::size_t height() const;
    /// Whether the left and the right side of the photo show the same, as those of a panorama.
    [[nodiscard]] bool closes() const;

    /// The places for some rows, row by row.
    void run(std::size_t first_row, std::size_t rows, std::vector<SourcePlace>& places) const;
    /// Those of any places of the camera's picture, in pixels; the coverage is 1 or 0.
    void at(std::span<const V2d> of, std::vector<SourcePlace>& places) const;

private:
    class Index;
    explicit StMap(std::shared_ptr<const Index> index) : index_(std::move(index)) {}
    std::shared_ptr<const Index> index_;
};

/// What came of a map or a photo.
struct StMapWritten {
    std::size_t valid = 0;  ///< Pixels that the photo shows.
    bool complete = false;  ///< Otherwise a stop or a problem ended it.
    Diagnostics problems{};
};

/// What is known to be wrong with the file of a map before it is written: its folder, its
/// extension, which is .exr.
[[nodiscard]] Diagnostics check_st_map_file(const std::filesystem::path& file);

/// Writes an EXR file of 32-bit floats: red is s and green is t of each pixel's centre, blue is 0,
/// alpha is 1 where the photo shows the pixel and otherwise 0, like the rest.
[[nodiscard]] StMapWritten write_st_map(const StMap& map, const std::filesystem::path& file,
                                        const std::stop_token& stop = {});

/// A photo as it is read, or by photo_of() of photo_arrays.hpp. Copies share its pixels.
class Photo {
public:
    /// In any format that images::ImageFile opens.
    [[nodiscard]] static Result<Photo> load(const std::filesystem::path& file);

    [[nodiscard]] std::size_t width() const;
    [[nodiscard]] std::size_t height() const;
    /// Whether it has whole numbers of more than 8 bits.
    [[nodiscard]] bool is_deep() const;

    struct Pixels;
    [[nodiscard]] static Photo of(Pixels pixels);
    [[nodiscard]] const Pixels& pixels() const { return *pixels_; }

private:
    explicit Photo(std::shared_ptr<const Pixels> pixels) : pixels_(std::move(pixels)) {}
    std::shared_ptr<const Pixels> pixels_;
};

/// Warps a photo: each pixel is the mean of the part of the photo that it shows, in linear light,
/// filtered by OpenImageIO, and transparent as far as the photo does not show it. The file's
/// extension says the format: .exr has linear light, the others are sRGB, limited to 0 .. 1. A deep
/// photo gives a deep file if the format permits it, which says `dpi`, as images::Raster::dpi.
[[nodiscard]] StMapWritten warp_photo(const StMap& map, const Photo& photo,
                                      const std::filesystem::path& file, double dpi = 0.0,
                                      const std::stop_token& stop = {});

}  // namespace balcony::bridge

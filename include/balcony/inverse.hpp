// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Inverse: from a point in space to the picture positions that show it.
//
// A ray o(x, y) + t d(x, y) meets the point P if the component of P - o perpendicular to d
// is zero: two equations for x and y with none, one or several solutions. Each
// camera layer of a picture is such a function of the whole picture's x and y.

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include <Imath/ImathVec.h>

#include "balcony/image_points.hpp"
#include "balcony/picture.hpp"
#include "balcony/progress.hpp"

namespace balcony::analyse {

using Imath::V2d;
using Imath::V3d;

class Work;

/// A picture position whose ray meets a point.
struct Sighting {
    std::size_t point = 0;  ///< The index of the point among the given points.
    std::size_t layer = 0;  ///< The camera layer of the picture that shows it, from 0 at the back.
    V2d position;           ///< In pixels, within [0, width) x [0, height).
    V3d origin;             ///< The origin of the ray, in the axes of the points.
    double distance = 0.0;  ///< Along the ray, in scene units; not negative.
    double miss = 0.0;      ///< The distance between the point and the ray, in scene units.
    /// Where a bent ray turns on its way from the origin to the point.
    std::vector<V3d> turns{};
};

/// Of each of some points, the sighting in the front layer that has one, the nearest of these; null
/// if there is none.
[[nodiscard]] std::vector<const Sighting*> foremost(std::span<const Sighting> sightings,
                                                    std::size_t points);

/// Finds points in a picture, or in that of a single camera, of one size, at one time. Immutable,
/// may be shared by threads, cheap to copy.
///
/// A layer shows a point where it covers something and nothing in front of it covers all. A camera
/// whose rays depend linearly on the picture (pinhole, parallel, two-slit and push-broom cameras,
/// turned and shifted in any way) is solved in closed form. For any other the picture is divided
/// into patches, small enough for Newton's iteration to find its way in each, and a tree over their
/// rays says which of them can see a point. The division starts from cells of 1/96 of the longer
/// side of the part that has rays, each looked at in 9 places, and goes down to 1/16 pixel at
/// seams, folds and borders, and to two pixels at long borders; a detail that falls between those
/// places can be overlooked. The work is bounded: a camera whose rays change all over so often that
/// some hundred thousand patches are not enough is searched less closely, with a warning, and of
/// the patches that may see a point some thousand are searched.
///
/// If a whole line of the picture sees a point (a pole of a panorama), some positions on it are
/// found. A point at which all rays of a region start is not found by them, and a point that is not
/// finite by none.
class Locator final : public rays::ImagePointFinder {
public:
    /// Width and height of the picture are in pixels and positive. Time as in the camera's
    /// formulas. Without axes, points are in the axes of the cameras, which must agree. An error of
    /// Kind::interrupted if it is stopped.
    [[nodiscard]] static Result<Locator> make(const camera::Picture& picture, double width,
                                              double height, double time = 0.0,
                                              std::optional<Axes> axes = {},
                                              const PartDone& progress = {},
                                              std::stop_token stop = {});

    /// The axes of the points.
    [[nodiscard]] Axes axes() const;
    /// The names of the picture's camera layers, from back to front; one for a single camera.
    [[nodiscard]] std::vector<std::string> layers() const;

    /// All sightings of a point, from left to right.
    [[nodiscard]] std::vector<Sighting> locate(const V3d& point) const;
    /// Those of many points, which is faster: point by point, each from left to right.
    [[nodiscard]] std::vector<Sighting> locate(std::span<const V3d> points) const;
    /// The same, or an error of Kind::interrupted if it is stopped. `in_part` becomes the indices
    /// of points that more patches may see than are searched.
    [[nodiscard]] Result<std::vector<Sighting>> locate(std::span<const V3d> points,
                                                       std::vector<std::size_t>& in_part,
                                                       const PartDone& progress = {},
                                                       std::stop_token stop = {}) const;

    /// The nearest of all sightings of a point in a layer.
    void find(std::span<const rays::ImagePointQuery> queries,
              std::span<rays::ImagePoint> found) const override;

    /// Whether all layers are solved in closed form.
    [[nodiscard]] bool closed_form() const;
    /// The number of patches of all layers; none for a layer
    /// that is solved in closed form.
    [[nodiscard]] std::size_t patch_count() const;

private:
    class Index;
    explicit Locator(std::shared_ptr<const Index> index) : index_(std::move(index)) {}
    [[nodiscard]] static Result<Locator> make(const camera::Picture& picture, double width,
                                              double height, double time, std::optional<Axes> axes,
                                              const Work& work);
    std::shared_ptr<const Index> index_;
};

}  // namespace balcony::analyse

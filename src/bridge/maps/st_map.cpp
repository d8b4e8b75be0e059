// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "balcony/st_maps.hpp"

namespace balcony::bridge {

namespace {

using rays::RayBatch;
using rays::Scratch;

/// A direction and its change from pixel to pixel.
struct Direction {
    V3d at, by_x, by_y;
};

Direction direction_of(const RayBatch& rays, std::size_t i) {
    return {rays.direction(i), rays.direction_by_x(i), rays.direction_by_y(i)};
}

/// From changes of a direction to changes of the place in a picture, in pixels, by least squares.
class PlaceOfDirection {
public:
    explicit PlaceOfDirection(const Direction& d)
        : by_x_(d.by_x),
          by_y_(d.by_y),
          xx_(d.by_x.length2()),
          yy_(d.by_y.length2()),
          xy_(d.by_x ^ d.by_y),
          determinant_(xx_ * yy_ - xy_ * xy_) {}

    /// Whether the direction changes in both directions of the picture.
    [[nodiscard]] bool regular() const { return determinant_ > 1e-12 * xx_ * yy_; }

    [[nodiscard]] V2d operator()(const V3d& change) const {
        const double x = by_x_ ^ change;
        const double y = by_y_ ^ change;
        return V2d(yy_ * x - xy_ * y, xx_ * y - xy_ * x) / determinant_;
    }

private:
    V3d by_x_, by_y_;
    double xx_, yy_, xy_, determinant_;
};

// An error, or a warning if parallax is ignored.
Diagnostic no_single_viewpoint(const Viewpoint& v, const std::string& camera, Parallax parallax) {
    std::string message = fmt::format(
        "{} has no single viewpoint: its rays pass ({:.4g}, {:.4g}, {:.4g}), the point nearest to "
        "all of them, at up to {:.4g} scene units, half of them at {:.4g} or more; what is {:.4g} "
        "units away appears up to 0.57 degrees from its place",
        camera, v.point.x, v.point.y, v.point.z, v.largest, v.median, 100.0 * v.largest);
    return parallax == Parallax::ignore
               ? warning(std::move(message))
               : error(
                     std::move(message), {},
                     "a photo shows a scene from one point; --allow-parallax takes the directions "
                     "of the rays alone, as for things that are far away");
}

}  // namespace

// Places in the photo are found at every eighth pixel of every eighth row by the inverse of the
// photo's camera, and from there by Newton's iteration for the pixels around; where that does not
// lead to a place, by the inverse again.
class StMap::Index {
public:
    Index(const RayGrid& rays, SourceCamera source, const Viewpoint& viewpoint)
        : rays_(rays),
          source_(std::move(source)),
          viewpoint_(viewpoint.point),
          distance_(std::max(1.0, 1000.0 * viewpoint.spread)),
          closes_(sides_meet()) {}

    [[nodiscard]] const RayGrid& rays() const { return rays_; }
    [[nodiscard]] bool closes() const { return closes_; }

    void run(std::size_t first_row, std::size_t rows, std::vector<SourcePlace>& places) const {
        std::vector<Pixel> pixels = pixels_of(first_row, rows);
        find(pixels, [](const Pixel& pixel) { return pixel.is_anchor(); });
        const std::vector<V2d> anchors = anchors_of(pixels, rows);
        for (Pixel& pixel : pixels) {
            if (!pixel.found) {
                pixel.position = anchors[pixel.anchor(anchor_columns())];
            }
        }
        constexpr int iterations = 6;
        for (int i = 0; i < iterations; ++i) {
            improve(pixels);
        }
        find(pixels, [](const Pixel& pixel) { return !pixel.found && !pixel.is_anchor(); });
        improve(pixels);
        places.assign(rows * rays_.width(), {});
        for (const Pixel& pixel : pixels) {
            if (pixel.found) {
                places[pixel.row * rays_.width() + pixel.column] = place_of(pixel);
            }
        }
    }

private:
    static constexpr std::size_t step = 8;

    /// A pixel with a ray, and where the photo shows it.
    struct Pixel {
        std::size_t column = 0;
        std::size_t row = 0;  ///< Of the rows at work.
        Direction wanted{};
        V2d position{nowhere()};  ///< In the photo, in pixels; a guess until it is found.
        V2d by_x{0.0}, by_y{0.0};
        bool found = false;
        bool settled = false;  ///< The iteration has converged.

        [[nodiscard]] bool is_anchor() const { return column % step == 0 && row % step == 0; }
        [[nodiscard]] std::size_t anchor(std::size_t columns) const {
            return row / step * columns + column / step;
        }
    };

    static V2d nowhere() { return V2d(std::numeric_limits<double>::quiet_NaN()); }
    [[nodiscard]] std::size_t anchor_columns() const { return (rays_.width() + step - 1) / step; }

    [[nodiscard]] std::vector<Pixel> pixels_of(std::size_t first_row, std::size_t rows) const {
        std::vector<Pixel> pixels;
        Scratch scratch;
        RayBatch batch;
        for (std::size_t x = 0; x < rays_.width(); x += program::max_tile_width) {
            const std::size_t width = std::min(program::max_tile_width, rays_.width() - x);
            rays_.run(x, first_row, width, rows, scratch, batch);
            for (std::size_t i = 0; i < batch.size(); ++i) {
                if (batch.valid(i)) {
                    pixels.push_back({.column = x + i % width,
                                      .row = i / width,
                                      .wanted = direction_of(batch, i)});
                }
            }
        }
        return pixels;
    }

    // Asks the inverse of the photo's camera where it shows points far away.
    template <class Which>
    void find(std::vector<Pixel>& pixels, const Which& is_wanted) const {
        std::vector<rays::ImagePointQuery> queries;
        std::vector<Pixel*> asked;
        for (Pixel& pixel : pixels) {
            if (is_wanted(pixel)) {
                queries.push_back({viewpoint_ + distance_ * pixel.wanted.at, 0, {}});
                asked.push_back(&pixel);
            }
        }
        std::vector<rays::ImagePoint> found(queries.size());
        source_.finder->find(queries, found);
        for (std::size_t i = 0; i < found.size(); ++i) {
            asked[i]->found = found[i].places > 0;
            asked[i]->settled = false;
            asked[i]->position = asked[i]->found ? found[i].position : nowhere();
        }
    }

    [[nodiscard]] std::vector<V2d> anchors_of(const std::vector<Pixel>& pixels,
                                              std::size_t rows) const {
        std::vector<V2d> anchors(anchor_columns() * ((rows + step - 1) / step), nowhere());
        for (const Pixel& pixel : pixels) {
            if (pixel.is_anchor()) {
                anchors[pixel.anchor(anchor_columns())] = pixel.position;
            }
        }
        return anchors;
    }

    // A step of Newton's iteration from each guess, and the change from pixel to pixel: that of the
    // direction, by what the photo's directions change.
    void improve(std::vector<Pixel>& pixels) const {
        std::vector<Pixel*> guesses;
        std::vector<double> x;
        std::vector<double> y;
        for (Pixel& pixel : pixels) {
            if (std::isfinite(pixel.position.x + pixel.position.y) && !pixel.settled) {
                guesses.push_back(&pixel);
                x.push_back(pixel.position.x);
                y.push_back(pixel.position.y);
            }
        }
        Scratch scratch;
        RayBatch batch;
        source_.rays.run_at(x, y, scratch, batch);
        for (std::size_t i = 0; i < guesses.size(); ++i) {
            improve(*guesses[i], batch, i);
        }
    }

    void improve(Pixel& pixel, const RayBatch& batch, std::size_t i) const {
        if (!batch.valid(i)) {
            pixel.position = pixel.found ? pixel.position : nowhere();
            return;
        }
        const Direction there = direction_of(batch, i);
        const PlaceOfDirection solve(there);
        if (!solve.regular()) {
            pixel.position = pixel.found ? pixel.position : nowhere();
            return;
        }
        const V2d move = solve(pixel.wanted.at - there.at);
        if (pixel.found && move.length() > 1.0) {
            return;  // Next to a place where the photo's rays do not change smoothly.
        }
        pixel.position += move;
        pixel.by_x = solve(pixel.wanted.by_x);
        pixel.by_y = solve(pixel.wanted.by_y);
        // The step after one of this length is below 1e-8 pixel.
        constexpr double small = 1e-4;
        const bool same = (pixel.wanted.at ^ there.at) > 0.0;
        pixel.settled = move.length() < small && same;
        pixel.found = pixel.found || (pixel.settled && is_in_photo(pixel.position));
    }

    [[nodiscard]] bool is_in_photo(const V2d& position) const {
        return position.x >= 0.0 && position.y >= 0.0 &&
               position.x < static_cast<double>(source_.rays.width()) &&
               position.y < static_cast<double>(source_.rays.height());
    }

    [[nodiscard]] SourcePlace place_of(const Pixel& pixel) const {
        const V2d scale(1.0 / static_cast<double>(source_.rays.width()),
                        -1.0 / static_cast<double>(source_.rays.height()));
        return {true, V2d(0.0, 1.0) + pixel.position * scale, pixel.by_x * scale,
                pixel.by_y * scale};
    }

    // Whether the rays go on from the last column to the first as they do from column to column.
    [[nodiscard]] bool sides_meet() const {
        const double middle = 0.5 * static_cast<double>(source_.rays.height());
        Scratch scratch;
        RayBatch sides;
        source_.rays.run_at(std::array{0.0, static_cast<double>(source_.rays.width())},
                            std::array{middle, middle}, scratch, sides);
        return sides.valid(0) && sides.valid(1) &&
               (sides.direction(0) - sides.direction(1)).length() <
                   1e-6 * sides.direction_by_x(0).length();
    }

    RayGrid rays_;
    SourceCamera source_;
    V3d viewpoint_;
    double distance_;
    bool closes_;
};

Result<StMap> StMap::make(const RayGrid& rays, const SourceCamera& source, Parallax parallax) {
    assert(rays.has_footprints() && source.rays.has_footprints() && rays.axes() == Axes::z_up &&
           source.rays.axes() == Axes::z_up);
    const Viewpoint photo = find_viewpoint(source.rays);
    Diagnostics found;
    for (const auto& [viewpoint, camera] :
         {std::pair(find_viewpoint(rays), fmt::format("camera '{}'", rays.name())),
          std::pair(photo, fmt::format("camera '{}' of the photo", source.rays.name()))}) {
        if (!viewpoint.is_single()) {
            found.push_back(no_single_viewpoint(viewpoint, camera, parallax));
        }
    }
    if (has_errors(found)) {
        return found;
    }
    return {StMap(std::make_shared<const Index>(rays, source, photo)), std::move(found)};
}

std::size_t StMap::width() const { return index_->rays().width(); }
std::size_t StMap::height() const { return index_->rays().height(); }
bool StMap::closes() const { return index_->closes(); }

void StMap::run(std::size_t first_row, std::size_t rows, std::vector<SourcePlace>& places) const {
    index_->run(first_row, rows, places);
}

}  // namespace balcony::bridge

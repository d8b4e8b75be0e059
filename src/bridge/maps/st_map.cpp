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
        // With the neighbours above and below.
        const std::size_t begin = first_row - std::min<std::size_t>(first_row, 1);
        const std::size_t end = std::min(first_row + rows + 1, rays_.height());
        const Part part{begin, end - begin, rays_.width()};
        std::vector<Pixel> pixels = pixels_of(part);
        find_centres(pixels, part);
        std::vector<SourcePlace> all(part.size());
        for (const Pixel& pixel : pixels) {
            if (pixel.found) {
                all[pixel.index] = place_of(pixel);
            }
        }
        cover_borders(all, part);
        const auto from =
            all.begin() + static_cast<std::ptrdiff_t>((first_row - begin) * part.width);
        places.assign(from, from + static_cast<std::ptrdiff_t>(rows * part.width));
    }

    void at(std::span<const V2d> of, std::vector<SourcePlace>& places) const {
        std::vector<Pixel> pixels = pixels_at(of);
        find_from_guesses(pixels);
        places.assign(of.size(), {});
        for (const Pixel& pixel : pixels) {
            if (pixel.found) {
                places[pixel.index] = place_of(pixel);
            }
        }
    }

private:
    static constexpr std::size_t step = 8;

    /// Some rows of the picture.
    struct Part {
        std::size_t first_row, rows, width;

        [[nodiscard]] std::size_t size() const { return rows * width; }
        [[nodiscard]] std::size_t anchor_columns() const { return (width + step - 1) / step; }
        /// Which anchor is near a pixel.
        [[nodiscard]] std::size_t anchor_of(std::size_t index) const {
            return index / width / step * anchor_columns() + index % width / step;
        }
        [[nodiscard]] bool is_anchor(std::size_t index) const {
            return index / width % step == 0 && index % width % step == 0;
        }
        [[nodiscard]] std::size_t anchors() const {
            return anchor_columns() * ((rows + step - 1) / step);
        }
    };

    /// A place in a pixel with a ray, and where the photo shows it.
    struct Pixel {
        std::size_t index = 0;  ///< In its part.
        Direction wanted{};
        V2d position{nowhere()};  ///< In the photo, in pixels; a guess until it is found.
        V2d by_x{0.0}, by_y{0.0};
        bool asked = false;  ///< The inverse has answered.
        bool found = false;
        bool settled = false;  ///< The iteration has converged.
    };

    static V2d nowhere() { return V2d(std::numeric_limits<double>::quiet_NaN()); }

    [[nodiscard]] std::vector<Pixel> pixels_of(const Part& part) const {
        std::vector<Pixel> pixels;
        Scratch scratch;
        RayBatch batch;
        for (std::size_t x = 0; x < part.width; x += program::max_tile_width) {
            const std::size_t width = std::min(program::max_tile_width, part.width - x);
            rays_.run(x, part.first_row, width, part.rows, scratch, batch);
            for (std::size_t i = 0; i < batch.size(); ++i) {
                if (batch.valid(i)) {
                    pixels.push_back({.index = i / width * part.width + x + i % width,
                                      .wanted = direction_of(batch, i)});
                }
            }
        }
        return pixels;
    }

    // The index of each is that of its point.
    [[nodiscard]] std::vector<Pixel> pixels_at(std::span<const V2d> points) const {
        std::vector<double> x;
        std::vector<double> y;
        for (const V2d& point : points) {
            x.push_back(point.x);
            y.push_back(point.y);
        }
        Scratch scratch;
        RayBatch batch;
        rays_.run_at(x, y, scratch, batch);
        std::vector<Pixel> pixels;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (batch.valid(i)) {
                pixels.push_back({.index = i, .wanted = direction_of(batch, i)});
            }
        }
        return pixels;
    }

    void find_centres(std::vector<Pixel>& pixels, const Part& part) const {
        ask(pixels, [&part](const Pixel& pixel) { return part.is_anchor(pixel.index); });
        std::vector<V2d> anchors(part.anchors(), nowhere());
        for (const Pixel& pixel : pixels) {
            if (pixel.found) {
                anchors[part.anchor_of(pixel.index)] = pixel.position;
            }
        }
        for (Pixel& pixel : pixels) {
            if (!pixel.asked) {
                pixel.position = anchors[part.anchor_of(pixel.index)];
            }
        }
        find_from_guesses(pixels);
    }

    void find_from_guesses(std::vector<Pixel>& pixels) const {
        constexpr int iterations = 6;
        for (int i = 0; i < iterations; ++i) {
            improve(pixels);
        }
        ask(pixels, [](const Pixel& pixel) { return !pixel.found && !pixel.asked; });
        improve(pixels);
    }

    // Looks at 16 places in each pixel that the photo shows other than one of its neighbours.
    void cover_borders(std::vector<SourcePlace>& places, const Part& part) const {
        constexpr int side = 4;
        std::vector<std::size_t> indices;
        std::vector<V2d> points;
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (!is_at_border(places, part, i)) {
                continue;
            }
            for (int k = 0; k < side * side; ++k) {
                indices.push_back(i);
                points.emplace_back(static_cast<double>(i % part.width) + (k % side + 0.5) / side,
                                    static_cast<double>(part.first_row + i / part.width) +
                                        (static_cast<double>(k / side) + 0.5) / side);
            }
        }
        std::vector<Pixel> within = pixels_at(points);
        for (Pixel& one : within) {
            one.index = indices[one.index];
            const SourcePlace& centre = places[one.index];
            one.position = centre.valid ? position_of(centre) : nowhere();
        }
        find_from_guesses(within);
        for (const std::size_t index : indices) {
            places[index].coverage = 0.0;
        }
        for (const Pixel& one : within) {
            SourcePlace& place = places[one.index];
            if (one.found && !place.valid && place.coverage == 0.0) {
                place = place_of(one);
                place.valid = false;
                place.coverage = 0.0;
            }
            place.coverage += one.found ? 1.0 / (side * side) : 0.0;
        }
    }

    static bool is_at_border(const std::vector<SourcePlace>& places, const Part& part,
                             std::size_t i) {
        const std::size_t column = i % part.width;
        const std::size_t row = i / part.width;
        for (std::size_t y = row - std::min<std::size_t>(row, 1); y < std::min(row + 2, part.rows);
             ++y) {
            for (std::size_t x = column - std::min<std::size_t>(column, 1);
                 x < std::min(column + 2, part.width); ++x) {
                if (places[y * part.width + x].valid != places[i].valid) {
                    return true;
                }
            }
        }
        return false;
    }

    // Asks the inverse of the photo's camera where it shows points far away.
    template <class Which>
    void ask(std::vector<Pixel>& pixels, const Which& is_wanted) const {
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
            asked[i]->asked = true;
            asked[i]->found = found[i].places > 0;
            asked[i]->settled = false;
            asked[i]->position = asked[i]->found ? found[i].position : nowhere();
        }
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

    // From pixels of the photo, y down, to (s, t) and back.
    [[nodiscard]] V2d scale() const {
        return {1.0 / static_cast<double>(source_.rays.width()),
                -1.0 / static_cast<double>(source_.rays.height())};
    }
    [[nodiscard]] SourcePlace place_of(const Pixel& pixel) const {
        return {true, 1.0, V2d(0.0, 1.0) + pixel.position * scale(), pixel.by_x * scale(),
                pixel.by_y * scale()};
    }
    [[nodiscard]] V2d position_of(const SourcePlace& place) const {
        return (place.st - V2d(0.0, 1.0)) / scale();
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

void StMap::at(std::span<const V2d> of, std::vector<SourcePlace>& places) const {
    index_->at(of, places);
}

}  // namespace balcony::bridge

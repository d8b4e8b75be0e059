// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "analyse/inverse/ray_patches.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

namespace balcony::analyse {

namespace {

constexpr double cells_along_the_longer_side = 96.0;
// Minimum half sizes of divided cells, in pixels; see Shape for `smooth`.
constexpr double min_half_size = 1.0 / 32.0;
constexpr double min_smooth_half_size = 1.0;
constexpr double max_bend = 0.25;
// Limits the memory of the patches and of their tree to about 50 MB.
constexpr std::size_t max_patches = 1U << 17U;
// The maximum cost of dividing cells, in instructions of the camera's program: a few seconds.
constexpr double max_instructions = 4e9;
// The sample positions in a cell, in half sizes from its centre: near the border, so that a seam
// cannot hide between two cells, but not on it, where seams of symmetric cameras often are.
constexpr double outermost = 0.9;
// The maximum error of Newton's first step from the centre, as a fraction of the way to the border:
// each step then at least halves the distance.
constexpr double max_error = 0.5 * outermost;
constexpr std::size_t middle = Survey::places / 2;

V2d offset_of(std::size_t place, const V2d& half) {
    return {outermost * half.x * (static_cast<double>(place % 3) - 1.0),
            outermost * half.y * (static_cast<double>(place / 3) - 1.0)};
}

// The rays of a cell, by place.
using Places = std::span<const Ray>;

// Calls use(cell, rays) for each cell in turn.
template <class Use>
void look_at(const PointRays& rays, const std::vector<Survey::Cell>& cells, const Work& work,
             const Use& use) {
    constexpr std::size_t cells_a_batch = program::max_points / Survey::places;
    PointRays::Batch batch(rays, work);
    std::array<Ray, Survey::places> seen;
    for (std::size_t begin = 0; begin < cells.size(); begin += cells_a_batch) {
        const std::size_t count = std::min(cells_a_batch, cells.size() - begin);
        for (std::size_t i = 0; i < count * Survey::places; ++i) {
            const Survey::Cell& cell = cells[begin + i / Survey::places];
            batch.place(i, cell.center + offset_of(i % Survey::places, cell.half));
        }
        batch.run(count * Survey::places);
        for (std::size_t cell = 0; cell < count; ++cell) {
            for (std::size_t place = 0; place < Survey::places; ++place) {
                seen[place] = batch.ray(cell * Survey::places + place);
            }
            use(cells[begin + cell], Places(seen));
        }
    }
}

std::vector<Ray> rays_of(const PointRays& rays, const std::vector<Survey::Cell>& cells,
                         const Work& work) {
    std::vector<Ray> made;
    made.reserve(cells.size() * Survey::places);
    look_at(rays, cells, work, [&made](const Survey::Cell&, Places of_cell) {
        made.insert(made.end(), of_cell.begin(), of_cell.end());
    });
    return made;
}

// A rectangle of the picture, in pixels.
struct Part {
    V2d minimum, maximum;

    [[nodiscard]] V2d size() const { return maximum - minimum; }
    [[nodiscard]] double longer_side() const { return std::max(size().x, size().y); }
};

// A part whose cells are as small as a pixel is sampled densely enough.
constexpr double min_part = cells_along_the_longer_side;

Survey look_over(const PointRays& rays, const Part& part, const Work& work) {
    const V2d whole = part.size();
    const double size = part.longer_side() / cells_along_the_longer_side;
    const double columns = std::ceil(whole.x / size - 1e-9);
    const double rows = std::ceil(whole.y / size - 1e-9);
    const V2d half(0.5 * whole.x / columns, 0.5 * whole.y / rows);
    Survey survey;
    for (double row = 0.0; row < rows; row += 1.0) {
        for (double column = 0.0; column < columns; column += 1.0) {
            survey.cells.push_back(
                {part.minimum + half * V2d(2.0 * column + 1.0, 2.0 * row + 1.0), half});
        }
    }
    survey.rays = rays_of(rays, survey.cells, work);
    return survey;
}

// The bounding part of the previous part and the cells with rays of a survey, with a margin of one
// cell on each side.
void include_rays(const Survey& survey, std::optional<Part>& part) {
    for (std::size_t i = 0; i < survey.rays.size(); ++i) {
        if (!survey.rays[i].valid) {
            continue;
        }
        const Survey::Cell& cell = survey.cells[i / Survey::places];
        const V2d minimum = cell.center - 3.0 * cell.half;
        const V2d maximum = cell.center + 3.0 * cell.half;
        part =
            !part
                ? Part{minimum, maximum}
                : Part{
                      {std::min(part->minimum.x, minimum.x), std::min(part->minimum.y, minimum.y)},
                      {std::max(part->maximum.x, maximum.x), std::max(part->maximum.y, maximum.y)}};
    }
}

// The part of a picture that has rays. If sampling the whole finds none, each sixteenth of it
// is sampled.
std::optional<Part> part_with_rays(const PointRays& rays, const Survey& whole, const V2d& picture,
                                   const Work& work) {
    std::optional<Part> part;
    include_rays(whole, part);
    constexpr int pieces = 4;
    const V2d piece = picture / double{pieces};
    for (int i = 0; !whole.any_ray() && i < pieces * pieces; ++i) {
        const V2d minimum = piece * V2d(i % pieces, i / pieces);
        include_rays(look_over(rays, {minimum, minimum + piece}, work), part);
    }
    return part;
}

double extent_of_origins(const std::vector<Ray>& rays) {
    V3d minimum(0.0);
    V3d maximum(0.0);
    bool first = true;
    for (const Ray& ray : rays) {
        for (int axis = 0; ray.valid && axis < 3; ++axis) {
            minimum[axis] = first ? ray.origin[axis] : std::min(minimum[axis], ray.origin[axis]);
            maximum[axis] = first ? ray.origin[axis] : std::max(maximum[axis], ray.origin[axis]);
        }
        first = first && !ray.valid;
    }
    return 0.5 * (maximum - minimum).length();
}

class Divider {
public:
    Divider(const PointRays& rays, double extent, const Work& work)
        : rays_(rays),
          work_(work),
          cells_left_(static_cast<std::size_t>(
              max_instructions /
              static_cast<double>(Survey::places * (1 + rays.instruction_count())))) {
        // If all origins are equal, the distance is irrelevant.
        distances_ =
            extent > 0.0 ? std::vector{0.1 * extent, extent, 100.0 * extent} : std::vector{1.0};
    }

    Division run(Survey survey) {
        std::vector<Survey::Cell> cells = std::move(survey.cells);
        const double whole = area_of(cells);
        std::vector<Survey::Cell> smaller;
        work_.done(0.0);
        judge_all(cells, survey.rays, smaller);
        while (!smaller.empty()) {
            cells = std::move(smaller);
            smaller.clear();
            cells_left_ -= cells.size();
            if (has_room_for(cells.size(), max_patches)) {
                // 1.6 kB of rays a cell are judged while they are in the processor's cache.
                look_at(rays_, cells, work_, [&](const Survey::Cell& cell, Places rays) {
                    judge(cell, rays, &smaller);
                });
            } else {
                judge_all(cells, rays_of(rays_, cells, work_), smaller);
            }
            work_.done(1.0 - area_of(cells) / whole);
        }
        return std::move(made_);
    }

private:
    // Whether the halves of some cells are not too many.
    [[nodiscard]] bool has_room_for(std::size_t cells, std::size_t patches) const {
        return made_.patches.size() + 2 * cells < patches && 2 * cells <= cells_left_;
    }

    static double area_of(const std::vector<Survey::Cell>& cells) {
        double area = 0.0;
        for (const Survey::Cell& cell : cells) {
            area += cell.half.x * cell.half.y;
        }
        return area;
    }

    // Judges cells with the rays of all.
    void judge_all(const std::vector<Survey::Cell>& cells, const std::vector<Ray>& rays,
                   std::vector<Survey::Cell>& smaller) {
        const auto of_cell = [&rays](std::size_t i) {
            return Places(rays).subspan(i * Survey::places, Survey::places);
        };
        const auto is_whole = [&of_cell](std::size_t i) {
            const Places places = of_cell(i);
            return std::all_of(places.begin(), places.end(),
                               [](const Ray& ray) { return ray.valid; });
        };
        std::size_t whole_cells = 0;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            whole_cells += is_whole(i) ? 1 : 0;
        }
        // Where a long border has too many cells, the others are still divided.
        const bool may_divide = has_room_for(cells.size(), max_patches);
        const bool may_divide_whole =
            may_divide || has_room_for(whole_cells, max_patches + max_patches / 8);
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const bool may = is_whole(i) ? may_divide_whole : may_divide;
            judge(cells[i], of_cell(i), may ? &smaller : nullptr);
        }
    }

    // Keeps a cell as a patch, drops it, or divides it along the axis on which it is less linear.
    void judge(const Survey::Cell& cell, Places rays, std::vector<Survey::Cell>* smaller) {
        const auto valid =
            std::count_if(rays.begin(), rays.end(), [](const Ray& ray) { return ray.valid; });
        if (valid == 0) {
            return;
        }
        const bool all_valid = valid == Survey::places;
        const Shape shape = all_valid ? shape_of(cell, rays) : Shape::rough;
        const double longest = std::max(cell.half.x, cell.half.y);
        const double minimum = shape == Shape::rough ? min_half_size : min_smooth_half_size;
        if (shape == Shape::linear || (shape == Shape::smooth && longest <= minimum)) {
            keep(cell, rays);
            return;
        }
        if (smaller == nullptr || longest <= minimum) {
            // A border need not be followed closer than smooth cells are divided.
            made_.complete =
                made_.complete && longest <= (all_valid ? minimum : min_smooth_half_size);
            keep_sides(cell, rays);
            return;
        }
        V2d need = cell.half;
        if (shape == Shape::rough) {
            need = all_valid ? changes(cell, rays) : validity_changes(rays);
        }
        const bool more_along_x =
            need.x > need.y || (need.x == need.y && cell.half.x > cell.half.y);
        const bool along_x = cell.half.x > minimum && (more_along_x || cell.half.y <= minimum);
        const V2d half =
            along_x ? V2d(0.5 * cell.half.x, cell.half.y) : V2d(cell.half.x, 0.5 * cell.half.y);
        const V2d shift = along_x ? V2d(half.x, 0.0) : V2d(0.0, half.y);
        smaller->push_back({cell.center - shift, half});
        smaller->push_back({cell.center + shift, half});
    }

    // A step as a fraction of the cell's half sizes.
    [[nodiscard]] static double relative(const V2d& step, const Survey::Cell& cell) {
        return std::max(std::abs(step.x) / cell.half.x, std::abs(step.y) / cell.half.y);
    }

    // Newton's iteration contracts in a linear cell. In a smooth one it does not, because rays that
    // cross somewhere, or a pole, make a derivative vanish; but the rays bend little over the cell.
    enum class Shape : std::uint8_t { linear, smooth, rough };

    [[nodiscard]] Shape shape_of(const Survey::Cell& cell, Places rays) const {
        Shape shape = Shape::linear;
        for (std::size_t place = 0; place < Survey::places; ++place) {
            for (const double distance : distances_) {
                if (place == middle || error(cell, rays, place, distance) <= max_error) {
                    continue;
                }
                shape = Shape::smooth;
                if (!(bend(cell, rays, place, distance) <= max_bend)) {
                    return Shape::rough;
                }
            }
        }
        return shape;
    }

    // The error of Newton's first step, relative to the change of the derivatives over the cell.
    [[nodiscard]] static double bend(const Survey::Cell& cell, Places rays, std::size_t place,
                                     double distance) {
        const Approach approach(rays[middle],
                                rays[place].origin + distance * rays[place].direction);
        const V3d left = approach.after(offset_of(place, cell.half));
        const double size = std::max((cell.half.x * approach.by_x).length(),
                                     (cell.half.y * approach.by_y).length());
        return approach.distance > 0.0 ? left.length() / size : 1.0;
    }

    // The error of Newton's first step from the centre to the point that another position sees at a
    // distance.
    [[nodiscard]] static double error(const Survey::Cell& cell, Places rays, std::size_t place,
                                      double distance) {
        const Approach approach(rays[middle],
                                rays[place].origin + distance * rays[place].direction);
        const V3d left = approach.after(offset_of(place, cell.half));
        return approach.distance > 0.0 ? relative(approach.step_to(left), cell) : 1.0;
    }

    // The difference of the derivatives between the centre and another position at a distance.
    [[nodiscard]] static double derivative_change(const Survey::Cell& cell, Places rays,
                                                  std::size_t place, double distance) {
        const auto seen_from = [&](const Ray& ray) {
            return Approach(ray, ray.origin + distance * ray.direction);
        };
        const Approach here = seen_from(rays[middle]);
        const Approach there = seen_from(rays[place]);
        return std::max(relative(here.step_to(cell.half.x * (there.by_x - here.by_x)), cell),
                        relative(here.step_to(cell.half.y * (there.by_y - here.by_y)), cell));
    }

    // The deviation of rays and derivatives from linearity along each axis.
    [[nodiscard]] V2d changes(const Survey::Cell& cell, Places rays) const {
        const auto along = [&](std::size_t before, std::size_t behind) {
            double largest = 0.0;
            for (const std::size_t place : {before, behind}) {
                for (const double distance : distances_) {
                    largest = std::max({largest, error(cell, rays, place, distance),
                                        derivative_change(cell, rays, place, distance)});
                }
            }
            return largest;
        };
        return {along(middle - 1, middle + 1), along(middle - 3, middle + 3)};
    }

    // The number of validity changes along each axis.
    [[nodiscard]] static V2d validity_changes(Places rays) {
        V2d changes(0.0);
        for (std::size_t i = 0; i < Survey::places; ++i) {
            if (i % 3 != 2 && rays[i].valid != rays[i + 1].valid) {
                changes.x += 1.0;
            }
            if (i / 3 != 2 && rays[i].valid != rays[i + 3].valid) {
                changes.y += 1.0;
            }
        }
        return changes;
    }

    // The distance of a ray from the prediction by the patch's derivatives: origin and direction.
    static std::array<double, 2> departure(const RayPatch& patch, const V2d& at, const Ray& ray) {
        const V2d by = at - patch.center;
        const Ray& from = patch.ray;
        const V3d origin = from.origin + by.x * from.origin_by_x + by.y * from.origin_by_y;
        const V3d direction =
            from.direction + by.x * from.direction_by_x + by.y * from.direction_by_y;
        return {(ray.origin - origin).length(), (ray.direction - direction).length()};
    }

    // How far origins move over a cell along the ray, times how far directions turn.
    static double shear(const Ray& ray, const V2d& half) {
        const double along = std::abs(half.x * ray.origin_by_x.dot(ray.direction)) +
                             std::abs(half.y * ray.origin_by_y.dot(ray.direction));
        return along *
               ((half.x * ray.direction_by_x).length() + (half.y * ray.direction_by_y).length());
    }

    // Bends increase with the square of the distance from the centre.
    void keep(const Survey::Cell& cell, Places rays) {
        constexpr double to_the_border = 1.0 / (outermost * outermost);
        RayPatch patch{cell.center, cell.half, rays[middle]};
        patch.shear = shear(patch.ray, patch.half);
        for (std::size_t place = 0; place < Survey::places; ++place) {
            const auto [origin, direction] =
                departure(patch, cell.center + offset_of(place, cell.half), rays[place]);
            patch.origin_bend = std::max(patch.origin_bend, origin * to_the_border);
            patch.direction_bend = std::max(patch.direction_bend, direction * to_the_border);
        }
        made_.patches.push_back(patch);
    }

    // For a cell that could not be divided further, across a seam perhaps: a patch around its
    // middle, with bends as large as what the derivatives say changes over the cell, and others
    // around places that those before do not explain.
    void keep_sides(const Survey::Cell& cell, Places rays) {
        const std::size_t first = made_.patches.size();
        for (std::size_t i = 0; i < Survey::places; ++i) {
            const std::size_t place = (middle + i) % Survey::places;
            const Ray& ray = rays[place];
            const V2d at = cell.center + offset_of(place, cell.half);
            const auto explains = [&](const RayPatch& patch) {
                const auto [origin, direction] = departure(patch, at, ray);
                return origin <= patch.origin_bend && direction <= patch.direction_bend;
            };
            if (!ray.valid ||
                std::any_of(made_.patches.begin() + static_cast<std::ptrdiff_t>(first),
                            made_.patches.end(), explains)) {
                continue;
            }
            RayPatch patch{at, cell.half, ray};
            patch.origin_bend =
                (cell.half.x * ray.origin_by_x).length() + (cell.half.y * ray.origin_by_y).length();
            patch.direction_bend = (cell.half.x * ray.direction_by_x).length() +
                                   (cell.half.y * ray.direction_by_y).length();
            made_.patches.push_back(patch);
        }
    }

    const PointRays& rays_;
    const Work& work_;
    std::vector<double> distances_;
    std::size_t cells_left_;  ///< That may still be looked at.
    Division made_;
};

}  // namespace

bool Survey::any_ray() const {
    return std::any_of(rays.begin(), rays.end(), [](const Ray& ray) { return ray.valid; });
}

V2d Survey::place(std::size_t index) const {
    const Cell& cell = cells[index / places];
    return cell.center + offset_of(index % places, cell.half);
}

// An inset may be a small part of the picture, so a small part with all rays is sampled again.
Survey survey(const PointRays& rays, const V2d& picture, const Work& work) {
    Part part{{0.0, 0.0}, picture};
    Survey survey = look_over(rays, part, work);
    std::optional<Part> used = part_with_rays(rays, survey, picture, work);
    while (used && used->longer_side() < 0.5 * part.longer_side() &&
           part.longer_side() > min_part) {
        part = {{std::max(used->minimum.x, 0.0), std::max(used->minimum.y, 0.0)},
                {std::min(used->maximum.x, picture.x), std::min(used->maximum.y, picture.y)}};
        survey = look_over(rays, part, work);
        used.reset();
        include_rays(survey, used);
    }
    survey.extent = extent_of_origins(survey.rays);
    return survey;
}

Division divide(const PointRays& rays, Survey survey, const Work& work) {
    const double extent = survey.extent;
    return Divider(rays, extent, work).run(std::move(survey));
}

}  // namespace balcony::analyse

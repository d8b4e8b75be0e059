// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "bridge/povray/camera_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "balcony/povray.hpp"
#include "balcony/ray_difference.hpp"

namespace balcony::bridge::povray {

namespace {

constexpr std::size_t cell_side = 64;
// The corners of cells are a little beyond those of pixels, so that no sample is on a diagonal.
constexpr double corner_shift = 0.2;

bool usable(const rays::RayBatch& rays, std::size_t i) {
    constexpr double farthest = 1e6;  // POV-Ray itself ends at 1e7.
    const V3d origin = rays.origin(i);
    return rays.valid(i) && std::abs(rays.direction(i).length2() - 1.0) < 1e-6 &&
           std::abs(origin.x) < farthest && std::abs(origin.y) < farthest &&
           std::abs(origin.z) < farthest;
}

// The smallest height of a triangle relative to its longest side.
double flatness(const V3d& a, const V3d& b, const V3d& c) {
    const double longest2 = std::max({(b - a).length2(), (c - b).length2(), (a - c).length2()});
    return longest2 > 0.0 ? ((b - a) % (c - a)).length() / longest2 : 0.0;
}

/// Two unit vectors across a ray and across each other; first x second is the ray's direction.
struct Plane {
    V3d first, second;

    explicit Plane(const V3d& direction) {
        const V3d other = std::abs(direction.x) < 0.6 ? V3d(1.0, 0.0, 0.0) : V3d(0.0, 1.0, 0.0);
        first = (direction % other).normalized();
        second = direction % first;
    }
    [[nodiscard]] V3d at(const V2d& place) const { return place.x * first + place.y * second; }
};

// A triangle with its centroid at the origin of a ray and its normal along it, by POV-Ray's rule:
// (c - a) x (b - a).
void add_face_across(const V3d& origin, const V3d& direction, double size, CameraMesh& mesh) {
    const Plane plane(direction);
    const auto a = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const V2d& corner : {V2d(1.0, 0.0), V2d(-0.5, -0.75), V2d(-0.5, 0.75)}) {
        mesh.vertices.emplace_back(origin + size * plane.at(corner));
    }
    mesh.faces.push_back({a, a + 1, a + 2});
}

/// A rectangle of pixels of a band, with corners at the nodes of the same numbers.
struct Cell {
    std::size_t x = 0, y = 0;
    std::size_t width = 0, height = 0;
};

/// A vertex of a cell as POV-Ray has it, in doubles.
struct Corner {
    V3d vertex;
    V3d normal;
    V2d place;
};

// Some rows of the picture at work.
class Band {
public:
    Band(const MeshFrame& frame, std::size_t first_row, std::size_t width, std::size_t rows,
         const rays::Tile& places, const rays::Tile& nodes, CameraMesh& mesh)
        : frame_(frame),
          first_row_(first_row),
          width_(width),
          rows_(rows),
          mesh_(mesh),
          node_vertices_((width + 1) * (rows + 1), none) {
        for (std::size_t i = 0; i <= width; ++i) {
            node_x_.push_back(nodes.column(i) - places.x);
        }
        for (std::size_t j = 0; j <= rows; ++j) {
            node_y_.push_back(nodes.row(j) - places.y);
        }
        // At the border of the picture, corners may be as far outside as samples.
        widen(node_x_, static_cast<double>(width));
        widen(node_y_, static_cast<double>(rows));
    }

    void add(const rays::RayBatch& samples, const rays::RayBatch& nodes,
             std::span<const std::uint8_t> seen) {
        samples_ = &samples;
        nodes_ = &nodes;
        seen_ = seen;
        for (std::size_t x = 0; x < width_; x += cell_side) {
            add_cell({x, 0, std::min(cell_side, width_ - x), rows_});
        }
    }

    void add_single(std::size_t x, std::size_t y) {
        const rays::RayBatch& rays = *samples_;
        const std::size_t i = y * width_ + x;
        const V3d direction = rays.direction(i);
        const V3d middle = rays.origin(i) - frame_.center + frame_.offset * direction;
        const double size = 1e-3 * frame_.extent;
        const Plane plane(direction);
        constexpr std::array<V2d, 3> corners{V2d(0.0, 0.4), V2d(-0.35, -0.2), V2d(0.35, -0.2)};
        Face face{};
        for (std::size_t k = 0; k < 3; ++k) {
            const V2d& corner = corners[k];
            face[k] = add_vertex(middle + size * plane.at(corner), direction,
                                 {static_cast<double>(x) + corner.x,
                                  static_cast<double>(first_row_ + y) + corner.y});
        }
        mesh_.faces.push_back(face);
        ++mesh_.single_rays;
    }

private:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    static void widen(std::vector<double>& nodes, double samples) {
        constexpr double margin = 0.05;
        nodes.front() = std::min(nodes.front(), -margin);
        nodes.back() = std::max(nodes.back(), samples - 1.0 + margin);
    }

    void add_cell(const Cell& cell) {
        if (!any_seen(cell)) {
            return;
        }
        if (const auto error = error_of(cell)) {
            mesh_.largest_error = std::max(mesh_.largest_error, *error);
            const std::uint32_t a = node_vertex(cell.x, cell.y);
            const std::uint32_t b = node_vertex(cell.x + cell.width, cell.y);
            const std::uint32_t c = node_vertex(cell.x, cell.y + cell.height);
            const std::uint32_t d = node_vertex(cell.x + cell.width, cell.y + cell.height);
            mesh_.faces.push_back({a, b, c});
            mesh_.faces.push_back({b, d, c});
            return;
        }
        if (cell.width == 1 && cell.height == 1) {
            add_single(cell.x, cell.y);
            return;
        }
        // Halves are powers of two, so that the parts stay squares.
        const auto half = [](std::size_t side) {
            std::size_t part = 1;
            while (2 * part < side) {
                part *= 2;
            }
            return part;
        };
        const std::size_t left = cell.width > 1 ? half(cell.width) : 1;
        const std::size_t top = cell.height > 1 ? half(cell.height) : 1;
        for (const auto& [y, height] :
             {std::pair(cell.y, top), std::pair(cell.y + top, cell.height - top)}) {
            for (const auto& [x, width] :
                 {std::pair(cell.x, left), std::pair(cell.x + left, cell.width - left)}) {
                if (width > 0 && height > 0) {
                    add_cell({x, y, width, height});
                }
            }
        }
    }

    [[nodiscard]] bool any_seen(const Cell& cell) const {
        for (std::size_t y = cell.y; y < cell.y + cell.height; ++y) {
            for (std::size_t x = cell.x; x < cell.x + cell.width; ++x) {
                if (seen_[y * width_ + x] != 0) {
                    return true;
                }
            }
        }
        return false;
    }

    [[nodiscard]] std::optional<Corner> corner(std::size_t x, std::size_t y) const {
        const std::size_t i = y * (width_ + 1) + x;
        if (!usable(*nodes_, i)) {
            return std::nullopt;
        }
        const V3d direction = nodes_->direction(i);
        return Corner{V3d(V3f(nodes_->origin(i) - frame_.center + frame_.offset * direction)),
                      V3d(V3f(direction)), V2d(node_x_[x], node_y_[y])};
    }

    // The largest error of two triangles over the cell; nothing if it is too large, or if POV-Ray
    // could not interpolate in them.
    [[nodiscard]] std::optional<double> error_of(const Cell& cell) const {
        const auto a = corner(cell.x, cell.y);
        const auto b = corner(cell.x + cell.width, cell.y);
        const auto c = corner(cell.x, cell.y + cell.height);
        const auto d = corner(cell.x + cell.width, cell.y + cell.height);
        constexpr double flattest = 1e-3;
        if (!a || !b || !c || !d || flatness(a->vertex, b->vertex, c->vertex) < flattest ||
            flatness(b->vertex, d->vertex, c->vertex) < flattest) {
            return std::nullopt;
        }
        double largest = 0.0;
        for (std::size_t y = cell.y; y < cell.y + cell.height; ++y) {
            const double down = (static_cast<double>(y) - a->place.y) / (d->place.y - a->place.y);
            for (std::size_t x = cell.x; x < cell.x + cell.width; ++x) {
                const std::size_t i = y * width_ + x;
                if (seen_[i] == 0) {
                    continue;
                }
                const double right =
                    (static_cast<double>(x) - a->place.x) / (d->place.x - a->place.x);
                const double rest = 1.0 - right - down;
                constexpr double too_near_the_diagonal = 1e-5;
                if (std::abs(rest) < too_near_the_diagonal) {
                    return std::nullopt;
                }
                const auto mix = [&](const V3d Corner::*part) {
                    return rest > 0.0 ? rest * (*a).*part + right * (*b).*part + down * (*c).*part
                                      : -rest * (*d).*part + (1.0 - down) * (*b).*part +
                                            (1.0 - right) * (*c).*part;
                };
                const double error = error_at(i, mix(&Corner::vertex), mix(&Corner::normal));
                if (!(error <= povray_tolerance)) {
                    return std::nullopt;
                }
                largest = std::max(largest, error);
            }
        }
        return largest;
    }

    // At distances from a tenth of the camera's extent to a hundred times.
    [[nodiscard]] double error_at(std::size_t i, const V3d& vertex, const V3d& normal) const {
        const rays::Ray exact = (*samples_)[i];
        rays::Ray other;
        other.origin = vertex - frame_.offset * normal + frame_.center;
        other.direction = normal.normalized();
        double largest = 0.0;
        for (const double distance : {100.0, 10.0, 1.0, 0.1}) {
            const double error = rays::pixels_between(exact, other, distance * frame_.extent);
            if (!(error <= povray_tolerance)) {
                return std::numeric_limits<double>::infinity();
            }
            largest = std::max(largest, error);
        }
        return largest;
    }

    std::uint32_t add_vertex(const V3d& vertex, const V3d& normal, const V2d& place) {
        mesh_.vertices.emplace_back(vertex);
        mesh_.normals.emplace_back(normal);
        mesh_.places.push_back(place);
        return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
    }

    std::uint32_t node_vertex(std::size_t x, std::size_t y) {
        std::uint32_t& vertex = node_vertices_[y * (width_ + 1) + x];
        if (vertex == none) {
            const Corner made = *corner(x, y);
            vertex = add_vertex(made.vertex, made.normal,
                                made.place + V2d(0.0, static_cast<double>(first_row_)));
        }
        return vertex;
    }

    const MeshFrame& frame_;
    std::size_t first_row_;
    std::size_t width_;
    std::size_t rows_;
    CameraMesh& mesh_;
    std::vector<std::uint32_t> node_vertices_;
    std::vector<double> node_x_, node_y_;  // In pixels from the first sample.
    const rays::RayBatch* samples_ = nullptr;
    const rays::RayBatch* nodes_ = nullptr;
    std::span<const std::uint8_t> seen_;
};

// The corners of the pixels around these samples.
rays::Tile nodes_around(const rays::Tile& places) {
    rays::Tile nodes = places;
    nodes.x -= 0.5 - corner_shift;
    nodes.y -= 0.5 - corner_shift;
    ++nodes.width;
    ++nodes.height;
    return nodes;
}

/// A grid of rays over the whole picture.
struct CoarseGrid {
    std::size_t columns = 0;
    std::size_t rows = 0;
    rays::RayBatch rays;

    // The share of its cells whose triangles are well shaped with this offset.
    [[nodiscard]] double quality(double offset) const {
        std::size_t all = 0;
        std::size_t good = 0;
        const auto vertex = [&](std::size_t i) {
            return rays.origin(i) + offset * rays.direction(i);
        };
        for (std::size_t y = 0; y + 1 < rows; ++y) {
            for (std::size_t x = 0; x + 1 < columns; ++x) {
                const std::size_t i = y * columns + x;
                if (usable(rays, i) && usable(rays, i + 1) && usable(rays, i + columns)) {
                    constexpr double good_shape = 0.03;
                    ++all;
                    good += flatness(vertex(i), vertex(i + 1), vertex(i + columns)) > good_shape
                                ? 1
                                : 0;
                }
            }
        }
        return all > 0 ? static_cast<double>(good) / static_cast<double>(all) : 1.0;
    }
};

std::vector<CoarseGrid> coarse_grids(render::PictureSamples& samples, std::size_t width,
                                     std::size_t height) {
    constexpr double points = 48.0;
    const double step = std::max(1.0, static_cast<double>(std::max(width, height)) / points);
    const auto count = [&](std::size_t side) {
        return static_cast<std::size_t>(static_cast<double>(side) / step) + 1;
    };
    rays::Tile tile = samples.places(0, {0, 0, 1, 1});
    tile.step = step;
    tile.width = count(width);
    tile.height = count(height);
    std::vector<CoarseGrid> grids(samples.layer_count());
    for (std::size_t layer = 0; layer < grids.size(); ++layer) {
        grids[layer].columns = tile.width;
        grids[layer].rows = tile.height;
        samples.find_rays(layer, tile, grids[layer].rays);
    }
    return grids;
}

}  // namespace

MeshFrame mesh_frame(render::PictureSamples& samples, std::size_t width, std::size_t height) {
    const std::vector<CoarseGrid> grids = coarse_grids(samples, width, height);
    MeshFrame frame;
    std::vector<V3d> origins;
    for (const CoarseGrid& grid : grids) {
        for (std::size_t i = 0; i < grid.rays.size(); ++i) {
            if (usable(grid.rays, i)) {
                origins.push_back(grid.rays.origin(i));
                frame.center += origins.back();
            }
        }
    }
    if (origins.empty()) {
        return frame;
    }
    frame.center /= static_cast<double>(origins.size());
    double extent = 0.0;
    for (const V3d& origin : origins) {
        extent = std::max(extent, (origin - frame.center).length());
    }
    constexpr double single_point = 1e-9;
    frame.extent = extent > single_point * (1.0 + frame.center.length()) ? extent : 1.0;
    double best = -1.0;
    for (const double offset : {1.0, 0.3, 3.0, -1.0}) {
        double quality = 1.0;
        for (const CoarseGrid& grid : grids) {
            quality = std::min(quality, grid.quality(offset * frame.extent));
        }
        if (quality > best) {
            best = quality;
            frame.offset = offset * frame.extent;
        }
    }
    return frame;
}

CameraMesh make_camera_mesh(render::PictureSamples& samples, std::size_t layer, std::size_t pass,
                            std::size_t width, std::size_t height, const MeshFrame& frame,
                            std::size_t max_faces, std::vector<std::uint8_t>& seen) {
    CameraMesh mesh;
    seen.clear();
    rays::RayBatch rays;
    rays::RayBatch nodes;
    std::vector<std::uint8_t> wanted;
    for (std::size_t y = 0; y < height; y += cell_side) {
        const render::Region region{0, y, width, std::min(cell_side, height - y)};
        samples.find_rays(layer, pass, region, rays, wanted);
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            wanted[i] = wanted[i] != 0 && usable(rays, i) ? 1 : 0;
            mesh.rays += wanted[i];
        }
        seen.insert(seen.end(), wanted.begin(), wanted.end());
        if (!mesh.complete) {
            continue;
        }
        const rays::Tile places = samples.places(pass, region);
        const rays::Tile around = nodes_around(places);
        samples.find_rays(layer, around, nodes);
        Band(frame, y, width, region.height, places, around, mesh).add(rays, nodes, wanted);
        mesh.complete = mesh.faces.size() <= max_faces;
    }
    return mesh;
}

CameraMesh make_single_faces(render::PictureSamples& samples, std::size_t layer, std::size_t pass,
                             const render::Region& region, const MeshFrame& frame,
                             std::vector<std::uint8_t>& seen) {
    CameraMesh mesh;
    mesh.vertices.reserve(3 * region.size());
    mesh.faces.reserve(region.size());
    seen.clear();
    rays::RayBatch rays;
    std::vector<std::uint8_t> wanted;
    for (std::size_t y = 0; y < region.height; y += cell_side) {
        const render::Region band{region.x, region.y + y, region.width,
                                  std::min(cell_side, region.height - y)};
        samples.find_rays(layer, pass, band, rays, wanted);
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            wanted[i] = wanted[i] != 0 && usable(rays, i) ? 1 : 0;
            add_face_across(wanted[i] != 0 ? rays.origin(i) - frame.center : V3d(0.0),
                            wanted[i] != 0 ? rays.direction(i) : V3d(0.0, 1.0, 0.0), frame.extent,
                            mesh);
            mesh.rays += wanted[i];
        }
        seen.insert(seen.end(), wanted.begin(), wanted.end());
    }
    mesh.single_rays = mesh.rays;
    return mesh;
}

}  // namespace balcony::bridge::povray

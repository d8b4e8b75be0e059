// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "measure/measure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace balcony::plates {

namespace {

using scene::V3d;

std::uint32_t id_of(const std::vector<std::string>& names, const std::string& name) {
    const auto place = std::find(names.begin(), names.end(), name);
    if (place == names.end()) {
        throw std::runtime_error("no object is named " + name);
    }
    return static_cast<std::uint32_t>(place - names.begin()) + 1;
}

std::size_t count_regions(const std::vector<std::uint32_t>& ids, std::size_t width,
                          std::size_t height, std::uint32_t id) {
    std::vector<bool> visited(ids.size(), false);
    std::size_t regions = 0;
    for (std::size_t start = 0; start < ids.size(); ++start) {
        if (ids[start] != id || visited[start]) {
            continue;
        }
        ++regions;
        std::vector<std::size_t> open{start};
        visited[start] = true;
        while (!open.empty()) {
            const std::size_t at = open.back();
            open.pop_back();
            const std::size_t x = at % width;
            const std::size_t y = at / width;
            const auto visit = [&](bool inside, std::size_t next) {
                if (inside && ids[next] == id && !visited[next]) {
                    visited[next] = true;
                    open.push_back(next);
                }
            };
            visit(x > 0, at - 1);
            visit(x + 1 < width, at + 1);
            visit(y > 0, at - width);
            visit(y + 1 < height, at + width);
        }
    }
    return regions;
}

/// Where a pixel looks on a rectangle, in scene units along right and up.
struct Sight {
    V3d pixel;  ///< (x, y, 1)
    V3d place;  ///< (right, up, 0)
};

// The farthest that a sight lies from the affine map that fits all of them best (least squares).
double max_residual(const std::vector<Sight>& sights) {
    Imath::M33d normal(0.0), mixed(0.0);
    for (const auto& [pixel, place] : sights) {
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                normal[i][j] += pixel[i] * pixel[j];
                mixed[i][j] += pixel[i] * place[j];
            }
        }
    }
    const Imath::M33d fit = normal.inverse() * mixed;
    double largest = 0.0;
    for (const auto& [pixel, place] : sights) {
        V3d fitted(0.0);
        for (int j = 0; j < 3; ++j) {
            fitted[j] = pixel.x * fit[0][j] + pixel.y * fit[1][j] + pixel.z * fit[2][j];
        }
        largest = std::max(largest, (fitted - place).length());
    }
    return largest;
}

}  // namespace

// From the trace and the determinant: with s = |M|^2 and p = |det M| the squares of the singular
// values are the roots of x^2 with x1^2 + x2^2 = s, x1 x2 = p.
double singular_ratio(double a, double b, double c, double d) {
    const double s = a * a + b * b + c * c + d * d;
    const double p = std::fabs(a * d - b * c);
    const double root = std::sqrt(std::max(s * s - 4.0 * p * p, 0.0));
    return std::sqrt((s + root) / std::max(s - root, 1e-300));
}

Rectangle rectangle_of(const scene::Scene& scene, const std::string& object) {
    std::vector<std::string> names;
    for (const scene::Object& named : scene.objects) {
        names.push_back(named.name);
    }
    const std::uint32_t index = id_of(names, object) - 1;
    const auto instance =
        std::find_if(scene.instances.begin(), scene.instances.end(),
                     [&](const scene::Instance& candidate) { return candidate.object == index; });
    const scene::Mesh& mesh = scene.meshes.at(instance->mesh.value());
    const auto world = [&](const scene::V3f& p) { return V3d(p) * instance->world_from_mesh; };
    // The first corner of the first triangle, and the two directions in which the mesh extends.
    const V3d corner = world(mesh.positions.at(mesh.triangles.at(0)[0]));
    V3d right(0.0), up(0.0);
    for (const scene::V3f& p : mesh.positions) {
        const V3d offset = world(p) - corner;
        const bool horizontal =
            std::fabs(offset.z) < 1e-6 * offset.length();  // the gallery's axes are z up
        V3d& side = horizontal ? right : up;
        const bool vertical = std::hypot(offset.x, offset.y) < 1e-6 * offset.length();
        if ((horizontal || vertical) && side.length() < offset.length()) {
            side = offset;
        }
    }
    return {corner, right, up};
}

View view_of(const render::Film& film, const std::string& object, const Rectangle& rectangle) {
    const render::DataLayers& layers = film.layers.value();
    const std::uint32_t id = id_of(film.objects, object);
    const std::size_t width = film.width;
    View view;
    view.regions = count_regions(layers.object, width, film.height, id);

    const double right_length = rectangle.right.length();
    const double up_length = rectangle.up.length();
    const V3d right = rectangle.right / right_length;
    const V3d up = rectangle.up / up_length;
    std::vector<Sight> sights;
    std::vector<bool> cell_seen(View::cells * View::cells, false);
    const auto cell_of = [](double share) {
        return static_cast<std::size_t>(std::clamp(share, 0.0, 0.999999) *
                                        static_cast<double>(View::cells));
    };
    for (std::size_t y = 0; y < film.height; ++y) {
        for (std::size_t x = 0; x < width; ++x) {
            const std::size_t i = y * width + x;
            if (layers.object[i] != id) {
                continue;
            }
            ++view.pixels;
            const V3d p(layers.position[i]);
            const V3d offset = p - rectangle.corner;
            sights.push_back({V3d(static_cast<double>(x), static_cast<double>(y), 1.0),
                              V3d(offset.dot(right), offset.dot(up), 0.0)});
            cell_seen[cell_of(offset.dot(up) / up_length) * View::cells +
                      cell_of(offset.dot(right) / right_length)] = true;
            if (x + 1 < width && y + 1 < film.height && layers.object[i + 1] == id &&
                layers.object[i + width] == id) {
                const V3d dx = V3d(layers.position[i + 1]) - p;
                const V3d dy = V3d(layers.position[i + width]) - p;
                view.anisotropy.push_back(
                    singular_ratio(dx.dot(right), dy.dot(right), dx.dot(up), dy.dot(up)));
            }
        }
    }
    view.share_seen = static_cast<double>(std::count(cell_seen.begin(), cell_seen.end(), true)) /
                      static_cast<double>(cell_seen.size());
    view.bend =
        sights.size() < 3 ? 0.0 : max_residual(sights) / std::hypot(right_length, up_length);
    return view;
}

Sightings sightings_of(const render::Film& film, const std::string& begin) {
    Sightings sightings;
    for (const std::string& name : film.objects) {
        if (name.starts_with(begin)) {
            const ObjectPixels region = object_pixels(film, name);
            ++sightings.objects;
            sightings.seen += region.pixels > 0 ? 1 : 0;
            sightings.connected += region.regions == 1 ? 1 : 0;
            sightings.pixels += region.pixels;
        }
    }
    return sightings;
}

ObjectPixels object_pixels(const render::Film& film, const std::string& object) {
    const std::vector<std::uint32_t>& ids = film.layers.value().object;
    const std::uint32_t id = id_of(film.objects, object);
    ObjectPixels region;
    region.min_x = film.width;
    region.min_y = film.height;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        if (ids[i] == id) {
            ++region.pixels;
            region.min_x = std::min(region.min_x, i % film.width);
            region.max_x = std::max(region.max_x, i % film.width);
            region.min_y = std::min(region.min_y, i / film.width);
            region.max_y = std::max(region.max_y, i / film.width);
        }
    }
    region.regions = region.pixels == 0 ? 0 : count_regions(ids, film.width, film.height, id);
    return region;
}

std::size_t max_runs_in_row(const render::Film& film, const std::string& object) {
    const std::uint32_t id = id_of(film.objects, object);
    const auto& ids = film.layers->object;
    std::size_t most = 0;
    for (std::size_t y = 0; y < film.height; ++y) {
        std::size_t runs = 0;
        for (std::size_t x = 0; x < film.width; ++x) {
            const std::size_t at = y * film.width + x;
            runs += ids[at] == id && (x == 0 || ids[at - 1] != id) ? 1 : 0;
        }
        most = std::max(most, runs);
    }
    return most;
}

RayStep max_step(const render::Film& film) {
    const render::DataLayers& layers = film.layers.value();
    RayStep longest;
    const auto compare = [&](std::size_t a, std::size_t b) {
        const V3d origin = V3d(layers.origin[b]) - V3d(layers.origin[a]);
        const V3d direction = V3d(layers.direction[b]) - V3d(layers.direction[a]);
        longest.origin = std::max(longest.origin, origin.length());
        longest.direction = std::max(longest.direction, direction.length());
    };
    for (std::size_t y = 0; y < film.height; ++y) {
        for (std::size_t x = 0; x < film.width; ++x) {
            const std::size_t i = y * film.width + x;
            if (x + 1 < film.width) {
                compare(i, i + 1);
            }
            if (y + 1 < film.height) {
                compare(i, i + film.width);
            }
        }
    }
    return longest;
}

}  // namespace balcony::plates

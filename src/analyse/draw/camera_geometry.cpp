// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "analyse/draw/camera_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "analyse/measure/ray_field.hpp"
#include "balcony/median.hpp"

namespace balcony::analyse {

namespace {

camera::Camera without_arrangers(const camera::Camera& camera) {
    camera::Camera::Parts parts = camera.parts();
    parts.arrangers.clear();
    return *camera::Camera::make(std::move(parts));
}

/// A ray with its position in the picture and its natural length.
struct Shown {
    V3d origin, direction;
    std::optional<double>
        reach;  ///< The distance to the point of the direction object, if it passes through that.
    std::vector<rays::RayBatch::Part> path{};  ///< Of a bent ray.
};

std::optional<double> reach_of(const Ray& ray, const V3d& origin, const V3d& direction,
                               const std::optional<ProjectionObjectPoint>& toward) {
    if (!toward || !ray.valid) {
        return std::nullopt;
    }
    const V3d there = toward->position - origin;
    constexpr double aligned = 1.0 - 1e-9;
    const double distance = there.length();
    return distance > 0.0 && there.dot(direction) > aligned * distance ? std::optional(distance)
                                                                       : std::nullopt;
}

std::vector<rays::RayBatch::Part> path_of(RayField& field, const V2d& place, Axes axes) {
    std::vector<rays::RayBatch::Part> path = field.path_at(place);
    for (rays::RayBatch::Part& part : path) {
        part.origin = turned(part.origin, axes, Axes::z_up);
        part.direction = turned(part.direction, axes, Axes::z_up);
    }
    return path;
}

Result<std::vector<Shown>> shown_rays(const camera::Camera& camera, const Depiction& depiction,
                                      CameraGeometry& geometry, const Work& work) {
    constexpr double picture_height = 1000.0;
    Result<RayField> field =
        RayField::make(camera, picture_height * geometry.aspect, picture_height, depiction.time,
                       RayField::Derivatives::without, work, RayField::Parts::all);
    if (!field) {
        return field.diagnostics;
    }
    std::vector<Shown> shown;
    const auto along = [&](double share) {
        const double count = std::round(static_cast<double>(depiction.rays) * share);
        return static_cast<std::size_t>(std::max(count, 1.0));
    };
    const PictureGrid grid{along(std::min(1.0, geometry.aspect)),
                           along(std::min(1.0, 1.0 / geometry.aspect))};
    for (std::size_t i = 0; i < grid.columns * grid.rows; ++i) {
        const V2d picture = grid.at(static_cast<double>(i % grid.columns) + 0.5,
                                    static_cast<double>(i / grid.columns) + 0.5);
        const V2d place = picture * picture_height * V2d(geometry.aspect, 1.0);
        const Ray ray = field->at(place);
        if (ray.valid && !is_near(ray.origin)) {
            geometry.far_rays = true;
        } else if (ray.valid) {
            const Axes axes = camera.parts().axes;
            const V3d origin = turned(ray.origin, axes, Axes::z_up);
            const V3d direction = turned(ray.direction, axes, Axes::z_up);
            const auto toward = geometry.toward ? geometry.toward->at(picture) : std::nullopt;
            shown.push_back({origin, direction, reach_of(ray, origin, direction, toward)});
            if (camera.parts().bend) {
                shown.back().path = path_of(*field, place, axes);
            }
        }
    }
    return shown;
}

double median_reach(const std::vector<Shown>& rays) {
    std::vector<double> all;
    for (const Shown& ray : rays) {
        if (ray.reach) {
            all.push_back(*ray.reach);
        }
    }
    return median(std::move(all)).value_or(0.0);
}

/// A path with fewer corners: without those near the line from the last corner that is kept to the
/// next one that is.
std::vector<V3d> thinned(const std::vector<V3d>& path, double visible) {
    const auto is_near_line = [&](const V3d& point, const V3d& from, const V3d& to) {
        const V3d way = to - from;
        const double square = way.length2();
        const double part =
            square > 0.0 ? std::clamp((point - from).dot(way) / square, 0.0, 1.0) : 0.0;
        return (from + part * way - point).length() <= visible;
    };
    std::vector<V3d> kept;
    std::size_t last = 0;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const auto is_straight_to = [&](std::size_t end) {
            return std::all_of(
                path.begin() + static_cast<std::ptrdiff_t>(last) + 1,
                path.begin() + static_cast<std::ptrdiff_t>(end),
                [&](const V3d& one) { return is_near_line(one, path[last], path[end]); });
        };
        if (i == 0 || i + 1 == path.size() || !is_straight_to(i + 1)) {
            kept.push_back(path[i]);
            last = i;
        }
    }
    return kept;
}

// A bent ray up to a length; without one, the whole bend and a little more.
void add_bent_arrow(const std::vector<rays::RayBatch::Part>& path,
                    const std::optional<double>& length, std::vector<Arrow>& made) {
    constexpr double beyond = 1.1;
    double bend = 0.0;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        bend += path[i].length;
    }
    constexpr double visible = 1.0 / 2000.0;  // Of a line that may be as long as the page.
    const double whole = length.value_or(beyond * bend);
    double left = whole;
    std::vector<V3d> corners{path.front().origin};
    for (const auto& [origin, direction, part_length] : path) {
        const double shown = std::min(part_length, left);
        if (!(shown > 0.0)) {
            continue;
        }
        const V3d end = origin + shown * direction;
        if (!is_near(end)) {
            break;
        }
        left -= shown;
        corners.push_back(end);
    }
    corners = thinned(corners, visible * whole);
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        const bool is_end = i + 2 == corners.size() && !(left > 0.0);
        made.push_back({corners[i], corners[i + 1], is_end});
    }
}

std::vector<Arrow> arrows(const std::vector<Shown>& rays, const Depiction& depiction,
                          double object_size) {
    constexpr double of_object = 0.16;  // The length of an arrow without a target point.
    constexpr double beyond = 1.25;     // The overshoot past the direction object.
    constexpr double longest = 2.5;     // In usual lengths; longer arrows would hide the rest.
    const double usual = median_reach(rays);
    const double without = usual > 0.0         ? usual * beyond
                           : object_size > 0.0 ? object_size * of_object
                                               : 1.0;
    std::vector<Arrow> made;
    for (const Shown& ray : rays) {
        if (ray.path.size() > 1) {
            add_bent_arrow(ray.path, depiction.length, made);
            continue;
        }
        const double own = ray.reach ? std::min(*ray.reach * beyond, usual * longest) : without;
        made.push_back({ray.origin, ray.origin + depiction.length.value_or(own) * ray.direction});
    }
    return made;
}

Diagnostic nothing_to_draw(const std::string& name, bool far) {
    return error(
        fmt::format("camera '{}' has no valid point{}, so there is nothing to draw", name,
                    far ? fmt::format(" within {:g} units of the origin", max_coordinate) : ""),
        {}, "check the ranges of its map, or use another --time");
}

// `share` is that of the camera in what a drawing may cost.
Result<CameraGeometry> measure_camera(const camera::Camera& camera, const Depiction& depiction,
                                      double share, const Work& work) {
    const camera::Camera bare = without_arrangers(camera);
    const camera::Camera::Parts& parts = bare.parts();
    CameraGeometry geometry;
    geometry.name = camera.name();
    geometry.aspect = parts.aspect;
    const auto object_on = [&](const camera::Path& path) {
        return std::make_unique<ProjectionObject>(path, parts.aspect, parts.axes, depiction.time,
                                                  0.5 * share, work);
    };
    geometry.eye = object_on(parts.eye);
    if (parts.toward) {
        geometry.toward = object_on(*parts.toward);
    }
    geometry.bounds = geometry.eye->bounds();
    if (geometry.bounds.isEmpty()) {
        return nothing_to_draw(camera.name(), geometry.eye->omissions().far);
    }
    if (geometry.toward) {
        geometry.bounds.extendBy(geometry.toward->bounds());
    }
    if (depiction.rays > 0) {
        const auto shown = shown_rays(bare, depiction, geometry, work);
        if (!shown) {
            return shown.diagnostics;
        }
        geometry.rays = arrows(*shown, depiction, geometry.extent());
        for (const Arrow& ray : geometry.rays) {
            geometry.bounds.extendBy(ray.from);
            geometry.bounds.extendBy(ray.to);
        }
    }
    return geometry;
}

}  // namespace

PictureGrid PictureGrid::of_cells(double count, double aspect) {
    const auto side = [](double cells) {
        return static_cast<std::size_t>(std::clamp(std::round(cells), 2.0, 1000.0));
    };
    return {side(std::sqrt(count * aspect)), side(std::sqrt(count / aspect))};
}

V2d PictureGrid::at(double column, double row) const {
    constexpr double inset = 0.002;
    const auto within = [](double share) { return inset + (1.0 - 2.0 * inset) * share; };
    return {within(column / static_cast<double>(columns)), within(row / static_cast<double>(rows))};
}

ProjectionObject* CameraGeometry::screen() const {
    return eye->dimension() == 2                ? eye.get()
           : toward && toward->dimension() == 2 ? toward.get()
                                                : nullptr;
}

double CameraGeometry::extent() const { return bounds.isEmpty() ? 0.0 : bounds.size().length(); }

namespace {

// With the aspect ratio of its first layer in the picture.
camera::Camera as_shown(const camera::ShownCamera& shown, const camera::Picture& picture,
                        double time) {
    constexpr double height = 1000.0;
    const auto size = size_of(shown.uses.front(), height * picture.aspect(), height, time);
    camera::Camera::Parts parts = shown.camera.parts();
    if (size[0] > 0.0 && size[1] > 0.0) {
        parts.aspect = size[0] / size[1];
    }
    const auto made = camera::Camera::make(std::move(parts));
    return made ? *made : shown.camera;
}

std::string title_of(const camera::ShownCamera& shown) {
    std::string numbers;
    for (const camera::ShownCamera::LayerUse& use : shown.uses) {
        numbers += (numbers.empty() ? " " : ", ") + use.layer;
    }
    return fmt::format("layer{}{}, {}", shown.uses.size() > 1 ? "s" : "", numbers,
                       shown.camera.name());
}

}  // namespace

Result<PictureGeometry> measure_geometry(const camera::Picture& picture, const Depiction& depiction,
                                         const Work& work) {
    PictureGeometry whole;
    std::size_t measured = 0;
    Diagnostics diagnostics;
    const bool by_itself = picture.only_camera() != nullptr;
    const std::vector<camera::ShownCamera> all = shown_cameras(picture);
    const double share = 1.0 / static_cast<double>(all.size());
    for (const camera::ShownCamera& shown : all) {
        work.done(share * static_cast<double>(measured++));
        auto geometry =
            measure_camera(by_itself ? shown.camera : as_shown(shown, picture, depiction.time),
                           depiction, share, work);
        diagnostics.insert(diagnostics.end(), geometry.diagnostics.begin(),
                           geometry.diagnostics.end());
        if (!geometry) {
            continue;
        }
        if (whole.cameras.empty()) {
            whole.axes = shown.camera.parts().axes;
        }
        whole.bounds.extendBy(geometry->bounds);
        whole.cameras.push_back({by_itself ? "" : title_of(shown), std::move(*geometry)});
    }
    if (whole.cameras.empty()) {
        return diagnostics;
    }
    for (Diagnostic& diagnostic : diagnostics) {
        diagnostic.severity = Severity::warning;
    }
    return {std::move(whole), std::move(diagnostics)};
}

std::vector<PictureGeometry> measure_film(const camera::Picture& picture,
                                          const Depiction& depiction, const Work& work) {
    constexpr int steps = 16;
    std::vector<PictureGeometry> film;
    Box3d bounds;
    for (int i = 0; depiction.film && i <= steps; ++i) {
        const double share = static_cast<double>(i) / steps;
        const auto [from, to] = *depiction.film;
        Depiction then = depiction;
        then.time = from + share * (to - from);
        Result<PictureGeometry> measured = measure_geometry(picture, then, work.silent());
        work.done(share);
        if (measured) {
            bounds.extendBy(measured->bounds);
            film.push_back(std::move(*measured));
        }
    }
    for (PictureGeometry& each : film) {
        each.bounds = bounds;
    }
    return film;
}

Diagnostics omissions(const PictureGeometry& geometry) {
    Diagnostics made;
    const auto add = [&made](const std::string& camera, std::string_view what,
                             const Omissions& of) {
        if (of.winding) {
            made.push_back(warning(
                fmt::format("of camera '{}', parts of {} turn or jump too often to be drawn",
                            camera, what),
                {}, "check the ranges of its map"));
        }
        if (of.far) {
            made.push_back(warning(fmt::format(
                "of camera '{}', parts of {} are farther from the origin than {:g} units and are "
                "not drawn",
                camera, what, max_coordinate)));
        }
    };
    for (const PictureGeometry::Part& part : geometry.cameras) {
        const CameraGeometry& camera = part.geometry;
        add(camera.name, "its eye object", camera.eye->omissions());
        if (camera.toward) {
            add(camera.name, "its direction object", camera.toward->omissions());
        }
        add(camera.name, "its rays", {false, camera.far_rays});
    }
    return made;
}

}  // namespace balcony::analyse

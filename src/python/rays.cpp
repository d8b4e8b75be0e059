// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Rays, their inverse, and their derivatives as arrays.

#include <algorithm>
#include <limits>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "balcony/parameter_derivatives.hpp"
#include "balcony/ray_arrays.hpp"
#include "balcony/studies.hpp"
#include "python/arrays.hpp"
#include "python/diagnostics.hpp"
#include "python/objects.hpp"
#include "python/running.hpp"
#include "python/words.hpp"

namespace balcony::python {

namespace py = pybind11;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

// What make(picture) makes for a query, or what was made for it last. The camera and the scene are
// locked.
template <class Made, class Make>
Result<Made> kept_in_lock(Last<Made> CameraObject::*last, CameraObject& camera,
                          const PictureQuery& query, const std::stop_token& stop,
                          const Make& make) {
    return (camera.*last).get(query, camera.changes, [&]() -> Result<Made> {
        auto picture = camera.picture(query.scene, stop);
        return picture ? make(*picture) : Result<Made>(std::move(picture.diagnostics));
    });
}

Result<analyse::Locator> locator_in_lock(CameraObject& camera, const PictureQuery& query,
                                         const std::stop_token& stop) {
    return kept_in_lock(
        &CameraObject::locator, camera, query, stop, [&](const camera::Picture& picture) {
            return analyse::Locator::make(picture, query.width(), query.height(), query.rays.time,
                                          query.rays.axes, {}, stop);
        });
}

Result<analyse::Locator> locator_of(CameraObject& camera, const PictureQuery& query,
                                    const std::stop_token& stop) {
    const Locked locked(camera, query.scene);
    return locator_in_lock(camera, query, stop);
}

// The arrays of some rays, which have this shape: origins, directions, valid, parameters,
// footprints and times; None for the last two without them.
template <class Fill>
py::tuple rays_in(const bridge::RayGrid& grid, const Shape& shape, const Fill& fill) {
    const auto with = [&](std::initializer_list<py::ssize_t> sides) {
        Shape whole = shape;
        whole.insert(whole.end(), sides);
        return py::array_t<double>(whole);
    };
    auto origins = with({3});
    auto directions = with({3});
    py::array_t<bool> valid(shape);
    auto parameters = with({2});
    bridge::RayArrays arrays{origins.mutable_data(), directions.mutable_data(),
                             reinterpret_cast<std::uint8_t*>(valid.mutable_data()),
                             parameters.mutable_data()};
    py::object footprints = py::none();
    py::object times = py::none();
    if (grid.has_footprints()) {
        auto array = with({4, 3});
        arrays.footprints = array.mutable_data();
        footprints = std::move(array);
    }
    if (grid.has_times()) {
        auto array = with({});
        arrays.times = array.mutable_data();
        times = std::move(array);
    }
    run([&](const std::stop_token& stop) { static_cast<void>(fill(arrays, stop)); });
    return py::make_tuple(origins, directions, valid, parameters, footprints, times);
}

py::tuple rays_of(const CameraPointer& camera, const std::array<std::size_t, 2>& size,
                  const std::string& layer, const py::object& axes, double time,
                  const ScenePointer& scene, bool footprints, const py::object& points) {
    PictureQuery query = query_of(size, layer, axes, time, scene);
    query.rays.footprints = footprints;
    const auto grid =
        take(made_by([&](const std::stop_token& stop) { return grid_of(*camera, query, stop); }));
    if (points.is_none()) {
        return rays_in(grid, {static_cast<py::ssize_t>(size[1]), static_cast<py::ssize_t>(size[0])},
                       [&](const bridge::RayArrays& arrays, const std::stop_token& stop) {
                           return bridge::fill(grid, arrays, stop);
                       });
    }
    const Rows rows = python::rows_of(points, "points", {2});
    return rays_in(grid, {static_cast<py::ssize_t>(rows.count)},
                   [&](const bridge::RayArrays& arrays, const std::stop_token& stop) {
                       return bridge::fill(grid, rows.points(), arrays, stop);
                   });
}

std::vector<analyse::Sighting> sightings_in(const CameraPointer& camera, const PictureQuery& query,
                                            const Rows& rows) {
    using Sightings = std::vector<analyse::Sighting>;
    return take(made_by([&](const std::stop_token& stop) -> Result<Sightings> {
        const auto locator = locator_of(*camera, query, stop);
        if (!locator) {
            return locator.diagnostics;
        }
        std::vector<std::size_t> in_part;
        auto found = locator->locate(rows.places(), in_part, {}, stop);
        found.diagnostics.insert(found.diagnostics.begin(), locator.diagnostics.begin(),
                                 locator.diagnostics.end());
        if (!in_part.empty()) {
            found.diagnostics.push_back(app::searched_in_part(in_part.size()));
        }
        return found;
    }));
}

template <class Number, class Get>
py::array_t<Number> column_of(const std::vector<analyse::Sighting>& sightings, std::size_t width,
                              const Get& get) {
    const auto count = static_cast<py::ssize_t>(sightings.size());
    py::array_t<Number> made(width == 1 ? Shape{count}
                                        : Shape{count, static_cast<py::ssize_t>(width)});
    Number* at = made.mutable_data();
    for (const analyse::Sighting& one : sightings) {
        get(one, at);
        at += width;
    }
    return made;
}

// Point, layer, position, origin and distance.
py::tuple columns_of(const std::vector<analyse::Sighting>& all) {
    using One = analyse::Sighting;
    return py::make_tuple(
        column_of<std::int64_t>(
            all, 1, [](const One& one, auto* at) { *at = static_cast<std::int64_t>(one.point); }),
        column_of<std::int64_t>(
            all, 1, [](const One& one, auto* at) { *at = static_cast<std::int64_t>(one.layer); }),
        column_of<double>(all, 2,
                          [](const One& one, double* at) {
                              at[0] = one.position.x;
                              at[1] = one.position.y;
                          }),
        column_of<double>(all, 3,
                          [](const One& one, double* at) {
                              at[0] = one.origin.x;
                              at[1] = one.origin.y;
                              at[2] = one.origin.z;
                          }),
        column_of<double>(all, 1, [](const One& one, double* at) { *at = one.distance; }));
}

py::tuple sightings_of(const CameraPointer& camera, const py::object& points,
                       const std::array<std::size_t, 2>& size, const py::object& axes, double time,
                       const ScenePointer& scene) {
    const Rows rows = python::rows_of(points, "points", {3});
    return columns_of(sightings_in(camera, query_of(size, "", axes, time, scene), rows));
}

Result<app::Located> located(CameraObject& camera, PictureQuery query, const Rows& rows,
                             const std::stop_token& stop) {
    const ScenePointer& scene = query.scene;
    const Locked locked(camera, scene);
    query.rays.time = scene->scene.settings().time;
    const auto picture = camera.picture(scene, stop);
    const auto inverse =
        picture ? locator_in_lock(camera, query, stop) : Result<analyse::Locator>();
    if (!picture || !inverse) {
        return picture ? inverse.diagnostics : picture.diagnostics;
    }
    auto session = app::LocateSession::make(*picture, scene->scene,
                                            {query.rays.width, query.rays.height}, stop, *inverse);
    if (!session) {
        return session.diagnostics;
    }
    const std::span<const Imath::V3d> places = rows.places();
    auto found = session->locate({places.begin(), places.end()}, stop);
    if (found) {
        const Diagnostics more = session->finish(stop);
        found.diagnostics.insert(found.diagnostics.end(), more.begin(), more.end());
    }
    return found;
}

// Sightings, the object that hides each, or -1, and where on its ray, and the names of all objects.
py::tuple located_of(const CameraPointer& camera, const py::object& points,
                     const std::array<std::size_t, 2>& size, const ScenePointer& scene) {
    const Rows rows = python::rows_of(points, "points", {3});
    const PictureQuery query = query_of(size, "", py::none(), 0.0, scene);
    const auto found = take(
        made_by([&](const std::stop_token& stop) { return located(*camera, query, rows, stop); }));
    const auto count = static_cast<py::ssize_t>(found.sightings.size());
    py::array_t<std::int64_t> objects(Shape{count});
    py::array_t<double> distances(Shape{count});
    for (std::size_t i = 0; i < found.sightings.size(); ++i) {
        const auto& obstacle = (*found.obstacles)[i];
        objects.mutable_data()[i] = obstacle ? static_cast<std::int64_t>(obstacle->object) : -1;
        distances.mutable_data()[i] = obstacle ? obstacle->distance : none;
    }
    std::vector<std::string> names;
    for (const scene::Object& object : found.objects) {
        names.push_back(object.name);
    }
    return py::make_tuple(columns_of(found.sightings), objects, distances, names);
}

py::array_t<double> project(const CameraPointer& camera, const py::object& points,
                            const std::array<std::size_t, 2>& size, const py::object& axes,
                            double time, const ScenePointer& scene) {
    const Rows rows = python::rows_of(points, "points", {3});
    const auto found = sightings_in(camera, query_of(size, "", axes, time, scene), rows);
    py::array_t<double> made(Shape{static_cast<py::ssize_t>(rows.count), 2});
    double* at = made.mutable_data();
    for (const analyse::Sighting* one : analyse::foremost(found, rows.count)) {
        *at++ = one != nullptr ? one->position.x : none;
        *at++ = one != nullptr ? one->position.y : none;
    }
    return made;
}

// Derivatives, NaN where there are none, and the names of the parameters that they are by.
py::tuple jacobian(const CameraPointer& camera, const py::object& points,
                   const std::optional<std::vector<std::string>>& by,
                   const std::array<std::size_t, 2>& size, std::size_t layer,
                   const py::object& axes, double time, const ScenePointer& scene) {
    using Made = Result<app::ParameterDerivatives>;
    const Rows rows = python::rows_of(points, "points", {2, 3});
    const PictureQuery query = query_of(size, "", axes, time, scene);
    const app::DerivativeRequest request{by, size, layer, time, query.rays.axes};
    auto made = take(made_by([&](const std::stop_token& stop) -> Made {
        const auto picture = [&] {
            const Locked locked(*camera, scene);
            return camera->camera.open_picture(by, scene ? &scene->scene : nullptr, stop);
        }();
        if (!picture) {
            return picture.diagnostics;
        }
        if (rows.columns == 2) {
            return app::ray_derivatives(*picture, request, rows.points(), stop);
        }
        const auto locator = locator_of(*camera, query, stop);
        return locator ? app::position_derivatives(*picture, request, *locator, rows.places(), stop)
                       : Made(locator.diagnostics);
    }));
    const std::size_t numbers = rows.columns == 2 ? 6 : 2;
    std::vector<double>& values = made.derivatives.values;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (made.derivatives.valid[i / (numbers * made.by.size())] == 0) {
            values[i] = none;
        }
    }
    const Shape shape{static_cast<py::ssize_t>(rows.count), static_cast<py::ssize_t>(numbers),
                      static_cast<py::ssize_t>(made.by.size())};
    return py::make_tuple(array_of(std::move(values), shape), made.by);
}

}  // namespace

PictureQuery query_of(const std::array<std::size_t, 2>& size, const std::string& layer,
                      const py::object& axes, double time, const ScenePointer& scene) {
    if (size[0] == 0 || size[1] == 0) {
        throw py::value_error("a picture has at least one pixel in each direction");
    }
    PictureQuery query{
        {.width = size[0], .height = size[1], .layer = layer, .axes = axes_of(axes), .time = time},
        scene};
    if (scene && !query.rays.axes) {
        query.rays.axes = scene->axes;
    }
    return query;
}

Result<bridge::RayGrid> grid_of(CameraObject& camera, const PictureQuery& query,
                                const std::stop_token& stop) {
    const Locked locked(camera, query.scene);
    return kept_in_lock(
        &CameraObject::grid, camera, query, stop,
        [&](const camera::Picture& picture) { return bridge::RayGrid::make(picture, query.rays); });
}

void define_rays(py::module_& module) {
    module.def("rays", &rays_of, py::arg("camera"), py::arg("size"), py::arg("layer"),
               py::arg("axes"), py::arg("time"), py::arg("scene"), py::arg("footprints"),
               py::arg("points"));
    module.def("project", &project, py::arg("camera"), py::arg("points"), py::arg("size"),
               py::arg("axes"), py::arg("time"), py::arg("scene"));
    module.def("sightings", &sightings_of, py::arg("camera"), py::arg("points"), py::arg("size"),
               py::arg("axes"), py::arg("time"), py::arg("scene"));
    module.def("locate", &located_of, py::arg("camera"), py::arg("points"), py::arg("size"),
               py::arg("scene").none(false));
    module.def("jacobian", &jacobian, py::arg("camera"), py::arg("points"), py::arg("by"),
               py::arg("size"), py::arg("layer"), py::arg("axes"), py::arg("time"),
               py::arg("scene"));
}

}  // namespace balcony::python

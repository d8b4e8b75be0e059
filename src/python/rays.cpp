// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Rays, their inverse, and their derivatives as arrays.

#include <algorithm>
#include <limits>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "balcony/ray_arrays.hpp"
#include "balcony/solve.hpp"
#include "python/arrays.hpp"
#include "python/diagnostics.hpp"
#include "python/objects.hpp"
#include "python/running.hpp"
#include "python/words.hpp"

namespace balcony::python {

namespace py = pybind11;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

Result<analyse::Locator> locator_of(CameraObject& camera, const PictureQuery& query,
                                    const std::stop_token& stop) {
    const Locked locked(camera, query.scene);
    return camera.locator.get(query, camera.changes, [&]() -> Result<analyse::Locator> {
        auto picture = camera.picture(query.scene, stop);
        if (!picture) {
            return std::move(picture.diagnostics);
        }
        return analyse::Locator::make(*picture, static_cast<double>(query.width),
                                      static_cast<double>(query.height), query.time, query.axes, {},
                                      stop);
    });
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
    query.footprints = footprints;
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

// Sightings of points, and which of these more patches may see than are searched.
struct Found {
    std::vector<analyse::Sighting> sightings;
    std::vector<std::size_t> in_part;
    Axes axes = Axes::z_up;
};

Result<Found> found_of(CameraObject& camera, const PictureQuery& query,
                       std::span<const Imath::V3d> points, const std::stop_token& stop) {
    const auto locator = locator_of(camera, query, stop);
    if (!locator) {
        return locator.diagnostics;
    }
    Found found{{}, {}, locator->axes()};
    auto sightings = locator->locate(points, found.in_part, {}, stop);
    if (!sightings) {
        return std::move(sightings.diagnostics);
    }
    found.sightings = std::move(*sightings);
    Diagnostics said = locator.diagnostics;
    if (!found.in_part.empty()) {
        said.push_back(
            warning(std::to_string(found.in_part.size()) +
                        " points may be seen in so many places that not all were searched",
                    {}, "make the picture smaller, or ask about fewer layers"));
    }
    return {std::move(found), std::move(said)};
}

Found sightings_in(const CameraPointer& camera, const PictureQuery& query, const Rows& rows) {
    return take(made_by([&](const std::stop_token& stop) {
        return found_of(*camera, query, rows.places(), stop);
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

py::tuple sightings_of(const CameraPointer& camera, const py::object& points,
                       const std::array<std::size_t, 2>& size, const py::object& axes, double time,
                       const ScenePointer& scene) {
    const Rows rows = python::rows_of(points, "points", {3});
    const auto found = sightings_in(camera, query_of(size, "", axes, time, scene), rows);
    const auto& all = found.sightings;
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

// Of each point the sighting in the front layer that has one, the nearest of these; null if there
// is none.
std::vector<const analyse::Sighting*> chosen_of(const Found& found, std::size_t points) {
    std::vector<const analyse::Sighting*> chosen(points, nullptr);
    for (const analyse::Sighting& one : found.sightings) {
        const analyse::Sighting*& best = chosen[one.point];
        if (best == nullptr || one.layer > best->layer ||
            (one.layer == best->layer && one.distance < best->distance)) {
            best = &one;
        }
    }
    return chosen;
}

py::array_t<double> project(const CameraPointer& camera, const py::object& points,
                            const std::array<std::size_t, 2>& size, const py::object& axes,
                            double time, const ScenePointer& scene) {
    const Rows rows = python::rows_of(points, "points", {3});
    const auto found = sightings_in(camera, query_of(size, "", axes, time, scene), rows);
    py::array_t<double> made(Shape{static_cast<py::ssize_t>(rows.count), 2});
    double* at = made.mutable_data();
    for (const analyse::Sighting* one : chosen_of(found, rows.count)) {
        *at++ = one != nullptr ? one->position.x : none;
        *at++ = one != nullptr ? one->position.y : none;
    }
    return made;
}

// A picture with open parameters, and the derivatives by them.
struct Opened {
    std::vector<std::string> names;
    std::vector<double> values;
    solve::Solver solver;
};

Result<Opened> opened_of(CameraObject& camera, const PictureQuery& query, std::size_t layer,
                         const std::optional<std::vector<std::string>>& by,
                         const std::stop_token& stop) {
    const Locked locked(camera, query.scene);
    auto opened = camera.camera.open_picture(by, query.scene ? &query.scene->scene : nullptr, stop);
    if (!opened) {
        return std::move(opened.diagnostics);
    }
    if (by && !opened->closed.empty()) {
        for (const std::string& name : *by) {
            if (std::find(opened->closed.begin(), opened->closed.end(), name) !=
                opened->closed.end()) {
                return error(Kind::usage, "there are no derivatives by '" + name + "'",
                             "it is no number, or determines the structure of the camera");
            }
        }
    }
    std::vector<std::string> names;
    std::vector<std::string> inputs;
    std::vector<double> values;
    for (const lang::OpenParameter& one : opened->open) {
        names.push_back(one.name);
        inputs.push_back(lang::parameter_input(one.name));
        values.push_back(one.value);
    }
    auto solver = solve::Solver::make(opened->picture, layer, static_cast<double>(query.width),
                                      static_cast<double>(query.height), inputs, query.time, stop);
    if (!solver) {
        return std::move(solver.diagnostics);
    }
    return Opened{std::move(names), std::move(values), std::move(*solver)};
}

struct Jacobian {
    std::vector<std::string> names;
    solve::Derivatives derivatives;
};

Result<Jacobian> jacobian_of_rays(const Opened& opened, const Rows& rows, Axes axes) {
    solve::Derivatives made = opened.solver.ray_derivatives(rows.points(), opened.values);
    if (axes != opened.solver.axes()) {
        const std::size_t inputs = opened.values.size();
        for (std::size_t i = 0; i < rows.count * 2 * inputs; ++i) {
            double* const x = made.values.data() + i / inputs * 3 * inputs + i % inputs;
            const Imath::V3d turned = balcony::turned(Imath::V3d(x[0], x[inputs], x[2 * inputs]),
                                                      opened.solver.axes(), axes);
            x[0] = turned.x;
            x[inputs] = turned.y;
            x[2 * inputs] = turned.z;
        }
    }
    return Jacobian{opened.names, std::move(made)};
}

Result<Jacobian> jacobian_of_positions(CameraObject& camera, const PictureQuery& query,
                                       std::size_t layer, const Opened& opened, const Rows& rows,
                                       const std::stop_token& stop) {
    const auto found = found_of(camera, query, rows.places(), stop);
    if (!found) {
        return found.diagnostics;
    }
    std::vector<Imath::V3d> points(rows.count);
    std::vector<Imath::V2d> seen(rows.count, Imath::V2d(none));
    std::vector<double> nearest(rows.count, std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < rows.count; ++i) {
        points[i] = turned(rows.places()[i], found->axes, opened.solver.axes());
    }
    for (const analyse::Sighting& one : found->sightings) {
        if (one.layer == layer && one.distance < nearest[one.point]) {
            nearest[one.point] = one.distance;
            seen[one.point] = one.position;
        }
    }
    return Jacobian{opened.names, opened.solver.position_derivatives(points, seen, opened.values)};
}

// Derivatives, NaN where there are none, and the names of the parameters that they are by.
py::tuple jacobian(const CameraPointer& camera, const py::object& points,
                   const std::optional<std::vector<std::string>>& by,
                   const std::array<std::size_t, 2>& size, std::size_t layer,
                   const py::object& axes, double time, const ScenePointer& scene) {
    const Rows rows = python::rows_of(points, "points", {2, 3});
    const PictureQuery query = query_of(size, "", axes, time, scene);
    auto made = take(made_by([&](const std::stop_token& stop) -> Result<Jacobian> {
        const auto opened = opened_of(*camera, query, layer, by, stop);
        if (!opened) {
            return opened.diagnostics;
        }
        return rows.columns == 2
                   ? jacobian_of_rays(*opened, rows, query.axes.value_or(opened->solver.axes()))
                   : jacobian_of_positions(*camera, query, layer, *opened, rows, stop);
    }));
    const std::size_t of_point = (rows.columns == 2 ? 6 : 2) * made.names.size();
    std::vector<double>& values = made.derivatives.values;
    for (std::size_t i = 0; i < rows.count; ++i) {
        if (made.derivatives.valid[i] == 0) {
            std::fill_n(values.begin() + static_cast<std::ptrdiff_t>(i * of_point), of_point, none);
        }
    }
    const Shape shape{static_cast<py::ssize_t>(rows.count), rows.columns == 2 ? 6 : 2,
                      static_cast<py::ssize_t>(made.names.size())};
    return py::make_tuple(array_of(std::move(values), shape), made.names);
}

}  // namespace

PictureQuery query_of(const std::array<std::size_t, 2>& size, const std::string& layer,
                      const py::object& axes, double time, const ScenePointer& scene) {
    if (size[0] == 0 || size[1] == 0) {
        throw py::value_error("a picture has at least one pixel in each direction");
    }
    PictureQuery query{size[0], size[1], layer, axes_of(axes), time, false, scene};
    if (scene && !query.axes) {
        query.axes = scene->axes;
    }
    return query;
}

Result<bridge::RayGrid> grid_of(CameraObject& camera, const PictureQuery& query,
                                const std::stop_token& stop) {
    const Locked locked(camera, query.scene);
    return camera.grid.get(query, camera.changes, [&]() -> Result<bridge::RayGrid> {
        auto picture = camera.picture(query.scene, stop);
        if (!picture) {
            return std::move(picture.diagnostics);
        }
        return bridge::RayGrid::make(*picture, {query.width, query.height, query.layer, query.axes,
                                                query.time, query.footprints});
    });
}

void define_rays(py::module_& module) {
    module.def("rays", &rays_of, py::arg("camera"), py::arg("size"), py::arg("layer"),
               py::arg("axes"), py::arg("time"), py::arg("scene"), py::arg("footprints"),
               py::arg("points"));
    module.def("project", &project, py::arg("camera"), py::arg("points"), py::arg("size"),
               py::arg("axes"), py::arg("time"), py::arg("scene"));
    module.def("sightings", &sightings_of, py::arg("camera"), py::arg("points"), py::arg("size"),
               py::arg("axes"), py::arg("time"), py::arg("scene"));
    module.def("jacobian", &jacobian, py::arg("camera"), py::arg("points"), py::arg("by"),
               py::arg("size"), py::arg("layer"), py::arg("axes"), py::arg("time"),
               py::arg("scene"));
}

}  // namespace balcony::python

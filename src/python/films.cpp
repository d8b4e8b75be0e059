// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The layers of rendered pictures as arrays.

#include <algorithm>
#include <filesystem>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "balcony/display_pixels.hpp"
#include "balcony/film.hpp"
#include "balcony/layer_values.hpp"
#include "python/arrays.hpp"
#include "python/diagnostics.hpp"
#include "python/objects.hpp"
#include "python/running.hpp"

namespace balcony::python {

namespace py = pybind11;

namespace {

using render::Film;
using FilmPointer = std::shared_ptr<Film>;

Shape shape_of(const Film& film, std::size_t channels) {
    Shape shape{static_cast<py::ssize_t>(film.window.height),
                static_cast<py::ssize_t>(film.window.width)};
    if (channels > 1) {
        shape.push_back(static_cast<py::ssize_t>(channels));
    }
    return shape;
}

py::array_t<float> array_in(const Film& film, render::LayerValues&& layer) {
    return array_of(std::move(layer.values), shape_of(film, layer.channels));
}

// Name and meaning of the layers that the film has.
py::list layers_of(const Film& film) {
    py::list told;
    for (const render::LayerInfo& one : render::layers()) {
        if (film.layer_set.contains(one.id)) {
            told.append(py::make_tuple(std::string(one.name), std::string(one.meaning)));
        }
    }
    return told;
}

py::array_t<float> layer_of(const Film& film, const std::string& name) {
    const auto all = render::layers();
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const render::LayerInfo& one) { return one.name == name; });
    if (found == all.end()) {
        throw py::key_error(name);
    }
    return array_in(film, take(made_by([&](const std::stop_token&) {
                        return render::layer_values(film, found->id);
                    })));
}

render::DisplayOptions display_options(double exposure, const std::string& view, bool dither) {
    const auto found = render::view_transforms().find(view);
    if (!found) {
        throw py::value_error("there is no view transform '" + view + "'");
    }
    return {.exposure = exposure, .view = *found, .dither = dither};
}

py::array_t<std::uint8_t> pixels_of(const Film& film, double exposure, const std::string& view,
                                    bool dither) {
    const auto options = display_options(exposure, view, dither);
    return array_of(
        made_by([&](const std::stop_token&) { return render::display_pixels(film, options); }),
        shape_of(film, 3));
}

py::bytes png_of(const Film& film, double exposure, const std::string& view, bool dither) {
    const auto options = display_options(exposure, view, dither);
    const auto bytes = take(made_by([&](const std::stop_token&) {
        return render::encode(film, *render::display_format("picture.png"), options);
    }));
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

void write_film(const Film& film, const std::filesystem::path& file, double exposure,
                const std::string& view, bool dither) {
    const auto options = display_options(exposure, view, dither);
    tell(made_by([&](const std::stop_token&) {
        Diagnostics found = render::check_output(file);
        return has_errors(found) ? found : render::write(film, file, options);
    }));
}

}  // namespace

void define_films(py::module_& module) {
    py::class_<Film, FilmPointer>(module, "Film")
        .def("size",
             [](const Film& film) { return py::make_tuple(film.window.width, film.window.height); })
        .def("layers", &layers_of)
        .def("layer", &layer_of)
        .def("color",
             [](const Film& film) {
                 return array_in(film, made_by([&](const std::stop_token&) {
                                     return render::color_values(film);
                                 }));
             })
        .def("exposure", &render::automatic_exposure)
        .def_readonly("objects", &Film::objects)
        .def_readonly("materials", &Film::materials)
        .def_readonly("picture_layers", &Film::picture_layers)
        .def("pixels", &pixels_of)
        .def("png", &png_of)
        .def("write",
             [](const Film& film, const std::string& file, double exposure, const std::string& view,
                bool dither) { write_film(film, file, exposure, view, dither); });
}

}  // namespace balcony::python

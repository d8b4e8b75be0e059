// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The layers of rendered pictures as arrays.

#include <algorithm>
#include <optional>
#include <string>

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

Shape shape_of(const Film& film, std::size_t channels) {
    Shape shape{static_cast<py::ssize_t>(film.window.height),
                static_cast<py::ssize_t>(film.window.width)};
    if (channels > 1) {
        shape.push_back(static_cast<py::ssize_t>(channels));
    }
    return shape;
}

py::array_t<float> array_in(const Film& film, render::LayerValues layer) {
    return array_of(std::move(layer.values), shape_of(film, layer.channels));
}

// Name and meaning of the layers that the picture has.
py::list layers_of(const PictureObject& picture) {
    py::list told;
    for (const render::LayerInfo& one : render::layers()) {
        if (picture.film->layer_set.contains(one.id)) {
            told.append(py::make_tuple(std::string(one.name), std::string(one.meaning)));
        }
    }
    return told;
}

py::array_t<float> layer_of(const PictureObject& picture, const std::string& name) {
    const auto all = render::layers();
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const render::LayerInfo& one) { return one.name == name; });
    if (found == all.end()) {
        throw py::key_error(name);
    }
    return array_in(*picture.film, take(made_by([&](const std::stop_token&) {
        return render::layer_values(*picture.film, found->id);
    })));
}

py::array_t<float> color_of(const PictureObject& picture) {
    return array_in(*picture.film, made_by([&](const std::stop_token&) {
        return render::color_values(*picture.film);
    }));
}

// As a display shows the picture, or with another exposure.
render::DisplayOptions shown(const PictureObject& picture, const std::optional<double>& exposure) {
    render::DisplayOptions made = picture.display;
    made.exposure = exposure.value_or(made.exposure);
    return made;
}

py::array_t<std::uint8_t> pixels_of(const PictureObject& picture,
                                    const std::optional<double>& exposure) {
    return array_of(made_by([&](const std::stop_token&) {
                        return render::display_pixels(*picture.film, shown(picture, exposure));
                    }),
                    shape_of(*picture.film, 3));
}

py::bytes png_of(const PictureObject& picture) {
    const auto bytes = take(made_by([&](const std::stop_token&) {
        return render::encode(*picture.film, *render::display_format("picture.png"),
                              picture.display);
    }));
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

void save(const PictureObject& picture, const std::string& file,
          const std::optional<double>& exposure) {
    tell(made_by([&](const std::stop_token&) {
        Diagnostics found = render::check_output(file);
        return has_errors(found) ? found
                                 : render::write(*picture.film, file, shown(picture, exposure));
    }));
}

}  // namespace

void define_pictures(py::module_& module) {
    py::class_<PictureObject>(module, "Picture")
        .def("size",
             [](const PictureObject& picture) {
                 return py::make_tuple(picture.film->window.width, picture.film->window.height);
             })
        .def_readonly("camera", &PictureObject::camera)
        .def("exposure", [](const PictureObject& picture) { return picture.display.exposure; })
        .def("layers", &layers_of)
        .def("layer", &layer_of)
        .def("color", &color_of)
        .def("objects", [](const PictureObject& picture) { return picture.film->objects; })
        .def("materials", [](const PictureObject& picture) { return picture.film->materials; })
        .def("pixels", &pixels_of)
        .def("png", &png_of)
        .def("save", &save);
}

}  // namespace balcony::python

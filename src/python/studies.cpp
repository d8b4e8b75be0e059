// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Photos in the pictures of cameras, and animations.

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "balcony/animation.hpp"
#include "balcony/film.hpp"
#include "balcony/inputs.hpp"
#include "balcony/photo_arrays.hpp"
#include "balcony/photo_maps.hpp"
#include "python/arrays.hpp"
#include "python/diagnostics.hpp"
#include "python/objects.hpp"
#include "python/running.hpp"
#include "python/told.hpp"
#include "python/words.hpp"

namespace balcony::python {

namespace py = pybind11;

namespace {

// ------------------------------------------------------------------------------------- photos

using Sides = std::array<std::optional<std::size_t>, 2>;

void check_sides(const Sides& size) {
    for (const std::optional<std::size_t>& side : size) {
        if (side && (*side == 0 || *side > app::max_side)) {
            throw py::value_error(fmt::format(
                "the sides of a picture have from 1 to {} pixels, not {}", app::max_side, *side));
        }
    }
}

app::PhotoMapRequest request_of(const Sides& size, const std::string& layer, double time,
                                const std::optional<std::array<std::size_t, 2>>& photo_size,
                                bool allow_parallax) {
    check_sides(size);
    if (photo_size) {
        check_sides({(*photo_size)[0], (*photo_size)[1]});
    }
    return {.size = {.width = size[0], .height = size[1]},
            .layer = layer,
            .time = time,
            .photo_size = photo_size,
            .parallax = allow_parallax ? bridge::Parallax::ignore : bridge::Parallax::refuse};
}

camera::Picture picture_of(CameraObject& camera) {
    const std::lock_guard lock(camera.mutex);
    return camera.camera.picture();
}

Result<bridge::StMap> map_of(const CameraPointer& wanted, const CameraPointer& photo,
                             const app::PhotoMapRequest& request, const std::stop_token& stop) {
    return app::photo_map(picture_of(*wanted), picture_of(*photo), request, stop);
}

Shape shape_of(const bridge::StMap& map) {
    return {static_cast<py::ssize_t>(map.height()), static_cast<py::ssize_t>(map.width()), 4};
}

// What make(map) makes of the map of two cameras, with it.
template <class Made, class Make>
std::pair<bridge::StMap, Made> made_of_map(const CameraPointer& wanted, const CameraPointer& photo,
                                           const app::PhotoMapRequest& request, const Make& make) {
    using Pair = std::pair<bridge::StMap, Made>;
    return take(made_by([&](const std::stop_token& stop) -> Result<Pair> {
        auto map = map_of(wanted, photo, request, stop);
        if (!map) {
            return map.diagnostics;
        }
        Result<Made> made = make(*map, stop);
        Diagnostics found = std::move(map.diagnostics);
        found.insert(found.end(), made.diagnostics.begin(), made.diagnostics.end());
        return made ? Result<Pair>({std::move(*map), std::move(*made)}, std::move(found))
                    : Result<Pair>(std::move(found));
    }));
}

py::array_t<float> st_map(const CameraPointer& wanted, const CameraPointer& photo,
                          const Sides& size, const std::string& layer, double time,
                          const std::optional<std::array<std::size_t, 2>>& photo_size,
                          bool allow_parallax) {
    auto [map, values] = made_of_map<std::vector<float>>(
        wanted, photo, request_of(size, layer, time, photo_size, allow_parallax),
        bridge::st_map_pixels);
    return array_of(std::move(values), shape_of(map));
}

void save_st_map(const CameraPointer& wanted, const CameraPointer& photo, const std::string& file,
                 const Sides& size, const std::string& layer, double time,
                 const std::optional<std::array<std::size_t, 2>>& photo_size, bool allow_parallax) {
    const auto request = request_of(size, layer, time, photo_size, allow_parallax);
    tell(bridge::check_st_map_file(file));
    tell(made_by([&](const std::stop_token& stop) {
        const auto map = map_of(wanted, photo, request, stop);
        Diagnostics found = map.diagnostics;
        if (map) {
            const auto written = bridge::write_st_map(*map, file, stop);
            found.insert(found.end(), written.problems.begin(), written.problems.end());
        }
        return found;
    }));
}

template <class Number>
bridge::Photo photo_of(const py::array& given, const bridge::PixelForm& form) {
    const auto array =
        py::array_t<Number, py::array::c_style | py::array::forcecast>::ensure(given);
    if (!array) {
        throw py::error_already_set();
    }
    const py::gil_scoped_release released;
    return bridge::photo_of(
        std::span<const Number>(array.data(), form.width * form.height * form.channels), form);
}

bridge::Photo photo_in(const py::object& argument) {
    const auto given = py::array::ensure(argument);
    if (!given) {
        throw py::error_already_set();
    }
    const auto side = [&](py::ssize_t axis) { return static_cast<std::size_t>(given.shape(axis)); };
    const bool is_grey = given.ndim() == 2;
    const bool fits =
        (is_grey || (given.ndim() == 3 && side(2) >= 1 && side(2) <= 4)) && given.size() > 0;
    if (!fits) {
        throw py::value_error(fmt::format(
            "the photo has the shape ({}), but (height, width) or (height, width, channels) with "
            "1 to 4 channels is needed",
            fmt::join(given.shape(), given.shape() + given.ndim(), ", ")));
    }
    const bridge::PixelForm form{side(1), side(0), is_grey ? 1 : side(2)};
    const auto type = given.dtype();
    if (type.kind() == 'u' && type.itemsize() == 1) {
        return photo_of<std::uint8_t>(given, form);
    }
    if (type.kind() == 'u' && type.itemsize() == 2) {
        return photo_of<std::uint16_t>(given, form);
    }
    if (type.kind() == 'f') {
        return photo_of<float>(given, form);
    }
    throw py::type_error(fmt::format(
        "the photo has the type {}, but uint8 or uint16, which are sRGB, or floats, which are "
        "linear light, are needed",
        std::string(py::str(given.dtype()))));
}

// A file, or an array.
bridge::Photo photo_from(const py::object& photo) {
    return py::isinstance<py::str>(photo)
               ? take(made_by([file = photo.cast<std::string>()](const std::stop_token&) {
                     return bridge::Photo::load(file);
                 }))
               : photo_in(photo);
}

py::object warp(const py::object& given, const CameraPointer& wanted, const CameraPointer& from,
                const Sides& size, const std::string& layer, double time, bool allow_parallax) {
    const bridge::Photo photo = photo_from(given);
    const auto request =
        request_of(size, layer, time, std::array{photo.width(), photo.height()}, allow_parallax);
    auto [map, pixels] = made_of_map<bridge::WarpedPixels>(
        wanted, from, request, [&](const bridge::StMap& made, const std::stop_token& stop) {
            return bridge::warped_pixels(made, photo, stop);
        });
    const Shape shape = shape_of(map);
    return std::visit(
        [&](auto&& numbers) -> py::object {
            return array_of(std::forward<decltype(numbers)>(numbers), shape);
        },
        std::move(pixels));
}

Diagnostics check_warped(const py::object& photo, const std::string& file) {
    Diagnostics found = render::check_output(file);
    if (!has_errors(found) && py::isinstance<py::str>(photo)) {
        const Diagnostics more = app::check_overwrites(
            file, std::array<std::filesystem::path, 1>{photo.cast<std::string>()});
        found.insert(found.end(), more.begin(), more.end());
    }
    return found;
}

void save_warped(const py::object& given, const CameraPointer& wanted, const CameraPointer& from,
                 const Sides& size, const std::string& layer, double time, bool allow_parallax,
                 const std::string& file) {
    tell(check_warped(given, file));
    const bridge::Photo photo = photo_from(given);
    const auto request =
        request_of(size, layer, time, std::array{photo.width(), photo.height()}, allow_parallax);
    tell(made_by([&](const std::stop_token& stop) {
        const auto map = map_of(wanted, from, request, stop);
        Diagnostics found = map.diagnostics;
        if (map) {
            const auto written = bridge::warp_photo(*map, photo, file, 0.0, stop);
            found.insert(found.end(), written.problems.begin(), written.problems.end());
        }
        return found;
    }));
}

// --------------------------------------------------------------------------------- animations

app::Observer observer_of_frames(ToldPart& told) {
    struct Place {
        std::size_t index = 0;
        std::size_t count = 1;
    };
    const auto at = std::make_shared<Place>();
    app::Observer made;
    made.frame = [at](std::size_t, std::size_t index, std::size_t count) { *at = {index, count}; };
    made.progress = [at, &told](const render::Progress& progress) {
        const double frame =
            static_cast<double>(progress.tiles_done) / static_cast<double>(progress.tiles);
        told.set((static_cast<double>(at->index) + frame) / static_cast<double>(at->count));
    };
    return made;
}

app::AnimationReport animated(const ScenePointer& scene, CameraObject& camera,
                              app::AnimationRequest animation, const app::Observer& observer,
                              const std::stop_token& stop) {
    const Locked locked(camera, scene);
    const auto picture = camera.picture(scene, stop);
    const auto identity = camera.camera.identity();
    if (!picture || !identity) {
        return {.diagnostics = picture ? identity.diagnostics : picture.diagnostics};
    }
    animation.identity = *identity;
    const double time = scene->scene.settings().time;
    app::AnimationReport report = scene->scene.animate(*picture, animation, observer, stop);
    ++scene->changes;
    const Diagnostics back = scene->scene.set_time(time);
    report.diagnostics.insert(report.diagnostics.end(), back.begin(), back.end());
    return report;
}

std::vector<std::string> files_of(const app::AnimationReport& report,
                                  const app::AnimationRequest& animation) {
    std::vector<std::string> files;
    if (animation.shard || animation.parts_per_frame > 1) {
        for (const app::FrameReport& frame : report.rendered) {
            files.push_back(frame.file.string());
        }
    } else if (animation.film) {
        files.push_back(report.film.string());
    } else {
        for (const std::size_t frame : report.frames) {
            files.push_back(animation.pattern.file(frame).string());
        }
    }
    return files;
}

// Without a camera, `of_scene` names one of the scene, which may move with it.
std::vector<std::string> animate(const ScenePointer& scene, const CameraPointer& camera,
                                 const py::dict& options, const std::string& of_scene,
                                 const py::object& progress) {
    app::AnimationRequest animation;
    animation.picture = scene->request;
    animation.picture.camera = of_scene;
    read_options(options, animation);
    tell(app::prepare_output(animation));
    ToldPart told(progress);
    const app::Observer observer = observer_of_frames(told);
    const app::AnimationReport report = made_by(
        [&](const std::stop_token& stop) {
            return camera ? animated(scene, *camera, animation, observer, stop)
                          : app::animate(animation, observer, stop);
        },
        [&] { told(); });
    tell(report.diagnostics);
    return files_of(report, animation);
}

}  // namespace

void define_studies(py::module_& module) {
    module.def("is_scene_option", &is_scene_option);
    module.def("st_map", &st_map, py::arg("wanted").none(false), py::arg("photo").none(false),
               py::arg("size"), py::arg("layer"), py::arg("time"), py::arg("photo_size"),
               py::arg("allow_parallax"));
    module.def("save_st_map", &save_st_map, py::arg("wanted").none(false),
               py::arg("photo").none(false), py::arg("file"), py::arg("size"), py::arg("layer"),
               py::arg("time"), py::arg("photo_size"), py::arg("allow_parallax"));
    module.def("warp", &warp, py::arg("photo"), py::arg("wanted").none(false),
               py::arg("source").none(false), py::arg("size"), py::arg("layer"), py::arg("time"),
               py::arg("allow_parallax"));
    module.def("save_warped", &save_warped, py::arg("photo"), py::arg("wanted").none(false),
               py::arg("source").none(false), py::arg("size"), py::arg("layer"), py::arg("time"),
               py::arg("allow_parallax"), py::arg("file"));
    module.def("animate", &animate, py::arg("scene").none(false), py::arg("camera"),
               py::arg("options"), py::arg("of_scene"), py::arg("progress"));
}

}  // namespace balcony::python

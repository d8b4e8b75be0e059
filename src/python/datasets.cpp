// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Data sets, and their pictures as arrays.

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "balcony/dataset.hpp"
#include "balcony/images.hpp"
#include "python/arrays.hpp"
#include "python/diagnostics.hpp"
#include "python/objects.hpp"
#include "python/running.hpp"
#include "python/told.hpp"

namespace balcony::python {

namespace py = pybind11;

namespace {

// `text` is a recipe, or empty for that of the file.
dataset::Recipe recipe_of(const std::string& file, const std::string& text) {
    return take(text.empty()
                    ? dataset::read_recipe(file)
                    : dataset::read_recipe(std::make_shared<const SourceText>("recipe", text), {}));
}

// The numbers of frames: of all, of those that were rendered, and of those that were there.
std::array<std::size_t, 3> make(const std::string& file, const std::string& text,
                                const std::string& folder,
                                const std::optional<std::array<std::size_t, 2>>& shard,
                                bool overwrite, const py::object& progress) {
    dataset::DatasetRequest request{.recipe = recipe_of(file, text), .folder = folder};
    request.overwrite = overwrite;
    if (shard) {
        const auto& [part, parts] = *shard;
        if (part < 1 || part > parts || parts > balcony::render::max_shards) {
            throw py::value_error("a shard is (part, parts), such as (2, 5)");
        }
        request.shard = balcony::render::Shard{part - 1, parts};
    }
    ToldPart told(progress);
    app::Observer observer;
    observer.frame = [&](std::size_t, std::size_t index, std::size_t count) {
        told.set(static_cast<double>(index) / static_cast<double>(count));
    };
    const dataset::DatasetReport report = made_by(
        [&](const std::stop_token& stop) { return dataset::make_dataset(request, observer, stop); },
        [&] { told(); });
    tell(report.diagnostics);
    told.set(1.0);
    told();
    return {report.frames, report.rendered, report.skipped};
}

py::array_t<std::uint8_t> picture_in(const std::string& file) {
    Shape shape;
    auto values = take(made_by([&](const std::stop_token&) -> Result<std::vector<std::uint8_t>> {
        const auto said = [&](const Diagnostic& reason) {
            return error(reason.kind, fmt::format("'{}' cannot be read: {}", file, reason.message),
                         reason.remedy);
        };
        auto opened = images::ImageFile::open(file);
        if (!opened) {
            return said(opened.diagnostics.front());
        }
        images::ImageFile& image = **opened;
        std::vector<std::uint8_t> read(image.height() * image.width() * image.channels());
        if (const auto reason = image.read_rows(0, image.height(), std::span(read))) {
            return said(*reason);
        }
        shape = {static_cast<py::ssize_t>(image.height()), static_cast<py::ssize_t>(image.width()),
                 static_cast<py::ssize_t>(image.channels())};
        return read;
    }));
    return array_of(std::move(values), shape);
}

}  // namespace

void define_datasets(py::module_& module) {
    module.def("make_dataset", &make, py::arg("file"), py::arg("text"), py::arg("folder"),
               py::arg("shard"), py::arg("overwrite"), py::arg("progress"));
    module.def("picture_in", &picture_in, py::arg("file"));
}

}  // namespace balcony::python

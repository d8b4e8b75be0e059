// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Edits of scenes: objects, materials and lights by name or number.

#include <algorithm>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "balcony/scene_edits.hpp"
#include "python/arrays.hpp"
#include "python/diagnostics.hpp"
#include "python/objects.hpp"
#include "python/running.hpp"

namespace balcony::python {

namespace py = pybind11;

namespace {

using scene::M44d;
using scene::PartName;
using scene::PropertyValue;
using scene::Scene;
using Found = Result<std::size_t>;

// Changes a scene.
template <class Change>
void edit(const ScenePointer& scene, const Change& change) {
    tell(made_by([&](const std::stop_token&) {
        const std::lock_guard lock(scene->mutex);
        ++scene->changes;
        return scene->scene.edit(change);
    }));
}

// Changes a part of a scene that is found by its name.
template <class Find, class Change>
void edit(const ScenePointer& scene, const PartName& name, const Find& find, const Change& change) {
    edit(scene, [&](Scene& own) {
        const Found found = find(own, name);
        return found ? change(own, *found) : found.diagnostics;
    });
}

// What is known of a part of a scene that is found by its name.
template <class Find, class Get>
auto ask(const ScenePointer& scene, const PartName& name, const Find& find, const Get& get) {
    using Got = decltype(get(std::declval<const Scene&>(), 0));
    return take(scene->locked([&](const app::PreparedScene& own) {
        const Found found = find(*own.scene(), name);
        return found ? get(*own.scene(), *found) : Got(found.diagnostics);
    }));
}

// The matrix of column vectors is that of row vectors transposed.
M44d matrix_of(const py::object& argument) {
    const Rows rows = rows_of(argument, "matrix", {4});
    if (rows.count != 4) {
        throw py::value_error("'matrix' is no matrix of 4 x 4 numbers");
    }
    M44d matrix;
    std::copy_n(rows.array.data(), 16, matrix.getValue());
    return matrix.transposed();
}

py::array_t<double> array_of_matrix(const M44d& matrix) {
    const M44d columns = matrix.transposed();
    return array_of(std::vector<double>(columns.getValue(), columns.getValue() + 16), {4, 4});
}

// Values of properties by name: a flag, a number, or several.
std::vector<PropertyValue> values_of_properties(const py::dict& values) {
    std::vector<PropertyValue> made;
    for (const auto& [key, value] : values) {
        const auto name = key.cast<std::string>();
        auto given = py::array::ensure(py::reinterpret_borrow<py::object>(value));
        if (!given || given.ndim() > 1 || given.size() == 0) {
            throw py::type_error("'" + name + "' is neither a number nor a row of numbers");
        }
        const Rows row =
            rows_of(given.reshape({-1}), name, {static_cast<std::size_t>(given.size())});
        made.push_back({name, {row.array.data(), row.array.data() + row.array.size()}});
    }
    return made;
}

py::object value_of(const scene::PropertyInfo& info, const std::vector<double>& numbers) {
    switch (info.type) {
        case scene::PropertyType::flag: return py::bool_(numbers.front() != 0.0);
        case scene::PropertyType::number: return py::float_(numbers.front());
        default: return py::make_tuple(numbers[0], numbers[1], numbers[2]);
    }
}

// Name, meaning, value and range of all properties of a part.
template <class Find, class Get>
py::list properties_of(const ScenePointer& scene, const PartName& name,
                       std::span<const scene::PropertyInfo> infos, const Find& find,
                       const Get& get) {
    const auto part = ask(scene, name, find, get);
    py::list told;
    for (const scene::PropertyInfo& info : infos) {
        const auto numbers = scene::property_of(part, info.name);
        told.append(py::make_tuple(std::string(info.name), std::string(info.meaning),
                                   value_of(info, *numbers),
                                   py::make_tuple(info.least, info.most)));
    }
    return told;
}

// The properties of a new material, or one of the scene.
using MaterialWanted = std::variant<py::dict, PartName>;

// Adds an object. A new material has its name.
void add_object(const ScenePointer& scene, const std::string& name, const py::object& positions,
                const py::object& triangles, const py::object& normals, const py::object& uv,
                const py::object& colors, const MaterialWanted& material,
                const py::object& matrix) {
    const auto rows = [](const py::object& argument, const char* what,
                         const std::vector<std::size_t>& columns) {
        return argument.is_none() ? Rows{} : rows_of(argument, what, columns);
    };
    const Rows p = rows_of(positions, "positions", {3});
    const Triples t = triples_of(triangles, "triangles");
    const Rows n = rows(normals, "normals", {3});
    const Rows c = rows(uv, "uv", {2});
    const Rows k = rows(colors, "colors", {3, 4});
    const M44d placed = matrix.is_none() ? M44d() : matrix_of(matrix);
    const scene::MeshArrays arrays{.positions = p.places(),
                                   .triangles = t.triangles(),
                                   .normals = n.places(),
                                   .texture_coordinates = c.points(),
                                   .colors = {k.array.data(), k.count * k.columns},
                                   .color_channels = k.count == 0 ? 3 : k.columns};
    const auto* const described = std::get_if<py::dict>(&material);
    const auto* const known = std::get_if<PartName>(&material);
    const auto values =
        described != nullptr ? values_of_properties(*described) : std::vector<PropertyValue>();
    edit(scene, [&](Scene& own) {
        const Found found = known != nullptr ? scene::find_material(own, *known)
                                             : scene::add_material(own, name, values);
        return found ? scene::add_object(own, name, arrays, *found, placed).diagnostics
                     : found.diagnostics;
    });
}

void define_objects(py::module_& edits) {
    edits.def("object", [](const ScenePointer& scene, const PartName& name) {
        return ask(scene, name, scene::find_object,
                   [](const Scene&, std::size_t found) { return Found(found); });
    });
    edits.def("matrix", [](const ScenePointer& scene, const PartName& name) {
        return array_of_matrix(ask(scene, name, scene::find_object, scene::place_of));
    });
    edits.def("bounds", [](const ScenePointer& scene, const PartName& name) {
        const auto box =
            ask(scene, name, scene::find_object, [](const Scene& own, std::size_t found) {
                return Result(scene::bounds_of(own, found));
            });
        return array_of(
            std::vector<double>{box.min.x, box.min.y, box.min.z, box.max.x, box.max.y, box.max.z},
            {2, 3});
    });
    edits.def("place",
              [](const ScenePointer& scene, const PartName& name, const py::object& matrix) {
                  const M44d place = matrix_of(matrix);
                  edit(scene, name, scene::find_object, [&](Scene& own, std::size_t found) {
                      return scene::place_object(own, found, place);
                  });
              });
    edits.def("transform",
              [](const ScenePointer& scene, const PartName& name, const py::object& matrix) {
                  const M44d change = matrix_of(matrix);
                  edit(scene, name, scene::find_object, [&](Scene& own, std::size_t found) {
                      return scene::transform_object(own, found, change);
                  });
              });
    edits.def("remove_object", [](const ScenePointer& scene, const PartName& name) {
        edit(scene, name, scene::find_object, [](Scene& own, std::size_t found) {
            scene::remove_object(own, found);
            return Diagnostics();
        });
    });
    edits.def("add_object", &add_object);
}

void define_materials(py::module_& edits) {
    edits.def("material", [](const ScenePointer& scene, const PartName& name) {
        return properties_of(
            scene, name, scene::material_properties(), scene::find_material,
            [](const Scene& own, std::size_t found) { return Result(own.materials[found]); });
    });
    edits.def("set_material",
              [](const ScenePointer& scene, const PartName& name, const py::dict& values) {
                  const auto wanted = values_of_properties(values);
                  edit(scene, name, scene::find_material, [&](Scene& own, std::size_t found) {
                      return scene::set_material(own, found, wanted);
                  });
              });
    edits.def("add_material", [](const ScenePointer& scene, const std::string& name,
                                 const py::dict& values) {
        const auto wanted = values_of_properties(values);
        edit(scene, [&](Scene& own) { return scene::add_material(own, name, wanted).diagnostics; });
    });
}

void define_lights(py::module_& edits) {
    edits.def("light", [](const ScenePointer& scene, const PartName& name) {
        return properties_of(
            scene, name, scene::light_properties(), scene::find_light,
            [](const Scene& own, std::size_t found) { return Result(own.lights[found]); });
    });
    edits.def("light_kind", [](const ScenePointer& scene, const PartName& name) {
        return ask(scene, name, scene::find_light, [](const Scene& own, std::size_t found) {
            return Result(std::string(scene::light_kinds()[own.lights[found].kind].name));
        });
    });
    edits.def("set_light",
              [](const ScenePointer& scene, const PartName& name, const py::dict& values) {
                  const auto wanted = values_of_properties(values);
                  edit(scene, name, scene::find_light, [&](Scene& own, std::size_t found) {
                      return scene::set_light(own, found, wanted);
                  });
              });
    edits.def("add_light", [](const ScenePointer& scene, const std::string& name,
                              const std::string& kind, const py::dict& values) {
        const auto known = scene::light_kinds().find(kind);
        if (!known) {
            throw py::value_error("there is no light of the kind '" + kind + "': give " +
                                  one_of(scene::light_kinds().all()));
        }
        const auto wanted = values_of_properties(values);
        edit(scene,
             [&](Scene& own) { return scene::add_light(own, name, *known, wanted).diagnostics; });
    });
    edits.def("remove_light", [](const ScenePointer& scene, const PartName& name) {
        edit(scene, name, scene::find_light, [](Scene& own, std::size_t found) {
            scene::remove_light(own, found);
            return Diagnostics();
        });
    });
}

}  // namespace

void define_scene_edits(py::module_& module) {
    py::module_ edits = module.def_submodule("edits");
    define_objects(edits);
    define_materials(edits);
    define_lights(edits);
}

}  // namespace balcony::python

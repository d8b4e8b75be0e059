// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The rows of the catalogue of stages, and the functions of formulas.

#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "balcony/catalogue.hpp"
#include "balcony/lang.hpp"
#include "balcony/operations.hpp"
#include "camera/catalogue/stage_text.hpp"
#include "python/objects.hpp"

namespace balcony::python {

namespace py = pybind11;

namespace {

using camera::Unit;

std::vector<std::string> names_in(const camera::FormulaShape& shape) {
    std::vector<std::string> names;
    if (shape.names.empty()) {
        names = {"u", "v"};
        if (shape.parameters == 3) {
            names = {"x", "y", "z"};
        }
        names.resize(shape.parameters);
        return names;
    }
    std::istringstream words{std::string(shape.names)};
    std::string name;
    while (std::getline(words >> std::ws, name, ',')) {
        names.push_back(name);
    }
    return names;
}

// How a value of Python becomes an argument of a parameter: a word, and of a stage its kind, of a
// formula the names of its parameters.
struct FormOf {
    using Form = py::tuple;

    Form operator()(const camera::NumberParameter& type) const { return number(type.unit); }
    Form operator()(const camera::PairParameter& type) const { return number(type.unit); }
    Form operator()(const camera::PointsParameter& type) const {
        return py::make_tuple(type.unit == Unit::angle ? "angles" : "points");
    }
    Form operator()(const camera::NestedStageParameter& type) const {
        return py::make_tuple(type.several ? "stages" : "stage", std::string(name_of(type.kind)));
    }
    Form operator()(const camera::FormulaParameter& type) const {
        return py::make_tuple("formula", names_in(type.shape), type.shape.may_have_fewer);
    }
    Form operator()(const camera::CountParameter&) const { return py::make_tuple("number"); }
    Form operator()(const camera::TripleParameter&) const { return py::make_tuple("number"); }
    Form operator()(const camera::ChoiceParameter&) const { return py::make_tuple("choice"); }
    /// A name, or that of a file.
    template <class Other>
    Form operator()(const Other&) const {
        return py::make_tuple("name");
    }

private:
    static Form number(Unit unit) {
        return py::make_tuple(unit == Unit::angle ? "angle" : "number");
    }
};

py::dict told_of(const camera::StageParameter& parameter) {
    py::dict made;
    made["name"] = parameter.name;
    made["form"] = std::visit(FormOf(), parameter.type);
    made["type"] = type_text(parameter);
    made["default"] = default_text(parameter);
    made["range"] = range_text(parameter);
    made["meaning"] = parameter.meaning;
    made["optional"] = parameter.optional;
    return made;
}

py::dict told_of(const camera::StageEntry& row) {
    py::list parameters;
    for (const camera::StageParameter& parameter : row.parameters) {
        parameters.append(told_of(parameter));
    }
    py::dict made;
    made["kind"] = std::string(name_of(row.kind));
    made["name"] = row.name;
    made["call"] = call_text(row);
    made["meaning"] = row.meaning;
    made["formula"] = stage_formula(row);
    made["example"] = row.example;
    made["parameters"] = parameters;
    made["shape"] = row.shape ? py::object(py::cast(names_in(*row.shape))) : py::none();
    return made;
}

py::list stage_rows() {
    py::list told;
    for (const camera::StageEntry& row : camera::catalogue()) {
        told.append(told_of(row));
    }
    return told;
}

// Name, number of arguments and meaning of operations that are written as calls.
py::list operation_rows() {
    py::list told;
    for (const expr::Operation& row : expr::operations()) {
        if (row.arity > 0 && row.scalar != nullptr && row.infix.empty()) {
            told.append(py::make_tuple(std::string(row.name), row.arity, std::string(row.meaning)));
        }
    }
    return told;
}

}  // namespace

void define_stages(py::module_& module) {
    module.def("stage_rows", &stage_rows);
    module.def("operation_rows", &operation_rows);
    module.def("literal", &lang::literal, py::arg("value"), py::arg("is_angle"),
               py::arg("instead_of") = "");
}

}  // namespace balcony::python

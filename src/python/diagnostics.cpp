// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "python/diagnostics.hpp"

#include <string>

namespace balcony::python {

namespace py = pybind11;

namespace {

py::dict told_of(const Diagnostic& one) {
    py::dict made;
    made["is_error"] = one.severity == Severity::error;
    made["kind"] = std::string(name_of(one.kind));
    made["message"] = one.message;
    made["remedy"] = one.remedy;
    if (one.span.source) {
        const LineColumn at = one.span.source->locate(one.span.begin);
        made["file"] = one.span.source->name();
        made["line"] = at.line;
        made["column"] = at.column;
    }
    made["text"] = to_text(one);
    return made;
}

}  // namespace

void tell(const Diagnostics& diagnostics) {
    if (diagnostics.empty()) {
        return;
    }
    py::list told;
    for (const Diagnostic& one : diagnostics) {
        told.append(told_of(one));
    }
    py::module_::import("balcony.errors").attr("tell")(told);
}

}  // namespace balcony::python

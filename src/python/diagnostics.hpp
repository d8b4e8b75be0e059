// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Diagnostics as exceptions and warnings of Python, whose classes are those of balcony/errors.py.

#include <utility>

#include <pybind11/pybind11.h>

#include "balcony/base.hpp"

namespace balcony::python {

/// Warns of the warnings, and raises the errors, if there are any. With the lock of Python.
void tell(const Diagnostics& diagnostics);

/// The value, after its warnings were told. With the lock of Python.
template <class T>
[[nodiscard]] T take(Result<T>&& result) {
    tell(result.diagnostics);
    return std::move(*result);
}

}  // namespace balcony::python

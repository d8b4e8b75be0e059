// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// A camera as one Python function that computes many rays at a time with NumPy.

#include "bridge/text/array_python.hpp"
#include "bridge/text/targets.hpp"

namespace balcony::bridge {

namespace {

constexpr std::string_view numpy_helpers = R"(
def _arrays(*given):
    return [np.asarray(a, float) for a in given]


def _rays(formulas, *given):
    x, y, *more = _arrays(*given)
    return formulas(*np.broadcast_arrays(x, y, *more)[:2], *more)


def _vector(x, *at):
    return np.stack(np.broadcast_arrays(*at, x)[:-1], -1)


)";

constexpr std::string_view numpy_inverse_helpers = R"(_doubles = _arrays
_indices = np.flatnonzero


def _count(n, like):
    return np.arange(float(n))


def _order(rows):
    return np.argsort(rows, axis=1, kind="stable")


)";

// NumPy's numbers are divided by 0 without an exception, and here without a warning.
constexpr std::string_view quiet = "@np.errstate(all=\"ignore\")\n";

constexpr ArrayLibrary numpy{.name = "np",
                             .imports = "import numpy as np\n",
                             .arrays = "arrays",
                             .spellings = array_spellings,
                             .number_of_condition = "np.where({0}, 1.0, 0.0)",
                             .decorator = quiet,
                             .helpers = numpy_helpers.substr(1),
                             .table = "np.array([{0}])",
                             .whole = ".astype(int)",
                             .inverse_helpers = numpy_inverse_helpers,
                             .searching = quiet};

Result<std::string> write_numpy(const ExportSource& source, const ExportOptions&,
                                CameraFormulas formulas) {
    return array_module(numpy, source, std::move(formulas));
}

}  // namespace

ExportTarget numpy_target() {
    return {.name = "numpy",
            .meaning = "one Python function that computes many rays at a time with NumPy",
            .ending = ".py",
            .write = write_numpy,
            .has_inverse = true};
}

}  // namespace balcony::bridge

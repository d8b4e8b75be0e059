// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/options/fit_options.hpp"

#include <CLI/CLI.hpp>

namespace balcony::cli {

void add_fit_options(CLI::App& command, FitWords& words) {
    command.add_flag("--fit", words.fit,
                     "place the camera by the size of the scene, as its file says; --set still "
                     "sets parameters");
    command
        .add_option("--fit-to", words.object,
                    "the same by the size of an object of the scene, such as a vase")
        ->type_name("OBJECT");
}

}  // namespace balcony::cli

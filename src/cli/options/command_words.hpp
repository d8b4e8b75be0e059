// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace balcony::cli {

/// The words of a command line, without the program, in the form that the options parse: `help
/// render` becomes `render --help`, `help zoom` of a stage `list zoom`, `version` `--version`, and
/// the words of a value of --set become one, so that `--set fov 60deg`, `--set fov = 60deg` and
/// `--set "fov = 60deg"` mean `--set fov=60deg`, as `--size 100 50` means `--size 100x50`.
/// `--help all` becomes `--help`, for the whole of it.
[[nodiscard]] std::vector<std::string> command_words(std::vector<std::string> words,
                                                     bool& whole_help);

}  // namespace balcony::cli

// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/options/camera_argument.hpp"

#include <algorithm>

#include <CLI/CLI.hpp>

namespace balcony::cli {

void add_camera_option(CLI::App& command, std::string& camera) {
    command
        .add_option("CAMERA", camera,
                    "camera file and the NAME of a camera or picture in it (default: the last), "
                    "or a built-in camera")
        ->type_name("FILE[:NAME]")
        ->required();
}

void add_set_option(CLI::App& command, std::vector<std::string>& set) {
    command
        .add_option("--set", set, "value of a parameter of the camera or picture; may be repeated")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false)
        ->take_all();
}

std::string ending_of(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return ending;
}

}  // namespace balcony::cli

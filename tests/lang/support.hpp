// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "balcony/lang.hpp"
#include "balcony/language_service.hpp"

namespace balcony::lang::test {

inline Result<camera::Camera> make(std::string text, const std::vector<Override>& overrides = {},
                                   std::string_view name = "") {
    return make_camera(std::make_shared<const SourceText>("test.cam", std::move(text)), name,
                       overrides);
}

/// All that is wrong with a file.
inline Diagnostics check(const CameraSource& source) {
    return Workspace().make_all(source).diagnostics;
}

inline std::string read_file(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

inline std::string joined(std::initializer_list<std::string_view> parts) {
    std::string text;
    for (const std::string_view part : parts) {
        text += part;
    }
    return text;
}

/// A text with its changes.
inline std::string edited(std::string text, std::vector<TextEdit> edits) {
    std::sort(edits.begin(), edits.end(),
              [](const TextEdit& a, const TextEdit& b) { return a.begin > b.begin; });
    for (const TextEdit& edit : edits) {
        text.replace(edit.begin, edit.end - edit.begin, edit.text);
    }
    return text;
}

struct Ray {
    std::array<double, 3> origin;
    std::array<double, 3> direction;
    bool valid;
};

/// The ray through a point of a picture, by the scalar definitions.
inline Ray ray(const camera::Camera& camera, double x, double y, double width, double height,
               double time = 0.0) {
    expr::Graph graph;
    const camera::RayExpressions made = camera.emit(graph, width, height);
    const std::array roots{made.origin.x,    made.origin.y,    made.origin.z, made.direction.x,
                           made.direction.y, made.direction.z, made.valid};
    const std::vector<double> v = expr::evaluate(roots, {x, y, time, {}});
    return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, v[6] != 0.0};
}

}  // namespace balcony::lang::test
